//! The state at the end of a run: positions, velocities, energy and momentum.

use super::enclosure::Enclosure;
use super::exact::Run;
use super::history::{Evaluated, History};
use super::outcome::{Collision, Enclosed, Energy, Limit, Outcome, Status};
use super::{Options, Value, ledger};
use malachite::Rational;

/// What a certified run leaves: its count, its list, its precision.
#[derive(Clone)]
pub(super) struct Made {
    pub count: u64,
    pub events: Vec<Collision>,
    pub bits: u64,
}

/// The state at the end of a certified run, from the evaluated history.
pub(super) fn values<N: Enclosure>(
    run: &Run,
    end: &Evaluated<N>,
    bits: u64,
    status: Status,
    options: &Options,
    (history, made): (&History, Made),
) -> Option<Outcome> {
    let line = run.line;
    let value = |x: &N| x.value();
    let number = |x: &Rational| N::of(x, bits);
    let last_pair = history.last();
    let finished = matches!(status, Status::Complete | Status::Limit(Limit::Values { .. }));
    let at_last = !(finished && options.until.is_some());
    let time = match (finished, &options.until, &end.last) {
        (true, Some(until), _) => number(until),
        (_, _, Some((gap, speed))) => gap.over(speed, bits),
        _ => number(run.time().rational()?),
    };
    // Touching a wall is a place that is known.
    let touching = |k: usize| {
        let wall = [k.checked_sub(1), Some(k + 1)]
            .into_iter()
            .flatten()
            .find(|w| line.points.get(*w).is_some_and(|p| p.mass.is_none()) && last_pair == Some(k.min(*w)))?;
        Some(Value::Exact(&line.points[wall].position + &line.points[k].offset))
    };
    let place = |k: usize| {
        if let Some(known) = touching(k).filter(|_| at_last) {
            return Some(known);
        }
        let here = end.b[k].plus(&end.v[k].times(&time, bits), bits);
        value(&here.plus(&number(&line.points[k].offset), bits))
    };
    let start: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
    let (energy, momentum) = (ledger::energy(line, &start), ledger::momentum(line, &start));
    let sum = |term: &dyn Fn(&N, &N) -> N| {
        let all = line.points.iter().zip(&end.v).filter_map(|(p, v)| p.mass.as_ref().map(|m| term(&number(m), v)));
        all.fold(number(&Rational::from(0)), |a, b| a.plus(&b, bits))
    };
    let half = number(&Rational::from_signeds(1, 2));
    let last = sum(&|m, v| m.times(&v.times(v, bits), bits).times(&half, bits));
    let lost = number(&energy).minus(&last, bits);
    let elastic = line.pairs.iter().all(|p| p.restitution == 1);
    let walls = line.has_left_wall() || line.has_right_wall();
    // What the laws give exactly needs no enclosure.
    let energy = if elastic {
        Energy {
            initial: Value::Exact(energy.clone()),
            last: Value::Exact(energy),
            lost: Value::Exact(Rational::from(0)),
        }
    } else {
        Energy { initial: Value::Exact(energy), last: value(&last)?, lost: value(&lost)? }
    };
    let after = if walls { value(&sum(&|m, v| m.times(v, bits)))? } else { Value::Exact(momentum.clone()) };
    Some(Outcome {
        status,
        count: made.count,
        events: made.events,
        joins: run.joins,
        joined: run.joined.clone(),
        time: value(&time)?,
        velocities: line.body_points().map(|k| value(&end.v[k])).collect::<Option<_>>()?,
        positions: line.body_points().map(place).collect::<Option<_>>()?,
        energy,
        momentum: (Value::Exact(momentum), after),
        simultaneous: run.simultaneous,
        any_order: run.frees,
        before_any_order: run.free,
        growth: run.growth.clone(),
        enclosed: Some(Enclosed { after: run.count(), bits: made.bits, entries: history.entries() }),
    })
}

/// The state at the end of an exact run.
pub(super) fn conclude(run: Run, status: Status, options: &Options) -> Outcome {
    let line = run.line;
    let start: Vec<Rational> = line.points.iter().map(|p| p.velocity.clone()).collect();
    let mut v = run.v.clone();
    let mut joined = None;
    let time = match (&status, &options.until) {
        (Status::Collapse(found), _) => {
            let points = found.bodies.0 - line.first..=found.bodies.1 - line.first;
            for k in points.clone() {
                v[k] = found.velocity.clone();
            }
            joined = Some(points);
            found.time.clone()
        }
        (Status::Ambiguous(contact), _) => Value::Exact(contact.time.clone()),
        (Status::Complete, Some(until)) => Value::Exact(until.clone()),
        _ => run.time(),
    };
    let positions = line.body_points().map(|k| {
        let offset = &line.points[k].offset;
        match &status {
            Status::Collapse(found) if joined.as_ref().is_some_and(|j| j.contains(&k)) => {
                let second = found.second() - line.first;
                found.position.plus(&(offset - &line.points[second].offset))
            }
            _ => time.times(&run.v[k]).plus(&(&run.b[k] + offset)),
        }
    });
    let positions = positions.collect();
    let initial = ledger::energy(line, &start);
    let last = ledger::energy(line, &v);
    let count = run.count();
    let mut growth = run.growth;
    if growth.last().is_none_or(|g| g.0 < count) {
        growth.push((count, run.largest));
    }
    Outcome {
        status,
        count,
        events: run.events,
        joins: run.joins,
        joined: run.joined,
        time,
        positions,
        energy: Energy {
            lost: Value::Exact(&initial - &last),
            initial: Value::Exact(initial),
            last: Value::Exact(last),
        },
        momentum: (Value::Exact(ledger::momentum(line, &start)), Value::Exact(ledger::momentum(line, &v))),
        velocities: line.body_points().map(|k| Value::Exact(v[k].clone())).collect(),
        simultaneous: run.simultaneous,
        any_order: run.frees,
        before_any_order: run.free,
        growth,
        enclosed: None,
    }
}
