//! Numbers: exact input and exact roots.
pub mod rational;
