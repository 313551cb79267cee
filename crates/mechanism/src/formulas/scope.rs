//! What the names in an expression stand for.

use super::Dimension;
use crate::expressions::graph::{Graph, Node};

/// A value with its unit, and what it depends on.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Measured {
    pub node: Node,
    pub dimension: Dimension,
    pub reach: Dependence,
}

/// The kinds of symbols that a value depends on.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Dependence(u16);

impl Dependence {
    pub const NOTHING: Self = Self(0);
    pub const PARAMETERS: Self = Self(1);
    pub const KEY: Self = Self(2);
    pub const COORDINATES: Self = Self(4);
    pub const SPEEDS: Self = Self(8);
    pub const INPUT: Self = Self(16);
    /// Rates of the input.
    pub const INPUT_RATES: Self = Self(32);
    pub const ACCELERATIONS: Self = Self(64);
    /// Reactions of constraints and forces of contacts.
    pub const REACTIONS: Self = Self(128);
    /// Forces that act in some modes only.
    pub const FORCES: Self = Self(256);

    const WORDS: [(Self, &'static str); 9] = [
        (Self::PARAMETERS, "parameters"),
        (Self::KEY, "the key's number"),
        (Self::COORDINATES, "coordinates"),
        (Self::SPEEDS, "speeds"),
        (Self::INPUT, "the input"),
        (Self::INPUT_RATES, "rates of the input"),
        (Self::ACCELERATIONS, "accelerations"),
        (Self::REACTIONS, "reactions and contacts"),
        (Self::FORCES, "forces by name"),
    ];

    /// Returns all that is in either.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether nothing of `other` is outside.
    pub const fn covers(self, other: Self) -> bool {
        other.0 & !self.0 == 0
    }

    /// Whether the two have something in common.
    pub const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Returns its kinds in words.
    pub fn words(self) -> String {
        let words: Vec<_> =
            Self::WORDS.iter().filter(|(kind, _)| self.meets(*kind)).map(|(_, it)| *it).collect();
        if words.is_empty() { "numbers".to_owned() } else { words.join(", ") }
    }

    /// Returns what of it `allowed` does not cover.
    #[must_use]
    pub const fn without(self, allowed: Self) -> Self {
        Self(self.0 & !allowed.0)
    }
}

/// Why a name cannot stand where it does.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NameError {
    pub message: String,
    pub help: String,
}

/// What names stand for.
pub trait NameScope {
    /// Returns what `name` with so many primes is.
    ///
    /// # Errors
    ///
    /// What is wrong with the name here; none if it was said before.
    fn value(
        &mut self,
        graph: &mut Graph,
        name: &str,
        primes: u8,
    ) -> Result<Measured, Option<NameError>>;

    /// Returns `function` of what is called `names`, as x(P).
    ///
    /// # Errors
    ///
    /// The number of the wrong name, and what is wrong; none if it was said before.
    fn named(
        &mut self,
        graph: &mut Graph,
        function: &str,
        names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)>;

    /// Returns the total rate of `value` along the motion.
    ///
    /// # Errors
    ///
    /// If it has none that can be known.
    fn rate(&mut self, graph: &mut Graph, value: Measured) -> Result<Measured, NameError>;

    /// Returns what may be depended on.
    fn allowed(&self) -> Dependence;
}
