//! How the next coefficient of a value follows from those before.

use crate::tape::Slot;

/// How the coefficient of order k ≥ 1 of a value follows; that of order 0 is its value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum TermRule {
    /// It stays as it is: a number, a parameter, or what is made of them alone.
    Constant,
    /// An entry of the state.
    State(u16),
    /// The input (0) or a rate of it (1, 2, 3).
    Input(u8),
    Add(Slot, Slot),
    Subtract(Slot, Slot),
    Negate(Slot),
    /// The second times the first, which stays as it is.
    Scale(Slot, Slot),
    Product(Slot, Slot),
    Square(Slot),
    /// The first over the second.
    Quotient(Slot, Slot),
    /// The first over the second, which stays as it is.
    Over(Slot, Slot),
    /// What changes with `slope` times the rate of `of`: its slope may stand behind it, since only
    /// lower orders of it count.
    Driven {
        slope: Slot,
        of: Slot,
    },
    /// The square root of the slot.
    Root(Slot),
    /// The first to the power of the second, which stays as it is.
    Power(Slot, Slot),
    /// The slot with the sign that makes its value positive.
    Magnitude(Slot),
    /// The second where the first is positive, else the third; where the step begins.
    Choice(Slot, Slot, Slot),
}

impl TermRule {
    /// Shows each operand whose coefficients count.
    pub(super) fn operands(self, mut see: impl FnMut(Slot)) {
        match self {
            Self::Constant | Self::State(_) | Self::Input(_) => {}
            Self::Negate(x)
            | Self::Square(x)
            | Self::Root(x)
            | Self::Magnitude(x)
            | Self::Scale(_, x)
            | Self::Over(x, _)
            | Self::Power(x, _) => see(x),
            Self::Add(x, y)
            | Self::Subtract(x, y)
            | Self::Product(x, y)
            | Self::Quotient(x, y)
            | Self::Driven { slope: x, of: y }
            | Self::Choice(_, x, y) => [x, y].into_iter().for_each(see),
        }
    }
}
