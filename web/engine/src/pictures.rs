//! Pictures of a chain's neighbourhood, as SVG.

use crate::request::{Fault, Request};
use carom::chain::best::{Best, best};
use carom::chain::{Positive, Restitution};
use carom::report::plot::axes::Chart;
use carom::report::plot::charts;
use carom::report::plot::svg;
use carom::report::plot::unclear::Unclear;
use carom::scene::Chain;
use carom::table::worksheet::Worksheet;
use malachite::Rational;
use serde_json::{Value, json};

/// A picture about the chain.
pub fn plot(request: &Request) -> Result<Value, Fault> {
    let chain = request.chain()?;
    let fault = |error| Fault::chain(None, &error);
    let (from, to) = (ratio(1, 1000)?, ratio(1000, 1)?);
    let n = chain.count();
    let page = match request.text("picture")? {
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
            let worksheet = Worksheet::of(&chain).map_err(fault)?;
            charts::velocities(&worksheet, "Velocities along the chain")
        }
        other => return Err(Fault::at("picture", format!("no picture is called {other:?}"))),
    };
    Ok(json!({ "svg": svg::render(&page.and_then(Chart::finish).map_err(|unclear| match unclear {
        Unclear::Chain(error) => fault(error),
        unclear => Fault::new(unclear.to_string()),
    })?) }))
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
}
