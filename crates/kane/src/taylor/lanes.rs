//! Which products of coefficients a recursion sums up.

use super::recursion::Recursion;
use super::rules::TermRule;
use crate::tape::Slot;

/// One of two factors: a value, or its coefficients each times its order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum LaneFactor {
    Value(Slot),
    Rate(Slot),
}

impl LaneFactor {
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
pub(super) struct ProductLane {
    pub(super) of: Slot,
    pub(super) first: LaneFactor,
    pub(super) second: LaneFactor,
}

/// Returns the sums that the live values take, in their order.
pub(super) fn lanes(recursion: &Recursion, is_live: &[bool]) -> Vec<ProductLane> {
    use LaneFactor::{Rate, Value};
    let mut lanes = Vec::new();
    for (at, rule) in (0..).zip(&recursion.rules).filter(|(at, _)| is_live[*at as usize]) {
        let of = Slot(at);
        let mut push = |first, second| lanes.push(ProductLane { of, first, second });
        match *rule {
            TermRule::Product(x, y) => push(Value(x), Value(y)),
            TermRule::Square(x) => push(Value(x), Value(x)),
            TermRule::Quotient(_, y) => push(Value(y), Value(of)),
            TermRule::Root(_) => push(Value(of), Value(of)),
            TermRule::Driven { slope, of: x } => push(Rate(x), Value(recursion.slope(slope).0)),
            TermRule::Power(x, _) => {
                push(Value(x), Value(of));
                push(Rate(x), Value(of));
            }
            TermRule::Constant
            | TermRule::State(_)
            | TermRule::Input(_)
            | TermRule::Add(..)
            | TermRule::Subtract(..)
            | TermRule::Negate(_)
            | TermRule::Scale(..)
            | TermRule::Over(..)
            | TermRule::Magnitude(_)
            | TermRule::Choice(..) => {}
        }
    }
    lanes
}
