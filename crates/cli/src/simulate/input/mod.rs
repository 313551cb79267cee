//! The input s(t) of a simulation, with its first three derivatives.

mod expression;
mod interval;
mod mistake;
mod table;

use pode::Motion;
use serde::Serialize;

use self::expression::Expression;
pub use self::mistake::InputMistake;
pub use self::table::InputTable;
use super::args::SimulateArgs;

const NAME: &str = "s";

/// Source of the input s(t).
#[derive(Debug)]
pub(super) enum InputSignal {
    Rest,
    Expression(Box<Expression>),
    Table(InputTable),
}

impl InputSignal {
    /// Reads `--input` and `--reconstruct`; adds to `mistakes`.
    pub(super) fn read(args: &SimulateArgs, mistakes: &mut Vec<InputMistake>) -> Self {
        let mut note = |found: Vec<InputMistake>| {
            mistakes.extend(found);
            Self::Rest
        };
        let table = |path: &str| {
            let how = args.reconstruct.unwrap_or_default();
            InputTable::read(path.as_ref(), how).map(Self::Table)
        };
        let expression = |text: &str, name: &str| {
            Expression::read(text, name).map(|it| Self::Expression(Box::new(it)))
        };
        let given = args.input.as_deref();
        let input = match given.map(|text| (text, name_before_equals(text))) {
            None => Ok(Self::Rest),
            Some((path, None)) => table(path),
            Some((text, Some(name))) => expression(text, name),
        }
        .unwrap_or_else(&mut note);
        if args.reconstruct.is_some() && given.is_none_or(|text| name_before_equals(text).is_some())
        {
            mistakes.push(InputMistake::NothingToReconstruct);
        }
        input
    }

    /// Returns s and its rates at `t` (s).
    pub(super) fn at(&self, t: f64) -> Motion {
        match self {
            Self::Rest => Motion::default(),
            Self::Expression(expression) => expression.at(t),
            Self::Table(table) => table.at(t),
        }
    }

    /// Returns the times of held end values in a run until `until` (s).
    pub(super) fn held(&self, until: f64) -> Vec<HeldInput> {
        match self {
            Self::Rest | Self::Expression(_) => Vec::new(),
            Self::Table(table) => table.held(until),
        }
    }

    /// Returns the largest magnitudes of s and its rates from `from` to `to` (s), where known.
    pub(super) fn bound(&self, from: f64, to: f64) -> Option<Motion> {
        match self {
            Self::Rest => Some(Motion::default()),
            Self::Expression(expression) => expression.bound(from, to),
            Self::Table(table) => table.bound(from, to),
        }
    }
}

/// A time outside of the input's rows, over which an end value holds.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub(super) struct HeldInput {
    /// Start (s).
    pub(super) from: f64,
    /// End (s).
    pub(super) to: f64,
    pub(super) s: f64,
}

pub(super) fn is_finite(s: &Motion) -> bool {
    [s.position, s.rate, s.acceleration, s.jerk].iter().all(|entry| entry.is_finite())
}

/// Returns the name in `name=…`; a path with a `=` can be given as `./path`.
fn name_before_equals(text: &str) -> Option<&str> {
    let (name, _) = text.split_once('=')?;
    let name = name.trim();
    let is_name = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    is_name.then_some(name)
}
