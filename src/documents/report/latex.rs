//! Text in LaTeX.

/// Text that LaTeX shows unchanged, whatever the fonts: letters of other scripts than Latin and Greek, for which
/// pdflatex has none, are named by their numbers.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut before = None;
    for c in text.chars() {
        // Two of these would be drawn together as one sign.
        if before == Some(c) && matches!(c, '-' | '\'' | ',') {
            out.push_str("{}");
        }
        out.push_str(&letter(c));
        before = Some(c);
    }
    out
}

/// A formula or a name in typewriter letters; a long word may be broken after a sign, and within a long number.
pub(crate) fn code(text: &str) -> String {
    const LONG: usize = 24;
    let word = |word: &str| {
        if word.chars().count() <= LONG {
            return escape(word);
        }
        let (mut out, mut run) = (String::new(), 0);
        let mut rest = word.chars().peekable();
        while let Some(c) = rest.next() {
            out.push_str(&letter(c));
            run = if c.is_alphanumeric() { run + 1 } else { 0 };
            let sign = matches!(c, '+' | '*' | '/' | '(' | ')' | '^' | ',' | '=' | '·' | '-' | '_');
            if rest.peek().is_some() && (sign || run == LONG) {
                out.push_str("\\allowbreak{}");
                run = 0;
            }
        }
        out
    };
    format!("\\texttt{{{}}}", text.split(' ').map(word).collect::<Vec<_>>().join(" "))
}

/// Characters that the default fonts of LaTeX do not have.
const SIGNS: [(char, &str); 29] = [
    ('≤', "\\le"),
    ('≥', "\\ge"),
    ('≠', "\\ne"),
    ('≈', "\\approx"),
    ('⇔', "\\Leftrightarrow"),
    ('⇒', "\\Rightarrow"),
    ('→', "\\to"),
    ('∞', "\\infty"),
    ('∈', "\\in"),
    ('√', "\\surd"),
    ('∑', "\\sum"),
    ('∏', "\\prod"),
    ('−', "-"),
    ('·', "\\cdot"),
    ('×', "\\times"),
    ('÷', "\\div"),
    ('±', "\\pm"),
    ('²', "^2"),
    ('³', "^3"),
    ('₀', "_0"),
    ('₁', "_1"),
    ('₂', "_2"),
    ('₃', "_3"),
    ('₄', "_4"),
    ('₅', "_5"),
    ('₆', "_6"),
    ('₇', "_7"),
    ('₈', "_8"),
    ('₉', "_9"),
];

/// Greek letters that do not look like Latin ones.
const GREEK: [(char, &str); 33] = [
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "varepsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('ι', "iota"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('μ', "mu"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('υ', "upsilon"),
    ('φ', "varphi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Ξ', "Xi"),
    ('Π', "Pi"),
    ('Σ', "Sigma"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('Ω', "Omega"),
];

fn letter(c: char) -> String {
    match c {
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{c}"),
        '^' => "\\^{}".to_string(),
        '~' => "\\~{}".to_string(),
        '\\' => "\\textbackslash{}".to_string(),
        '<' => "\\textless{}".to_string(),
        '>' => "\\textgreater{}".to_string(),
        '`' => "\\textasciigrave{}".to_string(),
        '"' => "\\char34{}".to_string(),
        '–' | '—' | '‘' | '’' | '“' | '”' | '…' | '§' | '°' | '«' | '»' => c.to_string(),
        // A line of its own would end a paragraph, and with it what the text stands in.
        c if c.is_whitespace() => " ".to_string(),
        c if c.is_ascii_graphic() => c.to_string(),
        c if c.is_alphabetic() && ('À'..='ſ').contains(&c) => c.to_string(),
        c => {
            let sign = SIGNS.iter().find(|s| s.0 == c).map(|s| format!("${}$", s.1));
            let greek = || GREEK.iter().find(|g| g.0 == c).map(|g| format!("$\\{}$", g.1));
            sign.or_else(greek).unwrap_or_else(|| format!("[U+{:04X}]", u32::from(c)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_latex_acts_on_is_left() {
        assert_eq!(escape("\\input{a}%$^_~#&"), "\\textbackslash{}input\\{a\\}\\%\\$\\^{}\\_\\~{}\\#\\&");
        assert_eq!(escape("η ≤ 1 м\n\u{7}é"), "$\\eta$ $\\le$ 1 [U+043C] [U+0007]é");
        assert_eq!(code("m1*(x) = 1/2"), "\\texttt{m1*(x) = 1/2}");
        let broken = code("abcdefghijklmnopqrstuvwxyz*x");
        assert_eq!(broken, "\\texttt{abcdefghijklmnopqrstuvwx\\allowbreak{}yz*\\allowbreak{}x}");
    }
}
