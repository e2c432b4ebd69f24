//! Claims and certificates made by hand, of trees that no text can say: the kernel refuses each of them, for what is wrong with it.

use carom::certificate::{Certificate, Refutes, Rule, Show, Step, Term};
use carom::claim::parse::{parse, parse_expr, parse_prop};
use carom::claim::syntax::*;
use carom::kernel::statement::{apply, compare, expr, name, numeral, power, prop, sum};
use carom::kernel::{Checker, Refusal, Verdict, check, key};

fn read(source: &str) -> Claim {
    parse(&format!("claim f \"f\"\n{source}")).unwrap_or_else(|e| panic!("{source}: {e:?}")).remove(0)
}

fn show(label: &str, rule: Rule, prop: Prop, by: &[&str]) -> Step {
    let by = by.iter().map(|s| s.to_string()).collect();
    Step::Show(Box::new(Show { label: label.to_string(), rule, prop, by, using: Vec::new() }))
}

fn combination(prop: Prop) -> Step {
    show("1", Rule::Combination { times: None, terms: Vec::new() }, prop, &[])
}

fn word(text: &str) -> Name {
    Name { text: text.to_string(), span: Span::default() }
}

fn binding(names: &[&str]) -> Binding {
    Binding {
        names: names.iter().map(|text| (word(text), None)).collect(),
        natural: false,
        constraints: Vec::new(),
        indices: None,
        unit: None,
        span: Span::default(),
    }
}

fn family(text: &str, index: &str) -> Binding {
    Binding { names: vec![(word(text), Some(word(index)))], ..binding(&[]) }
}

fn for_all(bindings: Vec<Binding>, body: Prop) -> Prop {
    prop(PropKind::ForAll(bindings, Box::new(body)))
}

fn over(index: &str, body: Expr) -> Expr {
    let index = Index { name: word(index), from: Box::new(numeral(1)), to: Box::new(numeral(2)) };
    expr(ExprKind::SumOver(index, Box::new(body)))
}

fn number(text: &str) -> Expr {
    expr(ExprKind::Number(text.to_string()))
}

fn is_itself(e: &Expr) -> Prop {
    compare(e.clone(), Relation::Equal, e.clone())
}

/// What the kernel answers, in words.
fn answer(claim: &Claim, refutes: Option<Refutes>, steps: Vec<Step>) -> String {
    let certificate = Certificate { claim: claim.name.text.clone(), statement: String::new(), refutes, steps };
    match check(claim, &certificate, &[]) {
        Verdict::Accepted(shown) => format!("accepted {}", shown.text()),
        Verdict::Refuted => "refuted".to_string(),
        Verdict::Rejected { reason, .. } => reason.to_string(),
        Verdict::Declined { limit } => format!("limit: {limit}"),
    }
}

fn said(refusal: Result<(), Refusal>) -> String {
    match refusal {
        Ok(()) => "taken".to_string(),
        Err(Refusal::Rejected(reason)) => reason.to_string(),
        Err(Refusal::Limit(limit)) => format!("limit: {limit}"),
    }
}

// The first five were accepted once. Each shows something false.

#[test]
fn a_comparison_with_more_sides_than_relations_looks_like_another_one() {
    let odd = prop(PropKind::Compare(vec![name("x"), name("y"), name("z")], vec![Relation::Less]));
    let steps = vec![show("1", Rule::Logic { from: vec!["h1".to_string()] }, odd.clone(), &[])];
    let claim = read("given x, y, z, yz real\nassume x < y\nprove x < yz\n");
    assert_eq!(answer(&claim, None, steps), "a comparison has one more side than relations");
    // Nor has it the key of that one.
    assert_ne!(key::prop(&odd), key::prop(&claim.goal));
}

#[test]
fn a_comparison_of_one_side_says_nothing() {
    let one = prop(PropKind::Compare(vec![name("x")], Vec::new()));
    let steps = vec![show("1", Rule::Logic { from: Vec::new() }, one, &[])];
    let claim = read("given x real\nprove x = x + 1\n");
    assert_eq!(answer(&claim, None, steps), "a comparison has one more side than relations");
}

#[test]
fn a_variable_called_1_looks_like_the_numeral() {
    let all = for_all(vec![binding(&["1"])], compare(name("1"), Relation::Greater, numeral(0)));
    let minus = expr(ExprKind::Negate(Box::new(numeral(1))));
    let with = vec![(word("1"), minus)];
    let steps = vec![
        show("1", Rule::Let, all, &[]),
        show("2", Rule::Combination { times: None, terms: Vec::new() }, parse_prop("1 > 0").unwrap(), &[]),
        Step::End("2".to_string()),
        show(
            "3",
            Rule::Instance { source: "1".to_string(), with, from: Vec::new() },
            parse_prop("-1 > 0").unwrap(),
            &[],
        ),
    ];
    assert_eq!(answer(&read("given x real\nprove -1 > 0\n"), None, steps), "\"1\" cannot be a name here");
    assert_ne!(key::expr(&name("1")), key::expr(&numeral(1)));
}

#[test]
fn a_name_of_the_kernels_own_is_the_variable_of_a_limit() {
    let minus = || expr(ExprKind::Negate(Box::new(numeral(1))));
    let named = compare(minus(), Relation::Equal, name("t that grows"));
    let negative = compare(name("t that grows"), Relation::Less, numeral(0));
    let goal = "limit of 1/t + 0*ln(-t) as t -> infinity is 0";
    let terms =
        vec![Term { facts: vec!["1".to_string()], factor: minus() }, Term { facts: Vec::new(), factor: minus() }];
    let steps = vec![
        show("1", Rule::Name, named, &[]),
        show("2", Rule::Combination { times: None, terms }, negative, &["1"]),
        show("3", Rule::Limit { with: Vec::new() }, parse_prop(goal).unwrap(), &["2"]),
    ];
    assert_eq!(answer(&read(&format!("prove {goal}\n")), None, steps), "\"t that grows\" cannot be a name here");
}

#[test]
fn a_family_called_sqrt_is_no_root() {
    let mut claim = read("given q(k) real\nassume q(4) = 3\nprove q(4) = 3\n");
    let said = compare(apply("sqrt", numeral(4)), Relation::Equal, numeral(3));
    claim.items = vec![Item::Given(vec![family("sqrt", "k")]), Item::Assume { label: None, prop: said.clone() }];
    claim.goal = said.clone();
    let steps = vec![show("1", Rule::Logic { from: vec!["h1".to_string()] }, said, &[])];
    assert_eq!(answer(&claim, None, steps), "\"sqrt\" cannot be a name here");
}

/// Expressions that no text can say, with what is wrong.
fn expressions() -> Vec<(Expr, String)> {
    let x = || name("x");
    let long = |of: &str| of.repeat(101);
    let no_name = |text: &str| format!("{text:?} cannot be a name here");
    let no_numeral = |text: &str| format!("the numeral {text} cannot be read");
    let parts = "a sum or product has two parts at least, and begins with + or *";
    let matrix = "a matrix has entries, in rows of one length";
    let derivative = |by: Vec<Name>| expr(ExprKind::Derivative(Box::new(x()), by));
    let mut all = vec![
        (sum(vec![]), parts.to_string()),
        (sum(vec![(Sign::Plus, x())]), parts.to_string()),
        (sum(vec![(Sign::Minus, x()), (Sign::Plus, x())]), parts.to_string()),
        (expr(ExprKind::Product(vec![])), parts.to_string()),
        (expr(ExprKind::Product(vec![(Factor::Times, x())])), parts.to_string()),
        (expr(ExprKind::Product(vec![(Factor::Over, x()), (Factor::Times, x())])), parts.to_string()),
        (expr(ExprKind::Matrix(vec![])), matrix.to_string()),
        (expr(ExprKind::Matrix(vec![vec![], vec![]])), matrix.to_string()),
        (expr(ExprKind::Matrix(vec![vec![x(), x()], vec![x()]])), matrix.to_string()),
        (expr(ExprKind::Apply(word("g"), vec![])), "a function has an argument".to_string()),
        (expr(ExprKind::Apply(word("exp"), vec![x(), x()])), "exp has one argument".to_string()),
        (derivative(vec![]), "a derivative is by a variable".to_string()),
        (derivative(vec![word("2")]), no_name("2")),
        (over("#0", x()), no_name("#0")),
        (apply("f g", x()), no_name("f g")),
        (name(&long("x")), "limit: characters in a name".to_string()),
        (number(&"1".repeat(10_001)), "limit: digits of a numeral".to_string()),
        (number("1e10001"), "limit: digits of a numeral".to_string()),
    ];
    for text in ["", "1", "x y", "_x", "x_", "x__y", "x'y", "x-y", "α", "x\n", "\"x\"", "for", "sum", "infinity"] {
        all.push((name(text), no_name(text)));
    }
    for text in ["", "x", "-1", "1.", ".5", "1e", "1e+", "1 ", "1.2.3", "٣", "1_000"] {
        all.push((number(text), no_numeral(text)));
    }
    // Deep inside, too.
    all.push((power(&x(), &apply("exp", name("not"))), no_name("not")));
    all
}

/// Propositions that no text can say.
fn propositions() -> Vec<(Prop, &'static str)> {
    let comparison = "a comparison has one more side than relations";
    let connective = "`and`, `or` and `<=>` have two parts at least";
    let names = "a quantifier and a declaration have names";
    let point = "the point of an extremum gives each of its variables one value";
    let one = || is_itself(&numeral(1));
    let ranged = Binding { constraints: vec![Constraint::Range(numeral(1), numeral(2))], ..binding(&["r"]) };
    let extremum = |over: Vec<Binding>, at: &[&str]| {
        prop(PropKind::Extremum(Box::new(Extremum {
            maximum: true,
            unique: false,
            of: numeral(1),
            over,
            at: at.iter().map(|text| (word(text), numeral(1))).collect(),
            value: numeral(1),
        })))
    };
    vec![
        (prop(PropKind::Compare(vec![], vec![])), comparison),
        (prop(PropKind::Compare(vec![numeral(1), numeral(1)], vec![Relation::Equal, Relation::Equal])), comparison),
        (prop(PropKind::And(vec![])), connective),
        (prop(PropKind::And(vec![one()])), connective),
        (prop(PropKind::Or(vec![one()])), connective),
        (prop(PropKind::Equivalent(vec![one()])), connective),
        (for_all(vec![], one()), names),
        (for_all(vec![binding(&[])], one()), names),
        (for_all(vec![ranged], one()), "what lies in a range `a..b` is natural"),
        (for_all(vec![binding(&["r", "r"])], one()), "the name r is in use"),
        (for_all(vec![binding(&["r"]), binding(&["r"])], one()), "the name r is in use"),
        (for_all(vec![binding(&["r"])], for_all(vec![binding(&["r"])], one())), "the name r is in use"),
        // Declared by the claim.
        (for_all(vec![binding(&["x"])], one()), "the name x is in use"),
        (prop(PropKind::Exists(vec![binding(&["x"])], Box::new(one()))), "the name x is in use"),
        (extremum(vec![binding(&["x"])], &["x"]), "the name x is in use"),
        (prop(PropKind::Exists(vec![family("g", "k")], Box::new(one()))), "the name g is in use"),
        (for_all(vec![binding(&["exp"])], one()), "\"exp\" cannot be a name here"),
        (for_all(vec![binding(&["and"])], one()), "\"and\" cannot be a name here"),
        (extremum(vec![binding(&["r"])], &[]), point),
        (extremum(vec![binding(&["r"])], &["r", "r"]), point),
        (extremum(vec![binding(&["r"])], &["s"]), point),
        (extremum(vec![], &[]), names),
        (
            prop(PropKind::Limit(Box::new(Limit { of: numeral(1), variable: word("1"), value: numeral(1) }))),
            "\"1\" cannot be a name here",
        ),
    ]
}

fn host() -> Claim {
    read("given x real; g(k) real\nassume x = 1\nprove x = x\n")
}

#[test]
fn a_claim_of_a_malformed_tree_is_taken() {
    let props = propositions().into_iter().map(|(p, why)| (p, why.to_string()));
    for (p, why) in expressions().into_iter().map(|(e, why)| (is_itself(&e), why)).chain(props) {
        for place in 0..2 {
            let mut claim = host();
            match place {
                0 => claim.goal = p.clone(),
                _ => claim.items.push(Item::Assume { label: None, prop: p.clone() }),
            }
            assert_eq!(answer(&claim, None, vec![combination(p.clone())]), why, "{p:?}");
            assert_eq!(said(Checker::new(&claim, &[]).map(|_| ())), why, "{p:?}");
        }
    }
    for (e, why) in expressions() {
        let mut claim = host();
        claim.items.push(Item::Let { name: word("c"), parameters: Vec::new(), value: e.clone() });
        assert_eq!(answer(&claim, None, Vec::new()), why, "{e:?}");
        claim.items.pop();
        let step = name("u");
        claim.items.push(Item::Define {
            name: word("u"),
            initial: e.clone(),
            index: word("i"),
            step,
            span: Span::default(),
        });
        assert_eq!(answer(&claim, None, Vec::new()), why, "{e:?}");
        claim.items.pop();
        let bounded = Binding { constraints: vec![Constraint::Relation(Relation::Less, e.clone())], ..binding(&["y"]) };
        claim.items.push(Item::Given(vec![bounded]));
        assert_eq!(answer(&claim, None, Vec::new()), why, "{e:?}");
    }
}

#[test]
fn a_step_of_a_malformed_tree_is_taken() {
    let claim = host();
    let refused = |step: Step, why: &str| {
        let mut checker = Checker::new(&claim, &[]).unwrap();
        assert_eq!(said(checker.step(&step)), why, "{step:?}");
        assert_eq!(checker.facts().count(), 1);
        if let Step::Show(show) = &step {
            assert_eq!(said(checker.used(show).map(|_| ())), why, "{step:?}");
        }
    };
    let constant = |p: &Prop, why: &str| {
        let mut checker = Checker::new(&claim, &[]).unwrap();
        assert_eq!(said(checker.constant(p, &[]).map(|_| ())), why, "{p:?}");
    };
    for (p, why) in propositions() {
        refused(combination(p.clone()), why);
        if !why.contains("in use") {
            constant(&p, why);
        }
    }
    let fine = || is_itself(&name("x"));
    for (e, why) in expressions() {
        refused(combination(is_itself(&e)), &why);
        constant(&is_itself(&e), &why);
        refused(show("1", Rule::Combination { times: Some(e.clone()), terms: Vec::new() }, fine(), &[]), &why);
        let terms = vec![Term { facts: Vec::new(), factor: e.clone() }];
        refused(show("1", Rule::Combination { times: None, terms }, fine(), &[]), &why);
        refused(show("1", Rule::Tangent { with: vec![(word("x"), e.clone())] }, fine(), &[]), &why);
    }
    refused(show("1", Rule::Mean { with: vec![(word("1"), numeral(1))] }, fine(), &[]), "\"1\" cannot be a name here");
    for label in ["", "1 2", "a-b", "é"] {
        let step = show(label, Rule::Combination { times: None, terms: Vec::new() }, fine(), &[]);
        let mut checker = Checker::new(&claim, &[]).unwrap();
        assert_eq!(said(checker.step(&step)), "a label consists of letters and digits", "{label:?}");
    }
}

#[test]
fn a_refutation_at_a_malformed_point_is_taken() {
    let claim = read("given x real\nprove x = 1\n");
    let point = |place: Expr, value: Expr, undefined| Some(Refutes { point: vec![(place, value)], undefined });
    for (e, why) in expressions() {
        assert_eq!(answer(&claim, point(e.clone(), numeral(2), None), Vec::new()), why, "{e:?}");
        assert_eq!(answer(&claim, point(name("x"), e.clone(), None), Vec::new()), why, "{e:?}");
        assert_eq!(answer(&claim, point(name("x"), numeral(2), Some(e.clone())), Vec::new()), why, "{e:?}");
    }
}

#[test]
fn a_name_has_two_meanings_in_a_claim() {
    let given = |b: Binding| Item::Given(vec![b]);
    let defined = |text: &str, parameters: &[&str]| Item::Let {
        name: word(text),
        parameters: parameters.iter().map(|text| word(text)).collect(),
        value: numeral(1),
    };
    let sequence = |text: &str, index: &str| Item::Define {
        name: word(text),
        initial: numeral(0),
        index: word(index),
        step: numeral(1),
        span: Span::default(),
    };
    let in_use = |text: &str| format!("the name {text} is in use");
    let cases = vec![
        (vec![given(binding(&["a", "a"]))], in_use("a")),
        (vec![given(binding(&["a"])), given(binding(&["a"]))], in_use("a")),
        (vec![given(binding(&["a"])), given(family("a", "k"))], in_use("a")),
        (vec![given(family("a", "k")), given(family("a", "k"))], in_use("a")),
        (vec![given(binding(&["a"])), given(family("b", "a"))], in_use("a")),
        (vec![given(binding(&["a"])), defined("a", &[])], in_use("a")),
        (vec![given(binding(&["a"])), defined("f", &["a"])], in_use("a")),
        (vec![defined("f", &["b", "b"])], in_use("b")),
        (vec![defined("f", &[]), defined("f", &[])], in_use("f")),
        (vec![given(binding(&["a"])), sequence("a", "k")], in_use("a")),
        (vec![given(binding(&["a"])), sequence("u", "a")], in_use("a")),
        (vec![sequence("u", "u")], in_use("u")),
        (vec![sequence("u", "k"), sequence("u", "k")], in_use("u")),
    ];
    for (items, why) in cases {
        let mut claim = read("prove 1 = 1\n");
        claim.items = items;
        assert_eq!(answer(&claim, None, vec![combination(claim.goal.clone())]), why, "{:?}", claim.items);
    }
    // An index of a sum, in a claim as it is written.
    for e in [over("x", name("x")), over("i", over("i", numeral(1)))] {
        let mut claim = host();
        claim.goal = is_itself(&e);
        assert!(answer(&claim, None, Vec::new()).ends_with("is in use"), "{e:?}");
    }
}

/// A name that nothing declares would be that of a variable which a block declares later: `y > 0` would be true for all y.
#[test]
fn a_hypothesis_speaks_of_a_name_that_a_block_declares_later() {
    let mut claim = read("prove for all y real: y > 0\n");
    let positive = parse_prop("y > 0").unwrap();
    claim.items = vec![Item::Assume { label: None, prop: positive.clone() }];
    let steps = vec![
        show("1", Rule::Let, claim.goal.clone(), &[]),
        show("2", Rule::Logic { from: vec!["h1".to_string()] }, positive, &[]),
        Step::End("2".to_string()),
    ];
    assert_eq!(answer(&claim, None, steps), "y is not declared here");
}

#[test]
fn a_name_of_a_claim_breaks_its_line() {
    for text in ["", "f\nprove (0 = 0)", "f g", "2nd", "a--", "prove"] {
        let mut claim = host();
        claim.name.text = text.to_string();
        assert_eq!(answer(&claim, None, Vec::new()), format!("{text:?} cannot be a name here"));
        let mut claim = host();
        claim.using = vec![word(text)];
        assert_eq!(answer(&claim, None, Vec::new()), format!("{text:?} cannot be a name here"));
    }
    assert!(parse("claim a-b_1' \"t\"\nprove 0 = 0\n").is_ok_and(|claims| Checker::new(&claims[0], &[]).is_ok()));
}

/// What ends may be taken again, and a definition brings the index of its sum along.
#[test]
fn a_name_whose_scope_has_ended_is_refused() {
    let claim = read("given n natural\nprove (for all k in 1..n: k >= 1) and (for all k in 1..n: k <= n)\n");
    let PropKind::And(parts) = claim.goal.kind.clone() else { panic!("{claim:?}") };
    let mut steps = Vec::new();
    for (place, part) in parts.iter().enumerate() {
        let PropKind::ForAll(_, inner) = &part.kind else { panic!("{part:?}") };
        let (outer, label) = (format!("a{place}"), format!("b{place}"));
        let within = [format!("{outer}d{}", place + 1)];
        steps.push(show(&outer, Rule::Let, part.clone(), &[]));
        steps.push(show(&label, Rule::Logic { from: within.to_vec() }, (**inner).clone(), &[]));
        steps.push(Step::End(label));
    }
    let from = vec!["a0".to_string(), "a1".to_string()];
    steps.push(show("c", Rule::Logic { from }, claim.goal.clone(), &[]));
    assert!(answer(&claim, None, steps).starts_with("accepted"));
    let claim = read("let s = sum(i = 1..3, i)\nprove sum(i = 1..2, s) = 12\n");
    let goal = parse_prop("sum(i = 1..2, sum(i = 1..3, i)) = 12").unwrap();
    assert!(answer(&claim, None, vec![show("1", Rule::Evaluate, goal, &[])]).starts_with("accepted"));
}

/// At the point of a refutation the variables of the goal have values; a hypothesis may bind them as before.
#[test]
fn a_hypothesis_that_binds_a_variable_of_the_goal_is_refused_at_a_point() {
    let claim = read("given x natural\nassume for all k in 1..2: k <= x\nprove for all k in 1..3: k < x\n");
    let point = vec![(name("x"), numeral(2)), (name("k"), numeral(2))];
    let refutes = Refutes { point, undefined: None };
    let checker = Checker::refuting(&claim, &refutes).unwrap();
    let goal = checker.statement().goal.clone();
    let mut step = show("1", Rule::Evaluate, goal, &[]);
    if let Step::Show(show) = &mut step {
        show.using = checker.facts().map(|fact| fact.0.to_string()).collect();
    }
    assert_eq!(answer(&claim, Some(refutes), vec![step]), "refuted");
}

/// The reader and the kernel have each its own list of words that are no names, and of functions.
#[test]
fn the_reader_and_the_kernel_know_other_words() {
    let page = include_str!("../../docs/certificates.md");
    let (_, list) = page.split_once("These words are no names:\n\n```\n").expect("the words of the language");
    let words: Vec<&str> = list.split_once("\n```").expect("the end of the list").0.split_whitespace().collect();
    assert!(words.len() > 40, "{words:?}");
    for text in words.iter().copied().chain(FUNCTIONS.iter().map(|f| f.0)) {
        assert!(parse(&format!("claim f \"f\"\ngiven {text} real\nprove 1 = 1\n")).is_err(), "{text}");
        let mut claim = read("prove 1 = 1\n");
        claim.items = vec![Item::Given(vec![binding(&[text])])];
        assert_eq!(answer(&claim, None, Vec::new()), format!("{text:?} cannot be a name here"));
    }
    // What the reader reads, the kernel takes.
    for text in ["x", "x1", "x_1", "x''", "X_ab_2'", "from", "paper", "text", "sample", "abs", "pi", "e"] {
        let claim = read(&format!("given {text} real\nprove {text} = {text}\n"));
        let goal = is_itself(&name(text));
        assert!(answer(&claim, None, vec![combination(goal)]).starts_with("accepted"), "{text}");
    }
    for text in ["0", "007", "1.50", "2.5e-3", "1E5", "3e+2"] {
        let goal = is_itself(&parse_expr(text).unwrap());
        let claim = read(&format!("prove {text} = {text}\n"));
        assert!(answer(&claim, None, vec![combination(goal)]).starts_with("accepted"), "{text}");
    }
}
