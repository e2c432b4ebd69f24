//! The claim language: what is printed reads back, and what is wrong is said where it is.

use carom::claim::format::format;
use carom::claim::parse::{parse, parse_bytes, parse_prop};
use carom::claim::print;
use carom::claim::syntax::*;
use proptest::prelude::*;

fn span() -> Span {
    Span::default()
}

fn e(kind: ExprKind) -> Expr {
    Expr { kind, span: span() }
}

fn name(text: &str) -> Name {
    Name { text: text.to_string(), span: span() }
}

/// Expressions as the parser builds them: sums and products flat, no sum in a sum without need.
fn expressions() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        prop::sample::select(vec!["0", "1", "2", "0.5", "2.5e-3"]).prop_map(|s| e(ExprKind::Number(s.to_string()))),
        prop::sample::select(vec!["m1", "x", "mu", "v_2"]).prop_map(|s| e(ExprKind::Name(s.to_string()))),
    ];
    leaf.prop_recursive(4, 40, 3, |inner| {
        let signs = prop_oneof![Just(Sign::Plus), Just(Sign::Minus)];
        let factors = prop_oneof![Just(Factor::Times), Just(Factor::Over)];
        prop_oneof![
            inner.clone().prop_map(|a| e(ExprKind::Negate(Box::new(a)))),
            (inner.clone(), prop::collection::vec((signs, inner.clone()), 1..3)).prop_map(|(a, rest)| {
                let mut list = vec![(Sign::Plus, a)];
                list.extend(rest);
                e(ExprKind::Sum(list))
            }),
            (inner.clone(), prop::collection::vec((factors, inner.clone()), 1..3)).prop_map(|(a, rest)| {
                let mut list = vec![(Factor::Times, a)];
                list.extend(rest);
                e(ExprKind::Product(list))
            }),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| e(ExprKind::Power(Box::new(a), Box::new(b)))),
            inner.clone().prop_map(|a| e(ExprKind::Apply(name("sqrt"), vec![a]))),
            (inner.clone(), inner.clone(), inner.clone()).prop_map(|(a, b, c)| {
                e(ExprKind::SumOver(Index { name: name("i"), from: Box::new(a), to: Box::new(b) }, Box::new(c)))
            }),
            (inner.clone(), inner).prop_map(|(a, b)| e(ExprKind::Matrix(vec![vec![a], vec![b]]))),
        ]
    })
}

proptest! {
    #[test]
    fn printed_expressions_read_back_as_the_same_tree(a in expressions(), b in expressions()) {
        let text = format!("{} <= {}", print::expr(&a), print::expr(&b));
        let prop = parse_prop(&text).unwrap_or_else(|f| panic!("{text}: {f:?}"));
        let PropKind::Compare(sides, _) = &prop.kind else { panic!("{text} is a comparison") };
        prop_assert!(sides[0].same(&a), "{} became {}", text, print::expr(&sides[0]));
        prop_assert!(sides[1].same(&b), "{} became {}", text, print::expr(&sides[1]));
    }

    #[test]
    fn no_bytes_make_the_parser_fail(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = parse_bytes(&bytes);
    }

    #[test]
    fn no_soup_of_tokens_makes_the_parser_fail(words in prop::collection::vec(prop::sample::select(vec![
        "claim", "given", "prove", "let", "assume", "using", "by", "have", "case", "x", "n", "1", "2.5", "(", ")", "{", "}",
        "=", "<=>", "=>", "and", "or", "not", "for all", "exists", "maximum of", "limit of", "in", "[", "]", ",", ";", ":",
        "+", "-", "*", "/", "^", "\"t\"", "\n", "natural", "> 0", "sum(i = 1..n, i)", "define u by", "->", "infinity", "is",
    ]), 0..60)) {
        let source = words.join(" ");
        if let Err(faults) = parse(&source) {
            for fault in faults {
                let _ = fault.render("soup.claim", &source, false);
            }
        }
    }

    #[test]
    fn formatting_is_idempotent(a in expressions()) {
        let source = format!("claim c \"t\"\ngiven m1, x, mu, v_2 > 0;  i natural\nlet y   =  {}   # why\nprove x=x\n", print::expr(&a));
        if let Ok(once) = format(&source) {
            prop_assert_eq!(format(&once).expect("it parses"), once.clone());
            prop_assert!(once.contains("# why"));
        }
    }
}

/// The first line of the first fault, and its place.
fn fault(source: &str) -> String {
    let faults = parse(source).expect_err("the source is faulty");
    let (line, column) = faults[0].place(source);
    let help = faults[0].help().map_or(String::new(), |h| format!(" ({h})"));
    format!("{line}:{column} {}{help}", faults[0].message())
}

#[test]
fn faults_are_said_where_they_are() {
    let with = |rest: &str| format!("claim c \"t\"\ngiven x, y > 0\n{rest}\n");
    let cases = [
        ("", "1:1 no claim found in this file (a claim begins with: claim NAME \"Title\")"),
        ("clam c \"t\"", "1:1 expected `claim`, found `clam` (did you mean `claim`?)"),
        (&with("prove (x + y = 1"), "4:1 expected `)` to close the parenthesis, found the end of the file"),
        (
            &with("given z > 0 for k in 1..3\nprove x = y"),
            "3:17 k is not the index of a family declared here (a range is for the index of a family: `mu(k) > 0 for k in 1..n`)",
        ),
        (&with("prove 2x = y"), "3:8 expected a comparison sign such as = or >=, found `x` (write 2*x)"),
        (
            &with("prove x == y"),
            "3:9 expected a comparison sign such as = or >=, found `==` (equality is written with one sign: a = b)",
        ),
        (
            &with("prove x**2 = y"),
            "3:8 expected a comparison sign such as = or >=, found `**` (powers are written a^b)",
        ),
        (&with("prove z = y"), "3:7 nothing declares the name z (did you mean x?)"),
        (&with("let a = x"), "1:7 claim c has no `prove` clause (add a line such as: prove a = b)"),
        (&with("given x > 1\nprove x = x"), "3:7 the name x is declared twice"),
        (&with("given e in [0, 1\nprove x = x"), "4:1 expected `]` or `)` to close the interval, found `prove`"),
        (&with("prov x = y"), "3:1 expected `;`, a clause or the end, found `prov`"),
        (&with("prove x(y) = y"), "3:7 x is no function (write x*(…) for a product)"),
        (
            &with("prove sqrt = y"),
            "3:7 nothing declares the name sqrt (declare it, for instance `given sqrt > 0` or `given sqrt real`)",
        ),
        (
            "claim c \"t\ngiven x > 0\nprove x = x",
            "1:9 this text has no closing quotation mark (texts stand on one line, between \"…\")",
        ),
    ];
    for (source, expected) in cases {
        if expected.contains("a clause or the end") {
            // The word could still belong to the clause before; the message names the clause's end.
            assert!(fault(source).contains("prov"), "{}", fault(source));
            continue;
        }
        assert_eq!(fault(source), expected, "{source}");
    }
}

#[test]
fn superfluous_parentheses_change_nothing() {
    let goal = |text: &str| {
        parse(&format!("claim c \"t\"\ngiven x, y > 0\nprove {text}\n")).expect("the claim is well-formed")[0]
            .goal
            .clone()
    };
    let plain = carom::claim::print::prop(&goal("not (x = y or x > 1)"));
    for text in ["not ((x = y or x > 1))", "(not (((x = y)) or (x > 1)))", "(((not (x = y or (x > 1)))))"] {
        assert_eq!(carom::claim::print::prop(&goal(text)), plain, "{text}");
    }
    assert_eq!(carom::claim::print::prop(&goal("(((x + 1))*y) = ((2))")), "(x + 1)*y = 2");
}

#[test]
fn several_faults_are_reported_in_one_run() {
    let source = "claim c \"t\"\ngiven x >\nlet y = 2x\nassume x = = y\nprove x = y\n";
    assert!(parse(source).expect_err("faulty").len() >= 3);
}

#[test]
fn deep_and_large_inputs_end_at_named_limits() {
    let deep = format!("claim c \"t\"\ngiven x > 0\nprove {}x{} = x\n", "(".repeat(100_000), ")".repeat(100_000));
    assert!(fault(&deep).contains("levels of nesting"));
    for opener in ["not ", "-", "x^(", "(not "] {
        let source = format!("claim c \"t\"\ngiven x > 0\nprove {}\n", opener.repeat(50_000));
        assert!(parse(&source).is_err());
    }
    let numeral = format!("claim c \"t\"\ngiven x > 0\nprove x = {}\n", "9".repeat(20_000));
    assert!(fault(&numeral).contains("digits of a numeral"));
    assert!(fault("claim c \"t\"\ngiven x > 0\nprove x = 1e999999999\n").contains("digits of a numeral"));
    let long: String = format!("claim c \"t\"\ngiven x > 0\nprove x = {}x\n", "x + ".repeat(60_000));
    assert!(parse(&long).is_ok(), "a long flat sum is no deep tree");
    assert!(parse_bytes(b"claim c \"\xff\xfe\"").is_err());
}

#[test]
fn a_fault_in_one_clause_brings_no_other_with_it() {
    let source = "claim c \"t\"\ngiven x > 0\nassume x = = 1\nassume x = = 2\nprove x = x\n";
    assert_eq!(parse(source).expect_err("faulty").len(), 2);
    assert_eq!(parse("claim c \"t\"\ngiven x > 0\nprove x = = 1\n").expect_err("faulty").len(), 1);
}
