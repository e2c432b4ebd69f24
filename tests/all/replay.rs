//! Replay against independent oracles: a naive simulator, the two-term recurrence of three bodies, the formulas of
//! the paper, and what others have proved.

use carom::chain::replay::{
    Body, Cause, Collapse, Entry, Joined, Limit, Line, LineError, Options, Outcome, Status, Value, Wall, replay,
};
use malachite::Rational;
use malachite::base::num::arithmetic::traits::Pow;
use std::cmp::Ordering;

fn q(n: i64, d: i64) -> Rational {
    Rational::from_signeds(n, d)
}

fn n(text: &str) -> Rational {
    carom::number::rational::parse(text).expect("a numeral")
}

fn body(mass: Rational, position: Rational, velocity: Rational) -> Body {
    Body { mass, position, velocity, length: q(0, 1) }
}

/// Masses, positions and velocities, one restitution for all.
fn line(masses: &[Rational], places: &[Rational], speeds: &[Rational], e: &Rational) -> Line {
    let bodies = bodies(masses, places, speeds);
    Line::new(&bodies, &vec![e.clone(); masses.len() - 1], None, None).expect("a valid line")
}

fn bodies(masses: &[Rational], places: &[Rational], speeds: &[Rational]) -> Vec<Body> {
    masses.iter().zip(places).zip(speeds).map(|((m, x), v)| body(m.clone(), x.clone(), v.clone())).collect()
}

/// The first body strikes bodies at rest, a unit apart.
fn struck(masses: &[Rational], e: &Rational) -> Line {
    let places: Vec<Rational> = (0..masses.len()).map(|i| q(i as i64, 1)).collect();
    let speeds: Vec<Rational> = (0..masses.len()).map(|i| q(i64::from(i == 0), 1)).collect();
    line(masses, &places, &speeds, e)
}

/// Replays with room for every scene that is meant to end.
fn run(line: &Line) -> Outcome {
    let options = Options { max_events: 20_000, list: 1000, ..Options::default() };
    replay(line, &options).expect("the ledger balances")
}

fn exact(value: &Value) -> &Rational {
    value.rational().expect("a rational value")
}

fn velocities(outcome: &Outcome) -> Vec<Rational> {
    outcome.velocities.iter().map(|v| exact(v).clone()).collect()
}

fn collapse(outcome: &Outcome) -> &Collapse {
    match &outcome.status {
        Status::Collapse(found) => found,
        other => panic!("no collapse but {other:?} after {}", outcome.count),
    }
}

/// A small generator: every failure names its seed.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678_9abc_def1)
    }

    fn below(&mut self, n: u64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n) as i64
    }
}

/// The textbook way, with nothing in common with the engine: positions now, all pairs scanned.
#[derive(Clone)]
struct Naive {
    x: Vec<Rational>,
    v: Vec<Rational>,
    /// `None` for a wall.
    m: Vec<Option<Rational>>,
    /// Half the length of a rod.
    half: Vec<Rational>,
    e: Vec<Rational>,
    now: Rational,
}

impl Naive {
    fn new(bodies: &[Body], e: &[Rational], left: Option<&Wall>, right: Option<&Wall>) -> Naive {
        let mut naive = Naive { x: vec![], v: vec![], m: vec![], half: vec![], e: vec![], now: q(0, 1) };
        let mut put = |x: &Rational, v: Rational, m: Option<Rational>, half: Rational| {
            naive.x.push(x.clone());
            naive.v.push(v);
            naive.m.push(m);
            naive.half.push(half);
        };
        left.iter().for_each(|w| put(&w.position, q(0, 1), None, q(0, 1)));
        bodies.iter().for_each(|b| put(&b.position, b.velocity.clone(), Some(b.mass.clone()), &b.length / q(2, 1)));
        right.iter().for_each(|w| put(&w.position, q(0, 1), None, q(0, 1)));
        naive.e.extend(left.map(|w| w.restitution.clone()));
        naive.e.extend_from_slice(e);
        naive.e.extend(right.map(|w| w.restitution.clone()));
        naive
    }

    fn gap(&self, p: usize) -> Rational {
        &self.x[p + 1] - &self.half[p + 1] - &self.x[p] - &self.half[p]
    }

    /// All pairs that meet next, and when.
    fn next(&self) -> Option<(Rational, Vec<usize>)> {
        let mut best: Option<(Rational, Vec<usize>)> = None;
        for p in 0..self.e.len() {
            if self.v[p] <= self.v[p + 1] {
                continue;
            }
            let wait = self.gap(p) / (&self.v[p] - &self.v[p + 1]);
            match &mut best {
                Some((t, pairs)) if *t == wait => pairs.push(p),
                Some((t, _)) if *t < wait => {}
                _ => best = Some((wait, vec![p])),
            }
        }
        best
    }

    fn wait(&mut self, wait: &Rational) {
        for (x, v) in self.x.iter_mut().zip(&self.v) {
            *x += v * wait;
        }
        self.now += wait;
    }

    /// Solves conservation and restitution as two linear equations.
    fn collide(&mut self, p: usize) {
        let (l, r, e) = (self.v[p].clone(), self.v[p + 1].clone(), &self.e[p]);
        let apart = e * (&l - &r);
        match (&self.m[p], &self.m[p + 1]) {
            (Some(a), Some(b)) => {
                let momentum = a * &l + b * &r;
                self.v[p] = (&momentum - b * &apart) / (a + b);
                self.v[p + 1] = &self.v[p] + apart;
            }
            (None, _) => self.v[p + 1] = apart + l,
            (_, None) => self.v[p] = r - apart,
        }
    }

    fn step(&mut self, wait: &Rational, pairs: &[usize]) {
        self.wait(wait);
        pairs.iter().for_each(|p| self.collide(*p));
    }

    /// Whether the order of collisions in the cluster of touching points around a pair changes the velocities after it or
    /// the number of collisions: every sequence is played, those of more than 200 collisions are not (`None`).
    fn order_matters(&self, p: usize) -> Option<bool> {
        let (mut from, mut to) = (p, p + 1);
        while from > 0 && self.gap(from - 1) == 0 {
            from -= 1;
        }
        while to < self.e.len() && self.gap(to) == 0 {
            to += 1;
        }
        let (mut layer, mut ends) = (vec![self.clone()], Vec::new());
        for count in 0..=200 {
            let mut next: Vec<Naive> = Vec::new();
            for state in layer {
                let due: Vec<usize> = (from..to).filter(|p| state.v[*p] > state.v[p + 1]).collect();
                if due.is_empty() && !ends.contains(&(count, state.v.clone())) {
                    ends.push((count, state.v.clone()));
                }
                for p in due {
                    let mut after = state.clone();
                    after.collide(p);
                    if next.iter().all(|known| known.v != after.v) {
                        next.push(after);
                    }
                }
            }
            if next.is_empty() || ends.len() > 1 || next.len() > 400 {
                let known = next.is_empty() || ends.len() > 1;
                return known.then_some(ends.len() > 1);
            }
            layer = next;
        }
        None
    }

    fn energy(&self) -> Rational {
        let all = self.m.iter().zip(&self.v).filter_map(|(m, v)| m.as_ref().map(|m| m * v * v / q(2, 1)));
        all.fold(q(0, 1), |a, b| a + b)
    }

    /// The velocity that momentum gives points that move as one, and where their centre of mass is: for each, the
    /// place where it would stand if all were one already.
    fn as_one(&self, first: usize, last: usize) -> (Rational, Vec<Rational>) {
        let stand = self.stand(first, last);
        let at = |edge: Rational| stand.iter().map(|s| &edge + s).collect();
        let (mut mass, mut momentum, mut moment) = (q(0, 1), q(0, 1), q(0, 1));
        for (k, stand) in (first..=last).zip(&stand) {
            let Some(m) = &self.m[k] else {
                return (q(0, 1), at(&self.x[k] - stand));
            };
            mass += m;
            momentum += m * &self.v[k];
            moment += m * (&self.x[k] - stand);
        }
        (momentum / &mass, at(moment / mass))
    }

    /// Where each of the points stands, seen from the left edge of their row.
    fn stand(&self, first: usize, last: usize) -> Vec<Rational> {
        let mut along = q(0, 1);
        let mut all = Vec::new();
        for k in first..=last {
            along += &self.half[k];
            all.push(along.clone());
            along += &self.half[k];
        }
        all
    }
}

/// What the random scenes had in them.
#[derive(Default, Debug)]
struct Seen {
    collisions: u64,
    simultaneous: u64,
    ambiguous: u64,
    free: u64,
    collapsed: u64,
    inelastic: u64,
    through: u64,
    unlike: u64,
    rods: u64,
    walls: u64,
    scaled: u64,
}

/// Infinitely many collisions of touching bodies at one instant: from here on any order comes near the velocity that is
/// claimed, and nobody beside them is met on the way.
fn comes_together(naive: &Naive, found: &Joined, first: usize, random: &mut Random, seed: u64) {
    let (from, to) = (found.bodies.0 - first, found.bodies.1 - first);
    let mut near = naive.clone();
    assert!((from..to).all(|p| near.gap(p) == 0), "seed {seed}: they do not touch");
    let far = |naive: &Naive| -> Rational {
        naive.v[from..=to]
            .iter()
            .map(|v| if *v > found.velocity { v - &found.velocity } else { &found.velocity - v })
            .max()
            .expect("points")
    };
    let start = far(&near);
    let mut steps = 0;
    while far(&near) * q(20, 1) > start {
        let due: Vec<usize> = (from..to).filter(|p| near.v[*p] > near.v[p + 1]).collect();
        assert!(!due.is_empty(), "seed {seed}: {:?} ends before {}", &near.v[from..=to], found.velocity);
        near.collide(due[random.below(due.len() as u64) as usize]);
        for p in [from.checked_sub(1), (to < near.e.len()).then_some(to)].into_iter().flatten() {
            assert!(near.gap(p) > 0 || near.v[p] <= near.v[p + 1], "seed {seed}: the order would matter");
        }
        steps += 1;
        assert!(steps < 3000, "seed {seed}: {} is not approached", found.velocity);
    }
}

/// A random scene, few different values: ties, contacts of three and bodies in touch are common.
fn scene_and_oracle(seed: u64, seen: &mut Seen) {
    let mut random = Random::new(seed);
    let count = 2 + random.below(5) as usize;
    let rods = random.below(3) == 0;
    let same_mass = random.below(3) == 0;
    let kind = if seed % 8 == 7 { 4 } else { random.below(4) };
    let choices = match kind {
        0 => vec![q(0, 1)],
        1 => vec![q(0, 1), q(1, 2), q(1, 1)],
        2 => vec![q(0, 1), q(1, 2), q(9, 10), q(1, 1), q(1, 1)],
        4 => vec![q(1, 1)],
        _ => vec![q(1, 20), q(1, 9), q(1, 2), q(0, 1)],
    };
    let pick = |random: &mut Random| choices[random.below(choices.len() as u64) as usize].clone();
    let mut edge = q(0, 1);
    let mut bodies: Vec<Body> = Vec::new();
    for i in 0..count {
        let length = if rods { q(random.below(3), 2) } else { q(0, 1) };
        let at = if i == 0 { q(0, 1) } else { &edge + q(random.below(4), 1 + random.below(2)) + &length / q(2, 1) };
        edge = &at + &length / q(2, 1);
        let ratio = if kind == 4 { Rational::from(10).pow(random.below(13) - 6) } else { q(1, 1) };
        let mass = if same_mass { q(2, 1) } else { q(1 + random.below(3), 1) * ratio };
        bodies.push(Body { mass, position: at, velocity: q(random.below(7) - 3, 1), length });
    }
    let e: Vec<Rational> = (1..count).map(|_| pick(&mut random)).collect();
    let start = &bodies[0].position - &bodies[0].length / q(2, 1);
    let left = (random.below(3) == 0)
        .then(|| Wall { position: start - q(random.below(3), 1), restitution: pick(&mut random) });
    let right =
        (random.below(3) == 0).then(|| Wall { position: edge + q(random.below(3), 1), restitution: pick(&mut random) });
    let (mut left, mut right) = (left, right);
    if seed % 4 == 3 {
        // Far beyond doubles, and near to what they hold; elastic bodies with a scale for times, too.
        let mut scale = || -> Rational {
            let size = [0i64, 17, 150, 160, 310, 330, 400][random.below(7) as usize];
            Rational::from(10).pow(if random.below(2) == 0 { size } else { -size })
        };
        let (place, mass) = (scale(), scale());
        let speed = if kind == 4 { scale() } else { place.clone() };
        for body in &mut bodies {
            body.position *= &place;
            body.length *= &place;
            body.velocity *= &speed;
            body.mass *= &mass;
        }
        left.iter_mut().chain(&mut right).for_each(|wall| wall.position *= &place);
        seen.scaled += 1;
    }
    seen.rods += u64::from(rods);
    seen.walls += u64::from(left.is_some() || right.is_some());
    let line = Line::new(&bodies, &e, left.as_ref(), right.as_ref()).expect("a valid line");
    let through_collapse = random.below(2) == 0;
    let options = Options { max_events: 60, through_collapse, ..Options::default() };
    let outcome = replay(&line, &options).expect("the ledger balances");
    let followed = carom::chain::replay::follow(&line, &options).expect("the sums agree");
    assert_eq!(followed.count(), Some(outcome.count), "seed {seed}");
    if !matches!(outcome.status, Status::Collapse(_)) {
        for ((lo, hi), v) in followed.velocities().into_iter().zip(velocities(&outcome)) {
            // An infinite bound is none.
            assert!(Rational::try_from(lo).map_or(lo < 0.0, |lo| lo <= v), "seed {seed}: {v} below {lo}");
            assert!(Rational::try_from(hi).map_or(hi > 0.0, |hi| hi >= v), "seed {seed}: {v} above {hi}");
        }
    }
    follow(&outcome, Naive::new(&bodies, &e, left.as_ref(), right.as_ref()), left.is_none(), seed, seen);
}

/// Holds a replay against the naive simulator, entry by entry.
fn follow(outcome: &Outcome, mut naive: Naive, no_left_wall: bool, seed: u64, seen: &mut Seen) {
    let first = usize::from(no_left_wall);
    let mut random = Random::new(seed ^ 99);
    let mut done = 0u64;
    let mut instant: Option<Rational> = None;
    let initial = naive.energy();
    for entry in outcome.in_order() {
        match entry {
            Entry::Collision(number, c) => {
                let (wait, pairs) = naive.next().unwrap_or_else(|| panic!("seed {seed}: nothing due after {done}"));
                naive.wait(&wait);
                let p = c.pair - first;
                assert!(pairs.contains(&p), "seed {seed}, collision {number}: {p} of {pairs:?}");
                // Several pairs may approach in one cluster at one instant only where their order does not matter.
                for other in pairs.iter().filter(|other| **other != p) {
                    let (from, to) = (p.min(*other), p.max(*other));
                    let linked = (from + 1..to).all(|r| naive.gap(r) == 0);
                    let soft = (from..=to).all(|r| naive.e[r] == 0);
                    let free = !linked || soft || naive.order_matters(p) == Some(false);
                    assert!(free, "seed {seed}, collision {number}: the order is open");
                    seen.free += u64::from(linked && !soft);
                }
                let before = [naive.v[p].clone(), naive.v[p + 1].clone()];
                let energy = naive.energy();
                naive.collide(p);
                assert_eq!(*exact(&c.time), naive.now, "seed {seed}, collision {number}");
                assert_eq!(*exact(&c.position), &naive.x[p] + &naive.half[p], "seed {seed}, collision {number}");
                assert_eq!([exact(&c.before[0]), exact(&c.before[1])], [&before[0], &before[1]], "seed {seed}");
                assert_eq!([exact(&c.after[0]), exact(&c.after[1])], [&naive.v[p], &naive.v[p + 1]], "seed {seed}");
                assert_eq!(*exact(&c.lost), energy - naive.energy(), "seed {seed}");
                done += 1;
                assert_eq!(number, done, "seed {seed}");
                seen.simultaneous += u64::from(instant.as_ref() == Some(&naive.now));
                instant = Some(naive.now.clone());
            }
            Entry::Joined(found) => {
                assert_eq!(found.after, done, "seed {seed}");
                let (from, to) = (found.bodies.0 - first, found.bodies.1 - first);
                assert!(to > from + 1, "seed {seed}: two bodies collide once");
                match &found.cause {
                    Cause::Inelastic => {
                        let (wait, pairs) = naive.next().expect("something is due");
                        naive.wait(&wait);
                        assert_eq!(*exact(&found.time), naive.now, "seed {seed}");
                        assert!(pairs.iter().any(|p| (from..to).contains(p)), "seed {seed}");
                        assert!((from..to).any(|p| naive.e[p] == 0), "seed {seed}: nobody sticks");
                        seen.unlike += u64::from((from..to).any(|p| naive.e[p] != 0));
                        comes_together(&naive, found, first, &mut random, seed);
                        assert_eq!(*exact(&found.position), &naive.x[from] + &naive.half[from], "seed {seed}");
                        seen.inelastic += 1;
                    }
                    Cause::Collapse(collapse) => {
                        infinite(&naive, collapse, first, seed);
                        seen.through += 1;
                    }
                }
                let (v, x) = naive.as_one(from, to);
                let energy = naive.energy();
                assert_eq!(found.before, [naive.v[from].clone(), naive.v[to].clone()], "seed {seed}");
                for (k, x) in (from..=to).zip(x) {
                    // Before the collapse this is where the row would stand: what comes after is the same.
                    naive.v[k] = v.clone();
                    naive.x[k] = x;
                }
                assert_eq!(found.velocity, v, "seed {seed}");
                assert_eq!(found.lost, energy - naive.energy(), "seed {seed}");
                if let Some((wait, _)) = naive.next() {
                    let next = wait + &naive.now;
                    assert_ne!(found.time.compare(&next), Some(Ordering::Greater), "seed {seed}: back in time");
                }
            }
        }
    }
    assert_eq!(done, outcome.count, "seed {seed}");
    seen.collisions += done;
    if !matches!(outcome.status, Status::Collapse(_)) {
        let bodies = naive.m.iter().zip(&naive.v).filter(|(m, _)| m.is_some()).map(|(_, v)| v.clone());
        assert_eq!(velocities(outcome), bodies.collect::<Vec<_>>(), "seed {seed}");
        assert_eq!(*exact(&outcome.energy.lost), initial - naive.energy(), "seed {seed}");
    }
    match &outcome.status {
        Status::Complete => {
            assert!(naive.next().is_none(), "seed {seed}: it goes on");
            if let Some(time) = outcome.time.rational() {
                let wait = time - &naive.now;
                naive.wait(&wait);
                let bodies = naive.m.iter().zip(&naive.x).filter(|(m, _)| m.is_some()).map(|(_, x)| x);
                assert!(bodies.zip(&outcome.positions).all(|(x, value)| x == exact(value)), "seed {seed}");
            }
        }
        Status::Limit(_) => assert!(done >= 60 && naive.next().is_some(), "seed {seed}"),
        Status::Ambiguous(found) => {
            seen.ambiguous += 1;
            let (wait, pairs) = naive.next().expect("something is due");
            assert_eq!(&naive.now + &wait, found.time, "seed {seed}");
            assert!(pairs.len() > 1, "seed {seed}");
            naive.wait(&wait);
            let (from, to) = (found.bodies.0 - first, found.bodies.1 - first);
            assert!((from..to).all(|p| naive.gap(p) == 0), "seed {seed}: not all touch");
            assert!((from..to).any(|p| naive.e[p] != 0), "seed {seed}: with restitution 0 the end is known");
            assert!(found.pairs.len() > 1 && found.pairs.iter().all(|p| pairs.contains(&(p - first))));
            assert_ne!(naive.order_matters(found.pairs[0] - first), Some(false), "seed {seed}: every order does");
        }
        Status::Collapse(found) => {
            seen.collapsed += 1;
            infinite(&naive, found, first, seed);
        }
    }
}

/// Forty more collisions, and as many as it takes to come near, all stay before the time of the collapse.
fn infinite(naive: &Naive, found: &Collapse, first: usize, seed: u64) {
    let mut naive = naive.clone();
    let (mut done, mut gap) = (0, None);
    while done < 40 || !(found.critical || gap.as_ref().is_some_and(|g| *g < q(1, 1000))) {
        let Some((wait, pairs)) = naive.next() else { panic!("seed {seed}: the pattern ends") };
        // Others may collide elsewhere at the instant of the collapse, not before it.
        let (ours, others): (Vec<usize>, Vec<usize>) =
            pairs.iter().partition(|p| (found.bodies.0..found.bodies.1).contains(&(**p + first)));
        assert_eq!(ours.len(), 1, "seed {seed}");
        assert!(
            others.is_empty() || found.time.compare(&(&naive.now + &wait)).is_some_and(Ordering::is_eq),
            "seed {seed}"
        );
        naive.step(&wait, &ours);
        assert_ne!(found.time.compare(&naive.now), Some(Ordering::Less), "seed {seed}: past the collapse");
        let closer = found.time.enclose(300).1 - &naive.now;
        assert!(gap.is_none_or(|g| closer <= g), "seed {seed}");
        gap = Some(closer);
        done += 1;
        assert!(done < 3000, "seed {seed}: the time of the collapse is not approached");
    }
}

/// `CAROM_REPLAY_SCENES=100000 cargo test --test all replay::random_scenes -- --nocapture` tries more.
#[test]
fn random_scenes_agree_with_a_naive_simulator_event_by_event() {
    let scenes = std::env::var("CAROM_REPLAY_SCENES").map_or(3000, |n| n.parse().expect("a number of scenes"));
    let mut seen = Seen::default();
    for seed in 0..scenes {
        scene_and_oracle(seed, &mut seen);
    }
    println!("{scenes} scenes: {seen:?}");
    assert!(seen.collisions > 5000 && seen.simultaneous > 50 && seen.ambiguous > 50 && seen.free > 20, "{seen:?}");
    assert!(seen.inelastic > 50 && seen.unlike > 5 && seen.collapsed > 10 && seen.through > 10, "{seen:?}");
    assert!(seen.scaled > 500, "{seen:?}");
}

/// Collisions of three bodies, the first moving, from the recurrence of approach speeds (no times, no positions).
fn recurrence(m: &[Rational; 3], e: &Rational, most: u64) -> u64 {
    let share = |a: &Rational, b: &Rational| (q(1, 1) + e) * a / (a + b);
    let shares = [share(&m[0], &m[1]), share(&m[2], &m[1])];
    let (mut before, mut now) = (q(0, 1), q(1, 1));
    let mut count = 0;
    while now > 0 && count < most {
        let next = &shares[(count % 2) as usize] * &now - e * &before;
        before = now;
        now = next;
        count += 1;
    }
    count
}

/// Whether three bodies collide for ever: (1+e)²·cos²θ ≥ 4e.
fn for_ever(m: &[Rational; 3], e: &Rational) -> Ordering {
    let cos = &m[0] * &m[2] / ((&m[0] + &m[1]) * (&m[1] + &m[2]));
    ((q(1, 1) + e).pow(2u64) * cos).cmp(&(q(4, 1) * e))
}

/// ⌈π/ψ⌉ − 1 in doubles, `None` where that is too near to a jump.
fn law(m: &[Rational; 3], e: &Rational) -> Option<u64> {
    use malachite::base::num::conversion::traits::RoundingFrom;
    use malachite::base::rounding_modes::RoundingMode;
    let f = |x: &Rational| f64::rounding_from(x, RoundingMode::Nearest).0;
    let cos = (f(&m[0]) * f(&m[2]) / ((f(&m[0]) + f(&m[1])) * (f(&m[1]) + f(&m[2])))).sqrt();
    let psi = ((1.0 + f(e)) * cos / (2.0 * f(e).sqrt())).acos();
    let count = std::f64::consts::PI / psi;
    ((count - count.round()).abs() > 1e-7).then(|| count.ceil() as u64 - 1)
}

#[test]
fn three_bodies_obey_the_general_law() {
    let (mut finite, mut infinite, mut by_law, mut longest) = (0, 0, 0, 0);
    for seed in 0..6000 {
        let mut random = Random::new(seed);
        let m: [Rational; 3] = std::array::from_fn(|_| q(1 + random.below(30), 1 + random.below(5)));
        let e = q(1 + random.below(40), 1 + 40);
        let e = if random.below(2) == 0 { &e * &e } else { e };
        let outcome = run(&struck(&m, &e));
        match for_ever(&m, &e) {
            Ordering::Less => {
                finite += 1;
                assert!(matches!(outcome.status, Status::Complete), "seed {seed}: {m:?} {e} {:?}", outcome.status);
                assert_eq!(outcome.count, recurrence(&m, &e, 1_000_000), "seed {seed}: {m:?} {e}");
                longest = longest.max(outcome.count);
                if let Some(count) = law(&m, &e) {
                    by_law += 1;
                    assert_eq!(outcome.count, count, "seed {seed}: {m:?} {e}");
                }
                let third = (q(1, 1) + &e).pow(2u64) * &m[0] * &m[2] > &e * (&m[0] + &m[1]) * (&m[1] + &m[2]);
                assert_eq!(outcome.count >= 3, third, "seed {seed}");
            }
            order => {
                infinite += 1;
                assert_eq!(collapse(&outcome).critical, order == Ordering::Equal, "seed {seed}");
            }
        }
    }
    println!("{finite} finite, up to {longest} collisions, {by_law} by the law in closed form, {infinite} infinite");
    assert!(finite > 2000 && infinite > 500 && by_law > 2000 && longest > 10);
}

#[test]
fn the_critical_collapse_is_recognised_exactly_and_both_its_sides() {
    let m = [q(3, 1), q(2, 1), q(3, 1)];
    let outcome = run(&struck(&m, &q(1, 9)));
    let found = collapse(&outcome);
    assert!(found.critical);
    assert_eq!(found.factor.rational(), Some(&q(1, 9)));
    assert_eq!(found.time.rational(), Some(&q(4, 1)));
    assert_eq!(found.position.rational(), Some(&q(5, 2)));
    assert_eq!(found.velocity, q(3, 8));
    assert_eq!(*exact(&outcome.energy.lost), q(15, 16));
    for digits in [3u64, 6, 9, 12] {
        let step = q(1, 1) / Rational::from(10).pow(digits);
        let below = run(&struck(&m, &(q(1, 9) - &step)));
        assert!(!collapse(&below).critical, "{digits}");
        let above = run(&struck(&m, &(q(1, 9) + &step)));
        assert!(!matches!(above.status, Status::Collapse(_)), "{digits}");
        if digits <= 6 {
            assert!(matches!(above.status, Status::Complete), "{digits}");
            assert_eq!(above.count, recurrence(&m, &(q(1, 9) + &step), 1_000_000));
        }
    }
    // Two restitutions: (1+e1)(1+e2)cos²θ = (√e1+√e2)² at 1/4, 1/9 for masses 2, 1, 3.
    let bodies = |e1: Rational| {
        let all = [body(q(2, 1), q(0, 1), q(1, 1)), body(q(1, 1), q(1, 1), q(0, 1)), body(q(3, 1), q(2, 1), q(0, 1))];
        run(&Line::new(&all, &[e1, q(1, 9)], None, None).expect("a valid line"))
    };
    assert!(collapse(&bodies(q(1, 4))).critical);
    assert!(!collapse(&bodies(q(1, 4) - n("1e-9"))).critical);
    assert!(matches!(bodies(q(1, 4) + n("1e-5")).status, Status::Complete));
}

#[test]
fn equal_masses_meet_as_often_as_mcnamara_and_young_say() {
    let m = [q(1, 1), q(1, 1), q(1, 1)];
    let at = |e: &str| run(&struck(&m, &n(e)));
    for e in ["1", "0.999999", "1/2", "0.17157287525380991", "1/5"] {
        let outcome = at(e);
        assert_eq!(outcome.count, if e == "1" { 2 } else { 3 }, "{e}");
        let e = n(e);
        if e < 1 {
            let one = q(1, 1);
            let expected = vec![
                (&one - &e) * (&e * &e + q(3, 1)) / q(8, 1),
                (&one + &e) * (&one - &e) * (q(3, 1) - &e) / q(8, 1),
                ((&one + &e) / q(2, 1)).pow(2u64),
            ];
            assert_eq!(velocities(&outcome), expected);
        }
    }
    // 3 − 2√2 = 0.17157287525380990…
    assert_eq!(at("0.17157287525380990").count, 4);
    // 5 − 2√6 = 0.10102051443364380…
    assert!(at("0.10102051443364381").count < 6);
    assert_eq!(at("0.10102051443364380").count, 6);
    // 7 − 4√3 = 0.07179676972449082589…
    assert!(matches!(at("0.0717967").status, Status::Collapse(_)));
    assert!(matches!(at("0.07179676972449082").status, Status::Collapse(_)));
    assert!(!matches!(at("0.07179676972449083").status, Status::Collapse(_)));
    let near = at("0.0718");
    assert!(matches!(near.status, Status::Complete));
    assert_eq!(near.count, recurrence(&m, &n("0.0718"), 1_000_000));
    assert_eq!(collapse(&at("0.05")).time.rational(), Some(&q(7, 2)));
    // An eigenvalue that is not rational.
    let found = at("0.06");
    let found = collapse(&found);
    assert!(found.time.rational().is_none() && found.factor.rational().is_none());
    let (lo, hi) = found.time.enclose(100);
    assert!(
        lo < hi
            && found.time.compare(&lo) == Some(Ordering::Greater)
            && found.time.compare(&hi) == Some(Ordering::Less)
    );
}

#[test]
fn elastic_triples_collide_at_most_as_often_as_the_angle_allows() {
    // ⌈π/arccos √(ac/((a+b)(b+c)))⌉ for (k, 1, k).
    for (k, most) in (1..=10).zip([3u64, 4, 5, 5, 6, 6, 7, 7, 7, 8]) {
        let m = [q(k, 1), q(1, 1), q(k, 1)];
        let mut best = 0;
        for step in 0..30 {
            // The first pair meets soon, slowly; the second approaches too, later.
            let second = q(step * step, 4);
            let places = [q(0, 1), q(1, 100), q(1000, 1)];
            let speeds = [q(1, 1), q(0, 1), -second];
            let outcome = run(&line(&m, &places, &speeds, &q(1, 1)));
            assert!(matches!(outcome.status, Status::Complete));
            best = best.max(outcome.count);
        }
        assert_eq!(best, most, "({k}, 1, {k})");
    }
}

#[test]
fn full_transfer_at_the_masses_of_ee_and_lee() {
    // M, αM, M with α = sec(π/3) − 1 = 1: two collisions hand everything on. α = sec(π/5) − 1 = √5 − 2 is irrational.
    let outcome = run(&struck(&[q(1, 1), q(1, 1), q(1, 1)], &q(1, 1)));
    assert_eq!(velocities(&outcome), [q(0, 1), q(0, 1), q(1, 1)]);
    assert_eq!(outcome.count, 2);
    for (alpha, count) in [("0.2360679774", 5), ("0.2360679775", 4)] {
        let outcome = run(&struck(&[q(1, 1), n(alpha), q(1, 1)], &q(1, 1)));
        let last = velocities(&outcome)[2].clone();
        assert_eq!(outcome.count, count);
        assert!(last > n("0.9999999999") && last <= 1);
    }
}

/// A light body between a wall and a heavy one.
fn heavy(k: u64, options: &Options) -> Outcome {
    let bodies = [body(q(1, 1), q(1, 1), q(0, 1)), body(Rational::from(100).pow(k), q(2, 1), q(-1, 1))];
    let wall = Wall { position: q(0, 1), restitution: q(1, 1) };
    let line = Line::new(&bodies, &[q(1, 1)], Some(&wall), None).expect("a valid line");
    replay(&line, options).expect("the ledger balances")
}

#[test]
fn heavy_bodies_count_the_digits_of_pi() {
    let options = Options { max_events: 4_000_000, list: 0, exact_bits: Some(1000), ..Options::default() };
    for (k, count) in [3u64, 31, 314, 3141, 31_415, 314_159, 3_141_592].into_iter().enumerate() {
        let outcome = heavy(k as u64, &options);
        assert!(matches!(outcome.status, Status::Complete), "k = {k}");
        assert_eq!(outcome.count, count, "k = {k}");
        assert_eq!(outcome.enclosed.is_some(), k > 1, "k = {k}");
    }
}

#[test]
fn enclosed_runs_contain_the_exact_one_and_values_are_exact_on_demand() {
    let exactly = Options { exact_bits: None, max_events: 4000, list: 0, ..Options::default() };
    let truth = heavy(2, &exactly);
    assert!(truth.enclosed.is_none() && truth.count == 314);
    for bits in [10, 100, 2000] {
        let options = Options { exact_bits: Some(bits), ..exactly.clone() };
        let enclosed = heavy(2, &options);
        assert!(enclosed.enclosed.is_some_and(|e| e.after < 314));
        assert_eq!(enclosed.count, 314);
        for (a, b) in enclosed.velocities.iter().zip(&truth.velocities).chain([(&enclosed.time, &truth.time)]) {
            let (lo, hi) = a.enclose(0);
            let x = exact(b);
            assert!(lo <= *x && *x <= hi && &hi - &lo < n("1e-15"));
        }
        let on_demand = heavy(2, &Options { exact_values: true, ..options });
        assert_eq!(velocities(&on_demand), velocities(&truth));
        assert_eq!(on_demand.time, truth.time);
        assert_eq!(on_demand.positions, truth.positions);
    }
}

#[test]
fn equal_elastic_masses_exchange_velocities() {
    for seed in 0..300 {
        let mut random = Random::new(seed);
        let count = 2 + random.below(7) as usize;
        let m = vec![q(1 + random.below(5), 3); count];
        let mut at = q(0, 1);
        let mut places = Vec::new();
        for _ in 0..count {
            at += q(1 + random.below(1000), 7);
            places.push(at.clone());
        }
        let speeds: Vec<Rational> = (0..count).map(|_| q(random.below(41) - 20, 3)).collect();
        let outcome = run(&line(&m, &places, &speeds, &q(1, 1)));
        let mut sorted = speeds.clone();
        sorted.sort();
        assert_eq!(velocities(&outcome), sorted, "seed {seed}");
        let inversions: usize = (0..count).map(|i| (0..i).filter(|j| speeds[*j] > speeds[i]).count()).sum();
        assert_eq!(outcome.count, inversions as u64, "seed {seed}");
        assert!(inversions <= count * (count - 1) / 2);
    }
}

#[test]
fn nearly_equal_masses_can_collide_more_often_than_equal_ones() {
    // Knauf and Stepan: up to (n+1)n(n−1)/6 = 10 for four bodies; equal ones at most n(n−1)/2 = 6.
    let mut most = 0;
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let tiny =
            |random: &mut Random, most: u64| q(1 + random.below(1000), 1000 * 10i64.pow(random.below(most) as u32));
        let size = 10i64.pow(1 + random.below(3) as u32);
        let m: Vec<Rational> = (0..4).map(|_| q(1, 1) + q(random.below(2001) - 1000, 1000 * size)).collect();
        let (mut at, mut speed) = (q(0, 1), q(5, 1));
        let (mut places, mut speeds) = (Vec::new(), Vec::new());
        for _ in 0..4 {
            places.push(at.clone());
            speeds.push(speed.clone());
            at += tiny(&mut random, 4);
            speed -= tiny(&mut random, 6);
        }
        let outcome = run(&line(&m, &places, &speeds, &q(1, 1)));
        assert!(outcome.count <= 10, "seed {seed}: {}", outcome.count);
        most = most.max(outcome.count);
    }
    assert!(most > 6, "at most {most} were seen");
}

#[test]
fn separate_pairs_at_one_instant_are_handled_together() {
    let m = vec![q(1, 1); 4];
    let places = [q(0, 1), q(1, 1), q(5, 1), q(6, 1)];
    let speeds = [q(1, 3), q(0, 1), q(1, 3), q(0, 1)];
    let outcome = run(&line(&m, &places, &speeds, &q(1, 2)));
    assert_eq!(outcome.simultaneous, 1);
    assert_eq!(outcome.events[0].time, outcome.events[1].time);
    assert_eq!((outcome.events[0].pair, outcome.events[1].pair), (1, 3));
    // One part in 10^30 later, they are two instants: doubles could not tell.
    let later = [q(1, 3), q(0, 1), q(1, 3) - n("1e-30"), q(0, 1)];
    let outcome = run(&line(&m, &places, &later, &q(1, 2)));
    assert_eq!(outcome.simultaneous, 0);
    assert!(exact(&outcome.events[0].time) < exact(&outcome.events[1].time));
}

#[test]
fn three_bodies_at_one_place_are_ambiguous_and_a_hair_off_they_are_not() {
    let m = [q(1, 1), q(2, 1), q(1, 1)];
    let speeds = [q(1, 1), q(0, 1), q(-1, 1)];
    let options = Options { orders: true, ..Options::default() };
    let at = |x: Rational| {
        let scene = line(&m, &[q(-1, 3), q(0, 1), x], &speeds, &q(1, 2));
        replay(&scene, &options).expect("the ledger balances")
    };
    let outcome = at(q(1, 3));
    let Status::Ambiguous(found) = &outcome.status else { panic!("{:?}", outcome.status) };
    assert_eq!((found.bodies, found.time.clone()), ((1, 3), q(1, 3)));
    assert_eq!(found.pairs, [1, 2]);
    let orders = found.outcomes.as_ref().expect("asked for");
    assert_eq!(orders.outcomes.len(), 2);
    // The two outcomes are those of the scenes a hair off on either side.
    for (hair, order) in [("1e-40", vec![1, 2, 1]), ("-1e-40", vec![2, 1, 2])] {
        let near = at(q(1, 3) + n(hair));
        assert!(matches!(near.status, Status::Complete));
        let one = orders.outcomes.iter().find(|o| o.order == order).expect("this order");
        assert_eq!(one.velocities, velocities(&near));
    }
    // Equal elastic masses: free in order, not in outcome.
    let equal = line(&[q(1, 1), q(1, 1), q(1, 1)], &[q(-1, 1), q(0, 1), q(1, 1)], &speeds, &q(1, 1));
    let outcome = replay(&equal, &options).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Complete), "{:?}", outcome.status);
    assert_eq!((velocities(&outcome), outcome.count), (vec![q(-1, 1), q(0, 1), q(1, 1)], 3));
    assert_eq!((outcome.any_order, outcome.before_any_order), (1, Some(0)));
}

#[test]
fn an_order_that_does_not_matter_stops_no_replay() {
    let row = |masses: &[Rational], speeds: &[Rational], e: &Rational| {
        // Bodies of length 1, the resting ones in touch, the moving ones in touch a unit away.
        let moving = speeds.iter().filter(|v| **v > 0).count();
        let places: Vec<Rational> = (0..masses.len()).map(|k| q(k as i64, 1) - q(i64::from(k < moving), 1)).collect();
        let mut all = bodies(masses, &places, speeds);
        all.iter_mut().for_each(|body| body.length = q(1, 1));
        run(&Line::new(&all, &vec![e.clone(); masses.len() - 1], None, None).expect("a valid line"))
    };
    let ones = |count: usize| vec![q(1, 1); count];
    // The cradle: as many leave as came.
    for (moving, resting) in [(2, 1), (2, 3), (3, 2), (4, 4), (20, 30)] {
        let speeds: Vec<Rational> = (0..moving + resting).map(|k| q(i64::from(k < moving), 1)).collect();
        let outcome = row(&ones(speeds.len()), &speeds, &q(1, 1));
        assert!(matches!(outcome.status, Status::Complete), "{moving} on {resting}: {:?}", outcome.status);
        let sorted: Vec<Rational> = speeds.iter().rev().cloned().collect();
        assert_eq!((velocities(&outcome), outcome.count), (sorted, (moving * resting) as u64));
    }
    // Elastic masses whose orders agree, although they are unlike: m2(m1 + m2 + m3) = m1·m3.
    let triple = |masses: [i32; 3], e: Rational| {
        let masses = masses.map(Rational::from);
        run(&line(&masses, &[q(-1, 1), q(0, 1), q(1, 1)], &[q(1, 1), q(0, 1), q(-1, 1)], &e))
    };
    let outcome = triple([3, 1, 2], q(1, 1));
    assert!(matches!(outcome.status, Status::Complete), "{:?}", outcome.status);
    assert_eq!((outcome.count, outcome.any_order), (4, 1));
    // With another restitution, or another mass, the order matters.
    assert!(matches!(triple([1, 1, 1], q(9, 10)).status, Status::Ambiguous(_)));
    assert!(matches!(triple([1, 2, 1], q(1, 1)).status, Status::Ambiguous(_)));
    // The same against a wall, where the orders agree as well.
    let wall = Wall { position: q(2, 1), restitution: q(1, 1) };
    let places = [q(0, 1), q(1, 1)];
    let both = |masses: &[Rational]| {
        let bodies = bodies(masses, &places, &[q(2, 1), q(1, 1)]);
        run(&Line::new(&bodies, &[q(1, 1)], None, Some(&wall)).expect("a valid line"))
    };
    let outcome = both(&ones(2));
    assert!(matches!(outcome.status, Status::Complete), "{:?}", outcome.status);
    assert_eq!((velocities(&outcome), outcome.count), (vec![q(-2, 1), q(-1, 1)], 4));
    assert!(matches!(both(&[q(2, 1), q(1, 1)]).status, Status::Ambiguous(_)));
}

#[test]
fn touching_bodies_follow_the_stated_rule() {
    let e = q(1, 1);
    let m = vec![q(1, 1); 3];
    // In touch and at rest together: nothing happens.
    let still = run(&line(&m, &[q(0, 1), q(0, 1), q(0, 1)], &[q(0, 1), q(0, 1), q(0, 1)], &e));
    assert_eq!(still.count, 0);
    // In touch and approaching: at once.
    let now = run(&line(&m[..2], &[q(0, 1), q(0, 1)], &[q(1, 1), q(0, 1)], &e));
    assert_eq!((now.count, exact(&now.time).clone()), (1, q(0, 1)));
    // In touch and separating: never.
    assert_eq!(run(&line(&m[..2], &[q(0, 1), q(0, 1)], &[q(0, 1), q(1, 1)], &e)).count, 0);
    // A cradle: one pair approaches at a time, all at the same instant.
    let cradle = run(&line(&m, &[q(0, 1), q(1, 1), q(1, 1)], &[q(1, 1), q(0, 1), q(0, 1)], &e));
    assert!(matches!(cradle.status, Status::Complete));
    assert_eq!(velocities(&cradle), [q(0, 1), q(0, 1), q(1, 1)]);
    assert!(cradle.events.iter().all(|c| *exact(&c.time) == 1));
    // Two approaching pairs in one cluster, not neighbours of each other: ambiguous as well, where it matters.
    let four = line(&vec![q(1, 1); 4], &vec![q(0, 1); 4], &[q(4, 1), q(0, 1), q(1, 1), q(0, 1)], &q(1, 2));
    assert!(matches!(run(&four).status, Status::Ambiguous(_)));
}

/// Each time that bodies come together: first and last, when, their common velocity.
fn joins(outcome: &Outcome) -> Vec<((usize, usize), Rational, Rational)> {
    outcome.joined.iter().map(|j| (j.bodies, exact(&j.time).clone(), j.velocity.clone())).collect()
}

#[test]
fn bodies_without_restitution_move_on_together_to_the_end() {
    let masses = [q(1, 1), q(2, 1), q(1, 1), q(3, 1), q(5, 1)];
    let outcome = run(&struck(&masses, &q(0, 1)));
    assert!(matches!(outcome.status, Status::Complete), "{:?}", outcome.status);
    // Each new body: the momentum 1 over more mass, a unit apart.
    let expected = [((1, 3), q(4, 1), q(1, 4)), ((1, 4), q(8, 1), q(1, 7)), ((1, 5), q(15, 1), q(1, 12))];
    assert_eq!(joins(&outcome), expected);
    assert_eq!((outcome.count, outcome.joins), (1, 3));
    assert_eq!(velocities(&outcome), vec![q(1, 12); 5]);
    assert!(outcome.positions.iter().all(|x| *exact(x) == 4));
    // m/2 − m/(2·12)
    assert_eq!(*exact(&outcome.energy.lost), q(11, 24));
    // A wall stops them all, and those who come later.
    let wall = Wall { position: q(10, 1), restitution: q(0, 1) };
    let places: Vec<Rational> = (0..5).map(|i| q(i, 1)).collect();
    let speeds: Vec<Rational> = (0..5).map(|i| q(5 - i, 1)).collect();
    let line = Line::new(&bodies(&masses, &places, &speeds), &vec![q(0, 1); 4], None, Some(&wall)).expect("valid");
    let outcome = run(&line);
    assert_eq!(velocities(&outcome), vec![q(0, 1); 5]);
    assert!(outcome.positions.iter().all(|x| *exact(x) == 10));
}

#[test]
fn contacts_without_restitution_are_not_ambiguous_and_mixed_ones_are() {
    let m = [q(1, 1), q(2, 1), q(4, 1)];
    let (places, speeds) = ([q(-1, 1), q(0, 1), q(1, 1)], [q(1, 1), q(0, 1), q(-1, 1)]);
    let with = |left: Rational, right: Rational| {
        run(&Line::new(&bodies(&m, &places, &speeds), &[left, right], None, None).expect("a valid line"))
    };
    // From both sides at once: momentum 1 − 4 on the mass 7.
    assert_eq!(joins(&with(q(0, 1), q(0, 1))), [((1, 3), q(1, 1), q(-3, 7))]);
    assert!(matches!(with(q(0, 1), q(1, 2)).status, Status::Ambiguous(_)));
    assert!(matches!(with(q(1, 2), q(0, 1)).status, Status::Ambiguous(_)));
    // A row that sticks strikes a body with restitution 1 that touches it: which is first is open.
    let all = bodies(
        &[q(1, 1), q(1, 1), q(1, 1), q(1, 1)],
        &[q(0, 1), q(1, 1), q(1, 1), q(1, 1)],
        &[q(1, 1), q(0, 1), q(0, 1), q(0, 1)],
    );
    let line = |all: &[Body]| Line::new(all, &[q(0, 1), q(0, 1), q(1, 1)], None, None).expect("a valid line");
    let outcome = run(&line(&all));
    let Status::Ambiguous(found) = &outcome.status else { panic!("{:?}", outcome.status) };
    assert_eq!((found.bodies, found.pairs.clone()), ((1, 4), vec![1, 3]));
    // If that body is as fast as the row will be, or faster, they never approach.
    let mut faster = all.clone();
    faster[3].velocity = q(1, 3);
    let outcome = run(&line(&faster));
    assert!(matches!(outcome.status, Status::Complete), "{:?}", outcome.status);
    assert_eq!(joins(&outcome), [((1, 3), q(1, 1), q(1, 3))]);
}

#[test]
fn a_hit_with_restitution_parts_bodies_that_stick() {
    // 1 and 2 stick at 1/2 from the time 1 on and strike 3, elastically, at 3: it takes what 2 has, then 1 and 2 share.
    let all = bodies(&[q(1, 1), q(1, 1), q(1, 1)], &[q(0, 1), q(1, 1), q(2, 1)], &[q(1, 1), q(0, 1), q(0, 1)]);
    let at = |e: Rational| run(&Line::new(&all, &[q(0, 1), e], None, None).expect("a valid line"));
    let outcome = at(q(1, 1));
    assert!(matches!(outcome.status, Status::Complete));
    assert_eq!(velocities(&outcome), [q(1, 4), q(1, 4), q(1, 2)]);
    assert_eq!((outcome.count, outcome.joins), (3, 0));
    // With little restitution infinitely often at once, and then they are one: (1 + e)/4 > e.
    let outcome = at(q(1, 9));
    assert!(matches!(outcome.status, Status::Complete), "{:?}", outcome.status);
    assert_eq!(joins(&outcome), [((1, 3), q(3, 1), q(1, 3))]);
    // At (1 + e)/4 = e it is finite.
    let outcome = at(q(1, 3));
    assert_eq!((outcome.joins, velocities(&outcome)), (0, vec![q(1, 3); 3]));
}

#[test]
fn a_collapse_can_be_gone_through_and_its_bodies_are_hit_again() {
    let m = [q(3, 1), q(2, 1), q(3, 1), q(8, 1)];
    let through = Options { through_collapse: true, ..Options::default() };
    // The critical collapse of the first three at 4, at 5/2 with 3/8; the fourth waits at 4, until 8.
    let all = bodies(&m, &[q(0, 1), q(1, 1), q(2, 1), q(4, 1)], &[q(1, 1), q(0, 1), q(0, 1), q(0, 1)]);
    let line = Line::new(&all, &[q(1, 9), q(1, 9), q(1, 1)], None, None).expect("a valid line");
    let ended = replay(&line, &Options::default()).expect("the ledger balances");
    assert!(collapse(&ended).critical);
    let outcome = replay(&line, &through).expect("the ledger balances");
    // Hit at 3, the row is struck apart and together again: 3 alone has 3/8·(3 − 8)/11 then.
    assert_eq!(joins(&outcome), [((1, 3), q(4, 1), q(3, 8)), ((1, 3), q(8, 1), q(15, 88))]);
    let Cause::Collapse(found) = &outcome.joined[0].cause else { panic!("{:?}", outcome.joined) };
    assert!(found.critical);
    let hit = outcome.events.iter().find(|c| c.pair == 3).expect("the fourth is hit");
    assert_eq!((exact(&hit.time), exact(&hit.position)), (&q(8, 1), &q(4, 1)));
    assert_eq!((exact(&hit.before[0]), exact(&hit.before[1])), (&q(3, 8), &q(0, 1)));
    // An irrational instant: the motion after it is rational all the same.
    let e = q(6, 100);
    let all = bodies(&vec![q(1, 1); 4], &[q(0, 1), q(1, 1), q(2, 1), q(9, 1)], &[q(1, 1), q(0, 1), q(0, 1), q(0, 1)]);
    let line = Line::new(&all, &[e.clone(), e, q(1, 1)], None, None).expect("a valid line");
    let outcome = replay(&line, &through).expect("the ledger balances");
    assert!(outcome.joined[0].time.rational().is_none() && outcome.joined[0].velocity == q(1, 3));
    // Their centre of mass was at 1 at the time 0.
    let hit = outcome.events.iter().find(|c| c.pair == 3).expect("the fourth is hit");
    assert_eq!(*exact(&hit.time), q(24, 1));
    assert_ne!(outcome.joined[0].time.compare(exact(&hit.time)), Some(Ordering::Greater));
    // Nothing comes after: the end is the instant itself.
    let alone = Line::new(&all[..3], &[q(6, 100), q(6, 100)], None, None).expect("a valid line");
    let outcome = replay(&alone, &through).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Complete));
    assert!(outcome.time == outcome.joined[0].time && outcome.time.rational().is_none());
}

#[test]
fn a_collapse_at_one_instant_is_not_claimed_past_a_neighbour_that_it_pushes() {
    let e = q(1, 20);
    let outcome = |v: Rational| {
        let all = bodies(&vec![q(1, 1); 4], &vec![q(0, 1); 4], &[q(1, 1), q(0, 1), q(0, 1), v]);
        run(&Line::new(&all, &[e.clone(), e.clone(), q(1, 1)], None, None).expect("a valid line"))
    };
    // The third approaches 1/3 from below.
    let found = outcome(q(1, 3));
    assert_eq!((collapse(&found).bodies, collapse(&found).velocity.clone()), ((1, 3), q(1, 3)));
    for short in ["1e-3", "1e-6", "1e-9"] {
        let found = outcome(q(1, 3) - n(short));
        assert!(matches!(found.status, Status::Ambiguous(_)), "{short}: {:?}", found.status);
    }
}

#[test]
fn bodies_that_never_come_nearer_in_turn_are_no_fault() {
    // The differences of intercepts are a multiple of the closing speeds: a pattern without a direction.
    let all = bodies(&[q(2, 1), q(2, 1)], &[q(0, 1), q(1, 1)], &[q(0, 1), q(1, 1)]);
    let wall = |x| Wall { position: q(x, 1), restitution: q(1, 1) };
    let line = Line::new(&all, &[q(1, 2)], Some(&wall(-1)), Some(&wall(3))).expect("a valid line");
    let outcome = replay(&line, &Options { max_events: 2000, ..Options::default() }).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Limit(_)), "{:?}", outcome.status);
}

#[test]
fn a_wall_can_be_part_of_a_collapse() {
    // Between a wall and a heavy body that comes nearer, a light one with little restitution.
    let bodies = [body(q(1, 1), q(1, 1), q(0, 1)), body(q(100, 1), q(2, 1), q(-1, 1))];
    let wall = Wall { position: q(0, 1), restitution: q(1, 10) };
    let outcome = run(&Line::new(&bodies, &[q(1, 10)], Some(&wall), None).expect("a valid line"));
    let found = collapse(&outcome);
    assert_eq!((found.bodies, found.position.rational()), ((0, 2), Some(&q(0, 1))));
    assert_eq!(found.velocity, 0);
    assert_eq!(*exact(&outcome.energy.last), 0);
    // One body between two walls loses speed for ever, but takes for ever: no collapse.
    let between = Line::new(
        &[body(q(1, 1), q(1, 1), q(1, 1))],
        &[],
        Some(&Wall { position: q(0, 1), restitution: q(1, 2) }),
        Some(&Wall { position: q(2, 1), restitution: q(1, 2) }),
    );
    let options = Options { max_events: 50, ..Options::default() };
    let outcome = replay(&between.expect("a valid line"), &options).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Limit(Limit::Events { allowed: 50 })));
}

#[test]
fn a_collapse_is_not_claimed_where_a_fourth_body_comes_in_time() {
    let e = q(1, 20);
    let m = vec![q(1, 1); 4];
    let speeds = |v: &str| [q(1, 1), q(0, 1), q(0, 1), n(v)];
    let places = [q(0, 1), q(1, 1), q(2, 1), q(100, 1)];
    // The three alone collapse at 7/2, at 13/6; the fourth has to travel 100 − 13/6 until then.
    let critical = (q(100, 1) - q(13, 6)) / q(7, 2);
    for (v, before) in [("-20", false), ("-27", false), ("-29", true), ("-60", true)] {
        let outcome = run(&line(&m, &places, &speeds(v), &e));
        let undisturbed = matches!(&outcome.status, Status::Collapse(c) if c.time.rational() == Some(&q(7, 2)));
        assert_eq!(undisturbed, !before, "{v}, critical {critical}");
        assert_eq!(n(v) < -&critical, before);
    }
    // Arriving exactly at the place and time of the collapse is not before it.
    let mut exactly = speeds("0");
    exactly[3] = -critical;
    let outcome = run(&line(&m, &places, &exactly, &e));
    assert_eq!(collapse(&outcome).time.rational(), Some(&q(7, 2)));
}

#[test]
fn elastic_motion_runs_backwards_to_its_start() {
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let count = 2 + random.below(4) as usize;
        let m: Vec<Rational> = (0..count).map(|_| q(1 + random.below(9), 1)).collect();
        let mut at = q(0, 1);
        let places: Vec<Rational> = (0..count)
            .map(|_| {
                at += q(1 + random.below(997), 13);
                at.clone()
            })
            .collect();
        let speeds: Vec<Rational> = (0..count).map(|_| q(random.below(2001) - 1000, 77)).collect();
        let there = run(&line(&m, &places, &speeds, &q(1, 1)));
        if !matches!(there.status, Status::Complete) || there.count == 0 {
            continue;
        }
        // Beyond the last collision, reversed.
        let late = exact(&there.time) + q(1, 1);
        let options = Options { until: Some(late.clone()), ..Options::default() };
        let there = replay(&line(&m, &places, &speeds, &q(1, 1)), &options).expect("the ledger balances");
        let x: Vec<Rational> = there.positions.iter().map(|x| exact(x).clone()).collect();
        let v: Vec<Rational> = velocities(&there).iter().map(|v| -v).collect();
        let options = Options { until: Some(late), ..Options::default() };
        let back = replay(&line(&m, &x, &v, &q(1, 1)), &options).expect("the ledger balances");
        assert_eq!(back.count, there.count, "seed {seed}");
        assert_eq!(back.positions.iter().map(|x| exact(x).clone()).collect::<Vec<_>>(), places, "seed {seed}");
        assert_eq!(velocities(&back).iter().map(|v| -v).collect::<Vec<_>>(), speeds, "seed {seed}");
    }
}

#[test]
fn rods_collide_like_points_that_are_nearer() {
    let rods = [
        Body { mass: q(2, 1), position: q(0, 1), velocity: q(1, 1), length: q(1, 1) },
        Body { mass: q(1, 1), position: q(2, 1), velocity: q(0, 1), length: q(1, 2) },
        Body { mass: q(3, 1), position: q(4, 1), velocity: q(-1, 2), length: q(2, 1) },
    ];
    let e = [q(1, 2), q(3, 4)];
    let long = run(&Line::new(&rods, &e, None, None).expect("a valid line"));
    // Gaps 2 − 1/2 − 1/4 and 2 − 1/4 − 1.
    let points = [q(0, 1), q(5, 4), q(2, 1)];
    let short = run(&{
        let all: Vec<Body> =
            rods.iter().zip(points).map(|(r, x)| body(r.mass.clone(), x, r.velocity.clone())).collect();
        Line::new(&all, &e, None, None).expect("a valid line")
    });
    assert_eq!(velocities(&long), velocities(&short));
    assert_eq!(long.time, short.time);
    let gap = |o: &Outcome, i: usize| exact(&o.positions[i + 1]) - exact(&o.positions[i]);
    assert_eq!(gap(&long, 0) - gap(&short, 0), q(3, 4));
    assert_eq!(gap(&long, 1) - gap(&short, 1), q(5, 4));
    // The first contact is at the ends of the rods.
    let first = &long.events[0];
    assert_eq!(first.pair, 1);
    assert_eq!(*exact(&first.position), q(7, 4));
    let overlapping = [rods[0].clone(), Body { position: q(1, 2), ..rods[1].clone() }];
    assert_eq!(Line::new(&overlapping, &e[..1], None, None).err(), Some(LineError::Order { body: 2, least: q(3, 4) }));
}

#[test]
fn limits_stop_the_run_and_say_so() {
    let m = [q(3, 1), q(2, 1), q(3, 1)];
    let options = Options { max_events: 2, ..Options::default() };
    let outcome = replay(&struck(&m, &q(1, 9)), &options).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Limit(Limit::Events { allowed: 2 })));
    assert_eq!(outcome.count, 2);
    // The last collision that is allowed may be the last of all.
    let options = Options { max_events: 3, ..Options::default() };
    let outcome = replay(&struck(&[q(1, 1), q(1, 1), q(1, 1)], &q(1, 2)), &options).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Complete));
    let options = Options { until: Some(q(1, 1)), ..Options::default() };
    let outcome = replay(&struck(&m, &q(1, 9)), &options).expect("the ledger balances");
    assert!(matches!(outcome.status, Status::Complete));
    assert_eq!(outcome.count, 1, "a collision at the time itself counts");
}

#[test]
fn the_papers_velocities_are_final_exactly_where_it_is_proved() {
    let (mut single, mut again) = (0, 0);
    for inserted in 1..=4usize {
        for (a, b) in [(1i64, 1i64), (2, 1), (3, 1), (3, 2), (1, 2), (2, 3), (5, 4), (10, 9), (1, 4)] {
            for e in ["0.1", "1/4", "1/2", "2/3", "4/5", "0.9", "1"] {
                let (x, e) = (q(a, b), n(e));
                let links = inserted + 1;
                // (21): masses in geometric progression, with a rational ratio.
                let masses: Vec<Rational> = (0..=links).map(|i| (&x).pow((links - i) as u64)).collect();
                let options = Options { max_events: 60, exact_bits: None, ..Options::default() };
                let outcome = replay(&struck(&masses, &e), &options).expect("the ledger balances");
                let one = q(1, 1);
                let final_once = x <= e || &x * &e >= one;
                let share = (&one + &e) * &x / (&x + &one);
                // (22), (23), (24).
                let mut pass: Vec<Rational> =
                    (0..links).map(|i| (&share).pow(i as u64) * (&x - &e) / (&x + &one)).collect();
                pass.push((&share).pow(links as u64));
                if final_once {
                    single += 1;
                    assert!(matches!(outcome.status, Status::Complete));
                    assert_eq!(outcome.count, links as u64, "x = {x}, e = {e}");
                    assert_eq!(velocities(&outcome), pass, "x = {x}, e = {e}");
                    // (25)
                    let last = &velocities(&outcome)[links];
                    let eta = masses[links].clone() * last * last / &masses[0];
                    let formula = (&one + &e).pow(2 * links as u64) * &masses[0] * &masses[links]
                        / ((&x + &one).pow(2 * links as u64) * (&masses[links]).pow(2u64));
                    assert_eq!(eta, formula, "x = {x}, e = {e}");
                } else {
                    again += 1;
                    assert!(outcome.count > links as u64, "x = {x}, e = {e}: no one meets again");
                    // After the first pass some neighbours still approach.
                    assert!(pass.windows(2).any(|w| w[0] > w[1]), "x = {x}, e = {e}");
                }
            }
        }
    }
    assert!(single > 50 && again > 50);
}

#[test]
fn four_and_more_bodies_collapse_where_three_could_not() {
    // e above 7 − 4√3, so that no three equal bodies collapse alone.
    let (mut found_many, mut other) = (0, 0);
    for seed in 0..16 {
        let mut random = Random::new(seed);
        let count = 4 + random.below(3) as usize;
        let e = q(8 + random.below(5), 100);
        let mut at = q(0, 1);
        let places: Vec<Rational> = (0..count)
            .map(|_| {
                at += q(5 + random.below(20), 7);
                at.clone()
            })
            .collect();
        // Squeezed from both sides.
        let speeds: Vec<Rational> =
            (0..count).map(|i| q(2 * (count as i64) - 4 * i as i64 + random.below(3), 1)).collect();
        let m = vec![q(1, 1); count];
        let scene = line(&m, &places, &speeds, &e);
        let outcome = replay(&scene, &Options { max_events: 400, list: 0, exact_bits: None, ..Options::default() })
            .expect("the ledger balances");
        let Status::Collapse(found) = &outcome.status else {
            other += 1;
            continue;
        };
        assert!(found.bodies.1 - found.bodies.0 >= 3, "seed {seed}: {:?}", found.bodies);
        assert!(found.trace.is_none());
        found_many += 1;
        // The naive simulator goes on by the pattern and stays before the enclosed time.
        let mut naive = Naive::new(&bodies(&m, &places, &speeds), &vec![e; count - 1], None, None);
        let mut done = 0;
        while done < outcome.count {
            let (wait, pairs) = naive.next().expect("something is due");
            naive.step(&wait, &pairs);
            done += pairs.len() as u64;
        }
        let (lo, hi) = found.time.enclose(0);
        assert!(naive.now < lo || naive.now <= hi, "seed {seed}");
        for i in 0..2 * found.pattern.len() {
            let (wait, pairs) = naive.next().expect("something is due");
            naive.step(&wait, &pairs);
            assert_eq!(pairs, [found.pattern[i % found.pattern.len()] - 1], "seed {seed}, collision {i}");
            assert!(naive.now < hi, "seed {seed}");
        }
        assert!(&hi - &naive.now < n("1e-6"), "seed {seed}");
        assert!(&hi - &lo < n("1e-12"), "seed {seed}: time only within {}", &hi - &lo);
    }
    println!("{found_many} collapses of four and more, {other} others");
    assert!(found_many > 3);
}
