//! What the reader of LaTeX says where it does not read: one place for its words.

use carom_diagnostic::{Diagnostic, Fault, Span};

/// A refusal with what to write instead.
pub(crate) fn refused(message: impl Into<String>, help: impl Into<String>, span: Span) -> Diagnostic {
    Diagnostic::new(Fault::Other { message: message.into(), help: Some(help.into()) }, span)
}

/// What may be read in two ways: both readings, and what to write for each.
pub(crate) fn ambiguous(what: &str, readings: [&str; 2], write: [&str; 2], span: Span) -> Diagnostic {
    let [first, second] = readings;
    let message = format!("{what} may be read in two ways: {first}, or {second}");
    let help = format!("for {first}, {}; for {second}, {}", write[0], write[1]);
    refused(message, help, span)
}

/// A limit of the reader.
pub(crate) fn limit(name: &'static str, allowed: usize, span: Span) -> Diagnostic {
    Diagnostic::new(Fault::Limit { name, allowed }, span)
}

/// Something else was expected.
pub(crate) fn expected(expected: &str, found: &str, span: Span) -> Diagnostic {
    let fault = Fault::Expected { expected: expected.to_string(), found: found.to_string(), help: None };
    Diagnostic::new(fault, span)
}

/// A unit of measurement behind a number.
pub(crate) fn unit(span: Span) -> Diagnostic {
    let help = "declare the unit with the name, `%carom given v > 0 in m/s`, and write the number alone";
    refused("a unit behind a number is not read", help, span)
}

/// Words that are not read where they stand.
pub(crate) fn unread_words(said: &str, span: Span) -> Diagnostic {
    let help = "words that are read: and, or, not, if, for, where, if and only if, for all, exists, maximum of, limit of; \
                `%carom remark` passes over words that are no part of the equation, `%carom skip` the equation";
    refused(format!("the words “{said}” are not read here"), help, span)
}

/// A name of the paper that no comment declares.
pub(crate) fn undeclared(name: &str, applied: bool, span: Span) -> Diagnostic {
    let message = format!("nothing declares the name {name}");
    if applied && (name == "O" || name == "\\mathcal{O}") {
        let help = "write the bound that is meant, as in |x - y| \\le x^2, or `%carom skip`";
        return refused("an order of magnitude is not read", help, span);
    }
    let help = match applied {
        true => format!(
            "for a product with the number {name} write `%carom given {name} real`; for a function write \
             `%carom let {name}(x) = …`, or `%carom given {name}(k) real` for a family; for its value at one place `%carom name \
             {name}(x) as x1`"
        ),
        false => format!("declare it in a comment: `%carom given {name} > 0` or `%carom given {name} real`"),
    };
    refused(message, help, span)
}

/// A member of a family that no comment declares.
pub(crate) fn no_family(member: &str, family: &str, span: Span) -> Diagnostic {
    let help = format!("declare a family with an index k of its own, `%carom given {family}(k) real`");
    refused(format!("nothing declares the family {family}, of which {member} is a member"), help, span)
}

/// A value of a function that is known at one place alone, where it is asked for at others.
pub(crate) fn one_value(what: &str, span: Span) -> Diagnostic {
    let help =
        "give the function a formula, as in v(t) := …; a name of its value says nothing of others, or of its change";
    refused(format!("{what} is known at one place alone"), help, span)
}

/// What to write instead of a command that is not read.
pub(crate) fn command(name: &str, span: Span) -> Diagnostic {
    let help = match name {
        "iint" | "iiint" | "oint" => {
            "write one integral within the other, \\int_a^b \\int_c^d f \\, dy \\, dx; or `%carom skip`"
        }
        "lg" => "write \\frac{\\ln x}{\\ln 10}",
        "underbrace" | "overbrace" => {
            "leave the brace out where it does not stand for parentheses, and state what it says as an equation of its own"
        }
        "boxed" => "put the whole equation or one whole side into the box, or write parentheses in it",
        "stackrel" | "overset" | "underset" => "leave out what stands over or under the sign",
        "therefore" | "because" => "leave the sign out, or write \\Rightarrow between two statements",
        "|" | "lVert" | "Vert" => "write \\lvert x \\rvert for the absolute value of a number",
        "pmod" | "bmod" | "mod" => "write a congruence with a multiple, as in n = 2 k + 1",
        "unit" | "SI" | "si" | "qty" | "num" => {
            "declare the unit with the name, `%carom given v > 0 in m/s`, and write the number alone"
        }
        "langle" | "rangle" | "Sigma" => {
            "if it is a part of a name, give that a name: `%carom name \\langle v \\rangle as v_mean`"
        }
        "propto" | "sim" | "simeq" | "ll" | "gg" | "lesssim" | "gtrsim" | "cong" => {
            "write the equation or the inequality that is meant, or `%carom skip`"
        }
        "dots" | "ldots" | "cdots" | "vdots" => "write a sum or product with its index, \\sum_{i=1}^{n}",
        "over" | "atop" | "choose" => {
            "put braces around it, as in {a \\over b}, or write \\frac{a}{b} or \\binom{n}{k}"
        }
        "mathbb" => "write the domain in a comment: `%carom given x real`",
        "nabla" | "hbar" | "ell" | "vec" | "mathbf" | "boldsymbol" | "hat" | "bar" | "tilde" | "dot" | "ddot" => {
            "if it is a part of a name, declare that name as it is written: `%carom given \\bar{v} real`"
        }
        _ => {
            "write it with signs that are read (`carom help latex` lists them), or pass the equation over by `%carom skip`"
        }
    };
    refused(format!("\\{name} is not read"), help, span)
}
