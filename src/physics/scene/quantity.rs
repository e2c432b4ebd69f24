//! What can be asked of a chain, and what each answer needs.

use carom_diagnostic::nearest;

/// A quantity; a closed set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Quantity {
    /// The chain with its masses, ready for the pass; not asked for by name.
    Pass,
    /// The energy transfer.
    Eta,
    /// `L_n`.
    Threshold,
    /// Whether the `n`-th body helps.
    Helps,
    /// All masses.
    Masses,
    /// All velocities after the pass.
    Velocities,
    /// That of the last body alone.
    LastVelocity,
    /// n*: the best number of inserted bodies.
    BestN,
    /// The transfer matrix of each collision.
    Matrix,
    /// The kinetic energy lost in each collision.
    Losses,
    /// Whether bodies meet again after the pass.
    Recollides,
}

/// An input that some quantities do not need. The masses of the first and of the last body are needed by all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// The inserted bodies: their number, or their masses.
    Inserted,
    /// The coefficients of restitution.
    Restitution,
}

impl Input {
    /// What it is.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Inserted => "the number of inserted bodies, or their masses",
            Self::Restitution => "the coefficient of restitution",
        }
    }
}

/// What an answer needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Needs {
    /// From the user.
    pub inputs: &'static [Input],
    /// Answered before it.
    pub quantities: &'static [Quantity],
}

impl Quantity {
    /// All of them, in the order of evaluation: each after what it needs, velocities apart.
    pub const ALL: [Quantity; 11] = [
        Self::Pass,
        Self::Eta,
        Self::Threshold,
        Self::Helps,
        Self::Masses,
        Self::Velocities,
        Self::LastVelocity,
        Self::BestN,
        Self::Matrix,
        Self::Losses,
        Self::Recollides,
    ];

    /// What must be known first. This table drives the evaluation, `--explain`, and what is asked of the user.
    #[must_use]
    pub const fn needs(self) -> Needs {
        use Input::{Inserted, Restitution};
        let (inputs, quantities): (&[Input], &[Quantity]) = match self {
            Self::Pass | Self::Eta | Self::Helps => (&[Inserted, Restitution], &[]),
            Self::Threshold | Self::Masses => (&[Inserted], &[]),
            Self::BestN => (&[Restitution], &[]),
            Self::Matrix | Self::Losses | Self::Recollides => (&[], &[Self::Pass]),
            // Every output that calls velocities final must know whether they are.
            Self::Velocities | Self::LastVelocity => (&[], &[Self::Pass, Self::Recollides]),
        };
        Needs { inputs, quantities }
    }

    /// The name in scenes, flags and reports.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Eta => "eta",
            Self::Threshold => "threshold",
            Self::Helps => "helps",
            Self::Masses => "masses",
            Self::Velocities => "velocities",
            Self::LastVelocity => "last-velocity",
            Self::BestN => "best-n",
            Self::Matrix => "matrix",
            Self::Losses => "losses",
            Self::Recollides => "recollides",
        }
    }

    /// The names that can be asked for.
    pub fn names() -> impl Iterator<Item = &'static str> {
        Self::ALL.into_iter().filter(|q| *q != Self::Pass).map(Self::name)
    }

    /// The quantity of a name.
    ///
    /// # Errors
    /// The message: what is wrong, and what to write instead.
    pub fn of_name(name: &str) -> Result<Quantity, String> {
        let found = Self::ALL.into_iter().find(|q| *q != Self::Pass && q.name() == name);
        found.ok_or_else(|| match nearest(name, Self::names()) {
            Some(near) => format!("no quantity is called {name:?}; did you mean {near:?}?"),
            None => {
                let names: Vec<&str> = Self::names().collect();
                format!("no quantity is called {name:?}; the quantities are {}", names.join(", "))
            }
        })
    }

    /// A position among [`Quantity::ALL`].
    pub(super) fn index(self) -> usize {
        self as usize
    }
}
