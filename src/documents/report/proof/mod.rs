//! A proof in words ([`crate::explain`]) as HTML and as LaTeX.

pub(crate) mod html;
pub(crate) mod latex;
