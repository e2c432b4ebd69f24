//! The catalogue's certificates: accepted, complete as stated, and rejected once they are damaged.
//!
//! `CAROM_MUTANTS=N` damages each certificate in N ways (a few, if it is not set).

#![allow(clippy::unwrap_used)]

use carom::certificate::text::{digest, read, refuted_by, write};
use carom::certificate::{Certificate, Step, needed};
use carom::claim::embedded;
use carom::claim::syntax::*;
use carom::kernel::{Accepted, Verdict, check, domains};
use carom::refute::catalogue::Limits;
use std::collections::BTreeMap;

fn deep<T: Send + 'static>(run: impl FnOnce() -> T + Send + 'static) -> T {
    std::thread::Builder::new().stack_size(256 << 20).spawn(run).unwrap().join().unwrap()
}

fn claims() -> Vec<Claim> {
    embedded::claims(&[]).unwrap().unwrap()
}

type Check = dyn Fn(&Claim, &Certificate, &[&Accepted]) -> bool;

/// The committed certificates of proved claims; those of refuted ones are in `tests/all/refutations.rs`.
fn proofs() -> impl Iterator<Item = (String, &'static str)> {
    embedded::certificates().into_iter().filter(|(_, text)| refuted_by(text).is_none())
}

/// Every committed certificate of a proof with its claim, cited ones first, and what was accepted so far.
fn all() -> (Vec<(Claim, String)>, BTreeMap<String, Accepted>) {
    let texts: BTreeMap<String, &str> = proofs().collect();
    let mut waiting: Vec<Claim> = claims().into_iter().filter(|c| texts.contains_key(&c.name.text)).collect();
    let mut accepted: BTreeMap<String, Accepted> = BTreeMap::new();
    let mut out = Vec::new();
    while !waiting.is_empty() {
        let before = waiting.len();
        for claim in std::mem::take(&mut waiting) {
            if claim.using.iter().any(|n| texts.contains_key(&n.text) && !accepted.contains_key(&n.text)) {
                waiting.push(claim);
                continue;
            }
            let text = texts[&claim.name.text];
            let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
            match check(&claim, &read(text).unwrap(), &cited) {
                Verdict::Accepted(shown) => {
                    assert_eq!(digest(&shown.text()), read(text).unwrap().statement, "{}", claim.name.text);
                    accepted.insert(claim.name.text.clone(), *shown);
                }
                other => panic!("{}: {other:?}", claim.name.text),
            }
            out.push((claim, text.to_string()));
        }
        assert!(waiting.len() < before, "certificates that wait for one another");
    }
    (out, accepted)
}

#[test]
fn every_committed_certificate_is_accepted_and_every_gap_is_listed() {
    deep(|| {
        let (list, _) = all();
        let have: Vec<String> = list.iter().map(|c| c.0.name.text.clone()).collect();
        let claims = claims();
        let mut gaps: Vec<&str> = claims
            .iter()
            .filter(|c| c.expect == Expectation::Proved && !have.contains(&c.name.text))
            .map(|c| c.name.text.as_str())
            .collect();
        gaps.sort_unstable();
        assert!(gaps.is_empty(), "proved, but without a certificate: {gaps:?}");
        assert!(!list.is_empty());
        for (claim, _) in &list {
            assert_eq!(claim.expect, Expectation::Proved, "{}", claim.name.text);
        }
        let names: Vec<String> = proofs().map(|c| c.0).collect();
        assert_eq!(names.len(), have.len(), "a certificate of no claim");
    });
}

#[test]
fn certificates_read_back_as_they_were_written() {
    for (name, text) in embedded::certificates() {
        assert_eq!(write(&read(text).unwrap()), text, "{name}");
    }
}

/// A bounded share; the whole is made again by `.ci/run`.
#[test]
fn small_certificates_are_found_again_just_as_they_are() {
    deep(|| {
        let (list, accepted) = all();
        for (claim, text) in list.iter().filter(|c| c.1.len() < 700) {
            let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
            let (found, _) = carom::prove::certificate(claim, &cited, &Limits::default()).unwrap();
            assert_eq!(write(&found), *text, "{}", claim.name.text);
        }
    });
}

/// Another goal: the first relation turned round, or the words after a limit or extremum changed.
fn other_goal(p: &Prop) -> Prop {
    let two = |e: &Expr| Expr {
        kind: ExprKind::Sum(vec![
            (Sign::Plus, e.clone()),
            (Sign::Plus, Expr { kind: ExprKind::Number("1".to_string()), span: Span::default() }),
        ]),
        span: Span::default(),
    };
    let kind = match &p.kind {
        PropKind::Compare(sides, relations) => {
            let mut relations = relations.clone();
            relations[0] = relations[0].negated();
            PropKind::Compare(sides.clone(), relations)
        }
        PropKind::And(list) | PropKind::Or(list) | PropKind::Equivalent(list) => {
            let mut list = list.clone();
            list[0] = other_goal(&list[0]);
            match &p.kind {
                PropKind::And(_) => PropKind::And(list),
                PropKind::Or(_) => PropKind::Or(list),
                _ => PropKind::Equivalent(list),
            }
        }
        PropKind::Not(inner) => inner.kind.clone(),
        PropKind::Implies(a, b) => PropKind::Implies(a.clone(), Box::new(other_goal(b))),
        PropKind::Exists(b, body) => PropKind::Exists(b.clone(), Box::new(other_goal(body))),
        PropKind::ForAll(b, body) => PropKind::ForAll(b.clone(), Box::new(other_goal(body))),
        PropKind::Extremum(e) => PropKind::Extremum(Box::new(Extremum { value: two(&e.value), ..(**e).clone() })),
        PropKind::Limit(l) => PropKind::Limit(Box::new(Limit { value: two(&l.value), ..(**l).clone() })),
        PropKind::WrittenLimit(_) => panic!("a claim that was read is written out"),
    };
    Prop { kind, span: p.span }
}

/// What a sound and complete check does; the faults of the one that is tried.
fn faults(tried: &Check) -> Vec<String> {
    let (list, accepted) = all();
    let mut out = Vec::new();
    for (place, (claim, text)) in list.iter().enumerate() {
        let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
        let certificate = read(text).unwrap();
        let name = &claim.name.text;
        if !tried(claim, &certificate, &cited) {
            out.push(format!("{name}: rejects a good certificate"));
        }
        let changed = Claim { goal: other_goal(&claim.goal), ..claim.clone() };
        if tried(&changed, &certificate, &cited) {
            out.push(format!("{name}: accepts it for another goal"));
        }
        let mut shorter = certificate.clone();
        shorter.steps.pop();
        if tried(claim, &shorter, &cited) {
            out.push(format!("{name}: accepts it without its last step"));
        }
        // The certificate of another claim, under this one's name.
        let (other, other_text) = &list[(place + 1) % list.len()];
        if other.name.text != *name {
            let stolen = Certificate { claim: name.clone(), ..read(other_text).unwrap() };
            if tried(claim, &stolen, &cited) {
                out.push(format!("{name}: accepts the certificate of {}", other.name.text));
            }
        }
    }
    out
}

#[test]
fn the_kernel_passes_and_mock_kernels_are_caught() {
    deep(|| {
        let kernel =
            |c: &Claim, cert: &Certificate, cited: &[&Accepted]| matches!(check(c, cert, cited), Verdict::Accepted(_));
        assert_eq!(faults(&kernel), Vec::<String>::new());
        let mocks: [(&str, &Check); 4] = [
            ("always accepts", &|_, _, _| true),
            ("always rejects", &|_, _, _| false),
            ("only looks at the name", &|c, cert, _| c.name.text == cert.claim),
            ("only looks whether there are steps", &|c, cert, _| c.name.text == cert.claim && !cert.steps.is_empty()),
        ];
        for (name, mock) in mocks {
            assert!(!faults(mock).is_empty(), "a kernel that {name} is not caught");
        }
    });
}

pub(crate) struct Random(pub u64);

impl Random {
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 >> 33).unwrap() % n.max(1)
    }
}

/// A label that a step cites: its line, the place of the space before it, and itself.
fn citation(lines: &[String], random: &mut Random) -> Option<(usize, usize, String)> {
    let mut all = Vec::new();
    for (line, text) in lines.iter().enumerate() {
        let field = ["| by ", "| using ", "| term ", "end "].iter().find(|f| text.trim_start().starts_with(*f));
        let (start, end) = match (field, text.find(" from ")) {
            (Some(field), _) => (text.find(field)? + field.len() - 1, text.find(':').unwrap_or(text.len())),
            (None, Some(from)) if !text.contains('|') => (from + 5, text.find(':').unwrap_or(text.len())),
            _ => continue,
        };
        let places = text.match_indices(' ').map(|m| m.0).filter(|at| (start..end).contains(at));
        all.extend(places.map(|at| {
            let label = text[at + 1..end].split(' ').next().unwrap_or_default();
            (line, at, label.to_string())
        }));
    }
    (!all.is_empty()).then(|| all.swap_remove(random.below(all.len())))
}

/// One way to damage a text; `None` where it does not apply.
pub(crate) fn damaged(text: &str, kind: usize, random: &mut Random) -> Option<(&'static str, String)> {
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    let at = 3 + random.below(lines.len() - 4);
    let replace_one = |text: &str, random: &mut Random, pairs: &[(&str, &str)]| -> Option<String> {
        let body = text.find("\n1 ")?;
        let places: Vec<(usize, &str, &str)> = pairs
            .iter()
            .flat_map(|(a, b)| text[body..].match_indices(a).map(move |(i, _)| (body + i, *a, *b)))
            .collect();
        let (i, a, b) = *places.get(random.below(places.len()))?;
        Some(format!("{}{b}{}", &text[..i], &text[i + a.len()..]))
    };
    let out = match kind % 11 {
        0 => {
            lines.remove(at);
            ("line removed", lines.join("\n") + "\n")
        }
        1 => {
            let line = lines[at].clone();
            lines.insert(at, line);
            ("line doubled", lines.join("\n") + "\n")
        }
        2 => {
            let other = 3 + random.below(lines.len() - 4);
            lines.swap(at, other);
            ("lines swapped", lines.join("\n") + "\n")
        }
        3 => {
            let places: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|m| m.0).collect();
            let i = *places.get(random.below(places.len()))?;
            let digit = char::from(b'0' + u8::try_from(random.below(10)).unwrap());
            ("digit changed", format!("{}{digit}{}", &text[..i], &text[i + 1..]))
        }
        4 => ("sign changed", replace_one(text, random, &[(" + ", " - "), (" - ", " + "), ("*", "/"), ("/", "*")])?),
        5 => {
            let pairs =
                [(" >= ", " > "), (" > ", " >= "), (" = ", " <= "), (" <= ", " < "), (" < ", " <= "), (" != ", " = ")];
            ("relation changed", replace_one(text, random, &pairs)?)
        }
        6 => {
            let mut cut = random.below(text.len());
            while !text.is_char_boundary(cut) {
                cut -= 1;
            }
            ("truncated", text[..cut].to_string())
        }
        7 => {
            let place = text.find("sha256 ")? + 7 + random.below(64);
            let digit = if &text[place..=place] == "0" { "1" } else { "0" };
            ("digest changed", format!("{}{digit}{}", &text[..place], &text[place + 1..]))
        }
        8 => {
            let pairs = [
                (" combination:", " power:"),
                (" power:", " combination:"),
                (" unfold:", " combination:"),
                (" logic from ", " instance from "),
                (" instance from ", " logic from "),
                (" suppose:", " let:"),
                (" from ", " to "),
                ("| by ", "| using "),
                ("| using ", "| by "),
                ("<=>", "=>"),
                (" and ", " or "),
            ];
            ("rule changed", replace_one(text, random, &pairs)?)
        }
        9 => {
            let (line, place, label) = citation(&lines, random)?;
            lines[line].replace_range(place..place + label.len() + 1, "");
            ("citation removed", lines.join("\n") + "\n")
        }
        _ => {
            let (line, place, label) = citation(&lines, random)?;
            let (_, _, other) = citation(&lines, random)?;
            lines[line].replace_range(place..place + label.len() + 1, &format!(" {other}"));
            ("citation changed", lines.join("\n") + "\n")
        }
    };
    // Without the newline at its end a certificate is the same.
    (out.1.trim_end() != text.trim_end()).then_some(out)
}

#[test]
fn damaged_certificates_are_rejected_or_still_show_the_same_statement() {
    let each: usize = std::env::var("CAROM_MUTANTS").ok().and_then(|n| n.parse().ok()).unwrap_or(11);
    deep(move || {
        let (list, accepted) = all();
        let mut counts: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
        let mut random = Random(0x5E_ED0F_CA20);
        for (claim, text) in &list {
            let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
            for kind in 0..each {
                let Some((how, mutant)) = damaged(text, kind, &mut random) else { continue };
                let count = counts.entry(how).or_default();
                count.0 += 1;
                let Ok(certificate) = read(&mutant) else { continue };
                if let Verdict::Accepted(shown) = check(claim, &certificate, &cited)
                    && digest(&shown.text()) == certificate.statement
                {
                    // The kernel was given the claim: what it shows is that claim, with other steps.
                    assert_eq!(shown.text(), accepted[&claim.name.text].text());
                    assert!(!matches!(how, "truncated" | "digest changed"), "{}: {how}", claim.name.text);
                    count.1 += 1;
                    if each > 100 {
                        let line = mutant.lines().zip(text.lines()).find(|(a, b)| a != b).map(|l| l.0.to_string());
                        println!("{}: {how}, still valid: {}", claim.name.text, line.unwrap_or_default());
                    }
                }
            }
        }
        let (tried, valid) = counts.values().fold((0, 0), |all, c| (all.0 + c.0, all.1 + c.1));
        println!("{tried} mutants, {valid} still valid: {counts:?}");
        assert!(tried >= list.len(), "mutants were made");
        assert!(valid * 5 < tried, "too many mutants are still valid: the certificates hold more than they need");
    });
}

/// The certificate of a claim that the search finds.
fn certified(claim: &str) -> String {
    let claim = carom::claim::parse::parse(&format!("claim t \"t\"\n{claim}")).unwrap().remove(0);
    write(&carom::prove::certificate(&claim, &[], &Limits::default()).unwrap_or_else(|why| panic!("{why}")).0)
}

#[test]
fn a_squeeze_and_a_supposition_are_written_out() {
    for (claim, part) in [
        ("given a > 0;  n natural >= 1\nprove limit of a*2^(-n) as n -> infinity is 0\n", "squeeze"),
        ("given n natural >= 2\nprove limit of 1/(n^2 - n - 1) as n -> infinity is 0\n", "limit"),
        ("given x in [0, 1]\nprove -x*x > 0 => -x > 0\n", "suppose"),
    ] {
        let written = certified(claim);
        assert!(written.contains(part), "{written}");
    }
}

proptest::proptest! {
    #[test]
    fn the_reader_never_panics(bytes in proptest::collection::vec(proptest::num::u8::ANY, 0..300), place in 0usize..400, cut in 0usize..400) {
        let good = "carom-certificate 2\nclaim a\nstatement sha256 0000000000000000000000000000000000000000000000000000000000000000\n1 suppose: x = x => x = x\n  2 combination: x = x\n      | term h1 1s: x^2\n      | by h1\nend 2\nqed\n";
        let noise = String::from_utf8_lossy(&bytes);
        let _ = read(&noise);
        let place = place.min(good.len());
        let end = (place + cut).min(good.len());
        let _ = read(&format!("{}{noise}{}", &good[..place], &good[end..]));
    }
}

/// What the kernel says of a false claim with a certificate that tries to slip it through.
fn slipped(claim: &str, steps: &str) -> String {
    // What the reader refuses cannot be slipped through.
    let mut claims = match carom::claim::parse::parse(claim) {
        Ok(claims) => claims,
        Err(faults) => return format!(": {}", faults[0].message()),
    };
    let claim = claims.remove(0);
    let zeros = "0".repeat(64);
    let text = format!("carom-certificate 2\nclaim {}\nstatement sha256 {zeros}\n{steps}qed\n", claim.name.text);
    match check(&claim, &read(&text).unwrap(), &[]) {
        Verdict::Rejected { step, reason, .. } => format!("{step}: {reason}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_moving_variable_is_not_put_in_for_one_that_stands_still() {
    let reason = slipped(
        "claim a \"The derivative of x^2 is x\"\ngiven x > 0\nprove derivative(x*x, x) = x\n",
        "1 let: for all z real > 0: derivative(x*z, x) = z\n2 combination: derivative(x*z, x) = z\nend 2\n\
         3 instance from 1 h1: derivative(x*x, x) = x\n| with z = x\n",
    );
    assert!(reason.starts_with("3: ") && reason.contains("moves"), "{reason}");
    let reason = slipped(
        "claim a \"n/n tends to 0\"\ngiven n natural >= 1\nprove limit of n/n as n -> infinity is 0\n",
        "1 combination: n > 0\n| by h1\n\
         2 let: for all z real > 0: limit of z/n as n -> infinity is 0\n\
         3 limit: limit of z/n as n -> infinity is 0\n| with from = 1\nend 3\n\
         4 instance from 2 1: limit of n/n as n -> infinity is 0\n| with z = n\n",
    );
    assert!(reason.starts_with("4: ") && reason.contains("moves"), "{reason}");
}

#[test]
fn a_sequence_that_depends_on_the_variable_has_no_limit_by_degrees() {
    let reason = slipped(
        "claim a \"A sequence that moves\"\ngiven x > 0\ndefine u by u(0) = x, u(k + 1) = u(k)\n\
         prove limit of u(3) as x -> infinity is u(3)\n",
        "1 limit: limit of u(3) as x -> infinity is u(3)\n",
    );
    assert!(reason.contains("x grows without bound and is tied to something else"), "{reason}");
}

/// An exponent that doubles at each step stays below its limit, and never sticks at the odd end of its type.
#[test]
fn exponents_do_not_stick() {
    let claim =
        "claim s4 \"Squares of squares\"\ngiven x < 0\ndefine u by u(0) = x, u(k + 1) = u(k)*u(k)\nprove 0 = 1\n";
    let claim = carom::claim::parse::parse(claim).unwrap().remove(0);
    let mut text = format!("carom-certificate 2\nclaim s4\nstatement sha256 {}\nu0 unfold: u(0) = x\n", "0".repeat(64));
    for k in 1..65 {
        text += &format!("u{k} unfold: u({k}) = u({0})*u({0})\n", k - 1);
    }
    let all: String = (0..65).rev().map(|k| format!(" u{k}")).collect();
    text += &format!("w combination: u(64) < 0\n| by h1\n| using{all}\nqed\n");
    match check(&claim, &read(&text).unwrap(), &[]) {
        Verdict::Declined { limit } => assert_eq!(limit, "degree"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_a_reader_of_the_kernel_tried_is_rejected() {
    let tried: [(&str, &str, &str); 11] = [
        (
            "given x real\ndefine u by u(0) = 0, u(k + 1) = u(k + 1) + 1\nprove 0 = 1\n",
            "1 unfold: u(1) = u(1) + 1\n2 combination: 0 = 1\n| term 1: 1\n",
            "not defined by the member",
        ),
        (
            "given x real\ndefine u by u(0) = 0, u(k + 1) = u(1) + 1\nprove 0 = 1\n",
            "1 unfold: u(1) = u(1) + 1\n2 combination: 0 = 1\n| term 1: 1\n",
            "not defined by the member",
        ),
        (
            "given x > 0\nassume x = 1\nprove derivative(x^2, x) = 0\n",
            "1 combination: derivative(x^2, x) = 0\n| using h2\n",
            "the signs do not show this",
        ),
        (
            "given x > 0\ndefine u by u(0) = x, u(k + 1) = u(k)\nprove derivative(x*u(2), x) = u(2)\n",
            "1 let: for all y real: derivative(x*y, x) = y\n2 combination: derivative(x*y, x) = y\nend 2\n\
             3 instance from 1: derivative(x*u(2), x) = u(2)\n| with y = u(2)\n",
            "moves",
        ),
        (
            "given n natural >= 1\ndefine u by u(0) = n, u(k + 1) = u(k)\n\
             assume for all y real: limit of y/n as n -> infinity is 0\nprove limit of u(0)/n as n -> infinity is 0\n",
            "1 instance from h2: limit of u(0)/n as n -> infinity is 0\n| with y = u(0)\n| by h1\n",
            "tied",
        ),
        (
            "given x real\ndefine u by u(0) = 1/x, u(k + 1) = u(k)\nprove u(0) - u(0) = 0\n",
            "1 combination: u(0) - u(0) = 0\n",
            "x is not shown to be other than 0",
        ),
        (
            "given x real\nprove x < [0, 1] or x >= [0, 1]\n",
            "1 logic: x < [0, 1] or x >= [0, 1]\n",
            "a part of it may have no value where the cited facts hold",
        ),
        (
            "given x, p, q real\nassume p = 3 - q\nprove x^(p + q) = x^3\n",
            "1 combination: x^(p + q) = x^3\n| using h1\n",
            "x is not shown to be positive",
        ),
        (
            "given a real != 0\nprove (-2)^(a/a) = -2\n",
            "1 combination: (-2)^(a/a) = -2\n| by h1\n",
            "is not shown to be positive",
        ),
        (
            "given x real; k natural\nprove x^(2*k/2) = x^(2*k/2)\n",
            "1 let: for all n natural: x = x\n2 combination: x = x\nend 2\n\
             3 instance from 1: x = x\n| with n = 2*k/2\n",
            "not a whole number by its form",
        ),
        (
            "given x real; k natural; mu(n) > x^n\nprove mu(2*k/2) > x^(2*k/2)\n",
            "1 instance from h1: mu(2*k/2) > x^(2*k/2)\n| with n = 2*k/2\n",
            "not a whole number by its form",
        ),
    ];
    for (claim, steps, reason) in tried {
        let said = slipped(&format!("claim a \"false\"\n{claim}"), steps);
        assert!(said.contains(reason), "{claim}: {said}");
    }
}

/// The claim without one of its hypotheses; labels of the certificate name the facts that are left. `None` where it is
/// the domain of a family of natural numbers, whose kind is used without a citation.
fn without(claim: &Claim, certificate: &Certificate, fact: usize) -> Option<(Claim, Certificate)> {
    let (mut claim, mut certificate) = (claim.clone(), certificate.clone());
    let mut place = 0;
    for item in &mut claim.items {
        match item {
            Item::Given(bindings) => {
                // The kernel takes the plain names of a declaration first, its families after them.
                let split = |b: &Binding| -> Vec<Binding> {
                    let (plain, families): (Vec<_>, Vec<_>) = b.names.iter().cloned().partition(|n| n.1.is_none());
                    plain.into_iter().chain(families).map(|n| Binding { names: vec![n], ..b.clone() }).collect()
                };
                *bindings = bindings.iter().flat_map(split).collect();
                for binding in bindings {
                    if binding.names[0].1.is_none() {
                        binding.constraints = binding.constraints.iter().flat_map(single).collect();
                    }
                    let count = domains(binding).len();
                    if (place..place + count).contains(&fact) {
                        if binding.names[0].1.is_none() {
                            binding.constraints.remove(fact - place);
                        } else if binding.natural {
                            return None;
                        } else {
                            binding.constraints.clear();
                        }
                    }
                    place += count;
                }
            }
            Item::Assume { prop, .. } => {
                if place == fact {
                    let zero = Expr { kind: ExprKind::Number("0".to_string()), span: Span::default() };
                    prop.kind = PropKind::Compare(vec![zero.clone(), zero], vec![Relation::Equal]);
                }
                place += 1;
            }
            _ => {}
        }
    }
    assert!(fact < place, "{}: there is no hypothesis {fact}", claim.name.text);
    let assumed = claim.items.iter().filter(|i| matches!(i, Item::Assume { .. })).count();
    // A hypothesis that is assumed became `0 = 0` and keeps its label; a domain is gone.
    if fact < place - assumed {
        let mut renamed = |label: &str| match label.strip_prefix('h').and_then(|n| n.parse::<usize>().ok()) {
            Some(number) if number > fact + 1 => format!("h{}", number - 1),
            _ => label.to_string(),
        };
        for step in &mut certificate.steps {
            if let Step::Show(show) = step {
                show.relabel(&mut renamed);
            }
        }
    }
    Some((claim, certificate))
}

/// A constraint as those that each say one thing.
fn single(constraint: &Constraint) -> Vec<Constraint> {
    match constraint.clone() {
        Constraint::Relation(..) => vec![constraint.clone()],
        Constraint::Interval { from, from_closed, to, to_closed } => vec![
            Constraint::Relation(if from_closed { Relation::GreaterEqual } else { Relation::Greater }, from),
            Constraint::Relation(if to_closed { Relation::LessEqual } else { Relation::Less }, to),
        ],
        Constraint::Range(from, to) => {
            vec![Constraint::Relation(Relation::GreaterEqual, from), Constraint::Relation(Relation::LessEqual, to)]
        }
    }
}

/// What is called not needed is not: the same steps show the claim without it.
#[test]
fn a_hypothesis_that_is_called_unneeded_can_be_left_out() {
    deep(|| {
        let (list, accepted) = all();
        let mut spare = 0;
        for (claim, text) in &list {
            let cited: Vec<&Accepted> = claim.using.iter().filter_map(|n| accepted.get(&n.text)).collect();
            let (certificate, shown) = (read(text).unwrap(), &accepted[&claim.name.text]);
            let statement = shown.statement();
            let domains: usize = statement.bindings.iter().map(|b| domains(b).len()).sum();
            let cited_facts = needed(&certificate).facts;
            for fact in 0..domains + statement.assumptions.len() {
                let label = format!("h{}", fact + 1);
                if cited_facts.contains(&label) || shown.assumed().contains(&label) {
                    continue;
                }
                let Some((fewer, renamed)) = without(claim, &certificate, fact) else { continue };
                spare += 1;
                let said = check(&fewer, &renamed, &cited);
                assert!(matches!(said, Verdict::Accepted(_)), "{} without {label}: {said:?}", claim.name.text);
            }
        }
        println!("{spare} hypotheses are not needed");
        assert!(spare > 50, "hypotheses were left out");
    });
}

#[test]
fn every_step_of_a_committed_certificate_is_needed() {
    for (name, text) in embedded::certificates() {
        let certificate = read(text).unwrap();
        let steps = needed(&certificate).steps;
        let spare: Vec<usize> = (0..certificate.steps.len()).filter(|place| !steps.contains(place)).collect();
        assert_eq!(spare, Vec::<usize>::new(), "{name}");
    }
}
