//! Claim files, certificates and Coq proofs are embedded: a new or removed one must be noticed.

fn main() {
    for folder in ["ricardo-lee-2015", "beyond", "lemmas", "coq", "certificates"] {
        println!("cargo:rerun-if-changed=proofs/{folder}");
    }
}
