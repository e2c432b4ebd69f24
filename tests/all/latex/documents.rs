//! Documents: what LaTeX reaches, what its macros mean, which rows are one equation, which names are missing.

use carom::claim::print::Style;
use carom::latex::{Outcome, Paper, latex_of, paper};

fn read(text: &str) -> Paper {
    paper(text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// The equations, each as it was read, or as the first fault's message.
fn said(found: &Paper) -> Vec<String> {
    let one = |outcome: &Outcome| match outcome {
        Outcome::Read(claim) => Style::Text.prop(claim.written_goal()),
        Outcome::Used(what) => (*what).to_string(),
        Outcome::Skipped(reason) => format!("skipped: {reason}"),
        Outcome::NotRead(faults) => format!("not read: {}", faults[0].message()),
        Outcome::Waits(_) => "waits".to_string(),
    };
    found.equations.iter().map(|equation| one(&equation.outcome)).collect()
}

#[test]
fn what_does_not_print_is_read() {
    for text in [
        "\\iffalse \\[ x = 1 \\] %carom assume\n\\fi \\[ x = x \\]",
        "\\iffalse \\ifx\\a\\b \\[ x = 1 \\] %carom assume\n\\fi \\fi \\[ x = x \\]",
        "\\iffalse \\[ x = 1 \\] \\else \\[ x = x \\] \\fi",
        "\\[ x = x \\] \\end{document} \\[ x = 1 \\]",
        "\\iftrue \\[ x = x \\] \\else \\[ x = 1 \\] %carom assume\n\\fi",
        "\\begin{filecontents}{x}\\[ x = 1 \\]\\end{filecontents}\\[ x = x \\]",
        "% %carom assume x = 1\n%%carom assume x = 1\n\\[ x = x \\]",
        "\\begin{comment}\n%carom assume x = 1\n\\[ x = 1 \\]\\end{comment}\\[ x = x \\]",
    ] {
        let found = read(&format!("%carom given x real\n{text}\n"));
        assert_eq!(said(&found), ["x = x"], "{text}");
        let Outcome::Read(claim) = &found.equations[0].outcome else { panic!() };
        assert_eq!(claim.written_items().len(), 1, "{text}: {claim:?}");
    }
    for markdown in [
        "<!--\n$$ x = 2 $$\n-->\n<!-- <!-- carom assume x = 1 -->\n$$ x = x $$\n",
        "    $$ x = 2 $$\n\nText\n\n\t$$ x = 2 $$\n\n- item\n\n  $$ x = x $$\n\n      $$ x = 2 $$\n",
        "````\n```\n$$ x = 2 $$\n```math\nx = 2\n```\n````\n~~~\n$$ x = 2 $$\n```\n~~~\n$$ x = x $$",
        "> ```\n> $$ x = 2 $$\n> ```\n>     $$ x = 2 $$\n\n> $$ x\n> = x $$",
        "``a ` $$ x = 2 $$`` and `b\n$$ x = 2 $$` and a lone ` $$ x = x $$",
    ] {
        assert_eq!(
            said(&read(&latex_of(&format!("<!-- carom given x real -->\n{markdown}")))),
            ["x = x"],
            "{markdown}"
        );
    }
}

#[test]
fn a_comment_in_markdown_is_passed_over() {
    for comments in [
        "<!-- carom given x > 0\n  ; y > 0\nassume x > 1 -->",
        "<!--carom given x, y > 0--><!-- carom: assume x > 1 -->",
        "<!--\ncarom given x, y > 0\nassume x > 1\n-->",
        "> <!-- carom given x, y > 0\n> assume x > 1 -->",
        "%carom given x, y > 0\n<!-- %carom assume x > 1 -->",
        "<!-- carom given x, y > 0 -->\nSince $x > 1$, <!-- carom inline assume -->",
    ] {
        let latex = latex_of(&format!("{comments}\n\n$$ x y > y $$ <!-- carom claim last -->\n"));
        let found = read(&latex);
        let Some(Outcome::Read(claim)) = found.equations.last().map(|e| &e.outcome) else {
            panic!("{latex}: {found:?}")
        };
        assert_eq!((claim.name.text.as_str(), claim.written_items().len()), ("last", 2), "{comments}");
    }
    for comments in ["<!-- caromgiven x > 0 -->", "<!--carom giben x > 0 -->", "<!-- carom given x > 0\nwhatever -->"] {
        assert!(!read(&latex_of(&format!("{comments}\n$$ 1 = 1 $$"))).faults.is_empty(), "{comments}");
    }
}

#[test]
fn a_function_is_something_else_than_its_formula_says() {
    let rows = |text: &str| {
        said(&read(&format!(
            "%carom given t, a, b, v_0, c real; n natural\n{}",
            text.replace("; ", "\\]\n\\[").replace('<', "\\[") + "\\]"
        )))
    };
    for (text, wanted) in [
        ("<v(t) = v_0 + a t; v(0) = v_0; v(2t) = a", &["definition", "v(0) = v_0", "v(2*t) = a"] as &[&str]),
        ("<v(t) = v_0 + a t; v(t) = a", &["definition", "v(t) = a"]),
        (
            "<v(s) = a s; v'(t) = a; \\frac{dv}{dt} = a",
            &["definition", "derivative(v(t), t) = a", "derivative(v(t), t) = a"],
        ),
        ("<p(t) = a t = b t; p(a) = 1", &["a*t = b*t", "p(a) = 1"]),
        ("<f(x, y) = x - y; f(a, b) = a - b", &["definition", "f(a, b) = a - b"]),
        ("<S(n) = \\sum_{k=1}^{n} k; S(2) = 3", &["definition", "S(2) = 3"]),
    ] {
        assert_eq!(rows(text), wanted, "{text}");
    }
    for text in [
        "<E(t) = a b",
        "<\\dot y(t) = a t",
        "<f'(x) = 2 x",
        "<mv(t) = a t",
        "<O(t) = t",
        "<\\delta(t) = t",
        "<e(s) = 1 - s",
        "<q(t) = a t %carom prove\n",
        "<q(0) = a",
        "<q(a t) = a t",
        "<q(t, t) = t",
        "<q(t) > t",
        "<1 + q(t) = t",
        "<q(t) = q(0) + t",
        "<\\mathrm{sin}(s) = s/2",
        "<v(t) = a t; v_n = 1",
        "<x(t) = a t; x = 1",
    ] {
        let found = rows(text);
        assert!(found.last().is_some_and(|last| last.starts_with("not read")), "{text}: {found:?}");
    }
    // What is said of a function before its formula may be what the formula follows from.
    let found = rows("<u(0) = 1; u(t) = 1 + a t; u(0) = 1");
    assert!(found.iter().all(|said| said.starts_with("not read")), "{found:?}");
}

#[test]
fn a_value_of_a_function_is_taken_for_another_or_for_a_constant() {
    let rows = |text: &str| {
        let names = "%carom name v(t) as v_now\n%carom name v(0) as v_start\n%carom given m, a, t, s, v_now, v_start real; n natural\n";
        said(&read(&format!("{names}\\[ {text} \\]")))
    };
    for (text, wanted) in [
        ("m v(t) = v(0)", "m*v_now = v_start"),
        ("v(t) = v(0) + a t", "v_now = v_start + a*t"),
        ("v \\left( t \\right)^2 (a + t) = 1", "v_now^2*(a + t) = 1"),
    ] {
        assert_eq!(rows(text), [wanted], "{text}");
    }
    for text in [
        "v(s) = a",
        "v(2t) = a",
        "v = a",
        "v'(t) = a",
        "\\frac{d v(t)}{dt} = a",
        "\\frac{d}{dt} (t v(t)) = a",
        "\\sum_{t=1}^{n} v(t) = a",
        "\\int_0^1 t v(t) dt = a",
        "q(t) = t v(t)",
        "v(t) := a t",
        "v(t) > 0 \\quad \\text{for all } t > 0",
        "\\forall t > 0: v(t) > 0",
        "\\lim_{t \\to \\infty} v(t) = a",
        "q := m v(t) \\] \\[ \\frac{d}{dt} (q t) = a",
        "\\text{maximum of } v(t) \\text{ over } t > 0 \\text{ is } a",
        "v(t) = a %carom given v real\n",
    ] {
        let found = rows(text);
        assert!(found.last().is_some_and(|last| last.starts_with("not read")), "{text}: {found:?}");
    }
}

#[test]
fn a_formula_that_is_broken_may_be_passed_over_with_its_hypothesis() {
    for (text, wanted) in [
        ("\\[ {a = b %carom skip why\n\\] \\[ 1 = 1 \\]", &["skipped: why", "1 = 1"] as &[&str]),
        ("\\[ {a = b %carom assume\n\\] \\[ 1 = 1 \\]", &["not read", "waits"]),
        ("\\[ {a = b \\] %carom assume\n\\[ 1 = 1 \\]", &["not read", "waits"]),
        ("\\begin{align} {a = b %carom skip\n\\\\ a = a \\end{align} \\[ 1 = 1 \\]", &["not read", "1 = 1"]),
        ("\\begin{numcases}{a} b %carom assume\n\\end{numcases} \\[ 1 = 1 \\]", &["not read", "waits"]),
        ("\\ifdraft \\[ a = b \\] %carom assume\n\\fi \\[ 1 = 1 \\]", &["not read", "waits"]),
        ("%carom inline assume\n\\[ 1 = 1 \\]", &["not read", "waits"]),
        ("\\input{macros} \\[ 1 = 1 \\]", &["not read", "waits"]),
        ("Since $a %carom assume a = b\n= b$, \\[ 1 = 1 \\]", &["not read", "waits"]),
        ("\\newcommand{\\x}{a %carom given c real\n} \\[ 1 = 1 \\]", &["not read", "waits"]),
    ] {
        let found = said(&read(&format!("%carom given a, b real\n{text}")));
        let short: Vec<&str> =
            found.iter().map(|said| if said.starts_with("not read") { "not read" } else { said }).collect();
        assert_eq!(short, wanted, "{text}");
    }
}

#[test]
fn an_alias_of_a_macro_takes_no_argument() {
    let define = "\\newcommand{\\p}[1][7]{x + #1}\\newcommand{\\q}{\\p}\\newcommand{\\r}{2 \\p}";
    for (formula, wanted) in [
        ("\\q[2] = \\q", "x + 2 = x + 7"),
        ("\\r = 1", "2*x + 7 = 1"),
        ("\\r[2] = 1", "not read: \\p may take what stands behind another macro"),
    ] {
        assert_eq!(said(&read(&format!("%carom given x real\n{define}\\[ {formula} \\]"))), [wanted], "{formula}");
    }
}

#[test]
fn a_box_around_an_equation_with_its_cells_hides_it() {
    let found =
        said(&read("%carom given a, b real\n\\begin{align*} \\Aboxed{a &= b} \\\\ \\Aboxed{b &= a}. \\end{align*}"));
    assert_eq!(found, ["a = b", "b = a"]);
    let found = said(&read("%carom given a, b real\n\\begin{align*} \\Aboxed{a &= b} + 1 \\end{align*}"));
    assert!(found[0].starts_with("not read"), "{found:?}");
}

#[test]
fn a_formula_between_macros_vanishes() {
    for (macros, formula) in [
        ("\\newcommand{\\be}{\\begin{equation}}\\newcommand{\\ee}{\\end{equation}}", "\\be x = 2 x \\ee"),
        ("\\def\\be{\\begin{align}}\\def\\ee{\\end{align}}", "\\be x &= 2 x \\ee"),
        ("\\newcommand{\\eq}[1]{\\begin{equation}#1\\end{equation}}", "\\eq{x = 2 x}"),
        ("\\newcommand{\\open}{\\begin}\\newcommand{\\be}{\\open{equation}}", "\\be x = 2 x \\end{equation}"),
        ("", "\\begin{IEEEeqnarray}{rCl} x &=& 2 x \\end{IEEEeqnarray}"),
        ("", "\\begin{dmath} x = 2 x \\end{dmath}"),
    ] {
        let found =
            read(&format!("%carom given x real\n{macros}\n{formula}\n\\begin{{equation}} x = x \\end{{equation}}"));
        assert_eq!(said(&found), ["x = 2*x", "x = x"], "{formula}");
        let numbers: Vec<_> = found.equations.iter().map(|equation| equation.number.as_deref()).collect();
        assert_eq!(numbers, [Some("1"), Some("2")], "{formula}");
    }
    let found = read("\\newif\\ifdraft \\ifdraft \\[ 1 = 2 \\] \\fi \\[ 2 = 2 \\]");
    assert_eq!(said(&found), ["not read: what stands in this condition may not print", "2 = 2"]);
    let found = read("\\begin{empheq}{align} 1 = 1 \\end{empheq} \\[ 2 = 2 \\]");
    assert_eq!(said(&found), ["not read: the environment empheq is not read", "2 = 2"]);
}

#[test]
fn a_macro_reaches_beyond_its_group() {
    let define = "%carom given x real\n\\newcommand{\\one}{2}";
    for (text, wanted) in [
        ("{\\renewcommand{\\one}{1}} \\[ x = \\one x \\]", "x = 2*x"),
        ("\\begingroup\\renewcommand{\\one}{1}\\endgroup \\[ x = \\one x \\]", "x = 2*x"),
        ("\\begin{center}\\renewcommand{\\one}{1}\\end{center} \\[ x = \\one x \\]", "x = 2*x"),
        ("\\begin{center}\\renewcommand{\\one}{1} \\[ x = \\one x \\]\\end{center}", "x = 1*x"),
        ("{\\gdef\\one{1}} \\[ x = \\one x \\]", "x = 1*x"),
        ("\\let\\two=\\one \\renewcommand{\\one}{1} \\[ x = \\two x \\]", "x = 2*x"),
        // As an argument without braces a macro is one, whatever it stands for.
        ("\\newcommand{\\xx}{3x} \\[ x = \\frac\\xx{7} + \\frac{1}\\xx \\]", "x = 3*x/7 + 1/(3*x)"),
    ] {
        assert_eq!(said(&read(&format!("{define}\n{text}"))), [wanted], "{text}");
    }
}

#[test]
fn a_row_is_judged_without_the_rest_of_its_equation() {
    let rows =
        |text: &str| said(&read(&format!("%carom given a, b, c real\n\\begin{{align*}} {text} \\end{{align*}}")));
    for begin in
        ["\\phantom{=} +", "{} +", "\\hphantom{=} -", "\\mathrel{\\phantom{=}} +", "\\hspace{1em} \\cdot", "\\quad{} +"]
    {
        let found = rows(&format!("a &= b \\\\ &{begin} c"));
        assert!(found.len() == 1 && found[0].ends_with('c'), "{begin}: {found:?}");
    }
    let found = rows("a &= b \\\\ & (c + 1) \\\\ a &= a");
    assert!(found[0].starts_with("not read: the row below compares nothing"), "{found:?}");
    assert_eq!((found.len(), found[2].as_str()), (3, "a = a"), "{found:?}");
    // A box around an equation is no parenthesis.
    assert_eq!(rows("\\boxed{a = b} \\\\ \\boxed{b = a}"), ["a = b", "b = a"]);
    // A comment within an environment of rows belongs to its row.
    for inner in ["split", "aligned", "gathered"] {
        let rows = format!("\\begin{{{inner}}} a = b \\\\\n c = a %carom assume\n\\end{{{inner}}}");
        let found = said(&read(&format!("%carom given a, b, c real\n\\begin{{equation}} {rows} \\end{{equation}}")));
        assert_eq!(found, ["a = b", "hypothesis"], "{inner}");
    }
    for text in ["b = 2 \\\\ a = 6", "a = 6 \\\\ 1", "a = 6 \\\\ (b + c)"] {
        let found = said(&read(&format!("%carom given a, b, c real\n\\begin{{multline*}} {text} \\end{{multline*}}")));
        assert!(found.len() == 1 && found[0].starts_with("not read"), "{text}: {found:?}");
    }
}

#[test]
fn equations_that_need_no_unread_definition_wait_for_it() {
    let found = read("%carom given a, b real\n\\[ L := \\lim_{n \\to \\infty} n \\]\n\\[ a = b \\]\n\\[ L = a \\]\n");
    let found = said(&found);
    assert!(found[0].starts_with("not read"), "{found:?}");
    assert_eq!(found[1..], ["a = b", "waits"]);
    // A declaration behind it is not what the paper means.
    let found =
        said(&read("%carom given a real\n\\[ p := \\oint a \\]\n%carom given p real\n\\[ p = a \\]\n\\[ a = a \\]"));
    assert_eq!(found[1..], ["waits", "a = a"]);
    let found =
        said(&read("%carom given x_1, x_2 real\n\\[ \\Delta x := x_2 - x_1 \\]\n\\[ \\Delta x + x_1 = x_2 \\]"));
    assert_eq!(found[0], "definition");
    assert!(found[1].ends_with("+ x_1 = x_2"), "{found:?}");
}

#[test]
fn a_hypothesis_that_is_not_read_holds_nothing_back() {
    for formula in [
        "\\begin{align*} a &= b & b &= a %carom assume\n\\end{align*}",
        "\\begin{align*} a &= b \\\\ & \\Rightarrow b = a %carom assume\n\\end{align*}",
        "\\[ \\oint a = b \\] %carom assume",
    ] {
        let found = said(&read(&format!("%carom given a, b real\n{formula}\n\\[ a = b \\]")));
        assert_eq!(found.last().map(String::as_str), Some("waits"), "{formula}: {found:?}");
    }
}

#[test]
fn many_groups_and_macros_take_for_ever() {
    let mut text: String = (0..5000).map(|k| format!("\\newcommand{{\\m{}}}{{b}}", letters(k))).collect();
    text += &"{\\def\\xa{b}}".repeat(20_000);
    let begun = std::time::Instant::now();
    assert_eq!(said(&read(&format!("{text}\\[ 1 = 1 \\]"))), ["1 = 1"]);
    // Signs of code in Markdown, in pairs and alone, and comments.
    let alone: Vec<String> = (2..1000).map(|length| "`".repeat(length)).collect();
    for long in ["`a` ".repeat(100_000), "<!-- x -->".repeat(50_000), alone.join(" ")] {
        assert_eq!(said(&read(&latex_of(&format!("$$ 1 = 1 $$\n\n{long}")))), ["1 = 1"]);
    }
    assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
}

/// A number in letters.
fn letters(mut k: usize) -> String {
    let mut out = String::new();
    while k > 0 {
        out.push(char::from(b'a' + (k % 26) as u8));
        k /= 26;
    }
    out
}

#[test]
fn only_the_first_missing_name_is_said() {
    let found = read("%carom given a real\n\\[ a = b + f(c) \\]\n\\[ \\Delta x = v_1 c \\]\n");
    let names: Vec<&str> = found.undeclared.keys().map(String::as_str).collect();
    assert_eq!(names, ["\\Delta x", "b", "c", "f(…)", "v_{1}"]);
}

#[test]
fn two_equations_get_one_name() {
    let found = read(
        "\\begin{align} 1 &= 1 \\tag{2} \\\\ 2 &= 2 \\tag{2'} \\\\ 3 &= 3 \\tag{2} \\end{align} $$ 4 = 4 $$ $$ 5 = 5 $$",
    );
    let names: Vec<&str> = found.equations.iter().map(|equation| equation.name.as_str()).collect();
    assert_eq!(names, ["eq-2", "eq-2-prime", "eq-2-line-1", "line-1", "line-1-2"]);
    let found = read("\\begin{align} 1 &= 1 \\label{eq:a-b} \\\\ 2 &= 2 \\label{eq:a_b} \\end{align}");
    let names: Vec<&str> = found.equations.iter().map(|equation| equation.name.as_str()).collect();
    assert_eq!(names, ["a-b", "a-b-line-1"]);
}
