//! Points of a law as proptest draws them: exact, and made simpler while a test fails.
//!
//! Contract: at every point all hypotheses hold for certain. A point is made simpler one number at a time, and stays one
//! where they hold.

use super::law::Law;
use carom_exact::number::rational::parse;
use carom_search::refute::goal::Seen;
use carom_search::refute::search::Choice;
use carom_search::refute::trial::Trial;
use malachite::Rational;
use proptest::prelude::Rng;
use proptest::strategy::{NewTree, Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use std::cell::RefCell;
use std::collections::{BTreeMap, VecDeque};
use std::fmt;
use std::ops::Index;

/// The values of a law's variables; a member of a family is called `mu(2)`.
#[derive(Clone, PartialEq)]
pub struct Values {
    numbers: BTreeMap<String, Rational>,
    /// Whether the goal holds there, where that is decided.
    pub(super) holds: Option<bool>,
}

impl Values {
    /// The value of a variable, if the law has it.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Rational> {
        self.numbers.get(name)
    }

    /// Names and values, by name.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Rational)> {
        self.numbers.iter().map(|(name, value)| (name.as_str(), value))
    }
}

impl Index<&str> for Values {
    type Output = Rational;

    /// The value of a variable.
    ///
    /// # Panics
    /// The law has no such variable, as an index beyond a list: [`Values::get`] asks.
    fn index(&self, name: &str) -> &Rational {
        &self.numbers[name]
    }
}

impl fmt::Debug for Values {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown: Vec<String> = self.numbers.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        write!(f, "{}", shown.join(", "))
    }
}

/// The values at a choice; `None` where a hypothesis does not hold for certain.
pub(super) fn values(trial: &mut Trial, choice: &Choice) -> Option<Values> {
    let (seen, point) = trial.at(choice)?;
    let holds = match seen {
        Seen::Holds => Some(true),
        Seen::Fails(_) => Some(false),
        Seen::Open => None,
    };
    let numbers = trial.named(&point).values.into_iter().filter_map(|(name, text)| Some((name, parse(&text).ok()?)));
    Some(Values { numbers: numbers.collect(), holds })
}

/// A point that proptest makes simpler.
pub struct Points {
    trial: RefCell<Trial>,
    now: (Choice, Values),
    /// The simplest point so far at which the test failed.
    failed: (Choice, Values),
    /// Simpler ones that are still to be tried.
    simpler: VecDeque<Choice>,
}

impl Points {
    fn next(&mut self) -> bool {
        while let Some(choice) = self.simpler.pop_front() {
            if let Some(values) = values(&mut self.trial.borrow_mut(), &choice) {
                self.now = (choice, values);
                return true;
            }
        }
        false
    }
}

impl ValueTree for Points {
    type Value = Values;

    fn current(&self) -> Values {
        self.now.1.clone()
    }

    fn simplify(&mut self) -> bool {
        self.failed = self.now.clone();
        self.simpler = Trial::simpler(&self.failed.0).into();
        self.next()
    }

    fn complicate(&mut self) -> bool {
        let more = self.next();
        if !more {
            self.now = self.failed.clone();
        }
        more
    }
}

impl Strategy for Law {
    type Tree = Points;
    type Value = Values;

    fn new_tree(&self, runner: &mut TestRunner) -> NewTree<Self> {
        let mut trial = Trial::new(self.claim()).map_err(|_| "the law cannot be tried at points")?;
        // The bias is far below what a test could notice.
        let mut below = |bound: u64| runner.rng().next_u64() % bound.max(1);
        let found = trial.random(&mut below).and_then(|choice| values(&mut trial, &choice).map(|v| (choice, v)));
        let now = found.ok_or("no point was found that satisfies all hypotheses")?;
        Ok(Points { trial: RefCell::new(trial), failed: now.clone(), now, simpler: VecDeque::new() })
    }
}
