//! How the next coefficient of a value follows from those before.

use crate::expressions::tape::TapeSlot;

/// How the coefficient of order k ≥ 1 of a value follows; that of order 0 is its value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SeriesRule {
    /// It stays as it is: a number, a parameter, or what is made of them alone.
    Constant,
    /// An entry of the state.
    State(u16),
    /// The input (0) or a rate of it (1, 2, 3).
    Input(u8),
    Add(TapeSlot, TapeSlot),
    Subtract(TapeSlot, TapeSlot),
    Negate(TapeSlot),
    /// The second times the first, which stays as it is.
    Scale(TapeSlot, TapeSlot),
    Product(TapeSlot, TapeSlot),
    Square(TapeSlot),
    /// The first over the second.
    Quotient(TapeSlot, TapeSlot),
    /// The first over the second, which stays as it is.
    Over(TapeSlot, TapeSlot),
    /// What changes with `slope` times the rate of `of`: its slope may stand behind it, since only
    /// lower orders of it count.
    Driven {
        slope: TapeSlot,
        of: TapeSlot,
    },
    /// The square root of the slot.
    Root(TapeSlot),
    /// The first to the power of the second, which stays as it is.
    Power(TapeSlot, TapeSlot),
    /// The slot with the sign that makes its value positive.
    Magnitude(TapeSlot),
    /// The second where the first is positive, else the third; where the step begins.
    Choice(TapeSlot, TapeSlot, TapeSlot),
}

impl SeriesRule {
    /// Shows each operand whose coefficients count.
    pub(super) fn operands(self, mut see: impl FnMut(TapeSlot)) {
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
