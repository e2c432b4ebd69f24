//! Plans for the limits of recurrences (`contraction`): a region that the step does not leave, and a factor q < 1 by which it brings
//! what is there nearer to the limit.
//!
//! Method: at values of the letters, members are computed with doubles. Of the bounds by 0, by 1, by the limit, by the first members and
//! by numbers around them, those that all members keep are taken. Those that the step breaks somewhere between them are left out, until it
//! breaks none: that is the greatest region. Then bounds are left out that no plan needs.
//!
//! Doubles decide nothing here: what a plan says is proved, or the plan fails.
//!
//! Limits: [`PLACES`], [`MEMBERS`], [`TRIED`].

use super::Prover;
use super::contraction::{Divided, FACTORS, Recurrence};
use super::limits::over;
use super::slopes::put_in;
use super::sums::replace;
use super::trial_points::{Place, Turns, truth, value_here};
use crate::claim::syntax::*;
use crate::kernel::key;
use crate::kernel::names::names_in;
use crate::kernel::order::Signs;
use crate::kernel::statement::{apply, compare, name, numeral, prop};
use crate::refute::literal::literal;
use malachite::Rational;
use malachite::rational::rational::arithmetic::traits::SimplestRationalInInterval;
use std::collections::BTreeSet;

/// The most values of the letters at which a plan is tried, and the members that are computed there.
const PLACES: usize = 16;
const MEMBERS: usize = 300;

/// The most factors q that are tried for one start, and how many numbers come before what depends on letters.
const TRIED: usize = 3;
const SMALL: usize = 3;

/// First members that are tried where none is given.
const FIRST: [f64; 6] = [0.3, 1.0, 2.5, 40.0, -0.7, -3.0];

/// What a double may be off, and how near to the limit no ratio is computed.
const OFF: f64 = 1e-9;
const NEAR: f64 = 1e-5;

/// The values of the letters, and members from 0 on.
pub(super) struct Orbit {
    pub(super) place: Place,
    pub(super) limit: f64,
    pub(super) members: Vec<f64>,
}

/// From which member on f keeps which region, as propositions about x, and the factor q that seems to do there.
pub(super) struct Plan {
    pub(super) start: u32,
    pub(super) region: Vec<Prop>,
    pub(super) factor: Expr,
}

/// A bound of x, with its value for each orbit.
#[derive(Clone)]
struct Bound {
    relation: Relation,
    e: Expr,
    values: Vec<f64>,
}

impl Bound {
    fn holds(&self, x: f64, orbit: usize) -> bool {
        let e = self.values[orbit];
        let off = OFF * (x.abs() + e.abs());
        match self.relation {
            Relation::Greater => x > e,
            Relation::GreaterEqual => x >= e - off,
            _ => x <= e + off,
        }
    }
}

/// Where points of a region lead, each with its orbit, and the largest ratio of the distances from the limit for each orbit.
struct Swept {
    points: Vec<(f64, usize)>,
    ratios: Vec<f64>,
}

impl Prover {
    /// Members at values of the letters, if they tend to the limit wherever this is tried.
    pub(super) fn orbits(&mut self, r: &Recurrence, limit: &Expr) -> Option<Vec<Orbit>> {
        let mut names = BTreeSet::new();
        [Some(&r.step), Some(limit), r.first.as_ref()].into_iter().flatten().for_each(|e| names_in(e, &mut names));
        names.remove(&r.x);
        let mut places = self.sampled(&names);
        // A number that an equation alone gives, as D = cos(D), is where the members tend.
        let unknown = match &limit.kind {
            ExprKind::Name(n) if places.is_empty() && names.remove(n) => Some(n.clone()),
            _ => None,
        };
        if unknown.is_some() {
            places = self.sampled(&names);
        }
        let zero = apply(&r.u, numeral(0));
        let sign = self.signs_of(&zero);
        let known: Vec<Prop> = self.facts().iter().filter_map(|(_, fact)| about(fact, &zero, &r.x)).collect();
        let mut out = Vec::new();
        for place in places.into_iter().take(PLACES) {
            let first = match &r.first {
                Some(e) => vec![value_here(e, &place)?],
                None => FIRST.to_vec(),
            };
            for x in first {
                let mut here = place.clone();
                here.push((r.x.clone(), x));
                let fits = r.first.is_some() || !(sign.within(Signs::NOT_NEGATIVE) && x < 0.0);
                if !fits || known.iter().any(|p| truth(p, &mut here, &Turns::new()) == Some(false)) {
                    continue;
                }
                let mut members = vec![x];
                for _ in 0..MEMBERS {
                    let next = self.stepped(r, &place, *members.last()?)?;
                    members.push(next);
                }
                let last = *members.last()?;
                let mut place = place.clone();
                place.extend(unknown.iter().map(|n| (n.clone(), last)));
                let limit = value_here(limit, &place)?;
                let far = members.iter().map(|x| (x - limit).abs()).fold(0.0, f64::max);
                let is_near = (last - limit).abs() <= far / 2.0 + OFF;
                if !is_near {
                    return None;
                }
                out.push(Orbit { place, limit, members });
            }
        }
        (!out.is_empty()).then_some(out)
    }

    fn stepped(&self, r: &Recurrence, place: &Place, x: f64) -> Option<f64> {
        let mut here = place.clone();
        here.push((r.x.clone(), x));
        value_here(&r.step, &here)
    }

    /// Regions of bounds that the step does not leave, each with a factor that seems to do there.
    pub(super) fn plans_of_contraction(
        &mut self,
        r: &Recurrence,
        limit: &Expr,
        start: u32,
        orbits: &[Orbit],
        divided: Option<&Divided>,
    ) -> Option<Vec<Plan>> {
        use Relation::{Greater, GreaterEqual, LessEqual};
        let from = usize::try_from(start).ok()?;
        let members = [apply(&r.u, numeral(start)), apply(&r.u, numeral(start + 1))];
        // In the order in which they are kept rather than left out.
        let mut ends = vec![numeral(0), limit.clone(), numeral(1)];
        ends.extend(self.numbers_around(r, start, orbits));
        ends.extend(members.iter().cloned());
        let mut region = vec![(Greater, numeral(0))];
        region.extend(ends.into_iter().flat_map(|e| [(GreaterEqual, e.clone()), (LessEqual, e)]));
        // The members that are bounds are numbers at each place.
        let mut at_members = Vec::new();
        for o in orbits {
            let mut place = o.place.clone();
            for (i, m) in members.iter().enumerate() {
                place.push((key::expr(m), *o.members.get(from + i)?));
            }
            at_members.push(place);
        }
        let value = |e: &Expr, place: &Place| {
            let mut e = e.clone();
            members.iter().for_each(|m| replace(&mut e, m, &name(&key::expr(m))));
            value_here(&e, place)
        };
        let bound = |(relation, e): (Relation, Expr)| {
            let values = at_members.iter().map(|place| value(&e, place)).collect::<Option<Vec<f64>>>()?;
            Some(Bound { relation, e, values })
        };
        let mut region: Vec<Bound> = region.into_iter().filter_map(bound).collect();
        region.retain(|b| orbits.iter().enumerate().all(|(i, o)| o.members[from..].iter().all(|x| b.holds(*x, i))));
        let ratios = loop {
            let Swept { points, ratios } = self.swept(r, &region, orbits)?;
            let before = region.len();
            region.retain(|b| points.iter().all(|(x, i)| b.holds(*x, *i)));
            if region.len() == before {
                break ratios;
            }
        };
        // Numbers where the ratios hardly depend on the letters; else what B/A is at the limit or at the first member.
        let number = |(n, d): &(i64, i64)| literal(&Rational::from_signeds(*n, *d));
        let mut factors: Vec<Expr> = FACTORS.iter().take(SMALL).map(number).collect();
        if let Some(Divided { a, b }) = divided {
            for at in [limit, &members[0]] {
                let quotient = over(put_in(b, &r.x, at).ok()?, put_in(a, &r.x, at).ok()?);
                factors.extend(self.simplified(&quotient));
            }
        }
        factors.extend(FACTORS.iter().skip(SMALL).map(number));
        let fits = |q: &Expr, ratios: &[f64]| {
            at_members
                .iter()
                .zip(ratios)
                .all(|(place, ratio)| value(q, place).is_some_and(|q| q.abs() >= ratio - OFF && q.abs() < 1.0))
        };
        factors.retain(|q| fits(q, &ratios));
        let mut plans = Vec::new();
        for factor in factors.into_iter().take(TRIED) {
            let mut own = region.clone();
            for i in (0..own.len()).rev().filter(|i| region[*i].relation != Greater) {
                let mut fewer = own.clone();
                fewer.remove(i);
                if let Some(Swept { points, ratios }) = self.swept(r, &fewer, orbits)
                    && points.iter().all(|(x, place)| fewer.iter().all(|b| b.holds(*x, *place)))
                    && fits(&factor, &ratios)
                {
                    own = fewer;
                }
            }
            let x = name(&r.x);
            let region = own.into_iter().map(|b| compare(x.clone(), b.relation, b.e)).collect();
            plans.push(Plan { start, region, factor });
        }
        Some(plans)
    }

    /// Where the step leads from points of a region, and by what factor it brings them nearer to the limit.
    fn swept(&self, r: &Recurrence, region: &[Bound], orbits: &[Orbit]) -> Option<Swept> {
        let mut swept = Swept { points: Vec::new(), ratios: Vec::new() };
        for (i, o) in orbits.iter().enumerate() {
            let (low, high): (Vec<&Bound>, Vec<&Bound>) =
                region.iter().partition(|b| b.relation != Relation::LessEqual);
            let low = low.into_iter().map(|b| b.values[i]).fold(f64::NEG_INFINITY, f64::max);
            let high = high.into_iter().map(|b| b.values[i]).fold(f64::INFINITY, f64::min);
            let mut most = 0f64;
            for x in grid(low, high).into_iter().filter(|x| region.iter().all(|b| b.holds(*x, i))) {
                let next = self.stepped(r, &o.place, x).filter(|x| x.is_finite())?;
                swept.points.push((next, i));
                if (x - o.limit).abs() > NEAR * (1.0 + o.limit.abs()) {
                    most = most.max(((next - o.limit) / (x - o.limit)).abs());
                }
            }
            swept.ratios.push(most);
        }
        Some(swept)
    }

    /// Numbers around the members from a start on, and around where the step leads from between them: one orbit alone has such.
    fn numbers_around(&mut self, r: &Recurrence, start: u32, orbits: &[Orbit]) -> Vec<Expr> {
        let [o] = orbits else { return Vec::new() };
        let later = o.members.iter().skip(usize::try_from(start).unwrap_or(0));
        let (mut low, mut high) = later.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(*x), b.max(*x)));
        for _ in 0..MEMBERS {
            for x in grid(low, high) {
                let Some(next) = self.stepped(r, &o.place, x).filter(|x| x.is_finite()) else { return Vec::new() };
                (low, high) = (low.min(next), high.max(next));
            }
        }
        let off = (high - low) / 50.0;
        let simple = |a: f64, b: f64| {
            let (a, b) = (Rational::try_from(a).ok()?, Rational::try_from(b).ok()?);
            (a < b).then(|| literal(&Rational::simplest_rational_in_open_interval(&a, &b)))
        };
        [simple(low - off, low), simple(high, high + off)].into_iter().flatten().collect()
    }
}

/// What a fact says of one member, with x in its place.
fn about(fact: &Prop, member: &Expr, x: &str) -> Option<Prop> {
    let PropKind::Compare(sides, relations) = &fact.kind else { return None };
    let mut sides = sides.clone();
    sides.iter_mut().for_each(|e| replace(e, member, &name(x)));
    Some(prop(PropKind::Compare(sides, relations.clone()))).filter(|p| key::prop(p) != key::prop(fact))
}

/// Numbers between two ends, which may be infinite: these, and numbers near them and far from them.
fn grid(low: f64, high: f64) -> Vec<f64> {
    let parts = (1..24).map(|i| f64::from(i) / 24.0).chain([0.0, 1e-6, 1e-3, 1.0 - 1e-3, 1.0 - 1e-6, 1.0]);
    let far = (-6..=6).map(|i| 10f64.powi(i)).flat_map(|x| [x, 2.0 * x, 5.0 * x]).chain([0.0]);
    match (low.is_finite(), high.is_finite()) {
        (true, true) => parts.map(|t| low + (high - low) * t).collect(),
        (true, false) => far.map(|x| low + x).collect(),
        (false, true) => far.map(|x| high - x).collect(),
        (false, false) => far.flat_map(|x| [x, -x]).collect(),
    }
}
