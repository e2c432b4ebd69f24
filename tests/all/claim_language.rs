//! The claim language: what is printed reads back, and what is wrong is said where it is.

use crate::support::{text, with_input};
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
        prop_assert!(sides[0] == a, "{} became {}", text, print::expr(&sides[0]));
        prop_assert!(sides[1] == b, "{} became {}", text, print::expr(&sides[1]));
    }

    #[test]
    fn what_is_printed_with_signs_reads_back_as_the_same_tree(a in expressions(), b in expressions()) {
        let text = format!("{} ≤ {}", print::Style::Unicode.expr(&a), print::Style::Unicode.expr(&b));
        let prop = parse_prop(&text).unwrap_or_else(|f| panic!("{text}: {f:?}"));
        let PropKind::Compare(sides, _) = &prop.kind else { panic!("{text} is a comparison") };
        for (side, printed) in sides.iter().zip([&a, &b]) {
            // In print an index has no underscore.
            let expected = print::expr(printed).replace("v_2", "v2");
            prop_assert_eq!(print::expr(side), expected, "{}", text);
        }
    }

    #[test]
    fn no_bytes_make_the_parser_fail(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = parse_bytes(&bytes);
    }

    #[test]
    fn no_soup_of_tokens_makes_the_parser_fail(words in prop::collection::vec(prop::sample::select(vec![
        "claim", "given", "prove", "let", "assume", "using", "by", "have", "case", "x", "n", "1", "2.5", "(", ")", "{", "}",
        "=", "<=>", "=>", "and", "or", "not", "for all", "exists", "maximum of", "limit of", "in", "[", "²", "⁻¹", "√", "m₁", "]", ",", ";", ":",
        "+", "-", "*", "/", "^", "\"t\"", "\n", "natural", "> 0", "sum(i = 1..n, i)", "define u by", "->", "infinity", "is",
        "mod", "iff", "forall", "there", "max of", "lim", "prime(", "positive", "e", "exists!", "∀", "ℝ", "½", "&&", "|", "<>", ":=", "sin²",
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
        ("given x > 0\nprove x > 0", "2:1 expected `claim`, found `prove` (a claim begins with: claim NAME \"Title\")"),
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
        (
            &with("prove z = y"),
            "3:7 nothing declares the name z (declare it, for instance `given z > 0` or `given z real`)",
        ),
        (
            &with("prove sum(k = 1..infinity, 1/k^2) < 2"),
            "3:18 this goes on to infinity (write it alone on one side of an equation, `sum(k = 0..infinity, f) = L`, or its limit: `limit of sum(k = 0..n, f) as n natural -> infinity is L`)",
        ),
        (
            &with("prove sum(k = 1..infinity, 0) = sum(k = 1..infinity, 0)"),
            "3:18 this goes on to infinity (write it alone on one side of an equation, `sum(k = 0..infinity, f) = L`, or its limit: `limit of sum(k = 0..n, f) as n natural -> infinity is L`)",
        ),
        (
            &with("given z > w, w > 0\nprove z > 0"),
            "3:11 the name w stands before its declaration (declare w first, as b in `given b > 0; a > b`, or write a chain: `given a > b > 0`)",
        ),
        (&with("let speed = x\nprove sped = y"), "4:7 nothing declares the name sped (did you mean speed?)"),
        (&with("let a = x"), "1:7 claim c has no `prove` clause (add a line such as: prove a = b)"),
        (
            &with("given x in (1, 2)\nprove x = x"),
            "3:7 the name x is declared twice (a name has one meaning at a place: give one of the two another name)",
        ),
        (&with("given e in [0, 1\nprove x = x"), "4:1 expected `]` or `)` to close the interval, found `prove`"),
        (&with("prov x = y"), "3:1 expected `;`, a clause or the end, found `prov`"),
        (&with("prove x(y) = y"), "3:7 x is a variable, not a function (for a product write x*(…))"),
        (
            &with("prove sqrt = y"),
            "3:7 nothing declares the name sqrt (declare it, for instance `given sqrt > 0` or `given sqrt real`)",
        ),
        (
            "claim c \"t\ngiven x > 0\nprove x = x",
            "1:9 this text has no closing quotation mark (write the text on one line, between \"…\")",
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
fn indices_and_powers_are_read_as_they_are_printed() {
    for (typed, plain) in [
        ("m₁*v₁² = (x + y)²", "m1*v1^2 = (x + y)^2"),
        ("x⁻¹ + x⁻¹² = 2³·x", "x^(-1) + x^(-12) = 2^3*x"),
        ("-x² = μ₁²/λ₂", "-x^2 = mu1^2/lambda2"),
        ("√x = √(x + 1)*√√2", "sqrt(x) = sqrt(x + 1)*sqrt(sqrt(2))"),
        ("2^x² = x", "2^x^2 = x"),
        ("v₁_2 = n!", "v1_2 = n!"),
        ("Σ(i = 1…n, Π(j = 1…i, x)) = 1", "sum(i = 1..n, product(j = 1..i, x)) = 1"),
    ] {
        let prop = |text: &str| parse_prop(text).unwrap_or_else(|f| panic!("{text}: {f:?}"));
        assert_eq!(print::prop(&prop(typed)), print::prop(&prop(plain)), "{typed}");
    }
    // The places of faults are those of what was typed.
    let with = |rest: &str| format!("claim c \"t\"\ngiven m₁, x > 0;  x² < 2\n{rest}\n");
    assert!(parse(&with("prove m₁² <= x⁻¹")).is_ok());
    for (rest, said) in [
        ("prove m₁² + z₂ = x", "3:13 nothing declares the name z2"),
        ("prove x²^3 = x", "3:9 a raised exponent is followed by another exponent"),
        ("prove x²! = x", "3:9 a raised exponent is followed by another exponent"),
        ("prove √x² = x", "3:9 it is not clear how far the root reaches"),
        ("prove x₁2 = x", "3:7 the name x₁2 mixes digits on the line with subscript digits"),
        ("prove ² = x", "3:7 expected an expression, found the power 2"),
        ("prove m_1 = x", "3:7 "),
        ("prove x⁻ = x", "3:8 "),
    ] {
        assert!(fault(&with(rest)).starts_with(said), "{rest}: {}", fault(&with(rest)));
    }
    let formatted = format(&with("prove   x² *m₁<=√( x )")).expect("it parses");
    assert!(formatted.ends_with("prove x²*m₁ <= √(x)\n"), "{formatted}");
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

/// The messages of all faults of a source.
fn messages(source: &str) -> Vec<String> {
    parse(source).expect_err("faulty").iter().map(carom::claim::diagnostic::Diagnostic::message).collect()
}

#[test]
fn a_keyword_used_as_a_name_is_a_fault_at_each_use() {
    let declared = |what: &str| format!("expected a name to {what}, found ");
    for (clauses, said) in [
        ("given by > 0, x > 0\nassume by < x\nlet y = by + x\nprove by*x + by > 0", declared("declare") + "`by`"),
        ("given x > 0, by real\nprove x > by", declared("declare") + "`by`"),
        ("given by + 1 > 0\nprove by > -1", declared("declare") + "`by`"),
        ("given prove real, given > 0\nprove prove + given > 0", declared("declare") + "`prove`"),
        ("given x > 0\nlet sum = 3\nprove sum*x > 0", declared("define") + "`sum`"),
        ("given x > 0\nlet not = x\nprove not > 0", declared("define") + "`not`"),
        ("given all real\nprove all in [0, 1] or all > 0", declared("declare") + "`all`"),
    ] {
        let source = format!("claim c \"t\"\n{clauses}\n");
        assert_eq!(messages(&source), std::slice::from_ref(&said), "{clauses}");
        // A preamble's is one for all claims of the file; each claim's own is one for it.
        let two = format!("{source}\nclaim d \"t\"\n{clauses}\n");
        assert_eq!(messages(&two), [said.clone(), said.clone()], "{clauses}");
    }
    let shared = "given by > 0\nclaim c \"t\"\nprove by > 0\nclaim d \"t\"\nprove 1 + by > 0\n";
    assert_eq!(messages(shared).len(), 1, "{:?}", messages(shared));
    // A keyword where an expression is expected, and no name of the claim, is a fault of its own.
    assert_eq!(messages("claim c \"t\"\ngiven x > 0\nprove x >\n by ideal\n"), ["expected an expression, found `by`"]);
}

#[test]
fn a_character_that_is_no_part_of_the_language_brings_a_second_fault() {
    for (goal, character) in
        [("x ≈ 3", '≈'), ("x = 3 ± 1", '±'), ("∫ x > 0", '∫'), ("x > 5%", '%'), ("x*50 % > 0", '%')]
    {
        let source = format!("claim c \"t\"\ngiven x > 0\nprove {goal}\n");
        assert_eq!(messages(&source), [format!("the character {character:?} is not part of the language")], "{goal}");
    }
}

#[test]
fn an_unfinished_claim_takes_none_of_the_others_away() {
    let whole = "given x real\nprove x = x\n";
    let source = format!(
        "claim a \"a\"\n{whole}claim half \"h\"\ngiven x real\nprove x >\n\nclaim b \"b\"\n{whole}claim c \"c\"\n{whole}"
    );
    let out = with_input(&["audit", "-"], &source);
    let (verdicts, faults) = (text(&out.stdout), text(&out.stderr));
    assert!(verdicts.contains("3 claims: 3 proved"), "{verdicts}");
    assert!(faults.contains("-:6:10") && faults.matches("error").count() == 1, "{faults}");
}

#[test]
fn what_other_languages_write_is_one_fault_with_what_to_write_instead() {
    for (rest, said, help) in [
        ("prove n^2 mod 4 = 0", "3:11 the claim language has no `mod`", "`n - 5*floor(n/5)`"),
        ("prove n % 3 = 0", "3:9 the character '%'", "`n - 5*floor(n/5)`"),
        ("prove 3 divides n^3 - n", "3:9 the claim language has no `divides`", "`exists k natural: n = 3*k`"),
        ("prove 3 | n", "3:9 expected a comparison sign", "`exists k natural: n = 3*k`"),
        ("prove gcd(n, n) = n", "3:7 nothing declares the name gcd", "there is no gcd"),
        ("prove prime(n)", "3:7 the claim language has no `prime`", "a*b = p => a = 1 or b = 1"),
        ("prove x = y iff y = x", "3:13 the claim language has no `iff`", "`A <=> B`"),
        ("prove x = y if and only if y = x", "3:13 the claim language has no `if`", "`A <=> B`"),
        ("prove if x > 1 then x > 0", "3:7 the claim language has no `if`", "`A => B`"),
        ("prove x > 1 -> x > 0", "3:13 expected the end of the clause", "`A => B`"),
        ("prove x > 1 implies x > 0", "3:13 the claim language has no `implies`", "`A => B`"),
        ("prove x => y", "3:9 expected a comparison sign", "write >= for"),
        ("prove x =< y", "3:10 expected an expression", "write <="),
        ("prove x <> y", "3:10 expected an expression", "write !="),
        ("prove x ≥≥ y", "3:10 expected an expression", "write one sign: >="),
        ("prove x ⩾ y", "3:9 the character '⩾'", "write >="),
        ("prove x > 1 && y > 1", "3:13 the character '&'", "write `and`"),
        ("prove x > 1 || y > 1", "3:13 expected the end of the clause", "write `or`"),
        ("prove forall z real, z = z", "3:7 the claim language has no `forall`", "`for all y real: …`"),
        ("prove for every z real: z = z", "3:11 the claim language has no `every`", "`for all y real: …`"),
        ("prove ∀ z: z = z", "3:7 the character '∀'", "`for all y real: …`"),
        ("prove ∃ z ∈ [0, 1]: z = z", "3:7 the character '∃'", "`exists y in [0, 1]: …`"),
        ("prove there exists z real: z = z", "3:7 the claim language has no `there`", "`exists y in [0, 1]: …`"),
        ("prove exists! z real: z = x", "3:13 expected a name", "for exactly one y"),
        ("assume n in {1, 2}\nprove n < 4", "3:10 expected a comparison sign", "`n = 1 or n = 2 or n = 3`"),
        ("assume x ∈ ℝ\nprove x = x", "3:12 the character 'ℝ'", "`x real`"),
        ("given z ∈ ℝ\nprove z = z", "3:11 the character 'ℝ'", "`x real`"),
        ("given k in N\nprove k >= 0", "3:12 the set N is no domain here", "`n natural`"),
        ("given z rational\nprove z = z", "3:9 the claim language has no `rational`", "`let x = p/q`"),
        ("given positive z\nprove z = z", "3:7 the claim language has no `positive`", "`x > 0`"),
        ("given real z\nprove z = z", "3:7 expected a name to declare", "`given x real`"),
        ("given z in [0, oo)\nprove z >= 0", "3:16 nothing declares the name oo", "`x >= 0`"),
        ("given z in [0, ∞)\nprove z >= 0", "3:16 expected an expression", "`x >= 0`"),
        ("prove limit of 1/z as z -> inf is 0", "3:28 nothing declares the name inf", "`as x -> infinity`"),
        ("prove max of z over z in [0, 1] is 1", "3:7 the claim language has no `max of`", "`maximum of f"),
        ("prove sup of z over z in [0, 1] is 1", "3:7 the claim language has no `sup of`", "`maximum of f"),
        ("prove lim z->0 sin(z)/z = 1", "3:7 the claim language has no `lim`", "`limit of f as x -> 0 is L`"),
        ("prove lim(sin(z)/z, z, 0) = 1", "3:7 nothing declares the name lim", "`limit of f as x -> 0 is L`"),
        ("prove limit of z as z to 0 is 0", "3:23 the claim language has no `to`", "`limit of f as x -> 0 is L`"),
        ("prove derivative(z^n, z) = n*z^(n - 1)", "3:18 nothing declares the name z", "`given z real`"),
        ("prove false", "3:7 the claim language has no `false`", "`prove not (A and B)`"),
        ("prove x = ½", "3:11 the character '½'", "1/2"),
        ("let a := 2\nprove x = a", "3:7 expected `=`", "write = for :="),
        ("prove sum(k,1,n,k) = n", "3:12 expected `=` and a range", "sum(k = 1..n, f)"),
        ("prove int(z, z, 0, 1) = x", "3:7 nothing declares the name int", "integral(x = a..b, f)"),
        ("prove sin^2 x = 1", "3:13 expected a comparison sign", "write sin(x)^2"),
        ("prove x < 1,000", "3:12 expected the end of the clause", "write 1000 without a separator, or 1.000"),
        ("prove x < 0,9", "3:12 expected the end of the clause", "write 0.9 with a decimal point"),
        ("prove x < 1, 2*y = 2*y", "3:12 expected the end of the clause", "join two statements by `and`"),
        ("prove maximum of z for z > 0 is 1", "3:20 expected `over`", "over x > 0"),
        (
            "prove maximum of z over z in [0, 1] is 1 only at z = 1",
            "3:42 expected the end of the clause",
            "the place before the value",
        ),
        ("prove sin² x = 1", "3:12 expected a comparison sign", "write sin(x)^2"),
    ] {
        let source = format!("claim c \"t\"\ngiven x, y > 0;  n natural\n{rest}\n");
        let found = fault(&source);
        assert!(found.starts_with(said) && found.contains(help), "{rest}: {found}");
        assert_eq!(messages(&source).len(), 1, "{rest}: {:?}", messages(&source));
    }
    let curly = fault("claim c “t”\nprove 1 = 1\n");
    assert!(curly.contains("straight quotation marks"), "{curly}");
    // A word that the claim declares is one of its names.
    for rest in [
        "given iff > 0, inf > 0\nprove iff + inf > 0",
        "given oo > 0, z in [0, oo)\nprove z >= 0",
        "given mod(k), lim(k) real\nprove mod(n) + lim(n) = lim(n) + mod(n)",
        "let gcd(a, b) = a*b\nprove for all prime, positive > 0: gcd(prime, positive) > 0",
    ] {
        lines(&format!("claim c \"t\"\ngiven n natural\n{rest}\n"));
    }
    let own = fault("claim c \"t\"\ngiven n > 0, iff > 0\nprove n iff = 1\n");
    assert!(own.contains("write n*iff for a product"), "{own}");
    let shared = "given lim(k) real;  n natural\nclaim c \"t\"\nprove lim(n) = lim(n)\n";
    assert!(parse(shared).is_ok(), "the preamble gives lim and n");
}

#[test]
fn what_a_help_offers_is_read() {
    for rest in [
        "prove exists k natural: n = 5*k",
        "prove n - 5*floor(n/5) < 5",
        "given g natural >= 1\nassume exists i, j natural: a = i*g and b = j*g\n\
         assume for all d, i, j natural: a = i*d and b = j*d => d <= g\nprove g >= 1",
        "given m natural >= 1\nassume exists i, j natural: m = i*a and m = j*b\n\
         assume for all i, j natural: i*a = j*b and i*a > 0 => m <= i*a\nprove m >= 1",
        "given p natural >= 2\nassume for all a_1, b_1 natural: a_1*b_1 = p => a_1 = 1 or b_1 = 1\nprove p > 1",
        "given p integer; q natural >= 1\nlet x = p/q\nprove x*q = p",
        "given k integer\nlet x = 2*k + 1\nprove x = 2*k + 1",
        "prove exists y real: y = 2*a and (for all z real: z = 2*a => z = y)",
        "prove maximum of x over x in [0, 1] is 1",
        "prove maximum of x over x in [0, 1] at x = 1 is 1",
        "prove limit of x as x -> 0 from above is 0",
        "prove limit of sum(k = 1..m, 1/2^k) as m natural -> infinity is 1",
        "prove not (a > b and a < b)",
        "prove integral(x = 0..1, x) = 1/2 and derivative(a^2, a) = 2*a",
    ] {
        let source = format!("claim c \"t\"\ngiven n, b natural;  a >= 0\n{rest}\n");
        assert!(parse(&source).is_ok(), "{}", fault(&source));
    }
}

/// The statement of the first claim as the kernel reads it.
fn lines(source: &str) -> Vec<String> {
    let claims = parse(source).unwrap_or_else(|f| panic!("{source}: {} ({:?})", f[0].message(), f[0].help()));
    print::statement_as_read(&claims[0], print::Style::Text)
}

#[test]
fn an_abbreviation_is_another_word_for_what_it_stands_for() {
    let goal = |text: &str| {
        let heading = "claim c \"t\"\ngiven x, y, z real;  n, k natural\nlet M = [x, y; z, 1]\nprove ";
        lines(&format!("{heading}{text}\n")).pop().expect("a goal")
    };
    for (short, long) in [
        ("|x - y| >= 0", "sqrt((x - y)^2) >= 0"),
        ("||x| - |y||*2 = abs(z)", "sqrt((sqrt(x^2) - sqrt(y^2))^2)*2 = sqrt(z^2)"),
        ("max(x, y) = 1", "(x + y + sqrt((x - y)^2))/2 = 1"),
        ("min(x, 2) = 1", "(x + 2 - sqrt((x - 2)^2))/2 = 1"),
        ("n! = 1", "product(i = 1..n, i) = 1"),
        ("(n + 1)!^2 != 1", "product(i = 1..n + 1, i)^2 != 1"),
        ("sum(i = 0..n, i!) = 1", "sum(i = 0..n, product(j = 1..i, j)) = 1"),
        ("binomial(n, k) = 1", "product(i = 1..k, (n + 1 - i)/i) = 1"),
        ("binomial(n!, 2) = 1", "product(j = 1..2, (product(i = 1..n, i) + 1 - j)/j) = 1"),
        ("trace(M) = 1", "x + 1 = 1"),
        ("trace(transpose(M)*[1, 2; 3, 4] - 2*M) = 1", "((x*1 + z*3) - x*2) + ((y*2 + 1*4) - 1*2) = 1"),
        ("inverse(M) = M", "[1, -y; -z, x]/det([x, y; z, 1]) = M"),
        ("M^2 = M^0", "M*M = [1, 0; 0, 1]"),
        ("[x, 1]*M^1 = [1, 2]", "[x, 1]*M = [1, 2]"),
    ] {
        let written = goal(short);
        assert_eq!(written, goal(long), "{short}");
        assert_eq!(written, format!("prove {long}"), "{short}");
        assert_eq!(goal(&written["prove ".len()..]), written, "what is printed reads back");
    }
    let own = "claim c \"t\"\ngiven max(k) > 0;  trace > 0\nprove max(1) + trace > 0\n";
    assert_eq!(lines(own)[1], "prove max(1) + trace > 0", "a name of the claim's own is no abbreviation");
}

#[test]
fn what_is_said_in_several_ways_is_one_statement() {
    for (short, long) in [
        (
            "define F by F(0) = 0, F(1) = 1, F(k + 2) = F(k + 1) + F(k)\nprove F(2) = 1",
            "given F(k) real\nassume F(0) = 0\nassume F(1) = 1\n\
             assume for all k natural: F(k + 2) = F(k + 1) + F(k)\nprove F(2) = 1",
        ),
        (
            "define u by u(k + 1) = 2*u(k), u(0) = 3\nprove u(1) = 6",
            "define u by u(0) = 3, u(k + 1) = 2*u(k)\nprove u(1) = 6",
        ),
        (
            "given a real\nprove limit of x^2 as x -> a is a^2",
            "given x real\ngiven a real\nprove limit of (a + 1/x)^2 as x -> infinity is a^2 and \
             limit of (a - 1/x)^2 as x -> infinity is a^2",
        ),
        ("prove limit of x as x -> 0 from below is 0", "given x real\nprove limit of -(1/x) as x -> infinity is 0"),
        (
            "prove limit of n! as n natural -> infinity is infinity",
            "given n natural\nprove (exists n_from natural > 0: for all n_later natural >= n_from: \
             product(i = 1..n_later, i) > 0) and limit of 1/product(i = 1..n, i) as n -> infinity is 0",
        ),
        (
            "prove limit of -x as x -> infinity is -infinity",
            "given x real\nprove (exists x_from > 0: for all x_later >= x_from: -x_later < 0) and \
             limit of 1/-x as x -> infinity is 0",
        ),
        (
            "given x > 0;  n natural\nlet M = [2/x, 1; 0, x]\nprove det(M^n) = 2^n and M^(n + 1) = M*M^n",
            "given x > 0;  n natural\nlet M = [2/x, 1; 0, x]\ngiven M_11(i), M_12(i), M_21(i), M_22(i) real\n\
             assume M_11(0) = 1\nassume for all i natural: M_11(i + 1) = (2/x)*M_11(i) + M_21(i)\n\
             assume M_12(0) = 0\nassume for all i natural: M_12(i + 1) = (2/x)*M_12(i) + M_22(i)\n\
             assume M_21(0) = 0\nassume for all i natural: M_21(i + 1) = x*M_21(i)\n\
             assume M_22(0) = 1\nassume for all i natural: M_22(i + 1) = x*M_22(i)\n\
             prove det([M_11(n), M_12(n); M_21(n), M_22(n)]) = 2^n and \
             [M_11(n + 1), M_12(n + 1); M_21(n + 1), M_22(n + 1)] = M*[M_11(n), M_12(n); M_21(n), M_22(n)]",
        ),
        ("prove minimum of t^2 over t real is 0", "prove (for all t real: t^2 >= 0) and (exists t real: t^2 = 0)"),
    ] {
        let [short, long] = [short, long].map(|rest| lines(&format!("claim c \"t\"\n{rest}\n")));
        assert_eq!(short, long);
    }
}

#[test]
fn a_name_that_an_angle_needs_is_not_the_authors() {
    let said = lines("claim c \"t\"\ngiven x, cos_x, sin_x2 real\nprove cos(x) + sin(x/2) = cos_x + sin_x2\n");
    assert_eq!(
        said.last().map(String::as_str),
        Some("prove (cos_x_over_2^2 - sin_x_over_2^2) + sin_x_over_2 = cos_x + sin_x2")
    );
    let said = lines("claim c \"t\"\ngiven x, cos_x real\nprove cos(x) = cos_x\n");
    assert_eq!(said.last().map(String::as_str), Some("prove cos_x_2 = cos_x"));
    // The half of theta and an angle of that name.
    let said = lines("claim c \"t\"\ngiven theta, theta_over_2 real\nprove cos(theta/2) = cos(theta_over_2)\n");
    assert_eq!(said.last().map(String::as_str), Some("prove cos_theta_over_2 = cos_theta_over_2_2"));
}

#[test]
fn a_claim_is_printed_as_its_author_wrote_it() {
    for goal in [
        "limit of 1/t as t -> 3 from above is 1/3",
        "limit of t^2 as t -> infinity is infinity",
        "limit of 1/t as t -> 0 from below is -infinity",
        "cos(x)^2 + sin(x)^2 = 1",
        "derivative(sin(x/2), x) = cos(x/2)/2",
        "maximum of sin(a) over a in [0, pi] at a = pi/2 is 1",
        "abs(y) >= 0 and factorial(3) = 6 and floor(y) <= y and [1, y; 0, 1]^2 = [1, 2*y; 0, 1]",
    ] {
        let source = format!("claim c \"t\"\ngiven x real; y real\nprove {goal}\n");
        let said = print::statement(&parse(&source).expect("it parses")[0], print::Style::Text);
        assert_eq!(said.last(), Some(&format!("prove {goal}")));
        // What is printed is read as the same statement.
        let again = format!("claim c \"t\"\n{}\n", said.join("\n"));
        assert_eq!(lines(&again), lines(&source));
    }
    let said = parse("claim c \"t\"\ngiven cos_x > 2\nprove cos_x > 1\n").expect("it parses");
    assert_eq!(print::Style::Unicode.prop(&said[0].goal), "cos_x > 1");
}

#[test]
fn a_member_is_defined_by_members_before_it() {
    let refused = |define: &str| {
        let said = fault(&format!("claim c \"t\"\ndefine {define}\nprove 1 = 1\n"));
        assert!(said.contains("is not defined by the members before it"), "{define}: {said}");
    };
    refused("V by V(0) = 1, V(1) = 0, V(k + 2) = V(k + 2) + 1");
    refused("V by V(0) = 1, V(k + 1) = V(k + 1)");
    refused("V by V(0) = 1, V(k + 1) = V(2*k)");
    refused("V by V(0) = 1, V(k + 1) = sum(i = 0..k + 1, V(i))");
    refused("V by V(0) = 1, V(1) = 1, V(k + 2) = sum(i = -3..k, V(k - i))");
    refused("V, u by V(0) = u(0), u(0) = V(0), V(k + 1) = 1, u(k + 1) = 1");
    refused("V, u by V(0) = 1, u(0) = 1, V(k + 1) = u(k + 1), u(k + 1) = V(k + 1)");
    for define in [
        "V, u by V(0) = 1, u(0) = V(0), V(k + 1) = u(k), u(k + 1) = V(k + 1)",
        "C by C(0) = 1, C(1) = 1, C(k + 2) = sum(i = 0..k + 1, C(i)*C(k + 1 - i))",
        "F by F(0) = 0, F(1) = 1, F(k + 2) = F(k + 1) + F(k) + F(0)",
    ] {
        lines(&format!("claim c \"t\"\ndefine {define}\nprove 1 = 1\n"));
    }
}

#[test]
fn what_is_no_abbreviation_is_refused_with_what_to_write() {
    let with =
        |rest: &str| fault(&format!("claim c \"t\"\ngiven x, y > 0;  n natural\nlet f(a) = [a, 1]\nprove {rest}\n"));
    for (rest, said) in [
        ("[x, y; y, x]^101 = [1, 0; 0, 1]", "a numeral as the exponent of a matrix is a whole number from -100 to 100"),
        ("[x, y]^n = [1, 0]", "a power needs a square matrix"),
        (
            "[1/(x - y), 0; 0, 1]^n = [1, 0; 0, 1]",
            "must have values everywhere (declare the names in its divisors positive",
        ),
        ("sum(i = 0..n, det([1, i; 0, 1]^n)) = 1", "a matrix to a variable power depends on the bound variable i"),
        ("inverse([x, y]) = x", "an inverse needs a square matrix"),
        ("trace(x) = x", "a trace needs a matrix whose entries are written out (write the matrix as [a, b; c, d]"),
        ("trace(f(x)) = x", "a trace needs a matrix whose entries are written out"),
        ("|x = y", "expected `|` to close the absolute value"),
        ("n!! = 1", "there is no n!! (write (n!)! or a product)"),
        ("binomial(n) = 1", "binomial takes 2 arguments"),
        ("max(x) = 1", "max takes 2 to 8 arguments"),
        ("asin(x) = y", "write arcsin(x)"),
        ("sec(x) = y", "write 1/cos(x)"),
        ("x + cos_x = sin(x)", "nothing declares the name cos_x"),
        ("for all pi > 0: pi > x", "pi is the number π, which nothing else may be called here (choose another name)"),
        ("sum(pi = 0..n, pi) = x", "pi is the number π"),
        ("for all sin > 0: sin > x", "sin is a built-in function"),
        ("log(x) = y", "write the natural logarithm as ln(x)"),
        ("floor(1/(x - y)) = n", "the argument of a floor must have a value everywhere"),
        ("integral(x) = y", "`=` and a range such as 1..n"),
        ("integrate(x^2, x) = y", "write integral(x = a..b, f)"),
        ("integral(x = 0..1, x) = y", "the name x is declared twice"),
        ("1 + integral(t = 0..infinity, t) = y", "write it alone on one side of an equation"),
        ("integral(t = 0..1, floor(t)) = y", "this floor depends on the bound variable t"),
        ("x = y + O(x)", "an order ends an equation and says where the variable goes"),
        ("sin(t) + O(t^2) = t as t -> 0", "O(…) is the last summand on the right of one equation"),
        ("sin(t) = t - 2*O(t^2) as t -> 0", "O(…) is the last summand on the right of one equation"),
        ("sin(t) < t + O(t^2) as t -> 0", "O(…) is the last summand on the right of one equation"),
        ("sin(x) = x + O(x^3) as x -> 0", "x is already declared, so it cannot be the variable"),
        ("limit of x as x -> 0 is 0", "x is already declared, so it cannot be the variable"),
        ("limit of t as t natural -> 0 is 0", "t is already declared, so it cannot be the variable"),
        ("limit of t as t -> t + 1 is 0", "this depends on t, the variable of the limit"),
        ("limit of sum(i = 1..3, i*t) as t -> i is 0", "nothing declares the name i"),
        ("limit of derivative(t^2, t) as t -> 3 is 0", "a derivative by t inside a limit by t cannot be read"),
        ("trace([x, y; 1, n]^26) = 0", "limit reached: at most 100000 nodes of abbreviations written out"),
        ("limit of t as t -> 0 from left is 0", "expected `above` or `below`"),
        (
            "limit of n as n -> infinity is infinity",
            "n is already declared, so it cannot be the variable of an infinite limit",
        ),
        ("for all k integer: k^2 >= k", "an `integer` is declared under `given` only"),
    ] {
        assert!(with(rest).contains(said), "{rest}: {}", with(rest));
    }
    for (rest, said) in [
        ("V, u by V(0) = 1, u(0) = 0, V(k + 1) = u(k)", "u needs one step"),
        ("F by F(0) = 0, F(k + 2) = F(k + 1) + F(k)", "the step to F(k + 2) needs F(0), F(1)"),
        ("F by F(0) = 0, F(1) = 1, F(2) = 2, F(k + 2) = F(k)", "the step to F(k + 2) needs F(0), F(1)"),
        ("F by F(0) = 0, F(k + 1) = F(k), F(k + 1) = 1", "F needs one step"),
        ("F by F(0) = 0, G(k + 1) = F(k)", "a definition by recurrence reads"),
        ("F by F(0) = 0, F(k + 21) = F(k)", "expected a whole number"),
    ] {
        let fault = fault(&format!("claim c \"t\"\ndefine {rest}\nprove 1 = 1\n"));
        assert!(fault.contains(said), "{rest}: {fault}");
    }
    let doubled = (0..40).fold("x".to_string(), |text, _| format!("max({text}, y)"));
    assert!(with(&format!("{doubled} = 1")).contains("nodes of abbreviations written out"));
}

#[test]
fn given_takes_relations_and_integers() {
    assert_eq!(
        lines("claim c \"t\"\ngiven 0 < a < b; x > 0, n natural\nprove a < b + x + n\n"),
        ["given a, b real", "assume 0 < a < b", "given x > 0; n natural", "prove a < b + x + n"]
    );
    assert_eq!(lines("claim c \"t\"\ngiven a > b > 0\nprove a > 0\n")[..2], ["given a, b real", "assume a > b > 0"]);
    let sum = lines("claim c \"t\"\ngiven x > 0; x + y < 1\nprove x > 0\n");
    assert_eq!(sum[..2], ["given x > 0; y real", "assume x + y < 1"]);
    assert_eq!(
        lines("claim c \"t\"\ngiven k integer >= -3 and < 5\nprove k >= -3\n"),
        ["given k_up, k_down natural", "let k = k_up - k_down", "assume k >= -3", "assume k < 5", "prove k >= -3"]
    );
    let once = lines("claim c \"t\"\ngiven x > 0 and != 1; n natural >= 1 and <= 7\nprove x > 0\n");
    assert_eq!(once[0], "given x > 0 and != 1; n natural >= 1 and <= 7");
    for rest in ["given x > 0 < 5", "given y > 0\nassume for all x > y > 0: x > 0"] {
        let said = fault(&format!("claim c \"t\"\n{rest}\nprove 1 = 1\n"));
        assert!(said.contains("write `and` between two conditions"), "{said}");
    }
}

#[test]
fn a_limit_declares_its_variable_unless_the_claim_does() {
    let limit = "limit of 1/n as n -> infinity is 0";
    assert_eq!(lines(&format!("claim c \"t\"\nprove {limit}\n"))[0], "given n real");
    assert_eq!(lines(&format!("claim c \"t\"\ngiven n natural >= 1\nprove {limit}\n"))[0], "given n natural >= 1");
    assert_eq!(
        lines(&limit.replace("as n", "as n natural").replace("limit", "claim c \"t\"\nprove limit"))[0],
        "given n natural"
    );
    assert!(
        fault(&format!("claim c \"t\"\ngiven n > 0\nprove {}\n", limit.replace("as n", "as n natural")))
            .contains("twice")
    );
}

#[test]
fn headings_are_read_as_they_are_printed() {
    let source = "paper \"A paper\"\nsource \"Journal 1\"\nreading as printed\n\ntext \"First, a remark.\"\n\
                  claim a \"t\"\nnumber A.3  # of the appendix\nprove 1 = 1\n\
                  claim b \"t\"\nnumber 2.10\nsource \"elsewhere\"\nreading restored\nprove 1 = 1\n\
                  claim c \"t\"\nnumber 7a\nprove 1 = 1\n";
    let claims = parse(source).expect("it parses");
    let heading = |c: &Claim| (c.number.clone().unwrap_or_default(), c.source.clone().unwrap_or_default(), c.reading);
    let expected = [
        ("A.3", "Journal 1", Some(Reading::Printed)),
        ("2.10", "elsewhere", Some(Reading::Restored)),
        ("7a", "Journal 1", Some(Reading::Printed)),
    ];
    for (claim, (number, from, reading)) in claims.iter().zip(expected) {
        assert_eq!(heading(claim), (number.to_string(), from.to_string(), reading));
        assert_eq!(claim.paper.as_deref(), Some("A paper"));
    }
    assert_eq!((claims[0].prose.len(), claims[1].prose.len()), (1, 0));
    assert_eq!(format(source).expect("it parses"), source);
    assert_eq!(parse("claim c \"t\"\nprove 1 = 1\n").expect("it parses")[0].reading, None, "nobody wrote a reading");
}

#[test]
fn a_claim_takes_from_the_preamble_what_it_speaks_of_and_no_more() {
    let preamble = "given m1, m2 > 0; e in [0, 1]; v real\nlet r = m1/m2\nassume light: r < 1\nassume v > 3\n";
    let of = |claim: &str| lines(&format!("{preamble}claim c \"t\"\n{claim}\n"));
    assert_eq!(of("prove e <= 1"), ["given e in [0, 1]", "prove e <= 1"]);
    let heavy = ["given m1, m2 > 0", "let r = m1/m2", "assume light: r < 1", "prove m1 < m2"];
    assert_eq!(of("prove m1 < m2"), heavy, "a hypothesis about what it is made of");
    assert_eq!(of("given x real\nprove x*v > x")[..2], ["given v real", "assume v > 3"]);
    assert_eq!(of("prove for all v > 0: v > 0"), ["prove for all v > 0: v > 0"], "bound there, not free");
    assert_eq!(of("given v > 4\nprove v > 0"), ["given v real", "assume v > 3", "assume v > 4", "prove v > 0"]);
    let said = fault(&format!("{preamble}claim c \"t\"\ngiven v real\nprove v > 0\n"));
    assert!(said.contains("6:7 the preamble already declares v"), "{said}");
    assert!(fault("given x > 0\nlet x = 1\nclaim c \"t\"\nprove 1 = 1\n").contains("2:5 the name x is declared twice"));
    assert!(fault("given m_1 > 0\nclaim c \"t\"\ngiven m1 > 0\nprove 1 = 1\n").contains("look the same in print"));
}

#[test]
fn a_sample_gives_numbers_to_variables() {
    let claims =
        parse("claim c \"t\"\ngiven x real; k integer\nsample x = sqrt(2), k = -2\nprove x = x\n").expect("it parses");
    let sample: Vec<String> =
        claims[0].sample.iter().map(|(n, e)| format!("{} = {}", n.text, print::expr(e))).collect();
    assert_eq!(sample, ["x = sqrt(2)", "k_up = 0", "k_down = 2"]);
    assert!(fault("claim c \"t\"\ngiven x, y real\nsample x = y\nprove x = x\n").contains("mentions y"));
    assert!(fault("claim c \"t\"\ngiven x real\nsample y = 1\nprove x = x\n").contains("nothing declares the name y"));
}

#[test]
fn the_page_lists_other_units_than_are_known() {
    let faults = parse("claim c \"t\"\ngiven x > 0 in kgg\nprove x = x\n").expect_err("no unit");
    let help = faults[0].help().expect("a list").to_string();
    let known: Vec<&str> = help.split_once(": ").expect("a list").1.split(", ").collect();
    let page = include_str!("../../docs/language.md");
    let said = page.split_once("Known are ").and_then(|(_, rest)| rest.split_once(". An angle")).expect("the list").0;
    let said: Vec<&str> = said.split([' ', ';', '\n']).filter(|unit| !unit.is_empty()).collect();
    assert_eq!(said, known);
}
