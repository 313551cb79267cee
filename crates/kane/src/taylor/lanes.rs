//! Which products of coefficients a recursion sums up.

use super::recursion::Recursion;
use super::rules::Rule;
use crate::tape::Slot;

/// One of two factors: a value, or its coefficients each times its order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Factor {
    Value(Slot),
    Rate(Slot),
}

impl Factor {
    /// Its coefficient of order k.
    pub(super) fn text(self) -> String {
        match self {
            Self::Value(slot) => format!("w{}", slot.0),
            Self::Rate(slot) => format!("k as f64 * w{}", slot.0),
        }
    }
}

/// A sum of products that a value takes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Lane {
    pub(super) of: Slot,
    pub(super) first: Factor,
    pub(super) second: Factor,
}

/// Returns the sums that the live values take, in their order.
pub(super) fn lanes(recursion: &Recursion, is_live: &[bool]) -> Vec<Lane> {
    use Factor::{Rate, Value};
    let mut lanes = Vec::new();
    for (at, rule) in (0..).zip(&recursion.rules).filter(|(at, _)| is_live[*at as usize]) {
        let of = Slot(at);
        let mut push = |first, second| lanes.push(Lane { of, first, second });
        match *rule {
            Rule::Product(x, y) => push(Value(x), Value(y)),
            Rule::Square(x) => push(Value(x), Value(x)),
            Rule::Quotient(_, y) => push(Value(y), Value(of)),
            Rule::Root(_) => push(Value(of), Value(of)),
            Rule::Driven { slope, of: x } => push(Rate(x), Value(recursion.slope(slope).0)),
            Rule::Power(x, _) => {
                push(Value(x), Value(of));
                push(Rate(x), Value(of));
            }
            Rule::Constant
            | Rule::State(_)
            | Rule::Input(_)
            | Rule::Add(..)
            | Rule::Subtract(..)
            | Rule::Negate(_)
            | Rule::Scale(..)
            | Rule::Over(..)
            | Rule::Magnitude(_)
            | Rule::Choice(..) => {}
        }
    }
    lanes
}
