//! Words and signs that other languages have and claims do not, with what to write instead.

const COMPLEX: &str = "there are no complex numbers; declare the real and the imaginary part: `given x, y real`";
const CONDITION: &str = "write a condition as a hypothesis, `assume A`, or as an implication, `A => B`";
const DIVIDES: &str = "write divisibility with a quotient, `exists k natural: n = 3*k`";
const END: &str = "write `as x -> infinity` in a limit, `x >= 0` for [0, infinity); a sum without an end is a limit, \
                   `limit of sum(k = 1..n, f) as n natural -> infinity is L`";
const EQUIVALENT: &str = "write `A <=> B`";
const EVERY: &str = "write `for all y real: …`, with a domain and a colon";
const EXISTS: &str = "write `exists y in [0, 1]: …`, with a domain and a colon";
const GREATEST: &str =
    "write `maximum of f over x in [0, 1] is M`, or with its place `maximum of f over x in [0, 1] at x = a is M`";
const IMPLIES: &str = "write `A => B`";
const INTEGRAL: &str =
    "write integral(x = a..b, f) for a definite integral; for an indefinite one say derivative(F, x) = f";
const LEAST: &str =
    "write `minimum of f over x in [0, 1] is m`, or with its place `minimum of f over x in [0, 1] at x = a is m`";
const LIMIT: &str = "write `limit of f as x -> 0 is L`, one-sided with `as x -> 0 from above`, or `as x -> infinity`";
const MEMBER: &str = "as a statement write `0 <= x <= 1`, or `n = 1 or n = 2 or n = 3`; a domain is declared: `given x real`, \
                      `given n natural`";
const REMAINDER: &str = "write divisibility as `exists k natural: n = 5*k`, the remainder as `n - 5*floor(n/5)`";
const SET: &str =
    "write `x real`, `k integer`, `n natural`, or an interval such as `x in [0, 1]`; for newton `x real in N`";
const SUM: &str = "write sum(k = 1..n, f)";
const TRUTH: &str = "a statement compares expressions; that A and B contradict each other is `prove not (A and B)`";

/// What to write instead of a word or sign. Two words are one entry where the first has a meaning of its own: `max of`.
pub fn foreign(word: &str) -> Option<&'static str> {
    Some(match word {
        // Functions and numbers.
        "cot" => "write cos(x)/sin(x)",
        "sec" => "write 1/cos(x)",
        "csc" => "write 1/sin(x)",
        "asin" => "write arcsin(x)",
        "acos" => "write arccos(x)",
        "atan" => "write arctan(x)",
        "atan2" | "arctan2" => "write arctan(y/x), with the case x > 0 in a hypothesis",
        "arccot" | "acot" => "write pi/2 - arctan(x)",
        "log" => "write the natural logarithm as ln(x), the logarithm to base b as ln(x)/ln(b)",
        "lg" | "log10" => "write ln(x)/ln(10)",
        "log2" | "lb" => "write ln(x)/ln(2)",
        "coth" => "write 1/tanh(x)",
        "csch" => "write 1/sinh(x)",
        "arcosh" | "acosh" | "arccosh" => "write ln(x + sqrt(x^2 - 1))",
        "arsinh" | "asinh" | "arcsinh" => "write ln(x + sqrt(x^2 + 1))",
        "artanh" | "atanh" | "arctanh" => "write ln((1 + x)/(1 - x))/2",
        "sgn" | "sign" => "write x/|x| where x != 0",
        "e" => "for the base of exponentials write exp(x), for a restitution declare it: `given e in [0, 1]`",
        "Re" | "Im" | "conj" => COMPLEX,
        "tr" => "write trace(M)",
        "inv" => "write inverse(M)",
        "gamma" | "Gamma" => "there is no gamma function; for a whole number n write (n - 1)!",
        "erf" | "erfc" => "there is no error function; write the integral, integral(t = 0..x, exp(-t^2))",
        "choose" | "binom" => "write binomial(n, k)",
        "oo" | "inf" | "Infinity" | "infinity" => END,
        // Whole numbers.
        "mod" => REMAINDER,
        "div" => "write floor(n/5)",
        "divides" | "∣" => DIVIDES,
        "gcd" => {
            "there is no gcd; declare it: `given g natural >= 1`, `assume exists i, j natural: a = i*g and b = j*g`, \
             `assume for all d, i, j natural: a = i*d and b = j*d => d <= g`"
        }
        "lcm" => {
            "there is no lcm; for a, b >= 1 declare it: `given m natural >= 1`, `assume exists i, j natural: m = i*a and m = j*b`, \
             `assume for all i, j natural: i*a = j*b and i*a > 0 => m <= i*a`"
        }
        // Sums, derivatives, limits, extrema.
        "Sum" | "∑" => SUM,
        "prod" | "Prod" | "Product" | "∏" => "write product(k = 1..n, f)",
        "int" | "integrate" | "Integrate" | "∫" => INTEGRAL,
        "diff" | "Derivative" | "D" | "dx" | "∂" => "write derivative(f, x)",
        "O" => "an order ends an equation and says where the variable goes: `f(x) = 1 + x + O(x^2) as x -> 0`",
        "o" => "there is no o(…); state a bound with a constant, such as |f - g| <= C*h^2 for h in (0, 1)",
        "lim" | "Limit" | "limit" | "to" | "tends" => LIMIT,
        "max of" | "max over" | "maximum" | "maximize" | "argmax" => GREATEST,
        "min of" | "min over" | "minimum" | "minimize" | "argmin" => LEAST,
        "sup" | "sup of" | "supremum" => {
            "there is no sup; where it is reached write `maximum of f over x in [0, 1] is M`, for a bound `for all x in [0, 1]: f <= M`"
        }
        "inf of" | "infimum" => {
            "there is no inf; where it is reached write `minimum of f over x in [0, 1] is m`, for a bound `for all x in [0, 1]: f >= m`"
        }
        // Logic.
        "iff" | "<->" | "⟺" | "↔" => EQUIVALENT,
        "if" => "write a condition as `A => B` or as a hypothesis, `assume A`; for if and only if write `A <=> B`",
        "when" | "where" | "whenever" | "provided" | "unless" => CONDITION,
        "then" | "implies" | "so" | "hence" | "->" | "⟹" | "⟶" => IMPLIES,
        "&" => "write `and`",
        "xor" => "write `(A or B) and not (A and B)`",
        "forall" | "every" | "any" | "∀" => EVERY,
        "there" | "exist" | "such" | "∃" => EXISTS,
        "unique" | "exists !" => {
            "for exactly one y with A write `exists y real: A and (for all z real: B => z = y)`, where B is A with z for y"
        }
        "true" | "false" => TRUTH,
        "equals" => "write `=`",
        "in" => MEMBER,
        "ℝ" | "ℚ" | "ℤ" | "ℕ" | "ℂ" => SET,
        "⩾" | "≧" => "write >=",
        "⩽" | "≦" => "write <=",
        "÷" => "write /",
        // Other signs.
        "." => "write a digit before the decimal point, as in 0.5; a range is 1..n",
        "\\" => "in a claim file write sqrt(x), a/b, x^2, <=; a paper in LaTeX is read from a file that ends in .tex",
        "~" | "∼" => "say what the quotient tends to: `limit of f/g as x -> 0 is 1`",
        "⌊" | "⌋" => "write floor(x)",
        "⌈" | "⌉" => "write -floor(-x)",
        "≈" => "write the bound that is meant, as in |x - 0.543| <= 0.0005",
        "±" | "∓" => {
            "write both statements, one with + and one with -; a measured value is an interval: `given x in [57.0, 57.2]`"
        }
        "%" => {
            "a percentage is a decimal, as in 0.05; the remainder of n by 5 is `n - 5*floor(n/5)`; a comment begins with #"
        }
        "≡" => REMAINDER,
        "°" => "write an angle with pi: 30° is pi/6",
        "½" | "⅓" | "⅔" | "¼" | "¾" => "write a fraction as a quotient: 1/2",
        "“" | "”" | "„" => "write the title between straight quotation marks: \"…\"",
        "{" | "}" => "group with parentheses: (…)",
        _ => return domain(word),
    })
}

/// What to write instead of a word behind a name that is declared, `x positive`.
pub fn domain(word: &str) -> Option<&'static str> {
    Some(match word {
        "rational" => "write `given p integer; q natural >= 1` and `let x = p/q`",
        "complex" => COMPLEX,
        "prime" => {
            "there are no primes; write `given p natural >= 2` and `assume for all a, b natural: a*b = p => a = 1 or b = 1`"
        }
        "positive" => "write `x > 0`, for a whole number `n natural >= 1`",
        "negative" => "write `x < 0`",
        "nonnegative" => "write `x >= 0`, for a whole number `n natural`",
        "nonzero" => "write `x real != 0`",
        "even" => "write `given k integer` and `let n = 2*k`",
        "odd" => "write `given k integer` and `let n = 2*k + 1`",
        _ => return None,
    })
}

/// What to write instead of a keyword that stands behind a statement, as it does in other languages.
pub fn behind_a_statement(word: &str) -> Option<&'static str> {
    Some(match word {
        "for" => "write the quantifier before what it says: `for all x > 0: x + 1/x >= 2`",
        "with" | "suppose" | "assuming" | "hypothesis" => {
            "write the condition as a hypothesis before `prove`: `assume a + b + c = 1`"
        }
        "at" | "only" => "write the place before the value: `maximum of x*(2 - x) over x real at x = 1 is 1`",
        _ => return None,
    })
}

/// Whether a word binds a variable in other languages, so that a variable in its arguments needs no declaration.
pub fn binds(word: &str) -> bool {
    matches!(word, "lim" | "Limit" | "int" | "integrate" | "Integrate" | "Sum" | "Product")
}
