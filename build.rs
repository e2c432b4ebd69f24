//! Claim files are embedded: a new or removed one must be noticed.

fn main() {
    println!("cargo:rerun-if-changed=proofs");
}
