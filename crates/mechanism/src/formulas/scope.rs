use super::Dimension;
use crate::expressions::graph::{Graph, Node};

/// Value with its unit and its dependence.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Measured {
    pub node: Node,
    pub dimension: Dimension,
    pub reach: Dependence,
}

/// Kinds of symbols on which a value depends.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Dependence(u16);

impl Dependence {
    pub const NOTHING: Self = Self(0);
    pub const PARAMETERS: Self = Self(1);
    pub const KEY: Self = Self(2);
    pub const COORDINATES: Self = Self(4);
    pub const SPEEDS: Self = Self(8);
    pub const INPUT: Self = Self(16);
    pub const INPUT_RATES: Self = Self(32);
    pub const ACCELERATIONS: Self = Self(64);
    pub const REACTIONS: Self = Self(128);
    /// Forces that act in some modes only.
    pub const FORCES: Self = Self(256);
    /// Friction forces, which depend on the contacts that stick.
    pub const FRICTIONS: Self = Self(512);

    const WORDS: [(Self, &'static str); 10] = [
        (Self::PARAMETERS, "parameters"),
        (Self::KEY, "the key's number"),
        (Self::COORDINATES, "coordinates"),
        (Self::SPEEDS, "speeds"),
        (Self::INPUT, "the input"),
        (Self::INPUT_RATES, "rates of the input"),
        (Self::ACCELERATIONS, "accelerations"),
        (Self::REACTIONS, "reactions and contacts"),
        (Self::FORCES, "forces by name"),
        (Self::FRICTIONS, "friction forces"),
    ];

    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    pub const fn covers(self, other: Self) -> bool {
        other.0 & !self.0 == 0
    }

    pub const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    pub fn words(self) -> String {
        let words: Vec<_> =
            Self::WORDS.iter().filter(|(kind, _)| self.meets(*kind)).map(|(_, it)| *it).collect();
        if words.is_empty() { "numbers".to_owned() } else { words.join(", ") }
    }

    #[must_use]
    pub const fn without(self, allowed: Self) -> Self {
        Self(self.0 & !allowed.0)
    }
}

/// Mistake in the use of a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct NameError {
    pub message: String,
    pub help: String,
}

/// Meanings of the names in an expression.
pub trait NameScope {
    /// Returns the value of `name` with `primes` primes.
    ///
    /// # Errors
    /// The mistake in the use of the name; `None` if it was reported before.
    fn value(
        &mut self,
        graph: &mut Graph,
        name: &str,
        primes: u8,
    ) -> Result<Measured, Option<NameError>>;

    /// Returns `function` of the objects `names`, as x(P).
    ///
    /// # Errors
    /// The index of the invalid name, and its mistake; `None` if it was reported before.
    fn named(
        &mut self,
        graph: &mut Graph,
        function: &str,
        names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)>;

    /// Returns the total rate of `value` along the motion.
    ///
    /// # Errors
    /// The rate is unknown.
    fn rate(&mut self, graph: &mut Graph, value: Measured) -> Result<Measured, NameError>;

    fn allowed(&self) -> Dependence;
}
