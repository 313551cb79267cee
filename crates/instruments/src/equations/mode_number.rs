/// A mode of an [`EquationModel`](crate::equations::EquationModel), by its number in the table.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ModeNumber(pub u8);
