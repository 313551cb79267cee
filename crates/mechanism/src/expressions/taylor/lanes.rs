//! Products of coefficients that a recursion sums up.

use super::recursion::Recursion;
use super::rules::SeriesRule;
use crate::expressions::tape::TapeSlot;

/// One of two factors: a value's coefficients, or these times their order.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum LaneFactor {
    Value(TapeSlot),
    Rate(TapeSlot),
}

impl LaneFactor {
    pub(super) const fn slot(self) -> TapeSlot {
        match self {
            Self::Value(slot) | Self::Rate(slot) => slot,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SeriesLane {
    pub(super) of: TapeSlot,
    pub(super) first: LaneFactor,
    pub(super) second: LaneFactor,
}

pub(super) fn lanes(recursion: &Recursion, is_live: &[bool]) -> Vec<SeriesLane> {
    use LaneFactor::{Rate, Value};
    let mut lanes = Vec::new();
    for (at, rule) in (0..).zip(&recursion.rules).filter(|(at, _)| is_live[*at as usize]) {
        let of = TapeSlot(at);
        let mut push = |first, second| lanes.push(SeriesLane { of, first, second });
        match *rule {
            SeriesRule::Product(x, y) => push(Value(x), Value(y)),
            SeriesRule::Square(x) => push(Value(x), Value(x)),
            SeriesRule::Quotient(_, y) => push(Value(y), Value(of)),
            SeriesRule::Root(_) => push(Value(of), Value(of)),
            SeriesRule::Driven { slope, of: x } => push(Rate(x), Value(recursion.slope(slope).0)),
            SeriesRule::Power(x, _) => {
                push(Value(x), Value(of));
                push(Rate(x), Value(of));
            }
            SeriesRule::Constant
            | SeriesRule::State(_)
            | SeriesRule::Input(_)
            | SeriesRule::Add(..)
            | SeriesRule::Subtract(..)
            | SeriesRule::Negate(_)
            | SeriesRule::Scale(..)
            | SeriesRule::Over(..)
            | SeriesRule::Magnitude(_)
            | SeriesRule::Choice(..) => {}
        }
    }
    lanes
}
