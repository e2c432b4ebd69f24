//! Names of claims as identifiers of Coq.

/// Words that a name of a claim must not take: Coq's own, and those that statements and proofs are made of.
pub(super) const RESERVED: &[&str] = &[
    "as",
    "at",
    "cofix",
    "else",
    "end",
    "exists",
    "exists2",
    "fix",
    "for",
    "forall",
    "fun",
    "if",
    "in",
    "let",
    "match",
    "mod",
    "return",
    "Set",
    "Prop",
    "SProp",
    "Type",
    "then",
    "using",
    "where",
    "with",
    "by",
    "IF",
    "R",
    "nat",
    "INR",
    "Rpower",
    "sqrt",
    "cbrt",
    "exp",
    "ln",
    "cosh",
    "sinh",
    "tanh",
    "sech",
    "sum_over",
    "product_over",
    "matrix",
    "mat_scale",
    "mat_mul",
    "mat_add",
    "mat_transpose",
    "det2",
    "is_derive",
    "is_derive_n",
    "Derive",
    "Derive_n",
    "ex_derive",
    "ex_derive_n",
    "is_lim_seq",
    "is_lim",
    "p_infty",
    "_",
    // Words that proofs are made of.
    "EQ",
    "GE",
    "GT",
    "I",
    "IZR",
    "LE",
    "LT",
    "NE",
    "Rgt_not_eq",
    "Rmult",
    "S3",
    "SA",
    "SI",
    "SM",
    "SN",
    "SP",
    "SW",
    "both",
    "by_sign",
    "conj",
    "divided",
    "eq_refl",
    "eq_sym",
    "eq_trans",
    "f_equal",
    "holds",
    "holds_any",
    "named",
    "of_root",
    "prodz",
    "same_square",
    "slope",
    "stands",
    "slope_between",
    "slope_integral",
    "smooth_on",
    "derivative_of_integral",
    "RInt",
    "continuous",
    "continuous_on",
];

/// A claim's name as an identifier of Coq that is none of the words of statements.
pub fn identifier(name: &str) -> String {
    let word = spelled(name);
    if RESERVED.contains(&word.as_str()) { format!("{word}_") } else { word }
}

pub(super) fn spelled(name: &str) -> String {
    name.chars()
        .map(|c| match c {
            c if c.is_ascii_alphanumeric() || c == '_' || c == '\'' => c.to_string(),
            '-' => "_".to_string(),
            c => format!("u{:x}_", u32::from(c)),
        })
        .collect()
}

/// Whether a text holds an identifier.
pub(super) fn mentions(text: &str, word: &str) -> bool {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == '\'')).any(|w| w == word)
}
