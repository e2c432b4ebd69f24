//! Which claims of the catalogue stand behind a result: the page's "why?".

use carom_physics::scene::{Chain, Coefficients, Inserted};
use serde_json::{Value, json};

/// The names of claims behind each result, the nearest one first.
pub fn behind(chain: &Chain) -> Value {
    let n = chain.count();
    let optimal = matches!(chain.inserted(), Inserted::Optimal(_)) || n == 0;
    let common = matches!(chain.coefficients(), Coefficients::Same(_));
    let eta: &[&str] = match (optimal, n) {
        (_, 0) => &["eq09", "eq08", "u2"],
        (true, 1) => &["eq14", "eq13", "b-global"],
        (true, 2) => &["eq17", "eq16", "b-global"],
        (true, _) if common => &["eq25", "b-global", "b-global-unique"],
        (true, _) => &["b-global", "p-indep"],
        (false, 1) => &["eq13", "eq12"],
        (false, 2) => &["eq16"],
        (false, _) => &["b-global", "eq06"],
    };
    let threshold: &[&str] = match (optimal, n) {
        (false, _) if common => &["b-insert", "eq15"],
        (false, _) => &["b-insert-each", "b-insert"],
        (true, 1) => &["eq15", "eq19", "b-positive"],
        (true, 2) => &["eq18", "eq19", "b-grow"],
        (true, _) => &["eq19", "b-grow", "b-closed"],
    };
    let masses: &[&str] = if optimal { &["eq21", "eq20", "b-global-unique"] } else { &["eq05", "eq06"] };
    let velocities: &[&str] =
        if optimal && common && n > 0 { &["eq22", "eq23", "eq24"] } else { &["eq05", "eq06", "eq07"] };
    json!({
        "eta": eta,
        "threshold": threshold,
        "helps": threshold,
        "best-n": ["b-best", "b-grow", "b-best-finite"],
        "masses": masses,
        "velocities": velocities,
        "losses": ["p-loss", "b-budget"],
        "recollides": ["p-final", "p-final-repaired", "b-final"],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::request::Request;
    use carom_catalogue as embedded;

    #[test]
    fn every_reason_is_a_claim_of_the_catalogue() {
        let names: Vec<&str> = embedded::files().iter().map(|f| embedded::stem(f.path)).collect();
        for (inserted, masses) in [("optimal", ""), ("given", "2"), ("given", "2, 3"), ("given", "2, 3, 4")] {
            for (n, e) in (0..5).flat_map(|n| [(n, "1/2"), (n, "1/2, 1/2, 1/2")]) {
                let request = json!({"m1": "4", "m2": "1", "n": n.to_string(), "inserted": inserted, "masses": masses,
                    "e": e})
                .to_string();
                let Ok(chain) = Request::read(&request).and_then(|r| r.chain()) else { continue };
                for (result, list) in behind(&chain).as_object().expect("an object") {
                    for name in list.as_array().expect("a list") {
                        assert!(names.contains(&name.as_str().expect("a name")), "{result}: {name}");
                    }
                }
            }
        }
    }
}
