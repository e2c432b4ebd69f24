//! What may be read in two ways, or is not read, is refused with a message; nothing makes the reader panic.

use carom::claim::diagnostic::Diagnostic;
use carom::claim::print::Style;
use carom::latex::{Outcome, latex_of, paper};
use proptest::prelude::*;

const DECLARED: &str = "%carom given a, b, c, x, y, m, v, theta real; k, n natural; mu(j) > 0\n%carom let f(t) = t^2\n";

/// What a formula is read as, or the first fault.
fn read(formula: &str) -> Result<String, Diagnostic> {
    let source = format!("{DECLARED}\\begin{{equation}}\n{formula}\n\\end{{equation}}\n");
    let mut found = paper(&source).map_err(|mut faults| faults.remove(0))?;
    if !found.faults.is_empty() {
        return Err(found.faults.remove(0));
    }
    match found.equations.remove(0).outcome {
        Outcome::Read(claim) => Ok(Style::Text.prop(claim.written_goal())),
        Outcome::NotRead(mut faults) => {
            let place = faults[0].place(&source);
            assert!(place.0 > 2, "{formula}: the place is {place:?}");
            Err(faults.remove(0))
        }
        other => panic!("{formula}: {other:?}"),
    }
}

#[test]
fn a_formula_is_read_as_something_else() {
    for (formula, wanted) in [
        (r"2ab = \frac{a b}{c}", "2*a*b = a*b/c"),
        (r"-x^2 \le \left| x - y \right|", "-x^2 <= abs(x - y)"),
        (r"f(x + 1) = \sqrt[3]{x}", "f(x + 1) = cbrt(x)"),
        (r"\mu_{k+1} = \mu_k^2", "mu(k + 1) = mu(k)^2"),
        (r"\sin^2\theta + \cos 2\theta \ne 1", "sin(theta)^2 + cos(2*theta) != 1"),
        (r"m(a + b) = m a + m b", "m*(a + b) = m*a + m*b"),
        (r"\int_a^b z^2 + 1 \, dz + c = 2", "integral(z = a..b, z^2 + 1) + c = 2"),
        (r"2 \int_0^x x \, \mathrm{d}x = x^2", "2*integral(x_in = 0..x, x_in) = x^2"),
        (r"\int_0^a \int_0^z w z \, dw \, dz = a", "integral(z = 0..a, integral(w = 0..z, w*z)) = a"),
        (r"(\int_0^1 dz) x = x \int_0^1 dz", "integral(z = 0..1, 1)*x = x*integral(z = 0..1, 1)"),
        (
            r"\prod_{k=1}^{n} \frac{k}{n} = \prod_{k=1}^{n} 2 \left|k\right|^2",
            "product(k_in = 1..n, k_in/n) = product(k_in = 1..n, 2*abs(k_in)^2)",
        ),
        (r"x > 1 \iff (y > 1 \Rightarrow x > 0)", "x > 1 <=> (y > 1 => x > 0)"),
        (r"\int_0^1 (1 - z) dz = \int_1^2 dz", "integral(z = 0..1, 1 - z) = integral(z = 1..2, 1)"),
        (r"\sum_{i=1}^{n} i a + b = 0", "sum(i = 1..n, i*a) + b = 0"),
        (r"a &= b \\ &= c", "a = b = c"),
        (r"a = b \text{ if } x > 0", "x > 0 => a = b"),
        (r"x \approx 0.543", "abs(x - 0.543) <= 0.5e-3"),
        (r"x \approx -5.43 \times 10^{-3}", "abs(x + 5.43e-3) <= 0.5e-5"),
        (r"x \approx 57.3^\circ", "abs(x - 57.3*pi/180) <= 0.5e-1*pi/180"),
        (r"x \approx (57.3 \pm 0.2)^\circ", "57.3*pi/180 - 0.2*pi/180 <= x <= 57.3*pi/180 + 0.2*pi/180"),
        (r"x \approx -57^\circ \pm 2^\circ", "-57*pi/180 - 2*pi/180 <= x <= -57*pi/180 + 2*pi/180"),
        (r"x \approx 57.1 \pm 0.1", "57.1 - 0.1 <= x <= 57.1 + 0.1"),
        (r"a b \approx -57.13(12)", "-57.13 - 12e-2 <= a*b <= -57.13 + 12e-2"),
        (
            r"x = a + b \approx (5.71 \pm 0.01) \times 10^{-3}",
            "x = a + b and 5.71e-3 - 0.01e-3 <= a + b <= 5.71e-3 + 0.01e-3",
        ),
        (r"\begin{vmatrix} a & b \\ c & x \end{vmatrix} = a x - b c", "det([a, b; c, x]) = a*x - b*c"),
        (r"\frac{d}{dx} x^2 = 2x", "derivative(x^2, x) = 2*x"),
        (r"\exp(x) = \mathrm{e}^{x}", "exp(x) = exp(x)"),
        (r"\binom{n}{2} = n!", "binomial(n, 2) = n!"),
        (r"x = {1 \over 2} a b^2", "x = 1/2*a*b^2"),
        (r"x^{a \over b} = {n \choose k} {a + b \over c}", "x^(a/b) = binomial(n, k)*((a + b)/c)"),
        (r"\boxed{a = b}", "a = b"),
        (r"a = \boxed{b + c}", "a = b + c"),
        (r"a + \underbrace{b + c}_{\text{small}} \mathrel{=} x", "a + b + c = x"),
        (r"\cot \theta = \sec^2 x", "(cos(theta)/sin(theta)) = (1/cos(x))^2"),
        (r"\csc(2x) + \coth y = 1", "1/sin(2*x) + cosh(y)/sinh(y) = 1"),
        (r"\log_2 x = \log_{a + b}^2(y)", "(ln(x)/ln(2)) = (ln(y)/ln(a + b))^2"),
        (r"\sin 30^\circ = \cos 2x", "sin(30*pi/180) = cos(2*x)"),
        (r"f'(x) = f''(x)", "derivative(f(x), x) = derivative(f(x), x, x)"),
        (r"\frac{df}{dx} = 1", "derivative(f(x), x) = 1"),
        (
            r"|x| = \left\{ \begin{array}{ll} x, & x \ge 0 \\ -x, & x < 0. \end{array} \right.",
            "(x >= 0 => abs(x) = x) and (x < 0 => abs(x) = -x) and (x >= 0 or x < 0)",
        ),
        (
            r"|x| = \begin{cases} x & \text{if } x > 0 \\ -x & \text{otherwise} \end{cases}",
            "(x > 0 => abs(x) = x) and (not x > 0 => abs(x) = -x)",
        ),
        (r"|a b| = |a||b|", "abs(a*b) = abs(a)*abs(b)"),
        (r"|a|^2 + |b|^2 = |a| - 2|b|/|c|", "abs(a)^2 + abs(b)^2 = abs(a) - 2*abs(b)/abs(c)"),
        (r"\begin{cases} a = 1, \\[2mm] m = 1 \end{cases}", "a = 1 and m = 1"),
        (r"x^2 &> 0 \\ & \text{for } x \ne 0", "x != 0 => x^2 > 0"),
        (r"x > 0 \text{ or} \\ & x \le 0", "x > 0 or x <= 0"),
        (r"2|a|\,|b| \not= |c|", "2*abs(a)*abs(b) != abs(c)"),
        (r"a ={} b + {}c", "a = b + c"),
        (r"\frac{d}{dx} \frac{1}{x} = \frac{d}{dx} x", "derivative(1/x, x) = derivative(x, x)"),
        (
            r"\begin{pmatrix} a & b \end{pmatrix}^{\mathsf T} = \begin{pmatrix} a \\ b \end{pmatrix}",
            "transpose([a, b]) = [a; b]",
        ),
        (r"{\rm m} + m_{\rm x} = 1 %carom given m_x real", "m + m_x = 1"),
        (
            r"M^{\mathrm T} M = M^\top M^{\intercal} %carom let M = [a, b; c, x]",
            "transpose(M)*M = transpose(M)*transpose(M)",
        ),
        (r"(2 M)^{\mathsf{T}} = 2 M^T %carom let M = [a, b; c, x]", "transpose(2*M) = 2*transpose(M)"),
        (r"v_\pm = a \mp b %carom given v_+, v_{-} real", "v_plus = a - b and v_minus = a + b"),
        (r"\sum_{k=1}^{k} k \sum_{k=1}^{k} k = n", "sum(k_in = 1..k, k_in*sum(k_in_in = 1..k_in, k_in_in)) = n"),
        (r"\begin{alignedat}{3} 2x & + {} & 3 y & = {} & 5 a \end{alignedat}", "2*x + 3*y = 5*a"),
        (r"x = \left( a \right. \\ & \left. {} + b \right) c", "x = (a + b)*c"),
        (r"(b + c)^2 &= b^2 + 2 b c \\ &\phantom{=} + c^2", "(b + c)^2 = b^2 + 2*b*c + c^2"),
        (r"a &= b \\ &\mathrel{\phantom{=}} \hspace{1em} \times c", "a = b*c"),
        (r"\begin{cases} x + y = a, \\ x - y = b. \end{cases}", "x + y = a and x - y = b"),
        (r"x \in (0,1) \implies x^2 < 1", "0 < x < 1 => x^2 < 1"),
        (r"a, b > 0 \Rightarrow a b > 0", "a > 0 and b > 0 => a*b > 0"),
        (r"x \ge a, \quad \text{where } x > a.", "x > a => x >= a"),
        (r"x^2 \ge 0 \quad \text{for all } x > 0", "for all x > 0: x^2 >= 0"),
        (r"x^2 \ge 0 \quad \forall x > 0\text{.}", "for all x > 0: x^2 >= 0"),
    ] {
        let wanted = carom::claim::parse::parse_prop(wanted).map(|prop| Style::Text.prop(&prop)).unwrap();
        let formula = if formula.contains(r"\\ &") {
            format!(r"\begin{{split}} {formula} \end{{split}}")
        } else {
            formula.into()
        };
        assert_eq!(read(&formula).map_err(|fault| fault.message()), Ok(wanted), "{formula}");
    }
}

#[test]
fn an_ambiguity_is_decided_by_guessing() {
    for formula in [
        "v(x) = 1",
        "1/2x = a",
        r"1/2 \cdot x = a",
        r"\sin a b = 1",
        r"\sin a / b = 1",
        r"\sin a^2 = 1",
        r"\ln^{-1} x = 1",
        r"e^{x} = 1",
        r"x = a \pm b",
        r"a = b, \quad x > 0",
        r"|a| b |c| = 1",
        r"\mu_{12} = 1",
        r"\mu_{kn} = 1",
        r"x^{(2)} = 1",
        r"1,000 = a",
        r"a \equiv b",
        r"2 \frac{1}{3} = a",
        r"f^2(x) = 1",
        r"\sum_{i=1}^{n} i + i = 0",
        r"\int_0^1 dz \, z^2 = a",
        r"\int_0^1 dx \cdot x = x",
        r"\int_0^1 2 \, dx \, x = 1",
        r"x > 1 \Rightarrow x > 0 \Leftrightarrow x^2 \ge 0",
        r"x^2 \ge 0 \iff x > 1 \implies x > 0",
        r"x^2 = 4 \iff x = 2 \text{ if } x > 0",
        r"x > 0 \iff x^3 > 0 \text{ for all } x > 1",
        r"\prod_{i=1}^{n} i \cdot (n + 1) = a",
        r"\prod_{i=1}^{n} i^2 / n = a",
        r"\prod_{i=1}^{n} i \sum_{i=1}^{n} i = a",
        r"x = 2 y \; (3.1)",
        r"x = y^2 \, (3)",
        r"\frac{d}{dx} x^2 y = 1",
        r"a > 0 \Rightarrow b > 0 \Rightarrow c > 0",
        r"x \approx 300",
        r"x = 57.1 \pm 0.1",
        r"x = 57.1(1)",
        r"57.1 \pm 0.1 = x",
        r"x \approx 57.1 \pm 0.1 \times 10^{3}",
        r"[a] = b",
        r"\begin{split} a &= b \\ & -c = x \end{split}",
        r"\begin{split} a &= b \\ & \Rightarrow c = x \end{split}",
        r"\lim_{n \to \infty} a + b = 1",
        r"\log x = 1",
        r"a = b \quad (x \ne 0)",
        r"a = b \hspace{2em} (x, y > 0)",
        r"2 {1 \over 3} = a",
        "v(2x) = 1",
        "v(-x) = v",
        r"m(a b) = 1",
        r"\Delta(x + y) = 1 %carom given \Delta real",
        r"x^{[2]} = 1",
        r"x = 5\,\mathrm{m}",
        r"v^{-1}(x) = 1",
        r"a = 2 \enspace b = 6",
        r"a = 2 \;\; b = 6",
        r"a = 2 ~ b = 6",
        r"a = 2 \phantom{xxx} b = 6",
        r"a = 2 \hfill b = 6",
        r"a = 2 \text{ } b = 6",
        r"a = 2 \hspace*{1cm} b = 6",
        r"a = 2 \hspace{2mm} b = 6",
        r"v\!\left(x\right) = 1",
        r"v[2x] = 1",
        r"v{(2x)} = 1",
        r"x = 5\,{\rm m}",
        r"x = (5 + 2)\,\mathrm{m}",
        r"x = 57.1(1) + a",
        r"\frac{df}{dx}(1) = 2",
        r"\begin{split} a &= b \text{ if } x > 0 \\ &= c \end{split}",
    ] {
        let fault = read(formula).expect_err(formula);
        assert!(fault.message().contains("may be read in two ways"), "{formula}: {}", fault.message());
        assert!(fault.help().is_some(), "{formula}");
    }
}

#[test]
fn what_is_not_read_is_read() {
    for (formula, says) in [
        (r"g(x + 1) = 1", "nothing declares the name g"),
        (r"x_{12} = 1", "nothing declares the name x_{12}"),
        (r"\int x dx = 1", "this integral has no ends"),
        (r"\int_0^1 x = 1", "the variable of this integral is not read"),
        (r"\int_{-\infty}^0 x dx = 1", "this integral begins at infinity"),
        (r"1 + \int_0^\infty x dx = 1", "this goes on to infinity"),
        (r"\int_0^1 a \, dx = a", "the integrand does not mention"),
        (r"\oint x dx = a", r"\oint is not read"),
        ("\\int_0^1 d x dx = a %carom given d real", "a d within an integral may be read in two ways"),
        ("\\int_0^1 x q dx = a %carom let q = x^2", "q may depend on the variable of this integral"),
        (r"\lg x = 1", r"\lg is not read"),
        (r"2 \boxed{a + b} = x", r"\boxed is not read"),
        (r"a - \underbrace{b + c} = x", r"\underbrace is not read"),
        (r"\underbrace{b + c}_{= x} = a", r"\underbrace is not read"),
        (r"{a \over b \over c} = 1", "two fractions in one group"),
        (r"a \over b = 1", r"\over is not read"),
        (r"\sum_{i=1}^\infty a < 1", "this goes on to infinity"),
        (r"n \equiv 1 \pmod 2", r"\pmod is not read"),
        (r"a : b = c", "a colon between two numbers"),
        (r"x \approx 2.5 \frac{a}{b}", "a number that stands alone"),
        (r"x \approx 2.5\,\mathrm{s}", "a unit behind a number"),
        (r"x = 2.5\,\mathrm{m/s}", "a unit behind a number"),
        (r"a = b, \quad n = 1, 2, \dots", "a list of values with dots"),
        (r"f'(2) = 1", "only of a variable"),
        (r"a = b \text{ unless } x = 1", "the words “unless”"),
        (r"a = b + \mathcal{O}(x^2)", "an order of magnitude"),
        (r"a \propto b", r"\propto is not read"),
        (r"x \approx 57.1(1) = a", "a chain goes on"),
        (r"x \approx 57.1 \pm a", "only before a number"),
        (r"x^12 = 1", "an exponent of two digits"),
        (r"1\,000 = a", "separated by a space"),
        (r"{a + b} c = 1", "these braces do not print"),
        (r"x 2 = 1", "a number stands behind a factor"),
        (r"sin(x) = 1", "without a backslash"),
        (r"\frac{a}{b = 1", "not closed"),
        (r"(a + b = 1", "is not closed"),
        (r"a } = 1", "not opened"),
        (r"\left. a \right| = 1", "one side left out"),
        (r"\frac{dy}{dx} = 1", "depends on no other"),
        (r"x^* = 1", "upper sign"),
        (r"a \approx b", "only before a number"),
        (r"a + b", "compares nothing"),
        (r"a -- b = 1", "two signs"),
        (r"x \to 0", r"\to is not read"),
        (r"\sqrt(x) = 1", "no argument in braces"),
        (r"{ab}^2 = 1", "these braces do not print"),
        (r"1/{2x} = a", "these braces do not print"),
        (r"2{3} = a", "these braces do not print"),
        (r"p := a \pm b", "one of two values in a definition"),
        (r"a = 0.333...", "dots at the end"),
        (r"x = 1 + a ...", "dots at the end"),
        (r"y = x, \quad x > 1 \text{ or } x < -1 %carom comma if", "before `or`"),
        (r"\begin{cases} a = b \\ - c = x \end{cases}", "a row of a system"),
        (r"(\vec{u} + \vec{w}) \times \vec{u} = 1 %carom given \vec{u}, \vec{w} real", "a product of vectors"),
        (r"x = 6 \phantom{0} 1", "what follows this wide space is no statement"),
        (r"\begin{cases} x = 6 & 1 > 0 \end{cases}", "in two ways"),
        (r"\begin{cases} a = 2 & x > 1 \\ a = 2 & x > 0 \end{cases}", "in two ways"),
        (r"\vec{u} \cdot \vec{w} = 1 %carom given \vec{u}, \vec{w} real", "a product of vectors"),
        (r"\mathbf{u} \times \mathbf{w} = \mathbf{w} %carom given \mathbf{u}, \mathbf{w} real", "a product of vectors"),
        (r"|\vec{u} m \vec{w}| = 1 %carom given \vec{u}, \vec{w} real", "a product of vectors"),
        (r"x \ne \pm 1 %carom pm or", "one of two values in an inequality"),
        (r"\Delta x = 1", r"nothing declares the name \Delta x"),
        (r"M^T = M %carom let M = [a, b; c, x]; T = 2", "the end of the clause"),
        ("M^n = M^T %carom let M = [a, b; c, x]\n%carom given T natural", "T above a matrix may be read in two ways"),
        ("v_\\pm = \\pm a %carom given v_+, v_- real\n%carom pm or", "one of two values is said"),
        (r"\frac{d}{dx} (m v) = a", "does not mention the variable"),
        (r"q := 1/x \quad \text{where } x > 0", "a condition behind a definition"),
        (r"q(t) = a t, \quad t > 0", "a condition behind a definition"),
        (r"x = a/3 %carom digits 3", "`digits` is said of no printed number"),
    ] {
        let fault = read(formula).expect_err(formula);
        let said = format!("{}; {}", fault.message(), fault.help().unwrap_or_default());
        assert!(said.contains(says), "{formula}: {said}");
    }
}

#[test]
fn a_comment_does_not_decide() {
    for (formula, wanted) in [
        ("x = a \\pm b %carom pm or", "x = a + b or x = a - b"),
        ("a = b \\implies x = \\pm y %carom pm or", "a = b => x = y or x = -y"),
        ("x = \\pm y \\implies x^2 = y^2 %carom pm or", "x = y or x = -y => x^2 = y^2"),
        ("x = \\pm y \\implies x^2 = y^2 %carom pm and", "(x = y => x^2 = y^2) and (x = -y => x^2 = y^2)"),
        ("x = \\pm y \\text{ and } a = \\mp b %carom pm or", "(x = y and a = -b) or (x = -y and a = b)"),
        ("x = 3 \\pm 2 %carom pm or", "x = 3 + 2 or x = 3 - 2"),
        ("x = 2(3) %carom pm or", "x = 2*3"),
        ("x = 57.1 \\pm 0.1 %carom pm interval", "57.1 - 0.1 <= x <= 57.1 + 0.1"),
        ("x = 57.1(1) %carom pm interval", "57.1 - 1e-1 <= x <= 57.1 + 1e-1"),
        ("x \\approx 1200 %carom digits 3", "abs(x - 1200) <= 0.5e1"),
        ("x = 0.543 %carom digits 3", "abs(x - 0.543) <= 0.5e-3"),
        ("a = b, \\quad x > 0 %carom comma if", "x > 0 => a = b"),
        ("a = b, \\quad x > 0 %carom comma and", "a = b and x > 0"),
        ("e^{x} = a %carom e is base", "exp(x) = a"),
        ("\\log x = a %carom log is natural", "ln(x) = a"),
        ("\\log x = a %carom log is decimal", "(ln(x)/ln(10)) = a"),
        ("a = b \\quad (x, y > 0) %carom comma if", "(x > 0 and y > 0) => a = b"),
        ("\\mu_{12} = 1 %carom name \\mu_{12} as mu(12)", "mu(12) = 1"),
        ("x = a %carom prove x = b", "x = b"),
        ("\\bar{v} = a %carom given \\bar{v} real", "bar_v = a"),
    ] {
        let wanted = carom::claim::parse::parse_prop(wanted).map(|prop| Style::Text.prop(&prop)).unwrap();
        assert_eq!(read(formula).map_err(|fault| fault.message()), Ok(wanted), "{formula}");
    }
}

#[test]
fn two_values_on_both_sides_of_an_arrow_are_guessed() {
    let fault = read("x = \\pm y \\implies a = \\mp b %carom pm or").expect_err("two readings");
    assert!(fault.message().contains("± in several relations"), "{}", fault.message());
}

#[test]
fn an_equation_is_judged_without_a_hypothesis_that_is_not_read() {
    let source = format!("{DECLARED}\\[ \\int a = b %carom assume\n\\]\n\\[ a = a \\]\n");
    let found = paper(&source).unwrap();
    assert!(matches!(found.equations[0].outcome, Outcome::NotRead(_)));
    let Outcome::Waits(declaration) = found.equations[1].outcome else { panic!("{:?}", found.equations[1]) };
    assert_eq!(source[..declaration.start].matches('\n').count() + 1, 3);
}

#[test]
fn a_limit_has_no_name() {
    let doubled: String =
        (b'a'..=b'y').map(|c| format!("\\newcommand{{\\z{0}}}{{\\z{1}\\z{1}}}", c as char, (c + 1) as char)).collect();
    for source in [
        "\\newcommand{\\a}{\\a}\n\\[ \\a = 1 \\]".to_string(),
        format!("{doubled}\\newcommand{{\\zz}}{{}}\\[ \\za = 1 \\]"),
        format!("\\[ {}1{} = 1 \\]", "(".repeat(300), ")".repeat(300)),
        format!("\\[ {}1{} = 1 \\]", "{".repeat(100_000), "}".repeat(100_000)),
        format!("\\[ {}1{} = 1 \\]", "\\boxed{".repeat(3000), "}".repeat(3000)),
        format!("\\[ {}1{} = 1 \\]", "x_{\\mu^{".repeat(5000), "}}".repeat(5000)),
        format!("\\[ {}1{} = 1 \\]", "\\bar{x_{".repeat(5000), "}}".repeat(5000)),
    ] {
        let found = paper(&source).unwrap();
        let Outcome::NotRead(faults) = &found.equations[0].outcome else { panic!("{:?}", found.equations[0]) };
        assert!(faults[0].is_limit(), "{}", faults[0].message());
    }
    assert!(paper(&"x".repeat(2 << 20)).unwrap_err()[0].is_limit());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn random_text_makes_the_reader_panic(text in "\\PC{0,60}", parts in prop::collection::vec(prop::sample::select(vec![
        "\\[", "\\]", "$$", "{", "}", "(", ")", "|", "\\frac", "\\sum", "_", "^", "'", "&", "\\\\", "\\begin{align}", "\\end{align}", "a",
        "\\mu", "1", ".", ",", "=", "+", "-", "\\left", "\\right", "\\text{and}", "%carom given a real\n", "%carom let\n", "%carom name a as\n",
        "\\newcommand{\\q}[2]{#1#2}", "\\q", "\\sqrt", "[", "]", "\\sin", "\\pm", "\\begin{cases}", "\\end{cases}", "\\lim", "\\to", "é", "\\Delta",
        "\\begin{pmatrix}", "\\end{pmatrix}", "\\partial", "d", "!", "/", "\\cdot", "\\approx", "\\in", "\\quad", "%carom begin\n", "\\over", "\\boxed",
        "\\underbrace", "\\log", "\\begin{array}", "\\end{array}", "\\{", "\\text{for all}", "\\hspace", "\\choose", "^\\circ", ",", "$", "%carom inline\n",
        "<!-- carom", "<!--", "-->", "> ", "\n", "```", "math", "    ", "`", "- ", "\u{a0}", "f(x) = x", "_\\pm", "%carom name a(b) as c\n", "a(b)", "\\Aboxed",
    ]), 0..40)) {
        let markdown = parts.concat() + &text;
        prop_assert_eq!(latex_of(&markdown).len(), markdown.len());
        for source in [text.clone(), parts.concat(), format!("\\[{}{text}\\]", parts.concat()), latex_of(&format!("$${text}{}", parts.concat())), latex_of(&markdown)] {
            if let Ok(found) = paper(&source) {
                for equation in &found.equations {
                    if let Outcome::NotRead(faults) = &equation.outcome {
                        faults.iter().for_each(|fault| drop(fault.render("paper.tex", &source, false)));
                    }
                }
            }
        }
    }
}

#[test]
fn a_wrong_number_of_digits_is_taken() {
    for formula in ["x \\approx 0.5 %carom digits 3", "x \\approx 1234 %carom digits 3", "x \\approx 0 %carom digits 1"]
    {
        let fault = read(formula).expect_err(formula);
        assert!(fault.message().contains("significant digits"), "{formula}: {}", fault.message());
    }
    let shared = paper("%carom digits 3\n\\[ 1 = 1 \\]").expect("a paper");
    assert!(shared.faults[0].message().contains("`digits` is no clause here"));
}

#[test]
fn a_marked_formula_in_running_text_is_passed_over() {
    let source = format!(
        "{DECLARED}Since $a = b$ and\n\\(b = c\\), %carom inline assume step\nwe find $a = \n c$. %carom inline claim end\n\
         Not this: $c = a$.\n$a = b$ and $b = a$ %carom inline\nno formula %carom inline\n"
    );
    let found = paper(&source).unwrap();
    assert_eq!(found.inline, 4);
    let list = &found.equations;
    assert_eq!(list.len(), 4, "{list:?}");
    assert!(matches!(list[0].outcome, Outcome::Used("hypothesis")), "{:?}", list[0]);
    let Outcome::Read(claim) = &list[1].outcome else { panic!("{:?}", list[1]) };
    let line = source[..list[1].span.start].matches('\n').count() + 1;
    assert_eq!((claim.name.text.as_str(), line, &list[1].number), ("end", 5, &None));
    assert_eq!(Style::Text.prop(claim.written_goal()), "a = c");
    for (equation, says) in
        [(&list[2], "more than one formula ends on this line"), (&list[3], "no formula in running text")]
    {
        let Outcome::NotRead(faults) = &equation.outcome else { panic!("{equation:?}") };
        assert!(faults[0].message().contains(says), "{}", faults[0].message());
        assert_eq!(&source[faults[0].span.start..faults[0].span.end], "inline");
    }
}

#[test]
fn a_comment_is_ignored_in_silence() {
    let words = "skip let assume prove by claim expect given define name comma pm digits e d product remark log continues begins number source \
                 section reading note using sample";
    let whole = [
        "assume",
        "assume step",
        "let",
        "prove",
        "by algebra",
        "expect refuted",
        "comma and",
        "pm interval",
        "digits 3",
        "e is base",
        "log is natural",
        "d is number",
        "product b",
        "remark",
        "continues",
        "begins",
        "name b_1 as b1",
        "claim one \"One\"",
        "number 3",
        "note \"x\"",
        "using eq19",
        "source \"x\"",
        "prove a = b",
        "reading as printed",
        "sample a = 1",
    ];
    let said = |comments: &str| {
        let source = format!("{DECLARED}\\begin{{equation}} x = 0.500\n{comments}\n\\end{{equation}}\n\\[ a = a \\]");
        let found = paper(&source).unwrap_or_else(|faults| panic!("{comments}: {faults:?}"));
        format!("{:?}", found.equations)
    };
    let known: Vec<&str> = words.split_whitespace().collect();
    for clause in whole {
        let word = clause.split(' ').next().unwrap_or_default();
        assert!(known.contains(&word), "{word}");
        // The name of what a definition defines is declared already.
        assert_eq!(said(&format!("%carom {clause}")).contains("NotRead"), clause == "let", "{clause}");
        for rest in [" , but rubbish", "; m > 0", "\n%carom but rubbish", "\n%carom= 1"] {
            assert!(said(&format!("%carom {clause}{rest}")).contains("NotRead"), "{clause}{rest}");
        }
    }
    for clause in [
        "begin",
        "end",
        "name b_1 as b1",
        "comma and",
        "pm or",
        "e is base",
        "d is number",
        "product b",
        "remark",
        "log is decimal",
    ] {
        for rest in [" but rubbish", "; m > 0", "\n%carom but rubbish"] {
            let found = paper(&format!("%carom begin\n%carom {clause}{rest}\n\\[ 1 = 1 \\]")).expect("a paper");
            assert!(!found.faults.is_empty(), "{clause}{rest}");
        }
    }
    for twice in [
        "assume\n%carom let",
        "skip x\n%carom assume",
        "by algebra\n%carom by algebra",
        "expect refuted\n%carom expect proved",
        "let\n%carom by algebra",
        "assume\n%carom expect refuted",
        "claim b \"\"\n%carom claim c \"\"",
    ] {
        assert!(said(&format!("%carom {twice}")).contains("NotRead"), "{twice}");
    }
    for source in ["%caromgiven a real\n\\[ 1 = 1 \\]", "%carom, given a real\n\\[ 1 = 1 \\]"] {
        assert!(!paper(source).expect("a paper").faults.is_empty(), "{source}");
    }
}
