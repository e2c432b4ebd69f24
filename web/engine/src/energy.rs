//! Where the energy of a pass goes: what each collision turns into heat, and what each body keeps.
//!
//! Contract: every number is a share of the kinetic energy before the first collision. The shares that the bodies keep
//! and those of the collisions add up to 1 exactly; of irrational ones every digit that is shown is right.

use carom_exact::number::decimal::{Decimal, Digits, Rounding, bits_of_digits};
use carom_exact::number::interval::Interval;
use carom_exact::number::real::Real;
use carom_physics::chain::optimum::Optimum;
use carom_physics::chain::pass::Pass;
use carom_physics::chain::{ChainError, Restitutions};
use carom_physics::scene::{Chain, Inserted, Start};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Square;
use malachite::base::num::basic::traits::{One, Zero};
use serde_json::{Value, json};

/// The most bodies whose shares are listed.
const MAX_LISTED: u64 = 200;
/// The longest exact share that is written beside its decimal.
const LONGEST: usize = 60;

/// The account of an exact chain: `null` where inputs are measured, where bodies are too many, or where the pass has no
/// answer.
pub fn account(chain: &Chain, digits: Digits) -> Value {
    if !chain.is_exact() || chain.count() > MAX_LISTED {
        return Value::Null;
    }
    let found = match chain.inserted() {
        Inserted::Optimal(n) => optimal(chain, *n),
        Inserted::Given(_) => given(chain),
    };
    let Ok(Account { total, kept, heat }) = found else { return Value::Null };
    let list = |shares: &[Real]| shares.iter().map(|share| number(share, digits)).collect::<Vec<_>>();
    json!({
        "total": total.to_string(),
        "kept": list(&kept),
        "heat": list(&heat),
        "kept_in_all": number(&sum(kept), digits),
        "heat_in_all": number(&sum(heat), digits),
    })
}

struct Account {
    /// The kinetic energy before the first collision.
    total: Rational,
    /// What each body has of it after the pass.
    kept: Vec<Real>,
    /// What each collision turns into heat.
    heat: Vec<Real>,
}

/// Kinetic energy.
fn kinetic(mass: &Rational, velocity: &Rational) -> Rational {
    mass * velocity.square() / Rational::from(2)
}

fn given(chain: &Chain) -> Result<Account, ChainError> {
    let masses: Vec<_> = chain.masses().unwrap_or_default().into_iter().map(|m| m.lo().clone()).collect();
    let restitutions = chain.restitutions().0;
    let pass = match chain.start() {
        Start::Speed(speed) => Pass::from_rest(masses, restitutions, speed.clone())?,
        Start::Velocities(list) => Pass::new(masses, restitutions, list.clone())?,
    };
    let energies = |velocities: &[Rational]| -> Vec<Rational> {
        pass.masses().iter().zip(velocities).map(|(m, v)| kinetic(m.value(), v)).collect()
    };
    let total: Rational = energies(pass.velocities_before()).into_iter().sum();
    if total == Rational::ZERO {
        return Err(ChainError::NotAtRest);
    }
    let share = |energy: Rational| Real::rational(energy / &total);
    let kept = energies(&pass.velocities_after()?).into_iter().map(share).collect();
    let heat = pass.losses()?.into_iter().map(share).collect();
    Ok(Account { total, kept, heat })
}

fn optimal(chain: &Chain, n: u64) -> Result<Account, ChainError> {
    let (first, last) = (chain.first().lo().clone(), chain.last().lo().clone());
    let restitutions: Restitutions = chain.restitutions().0;
    let speed = match chain.start() {
        Start::Speed(speed) => speed.clone(),
        Start::Velocities(_) => return Err(ChainError::NeedsGivenMasses),
    };
    let total = kinetic(first.value(), &speed);
    let optimum = Optimum::new(first, last, n, restitutions)?;
    let unit = Rational::ONE / &total;
    let kept = (0..=optimum.collisions())
        .map(|i| {
            let (mass, velocity) = (optimum.mass(i), optimum.velocity(i, &speed));
            if let (Some(m), Some(v)) = (mass.as_rational(), velocity.as_rational()) {
                return Real::rational(kinetic(m, v) * &unit);
            }
            let half = &unit / Rational::from(2);
            Real::enclosed(move |bits| {
                let work = bits + 8;
                let energy = velocity.enclosure(work).square(work).multiply(&mass.enclosure(work), work);
                energy.multiply_rational(&half, bits + 4)
            })
        })
        .collect();
    let heat = (1..=optimum.collisions())
        .map(|i| {
            let loss = optimum.loss(i, &speed);
            if let Some(exact) = loss.as_rational() {
                return Real::rational(exact * &unit);
            }
            let unit = unit.clone();
            Real::enclosed(move |bits| loss.enclosure(bits + 4).multiply_rational(&unit, bits + 4))
        })
        .collect();
    Ok(Account { total, kept, heat })
}

/// The sum of positive shares.
fn sum(shares: Vec<Real>) -> Real {
    let exact: Option<Rational> = shares.iter().map(|share| share.as_rational().cloned()).sum();
    match exact {
        Some(exact) => Real::rational(exact),
        None => Real::enclosed(move |bits| {
            let zero = Interval::from_integer(0);
            shares.iter().fold(zero, |all, share| all.add(&share.enclosure(bits + 8), bits + 8))
        }),
    }
}

/// A share as the page shows numbers; without a decimal where the digits stay open.
fn number(share: &Real, digits: Digits) -> Value {
    let (exact, decimal) = match share.as_rational() {
        Some(x) => (Some(x.to_string()), Decimal::of_rational(x, digits, Rounding::Nearest).ok()),
        None => {
            let enclosure = share.enclosure(bits_of_digits(digits.count()) + 128);
            (None, Decimal::of_interval(&enclosure, digits, Rounding::Nearest))
        }
    };
    json!({
        "exact": exact.filter(|text| text.len() <= LONGEST),
        "decimal": decimal.map(|d| d.to_string()),
        "radical": null,
        "digits": digits.count(),
        "enclosure": ["0", "1"],
    })
}

#[cfg(test)]
mod tests {
    use carom_exact::number::rational;
    use malachite::Rational;
    use malachite::base::num::arithmetic::traits::Abs;
    use serde_json::{Value, json};

    fn answers(m1: &str, e: &str, n: &str, more: &[(&str, &str)]) -> Value {
        let mut request = json!({"m1": m1, "m2": "1", "e": e, "n": n, "digits": "30"});
        for (key, value) in more {
            request[*key] = json!(value);
        }
        serde_json::from_str(&crate::answers(&request.to_string())).expect("JSON")
    }

    fn decimals(list: &Value) -> Rational {
        let one = |x: &Value| rational::parse(x["decimal"].as_str().expect("a decimal")).expect("a number");
        list.as_array().expect("a list").iter().map(one).sum()
    }

    #[test]
    fn shares_add_up_to_the_whole() {
        for (m1, e, n) in [("10", "9/10", "7"), ("64", "44/81", "2"), ("2", "0", "3"), ("10", "9/10, 1/2, 1", "2")] {
            let found = answers(m1, e, n, &[]);
            let energy = &found["energy"];
            let all = decimals(&energy["kept"]) + decimals(&energy["heat"]);
            let off = (all - Rational::from(1)).abs();
            assert!(off < rational::parse("1e-27").expect("a number"), "{m1} {e} {n}: {energy}");
            let last = energy["kept"].as_array().and_then(|l| l.last()).expect("a body");
            assert_eq!(last["decimal"], found["answers"]["eta"]["value"]["decimal"], "the last body has eta");
        }
    }

    #[test]
    fn bodies_that_all_move_have_one_total() {
        let more = [("inserted", "given"), ("masses", "2"), ("velocities", "3, 1, -1")];
        let found = answers("4", "1/2", "", &more);
        // 4·9/2 + 2·1/2 + 1·1/2.
        assert_eq!(found["energy"]["total"], "39/2");
        let energy = &found["energy"];
        let exact = |list: &Value| -> Rational {
            let one = |x: &Value| rational::parse(x["exact"].as_str().expect("exact")).expect("a number");
            list.as_array().expect("a list").iter().map(one).sum()
        };
        assert_eq!(exact(&energy["kept"]) + exact(&energy["heat"]), Rational::from(1));
    }

    #[test]
    fn measured_chains_have_no_shares() {
        assert!(answers("10 ± 1", "9/10", "1", &[])["energy"].is_null());
    }
}
