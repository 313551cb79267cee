use crate::expressions::tape::TapeSlot;

/// Rule for the coefficient of order k ≥ 1 of a value; that of order 0 is its value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SeriesRule {
    /// Constant: a number, a parameter, or a function of them alone.
    Constant,
    State(u16),
    /// Input (0) or a rate of it (1, 2, 3).
    Input(u8),
    Add(TapeSlot, TapeSlot),
    Subtract(TapeSlot, TapeSlot),
    Negate(TapeSlot),
    /// The second times the constant first.
    Scale(TapeSlot, TapeSlot),
    Product(TapeSlot, TapeSlot),
    Square(TapeSlot),
    Quotient(TapeSlot, TapeSlot),
    /// The first over the constant second.
    Over(TapeSlot, TapeSlot),
    /// Rate `slope` times the rate of `of`; the slope may follow: only its lower orders count.
    Driven {
        slope: TapeSlot,
        of: TapeSlot,
    },
    Root(TapeSlot),
    Power(TapeSlot, TapeSlot),
    /// The slot with the sign that makes its value positive.
    Magnitude(TapeSlot),
    /// The second where the first is positive at the start of the step, else the third.
    Choice(TapeSlot, TapeSlot, TapeSlot),
}

impl SeriesRule {
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
