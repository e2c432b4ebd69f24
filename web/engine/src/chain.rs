//! Everything that is known of a chain, each quantity with its own answer or its own refusal.

use crate::energy;
use crate::reasons;
use crate::request::{Fault, Request};
use carom_checker::claim::parse::parse_prop;
use carom_checker::claim::syntax::PropKind;
use carom_documents::report::answers;
use carom_documents::report::mathml::{expression, statement};
use carom_exact::number::decimal::{Digits, Rounding};
use carom_physics::scene::answer::Answers;
use carom_physics::scene::quantity::Quantity;
use carom_physics::scene::{Chain, Inserted, Scene};
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use serde_json::{Map, Value, json};

/// The most bodies whose masses and velocities the page lists.
const MAX_LISTED: u64 = 200;

/// The longest closed form that is typeset.
const MAX_TYPESET: usize = 200;

/// The answers to all questions about a chain.
pub fn answers(request: &Request) -> Result<Value, Fault> {
    let chain = &request.chain()?;
    let digits = Digits::Significant(request.digits("digits")?);
    let mut scene = Scene { want: Vec::new(), digits, rounding: Rounding::Nearest, inputs: chain.clone().into() };
    let mut found = Map::new();
    {
        let held = scene.clone();
        let answers = Answers::new(&held);
        for quantity in asked(chain) {
            scene.want = vec![quantity];
            found.insert(quantity.name().to_owned(), one(&scene, &answers, quantity, chain.count()));
        }
    }
    Ok(json!({
        "answers": found,
        "energy": energy::account(chain, digits),
        "plain": request.plain()?,
        "why": reasons::behind(chain),
        "n": chain.count().to_string(),
        "collisions": (chain.count() + 1).to_string(),
        "optimal": matches!(chain.inserted(), Inserted::Optimal(_)),
        "measured": !chain.is_exact(),
        "places": places(chain),
    }))
}

/// What is asked: thresholds begin with the first inserted body, the best number is about optimal masses, and long
/// lists are not for a page.
fn asked(chain: &Chain) -> Vec<Quantity> {
    let given = matches!(chain.inserted(), Inserted::Given(list) if !list.is_empty());
    let threshold = [Quantity::Threshold, Quantity::Helps];
    let mut lists = vec![Quantity::Masses, Quantity::Velocities, Quantity::Losses];
    if given {
        lists.extend(threshold);
    }
    [Quantity::Eta, Quantity::Threshold, Quantity::Helps, Quantity::BestN, Quantity::Recollides]
        .into_iter()
        .chain([Quantity::Masses, Quantity::Velocities, Quantity::Losses])
        .filter(|q| !given || *q != Quantity::BestN)
        .filter(|q| chain.count() > 0 || !threshold.contains(q))
        .filter(|q| chain.count() <= MAX_LISTED || !lists.contains(q))
        .collect()
}

/// The answer to a scene that wants one quantity.
fn one(scene: &Scene, answers: &Answers<'_>, quantity: Quantity, n: u64) -> Value {
    match answers::json(scene, answers, true) {
        Ok(text) => {
            let all: Value = serde_json::from_str(&text).unwrap_or_default();
            let entry = |key: &str| all.get(key).cloned().unwrap_or_default();
            let value = entry(quantity.name());
            let formula = formula(quantity, n, &value);
            json!({ "value": value, "level": entry("level"), "mathml": formula })
        }
        Err((_, error)) => json!({ "error": Fault::chain(None, &error).to_json() }),
    }
}

/// The closed forms of irrational answers, typeset: the engine writes them as the claim language does. A single
/// answer is an equation, a list has an expression or null for each entry.
fn formula(quantity: Quantity, n: u64, value: &Value) -> Value {
    let name = match quantity {
        Quantity::Threshold => format!("L_{n}"),
        quantity => quantity.name().to_owned(),
    };
    let equation = |number: &Value| {
        let radical = number.get("radical")?.as_str().filter(|text| text.len() <= MAX_TYPESET)?;
        parse_prop(&format!("{name} = {radical}")).ok()
    };
    match (quantity, value) {
        (Quantity::Eta | Quantity::Threshold, number) => equation(number).as_ref().map(statement).into(),
        (Quantity::Masses | Quantity::Velocities, Value::Array(list)) => list
            .iter()
            .map(|number| match equation(number)?.kind {
                PropKind::Compare(sides, _) => sides.get(1).map(expression),
                _ => None,
            })
            .map(Value::from)
            .collect(),
        _ => Value::Null,
    }
}

/// Doubles near the inputs: where the sliders stand.
fn places(chain: &Chain) -> Value {
    let near = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
    let middle = |lo: &Rational, hi: &Rational| near(&((lo + hi) / Rational::from(2)));
    json!({
        "m1": middle(chain.first().lo().value(), chain.first().hi().value()),
        "m2": middle(chain.last().lo().value(), chain.last().hi().value()),
        "e": chain.common_restitution("e").ok().map(|e| middle(e.lo().value(), e.hi().value())),
        "n": chain.count() as f64,
    })
}

#[cfg(test)]
mod tests {
    use super::{PropKind, parse_prop};
    use carom_checker::claim::syntax::{Expr, ExprKind, Factor, Sign};
    use serde_json::{Value, json};

    fn eval(m1: &str, m2: &str, e: &str, n: &str, masses: &str) -> Value {
        let request = json!({"m1": m1, "m2": m2, "e": e, "n": n, "masses": masses, "digits": "15",
            "inserted": if masses.is_empty() { "optimal" } else { "given" }});
        serde_json::from_str(&crate::answers(&request.to_string())).expect("JSON")
    }

    #[test]
    fn a_chain_on_the_threshold_is_recognised_exactly() {
        let found = eval("64", "1", "44/81", "2", "");
        let answers = &found["answers"];
        assert_eq!(answers["eta"]["value"]["exact"], "15625000000/282429536481");
        assert_eq!(answers["threshold"]["value"]["exact"], "44/81");
        assert_eq!(answers["helps"]["value"], "exactly on the threshold");
        assert_eq!(answers["best-n"]["value"]["tie"], true);
        assert_eq!(answers["masses"]["value"][1]["exact"], "16");
    }

    #[test]
    fn given_masses_are_asked_about_themselves() {
        let found = eval("10", "1", "9/10", "", "1000, 0.001");
        let answers = &found["answers"];
        assert_eq!(answers["helps"]["value"], json!(["no", "no"]));
        assert_eq!(answers["threshold"]["value"][1]["exact"], "999001/1000");
        assert!(answers.get("best-n").is_none(), "the best number is about optimal masses");
        assert_eq!(found["why"]["helps"][0], "b-insert");
    }

    #[test]
    fn irrational_answers_have_a_typeset_equation() {
        let found = eval("10", "1", "9/10", "7", "");
        for (quantity, sign) in [("eta", "<mi>η</mi>"), ("threshold", "<msub><mi>L</mi><mn>7</mn></msub>")] {
            let formula = found["answers"][quantity]["mathml"].as_str().expect("a formula");
            assert!(formula.contains(sign) && formula.contains("<msup>"), "{formula}");
        }
        let velocities = &found["answers"]["velocities"]["mathml"];
        assert!((0..9).all(|i| velocities[i].as_str().is_some_and(|f| f.starts_with("<math"))), "{velocities}");
        assert!(found["answers"]["masses"]["mathml"][0].is_null());
    }

    /// The value of an expression without names, in doubles: independent of the engine's enclosures.
    fn value(e: &Expr) -> f64 {
        match &e.kind {
            ExprKind::Number(text) => text.parse().expect("a number"),
            ExprKind::Negate(a) => -value(a),
            ExprKind::Sum(list) => list.iter().map(|(s, a)| if *s == Sign::Plus { value(a) } else { -value(a) }).sum(),
            ExprKind::Product(list) => {
                list.iter().map(|(f, a)| if *f == Factor::Times { value(a) } else { 1.0 / value(a) }).product()
            }
            ExprKind::Power(a, b) => value(a).powf(value(b)),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn closed_forms_are_the_numbers_that_they_stand_beside() {
        let mut seen = 0;
        for m1 in ["10", "1/3", "7.5"] {
            for (e, n) in [("9/10", "7"), ("0", "3"), ("1", "2"), ("9/10, 1/2, 0", "2"), ("1/7", "1")] {
                let found = eval(m1, "2", e, n, "");
                for quantity in ["eta", "threshold", "masses", "velocities"] {
                    let answer = &found["answers"][quantity]["value"];
                    let list = answer.as_array().cloned().unwrap_or_else(|| vec![answer.clone()]);
                    for number in list.iter().filter(|x| x["exact"].is_null()) {
                        let Some(text) = number["radical"].as_str() else { panic!("{quantity} {e}: {number}") };
                        let prop = parse_prop(&format!("0 = {text}")).expect("the language's own form");
                        let PropKind::Compare(sides, _) = &prop.kind else { panic!("{text}") };
                        let decimal: f64 = number["decimal"].as_str().and_then(|d| d.parse().ok()).expect("a decimal");
                        let error = (value(&sides[1]) / decimal - 1.0).abs();
                        assert!(error < 1e-12, "{quantity}, m1 = {m1}, e = {e}: {text} is not {decimal}");
                        seen += 1;
                    }
                }
            }
        }
        assert!(seen > 100, "{seen}");
    }

    #[test]
    fn one_quantity_without_an_answer_takes_no_other_with_it() {
        let found = eval("10", "1", "1/2, 3/4", "1", "");
        assert!(found["answers"]["threshold"]["value"]["decimal"].is_string());
        assert!(found["answers"]["best-n"]["error"]["message"].is_string());
        assert!(found["answers"]["eta"]["value"]["decimal"].is_string());
        assert!(eval("10", "1", "1/2", "0", "")["answers"].get("threshold").is_none());
    }

    #[test]
    fn a_fault_names_its_field() {
        for (field, found) in [
            ("m1", eval("ten", "1", "1", "1", "")),
            ("m2", eval("1", "0", "1", "1", "")),
            ("e", eval("1", "1", "1.5", "1", "")),
            ("e", eval("1", "1", "1, 1, 1", "1", "")),
            ("n", eval("1", "1", "1", "-1", "")),
            ("masses", eval("1", "1", "1", "", "2, x")),
        ] {
            assert_eq!(found["error"]["field"], field, "{found}");
        }
    }

    #[test]
    fn no_request_makes_the_engine_panic() {
        for text in ["", "[]", "{}", "{\"m1\": 1}", "{\"m1\": \"\u{202e}1\"}", "\u{0}"] {
            for call in [
                crate::answers,
                crate::replay,
                crate::table,
                crate::plot,
                crate::worksheet,
                crate::check_table,
                crate::restitution,
                crate::audit,
                crate::claim,
            ] {
                let answer: Value = serde_json::from_str(&call(text)).expect("JSON");
                assert!(answer.is_object());
            }
        }
    }
}
