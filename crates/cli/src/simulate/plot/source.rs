/// Source of a curve's values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum CurveSource {
    Input,
    State(usize),
    Output(usize),
    /// Guard with this name, in the modes that have it.
    Guard(&'static str),
}
