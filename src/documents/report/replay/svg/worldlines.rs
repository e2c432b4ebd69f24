//! The worldlines of a replay as corners of time and place, in doubles: for drawing only.

use super::{EDGE, near};
use crate::chain::replay::{Collision, Entry, Joined, Line, Outcome, Status, Value};
use crate::report::replay::Replay;
use malachite::Rational;

/// The worldlines as corners `(t, x)`, in doubles: for drawing only.
pub struct Worldlines {
    /// One list of corners for each body, first and last at the ends of the picture.
    pub bodies: Vec<Vec<(f64, f64)>>,
    /// Half the length of each body.
    pub half: Vec<f64>,
    /// Where listed collisions happen, infinitely many at once included.
    pub contacts: Vec<(f64, f64)>,
    /// The walls.
    pub walls: (Option<f64>, Option<f64>),
    /// Times and places of infinitely many collisions, and of an ambiguous contact.
    pub marks: Vec<(f64, f64)>,
    /// The last time drawn.
    pub end: f64,
    /// The places drawn.
    pub range: (f64, f64),
}

impl Worldlines {
    /// Follows the listed collisions.
    #[must_use]
    pub fn new(replay: &Replay) -> Worldlines {
        let (line, o) = (replay.line, replay.outcome);
        let mut paths = Paths::begun(line);
        for entry in o.in_order() {
            match entry {
                Entry::Collision(_, c) => paths.collide(c),
                Entry::Joined(j) => paths.join(j),
            }
        }
        let all = o.events.len() as u64 == o.count && o.joined.len() as u64 == o.joins;
        let last = paths.contacts.last().map_or(0.0, |c| c.0);
        let stop = if all { near(&o.time).max(last) } else { last };
        // Some room to see who flies where, unless the picture was asked to end here.
        let end = match (&o.status, stop > 0.0) {
            (Status::Complete, true) if all && stop <= last => stop * 1.15,
            (_, true) => stop,
            (_, false) => 1.0,
        }
        .max(1.0 / EDGE);
        if all {
            paths.mark_end(o);
        }
        paths.fly_on(end);
        let walls = line.walls();
        let walls = (walls.0.as_ref().map(exact), walls.1.as_ref().map(exact));
        let range = paths.range(walls, stop);
        let Paths { bodies, half, contacts, marks, .. } = paths;
        Worldlines { bodies, half, contacts, walls, marks, end, range }
    }
}

fn exact(x: &Rational) -> f64 {
    near(&Value::Exact(x.clone()))
}

/// Worldlines in the making; bodies are counted from 0, points from 1.
struct Paths {
    bodies: Vec<Vec<(f64, f64)>>,
    /// The velocity after the last corner.
    speed: Vec<f64>,
    half: Vec<f64>,
    contacts: Vec<(f64, f64)>,
    marks: Vec<(f64, f64)>,
}

impl Paths {
    fn begun(line: &Line) -> Paths {
        let n = line.bodies();
        let starts: Vec<(f64, f64)> =
            (1..=n).map(|b| line.start(b).map_or((0.0, 0.0), |(x, v)| (exact(&x), exact(&v)))).collect();
        Paths {
            bodies: starts.iter().map(|(x, _)| vec![(0.0, *x)]).collect(),
            speed: starts.iter().map(|(_, v)| *v).collect(),
            half: (1..=n).map(|b| line.half_length(b).map_or(0.0, exact)).collect(),
            contacts: Vec::new(),
            marks: Vec::new(),
        }
    }

    fn collide(&mut self, c: &Collision) {
        let (t, x) = (near(&c.time), near(&c.position));
        self.contacts.push((t, x));
        for (point, after, side) in [(c.pair, &c.after[0], -1.0), (c.pair + 1, &c.after[1], 1.0)] {
            if (1..=self.bodies.len()).contains(&point) {
                self.bodies[point - 1].push((t, x + side * self.half[point - 1]));
                self.speed[point - 1] = near(after);
            }
        }
    }

    fn join(&mut self, j: &Joined) {
        let (t, mut x) = (near(&j.time), near(&j.position));
        self.contacts.push((t, x));
        self.marks.push((t, x));
        // The position is where the first two touch: the first ends there, the second begins.
        if let Some(wide) = j.bodies.0.checked_sub(1).and_then(|first| self.half.get(first)) {
            x -= 2.0 * wide;
        }
        for body in j.bodies.0.max(1)..=j.bodies.1.min(self.bodies.len()) {
            self.bodies[body - 1].push((t, x + self.half[body - 1]));
            x += 2.0 * self.half[body - 1];
            self.speed[body - 1] = exact(&j.velocity);
        }
    }

    /// A collapse, or an ambiguous contact, at the end of a run.
    fn mark_end(&mut self, o: &Outcome) {
        let n = self.bodies.len();
        match &o.status {
            Status::Collapse(found) => {
                let (t, x) = (near(&found.time), near(&found.position));
                self.marks.push((t, x));
                for point in found.bodies.0.max(1)..=found.bodies.1.min(n) {
                    self.bodies[point - 1].push((t, near(&o.positions[point - 1])));
                    self.speed[point - 1] = near(&o.velocities[point - 1]);
                }
            }
            Status::Ambiguous(found) => {
                let point = found.bodies.0.clamp(1, n);
                self.marks.push((near(&o.time), near(&o.positions[point - 1]) + self.half[point - 1]));
            }
            Status::Complete | Status::Limit(_) => {}
        }
    }

    /// Goes on straight to the end of the picture.
    fn fly_on(&mut self, end: f64) {
        for (path, v) in self.bodies.iter_mut().zip(&self.speed) {
            if let Some((t, x)) = path.last().copied().filter(|(t, _)| *t < end) {
                path.push((end, x + v * (end - t)));
            }
        }
    }

    /// The places drawn, with some room. Bodies that fly off after the last collision must not squeeze the rest: what
    /// happens up to `stop` sets the range.
    fn range(&self, walls: (Option<f64>, Option<f64>), stop: f64) -> (f64, f64) {
        let inside = |(t, _): &&(f64, f64)| *t <= stop || stop == 0.0;
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        let mut grow = |x: f64| range = (range.0.min(x), range.1.max(x));
        for (path, h) in self.bodies.iter().zip(&self.half) {
            for (_, x) in path.iter().filter(inside) {
                grow(x - h);
                grow(x + h);
            }
            if let [.., (t0, x0), (t1, x1)] = path.as_slice()
                && *t1 > stop
                && *t1 > *t0
            {
                grow(x0 + (x1 - x0) * (stop.max(*t0) - t0) / (t1 - t0));
            }
        }
        for x in [walls.0, walls.1].into_iter().flatten() {
            grow(x);
        }
        let wide = range.1 - range.0;
        let room = (wide * 0.06).max(1e-9 * range.1.abs());
        let room = if wide > 1.0 / EDGE { room } else { 1.0f64.max(range.1.abs()) };
        (range.0 - room, range.1 + room)
    }
}
