//! Pictures of a chain's neighbourhood, as SVG.
//!
//! Curves are drawn for single numbers: where inputs are measured, for their middles, and the title says so. The chain
//! itself is marked, with bars for what measured inputs leave open.

use crate::middle;
use crate::request::{Fault, Request};
use carom_documents::report::plot::charts;
use carom_documents::report::plot::svg;
use carom_documents::report::plot::unclear::Unclear;
use carom_exact::number::decimal::{Digits, Rounding};
use carom_physics::chain::best::{Best, best};
use carom_physics::chain::{ChainError, Positive, Restitution};
use carom_physics::scene::answer::{Answers, Value as Answer};
use carom_physics::scene::quantity::Quantity;
use carom_physics::scene::{Chain, Scene};
use carom_physics::table::worksheet::Worksheet;
use malachite::Rational;
use malachite::base::num::conversion::traits::RoundingFrom;
use malachite::base::rounding_modes::RoundingMode;
use serde_json::{Value, json};

/// A picture about the chain.
pub fn plot(request: &Request) -> Result<Value, Fault> {
    let asked = request.chain()?;
    let (chain, middle) = middle::of(&asked)?;
    let picture = request.text("picture")?;
    let mut at_the_middle = middle.is_some();
    let fault = |error| Fault::chain(None, &error);
    let (from, to) = (ratio(1, 1000)?, ratio(1000, 1)?);
    let n = chain.count();
    let chart = match picture {
        "eta-x" => charts::eta_of_ratio(&from, &to, &common(&chain)?, &numbers(&[0, 1, 2, 5, 10], n)),
        "eta-n" => {
            let ratio = exact_ratio(&chain)?;
            let list = restitutions(common(&chain)?)?;
            // Twice as far as the best one.
            let mut most = 8;
            for e in &list {
                if let Best::Finite { count, .. } = best(&ratio, e).map_err(fault)?.0 {
                    most = most.max(u64::try_from(&count).unwrap_or(u64::MAX / 4).saturating_mul(2));
                }
            }
            charts::eta_of_number(&ratio, &list, most)
        }
        "threshold" => charts::thresholds(&from, &to, &numbers(&[1, 2, 3, 5, 10], n.max(1))),
        "map" => charts::map(&from, &to),
        "velocities" => {
            // Where all masses are given, bars show what the measured ones leave open.
            let worksheet = match Worksheet::of(&asked) {
                Err(ChainError::Measured { .. }) => Worksheet::of(&chain),
                found => {
                    at_the_middle = false;
                    found
                }
            };
            let worksheet = worksheet.map_err(fault)?;
            charts::velocities(&worksheet, "Velocities along the chain", None)
        }
        other => return Err(Fault::at("picture", format!("no picture is called {other:?}"))),
    };
    let unclear = |unclear| match unclear {
        Unclear::Chain(error) => fault(error),
        unclear => Fault::new(unclear.to_string()),
    };
    let mut chart = chart.map_err(unclear)?;
    if at_the_middle && picture != "map" && picture != "threshold" {
        let title = format!("{} (middle of the measured values)", chart.title());
        chart.rename(&title);
    }
    if let Some((x, y)) = place(&asked, picture) {
        // A chain beyond the edge of the picture is not in it.
        if chart.measured(x, y).is_ok() {
            chart.legend_own("this chain");
        }
    }
    Ok(json!({ "svg": svg::render(&chart.finish().map_err(unclear)?), "middle": middle.filter(|_| at_the_middle) }))
}

/// Where the chain is in a picture: its ends across and upright, equal where nothing is measured.
fn place(chain: &Chain, picture: &str) -> Option<((f64, f64), (f64, f64))> {
    let near = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
    let (first, last) = (chain.first(), chain.last());
    let ratio = (near(first.lo().over(last.hi()).value()), near(first.hi().over(last.lo()).value()));
    let n = chain.count() as f64;
    match picture {
        "eta-x" => Some((ratio, share(chain)?)),
        "eta-n" => Some(((n, n), share(chain)?)),
        "threshold" | "map" => {
            let e = chain.common_restitution("this picture").ok()?;
            Some((ratio, (near(e.lo().value()), near(e.hi().value()))))
        }
        _ => None,
    }
}

/// The ends of eta.
fn share(chain: &Chain) -> Option<(f64, f64)> {
    let digits = Digits::Significant(15);
    let scene = Scene { want: Vec::new(), digits, rounding: Rounding::Nearest, inputs: chain.clone().into() };
    let answers = Answers::new(&scene);
    let Ok((Answer::Number(eta), _)) = answers.get(Quantity::Eta) else { return None };
    Some((eta.enclosure.0.parse().ok()?, eta.enclosure.1.parse().ok()?))
}

fn ratio(above: u64, below: u64) -> Result<Positive, Fault> {
    Positive::new(Rational::from_unsigneds(above, below)).map_err(|error| Fault::chain(None, &error))
}

/// The usual numbers of bodies and the chain's own.
fn numbers(usual: &[u64], own: u64) -> Vec<u64> {
    let mut list = usual.to_vec();
    list.push(own);
    list.sort_unstable();
    list.dedup();
    list
}

/// The usual coefficients and the chain's own.
fn restitutions(own: Restitution) -> Result<Vec<Restitution>, Fault> {
    let usual = [(1, 2), (4, 5), (19, 20), (1, 1)];
    let mut list: Vec<Rational> = usual.iter().map(|(a, b)| Rational::from_unsigneds(*a as u64, *b as u64)).collect();
    list.push(own.value().clone());
    list.sort();
    list.dedup();
    list.into_iter().map(|e| Restitution::new(e).map_err(|error| Fault::chain(Some("e"), &error))).collect()
}

fn common(chain: &Chain) -> Result<Restitution, Fault> {
    let measured = || Fault::new("a picture is drawn for single numbers, not for measured ones");
    let e = chain.common_restitution("this picture").map_err(|error| Fault::chain(Some("e"), &error))?;
    e.single().cloned().ok_or_else(measured)
}

fn exact_ratio(chain: &Chain) -> Result<Positive, Fault> {
    match (chain.first().single(), chain.last().single()) {
        (Some(first), Some(last)) => Ok(first.over(last)),
        _ => Err(Fault::new("a picture is drawn for single numbers, not for measured ones")),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    #[test]
    fn every_picture_is_drawn() {
        for picture in ["eta-x", "eta-n", "threshold", "map", "velocities"] {
            let request = json!({"picture": picture, "m1": "10", "m2": "1", "e": "9/10", "n": "3"});
            let found: Value = serde_json::from_str(&crate::plot(&request.to_string())).expect("JSON");
            assert!(found["svg"].as_str().is_some_and(|svg| svg.starts_with("<svg") || svg.starts_with("<?xml")));
        }
    }

    #[test]
    fn measured_chains_are_drawn_at_their_middles_and_say_so() {
        let draw = |picture: &str, m1: &str, inserted: &str| -> Value {
            let request = json!({"picture": picture, "m1": m1, "m2": "1", "e": "0.9 ± 0.02", "n": "3", "masses": "5, 2",
                "inserted": inserted});
            serde_json::from_str(&crate::plot(&request.to_string())).expect("JSON")
        };
        for picture in ["eta-x", "eta-n", "threshold", "map", "velocities"] {
            let found = draw(picture, "57.1(1)", "optimal");
            assert!(found["svg"].is_string(), "{picture}: {found}");
            assert_eq!(found["middle"], "m1 = 57.1, e = 0.9", "{picture}");
        }
        // Bars hold every velocity: that is no middle.
        assert!(draw("velocities", "57.1(1)", "given")["middle"].is_null());
        // Beyond the edge of the picture a chain is not marked, and the picture is drawn.
        assert!(draw("eta-x", "1e9", "optimal")["svg"].is_string());
    }
}
