//! What papers of others print: each is read as it is meant, or refused with what decides.

use carom::claim::print::Style;
use carom::latex::{Outcome, Paper, latex_of, paper};
use proptest::prelude::*;

fn read(text: &str) -> Paper {
    paper(text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// What became of each equation: the statement, or the message and the help.
fn said(text: &str) -> Vec<String> {
    let found = read(text);
    assert!(found.faults.is_empty(), "{text}: {:?}", found.faults);
    let one = |outcome: &Outcome| match outcome {
        Outcome::Read(claim) => Style::Text.prop(claim.written_goal()),
        Outcome::Used(what) => (*what).to_string(),
        Outcome::Skipped(_) => "skipped".to_string(),
        Outcome::Waits(_) => "waits".to_string(),
        Outcome::NotRead(faults) => {
            format!("not read: {}; {}", faults[0].message(), faults[0].help().unwrap_or_default())
        }
    };
    found.equations.iter().map(|equation| one(&equation.outcome)).collect()
}

/// Each formula under its comments is read as this.
fn is_read(list: &[(&str, &str, &str)]) {
    for (comments, formula, wanted) in list {
        assert_eq!(said(&format!("{comments}\n\\[ {formula}\n\\]")), [*wanted], "{formula}");
    }
}

/// Each formula under its comments is refused, and the message with its help says this.
fn is_refused(list: &[(&str, &str, &str)]) {
    for (comments, formula, says) in list {
        let found = said(&format!("{comments}\n\\[ {formula}\n\\]"));
        assert!(
            found.len() == 1 && found[0].starts_with("not read") && found[0].contains(says),
            "{formula}: {found:?}"
        );
    }
}

#[test]
fn a_quantifier_forgets_that_its_name_is_natural() {
    let n = "%carom given n natural";
    let least = "%carom given n natural >= 1";
    is_read(&[
        (n, r"\exists n > 0: n^2 = 2", "exists n natural > 0: n^2 = 2"),
        (n, r"n^2 \ge n \quad \text{for all } n \ge 0", "for all n natural >= 0: n^2 >= n"),
        (n, r"\forall n: n \ge 0", "for all n natural: n >= 0"),
        (least, r"n \ge 1 \quad \text{for all } n", "for all n natural >= 1: n >= 1"),
        (least, r"\forall n > 0: n \ge 1", "for all n natural > 0: n >= 1"),
        (
            n,
            r"\text{minimum of } n^2 \text{ over } n \ge 0 \text{ is } 0",
            "(for all n natural >= 0: n^2 >= 0) and (exists n natural >= 0: n^2 = 0)",
        ),
        ("%carom given n natural; x real", r"\forall x, n > 0: x n > 0", "for all x > 0; n natural > 0: x*n > 0"),
        (
            "%carom given x, y real",
            r"x^2 + y^2 \ge 2xy \quad \text{for all } x, y",
            "for all x, y real: x^2 + y^2 >= 2*x*y",
        ),
        ("%carom given x > 0", r"\forall x \in \mathbb{R}: x^2 \ge 0", "for all x real: x^2 >= 0"),
        (n, r"\forall n \in \mathbb{N}: n \ge 0", "for all n natural: n >= 0"),
        ("%carom given x > 0", r"\forall x > 1: x > 0", "for all x > 1: x > 0"),
    ]);
    is_refused(&[
        (least, r"\forall n \ge 0: n \ge 1", "the domain of n may be read in two ways"),
        ("%carom given x > 0", r"\exists x < 1: x < 0", "%carom prove for all x real > 0"),
        ("%carom given x real\n%carom assume x > 0", r"\exists x < 1: x < 0", "the domain of x"),
        ("%carom given k integer", r"\exists k > 0: k < 1", "declared as an integer"),
        ("%carom let w = 2", r"\forall w > 0: w > 0", "w is defined"),
        ("", r"\exists n > 0: n^2 = 2", "%carom given n natural"),
        ("", r"\forall x: x = x", "nothing says which values x takes"),
        ("%carom given x real", r"\forall x \in \mathbb{N}: x \ge 0", "the numbers 0, 1, 2"),
        (n, r"\exists n > 1: n > 2 \text{ for all } n", "one value for all"),
    ]);
}

#[test]
fn a_member_of_a_family_is_a_constant() {
    let a = "%carom given a_i, a_n, L real; n natural; i natural";
    is_refused(&[
        (a, r"\sum_{i=1}^{n} a_i = n a_i", "a_{i} depends on i"),
        (a, r"\sum_{i=1}^{n} a_{2 i} = n", "given a(k) real"),
        (a, r"\sum_{i=1}^{n} \bar{a_i} = n", "depends on i"),
        (a, r"a_n > 0 \quad \text{for all } n \ge 1", "a_{n} depends on n"),
        (a, r"\lim_{n \to \infty} a_n = L", "a_{n} depends on n"),
        (a, r"\prod_{i=1}^{n} a_i = 1", "depends on i"),
        (a, r"f(i) := a_i", "depends on i"),
    ]);
    is_read(&[
        ("%carom given a(k) real; n natural", r"\sum_{i=1}^{n} a_i = 1", "sum(i = 1..n, a(i)) = 1"),
        (
            r"%carom given a_{\mathrm{min}}, n natural",
            r"\sum_{i=1}^{n} a_{\mathrm{min}} = 1",
            "sum(i = 1..n, a_min) = 1",
        ),
        (
            "%carom name a_i as b(i)\n%carom given b(k) real; n natural",
            r"\sum_{i=1}^{n} a_i = 1",
            "sum(i = 1..n, b(i)) = 1",
        ),
    ]);
}

#[test]
fn a_vector_is_a_number() {
    let v = r"%carom given \vec{a}, \vec{b}, \mathbf{p} real; s, t, x real";
    is_refused(&[
        (v, r"\vec a^2 = \vec b^2", "a power of a vector"),
        (v, r"|\vec a + \vec b| = |\vec a| + |\vec b|", "the length of a sum"),
        (v, r"t = \frac{2\vec a}{\vec b}", "a quotient by a vector"),
        (v, r"\vec a = 2\vec b\frac{2\vec a}{t}", "a product of vectors"),
        (v, r"\sin\vec a = x", "a function of a vector"),
        (v, r"\sqrt{\vec a} = x", "a root of a vector"),
        (v, r"\vec a > \vec b", "an order of vectors"),
        (v, r"\vec a = \vec b \text{ or } \vec a = -\vec b", "`or`"),
        (v, r"\exists s > 0: s \vec a = \vec b", "`exists`"),
        (v, r"\vec a = \vec b \Rightarrow |\vec a| = |\vec b|", "the length of a vector beside vectors"),
        (v, r"q := s \vec a", "an unmarked name"),
        (v, r"x = s \vec a %carom assume", "a vector beside a number"),
        (r"%carom given \vec{a}(k) real; n natural", r"\vec a_n^2 = 1", "a power of a vector"),
    ]);
    is_read(&[
        (v, r"s\vec a = \frac{\vec a}{2} - t \vec b", "s*vec_a = vec_a/2 - t*vec_b"),
        (v, r"\vec{a} + \vec{b} = \vec{0}", "vec_a + vec_b = 0"),
        (v, r"x^2 = |\mathbf{p}|^2 t^2", "x^2 = abs(mathbf_p)^2*t^2"),
        (
            r"%carom name \vec v as v
%carom given v real",
            r"\vec v^2 = 1",
            "v^2 = 1",
        ),
    ]);
    // A length in what is supposed, beside a vector in what is judged.
    let found = said(&format!("{v}\n\\[ |\\vec a| = |\\vec b| \\] %carom assume\n\\[ \\vec a = \\vec b \\]"));
    assert!(found[1].contains("beside vectors"), "{found:?}");
}

#[test]
fn a_unit_is_a_product_of_names() {
    let names = "%carom given c, m, k, s, g, x, b, v real";
    is_refused(&[
        (names, r"x = 2.42\cdot 10^{-10}\; cm", "the unit cm"),
        (names, r"v = 11km/s", "the unit km/s"),
        (names, r"v = 11 km", "the unit km"),
        (names, r"v = 2.5\,m", "the unit m"),
        (names, r"v = 3\;m/s", "the unit m/s"),
        (names, r"v = 5\,kg \cdot m/s", "the unit kg*m/s"),
    ]);
    is_read(&[
        (names, r"x = 2 m v", "x = 2*m*v"),
        (names, r"x = 2\,m v", "x = 2*m*v"),
        (names, r"x = 2mg", "x = 2*m*g"),
        (names, r"b^2 = 4km", "b^2 = 4*k*m"),
        (names, r"x = \frac{1}{2}\,kx^2", "x = 1/2*k*x^2"),
        (names, r"x = 2\,mg\sin v", "x = 2*m*g*sin(v)"),
        (names, r"x = \frac{99}{101} \, m", "x = 99/101*m"),
        (names, r"x = 10 \cdot k m", "x = 10*k*m"),
    ]);
}

#[test]
fn a_differential_is_a_product() {
    let names = "%carom given d, g, k, t, v real";
    is_refused(&[
        (names, r"\frac{dv}{g + kv^2} = -dt", "a d before a name"),
        (names, r"d\vec{r} = 1", "a differential"),
        ("%carom given g, k, t, v real", r"dv = g dt", "a differential"),
        ("%carom given W, F, x real", r"\delta W = F \delta x", "a small change"),
    ]);
    is_read(&[
        (names, r"2 g d = v^2", "2*g*d = v^2"),
        ("%carom name \\delta W as dW\n%carom given dW, v real", r"\delta W = v", "dW = v"),
        ("%carom d is number\n%carom given d, g, v real", r"2dg = v^2", "2*d*g = v^2"),
    ]);
    assert!(read(r"\[ \frac{dv}{g} = -dt \]").offered.iter().all(|clause| !clause.contains(" d")));
}

#[test]
fn an_upper_index_is_a_power() {
    let names = r"%carom given p, p_{\mu}, \mu, m, g, g_j, u_n, q, n, j real";
    is_refused(&[
        (names, r"p^\mu p_\mu = m^2", "an upper index"),
        (names, r"m p_\mu = g^\mu", "an upper index"),
        (names, r"p^j g_j = m", "an upper index"),
        (names, r"p^{nj} g_j = m", "an upper index"),
    ]);
    let found = said(&format!("{names}\n\\[ m = (p^\\mu)^2 \\] \\[ p_\\mu = m \\]"));
    assert!(found[0].contains("an upper index"), "{found:?}");
    is_read(&[
        (
            r"%carom name p_\mu as pm
%carom given p, pm, \mu real",
            r"p^\mu = p_\mu",
            "p^mu = pm",
        ),
        (names, r"u_n = q^n m", "u_n = q^n*m"),
        ("%carom given a(k), x real; n natural", r"\sum_{k=0}^{n} a_k x^k = 1", "sum(k = 0..n, a(k)*x^k) = 1"),
    ]);
}

#[test]
fn an_environment_of_markdown_is_passed_over() {
    for text in [
        "\\begin{align}\nx &= y \\\\\ny &= x\n\\end{align}",
        "$$\n\\begin{align*}\nx &= y \\\\\ny &= x\n\\end{align*}\n$$",
        "$$\\begin{gather} x = y \\\\ y = x. \\end{gather}.$$",
        "\\begin{equation*} x = y \\end{equation*} and\n> \\begin{equation}\n> y = x\n> \\end{equation}",
        "`\\begin{equation} x = 1 \\end{equation}` $$ x = y $$\n\n    \\begin{equation} x = 1 \\end{equation}\n\n$$ y = x $$",
        "```\n\\begin{equation} x = 1 \\end{equation}\n```\n\\begin{align} x = y \\\\ y = x \\end{align}",
    ] {
        assert_eq!(
            said(&latex_of(&format!("<!-- carom given x, y real -->\n\n{text}\n"))),
            ["x = y", "y = x"],
            "{text}"
        );
    }
    let found = said("%carom given x, y real\n$$ %carom assume\n\\begin{align} x &= y \\\\ y &= x \\end{align} $$");
    assert_eq!(found, ["hypothesis", "y = x"]);
}

#[test]
fn what_is_offered_is_not_read() {
    for (formula, wanted) in [
        (r"P_{k+1} = P_k", "given k natural; P(j) real"),
        (r"\sum_{i=1}^{n} a_i = n", "given n natural; a(k) real"),
        (
            r"\gamma_{воз} = \vec{v'}_1",
            r"name \gamma_{воз} as gamma; name \vec{v'}_{1} as vec_v_1; given gamma, vec_v_1 real",
        ),
        (r"x = \Delta t", r"given \Delta t, x real"),
    ] {
        assert_eq!(read(&format!("\\[ {formula} \\]")).offered.join("; "), wanted, "{formula}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn an_offered_declaration_stops_the_paper(names in prop::collection::vec(prop::sample::select(vec![
        "a", "k", "P_{k+1}", "P_k", "\\mathrm{const.}", "\\vec{v'}_{1}", "\\vec{v}_1", "\\gamma_{воз}", "\\beta_{u'}", "\\Delta t''",
        "\\Delta t", "\\bar{x}", "x_{1,2}", "x_{12}", "x_1'", "x_+", "x_{-}", "v_{\\mathrm{max}}", "v_{max}", "\\mathbf{p}", "\\dot{q}", "N_A",
        "\\sum_{i=1}^{m} b_i", "\\hat{H}_{n-1}", "E_0^2", "\\mathcal{E}", "in", "\\ell", "real", "\\varepsilon_0", "f(x)", "{v'}_2", "d", "\\pi",
        "m_\\text{e}", "\\tilde a_{j+1}", "R_{\\odot}", "T^{*}", "\\Phi_\\text{in}", "given", "sum", "x1", "x_1",
    ]), 1..8)) {
        let text: String = names.iter().map(|name| format!("\\[ 1 = {name} \\]\n")).collect();
        let found = read(&format!("%carom e is base\n{text}"));
        let comments: String = found.offered.iter().map(|clause| format!("%carom {clause}\n")).collect();
        let again = read(&format!("%carom e is base\n{comments}{text}"));
        prop_assert!(again.faults.is_empty(), "{comments}: {:?}", again.faults);
        for key in found.undeclared.keys() {
            prop_assert!(!again.undeclared.contains_key(key) || key.ends_with("(…)"), "{key} of {comments}");
        }
    }
}

#[test]
fn what_is_printed_otherwise_is_refused() {
    let names = r"%carom given x, y, \sigma, \sigma_N, v_{up}, v_1', n, K, M, w, T, g, k, u real";
    is_read(&[
        (names, r"y = \> 2x", "y = 2*x"),
        (names, r"x^\frac{1}{2} = (x) ^ \frac12", "x^(1/2) = x^(1/2)"),
        (names, r"\sigma^2_N = x", "sigma_N^2 = x"),
        (names, r"(v_\text{up} + y) = x", "v_up + y = x"),
        (names, r"\ln\cosh\left(x\right) = y", "ln(cosh(x)) = y"),
        (names, r"{v'}_1 = x", "v_1' = x"),
        (names, r"(25)(50) \ge x", "25*50 >= x"),
        (names, r"2^{2(5) - 2} = x", "2^(2*5 - 2) = x"),
        (names, r"\int_{0}^{u} \frac{dv}{g + kv^2} = T", "integral(v = 0..u, 1/(g + k*v^2)) = T"),
        (names, r"\int_{0}^{u} -dt = T", "integral(t = 0..u, -1) = T"),
        ("%carom given k natural", r"{}^{2k}C_k < 4^k", "binomial(2*k, k) < 4^k"),
        (
            "%carom pm interval\n%carom given k real",
            r"k = 0.00243 \pm 6\cdot 10^{-5}",
            "0.00243 - 6e-5 <= k <= 0.00243 + 6e-5",
        ),
        (names, r"x = y \quad \checkmark", "x = y"),
        (
            names,
            r"R = K \left(\frac{M}{w}\right)^{2} %carom product K
%carom given R real",
            "R = K*(M/w)^2",
        ),
        (
            names,
            r"x = n2^{n-1} %carom product n
",
            "x = n*2^(n - 1)",
        ),
        (
            names,
            r"x = y \quad \text{(shown)} %carom remark
",
            "x = y",
        ),
        (names, r"x = y \tag 8", "x = y"),
    ]);
    is_refused(&[
        (names, r"x = 2(6)", "a measured value"),
        (names, r"\int_{0}^{u} \frac{dv}{g} \frac{1}{v} = T", "how far this integral reaches"),
        ("%carom pm interval\n%carom given k real", r"k = 1.40 \pm 5.7\cdot 10^{-4}", "a power of ten behind ±"),
        (names, r"{}^{14}C = x", "an index at the left"),
        (names, r"\left[ x^2 \right]_{u}^{T} = 1", "the two values"),
        (names, r"x = \square", r"\square is not read"),
        (
            names,
            r"x = y \quad \text{(reject, } x > 0 \text{)} %carom remark
",
            "the words",
        ),
        (
            names,
            r"x = y \quad \text{if small} %carom remark
",
            "the words",
        ),
        (names, r"x = y \quad \text{(shown)}", "%carom remark"),
    ]);
    let titles = "\\begin{eqnarray}\n\\textrm{density ratio,}&\\qquad& x = y;\\\\\n\\textrm{mass ratio,}&\\qquad& y = x.\n\\end{eqnarray}";
    assert_eq!(said(&format!("%carom remark\n%carom given x, y real\n{titles}")), ["x = y", "y = x"]);
    let found = read("%carom given x real\n\n$$ \\hspace{1cm} $$");
    let Outcome::NotRead(faults) = &found.equations[0].outcome else { panic!("{found:?}") };
    assert_eq!(
        (faults[0].message().as_str(), faults[0].place("%carom given x real\n\n$$").0),
        ("this formula is empty", 3)
    );
}

#[test]
fn a_name_of_several_signs_is_taken_apart() {
    let names = "%carom name \\Sigma F as Fnet\n%carom name \\sum F_x as Fx\n%carom name E[X] as EX\n%carom name \\langle v\\rangle as vbar\n\
                 %carom given Fnet, Fx, EX, vbar, m, a, x real";
    is_read(&[
        (names, r"\Sigma F = m a", "Fnet = m*a"),
        (names, r"\sum F_{x} = 2\sum F_x^2", "Fx = 2*Fx^2"),
        (names, r"E \left[ X \right]^2 = 1", "EX^2 = 1"),
        (names, r"\left\langle v\right\rangle = \langle  v  \rangle^2", "vbar = vbar^2"),
    ]);
    is_refused(&[
        (names, r"\Sigma F_M = m", "nothing declares"),
        (names, r"\sum F_x m = a", "a part of what the sign is over"),
        (names, r"\langle x \rangle = a", "%carom name"),
    ]);
    for comment in ["name \\langle v as x1", "name ( as x1", "name a = b as x1", "name E[X as x1"] {
        assert!(!read(&format!("%carom {comment}\n\\[ 1 = 1 \\]")).faults.is_empty(), "{comment}");
    }
}

#[test]
fn a_member_of_a_family_is_called_pi() {
    let found = read("%carom given a(j) real; n natural\n\\[ a_n = a_{n-1} \\]");
    let names: Vec<&str> = found.names.iter().map(|name| name.1.as_str()).collect();
    assert_eq!(names, ["a(n - 1)", "a(n)", "n"]);
}
