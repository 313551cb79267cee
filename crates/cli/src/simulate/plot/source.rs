//! Where the values of a curve come from.

/// Where a curve's values come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum CurveSource {
    Input,
    /// An entry of the state.
    State(usize),
    Output(usize),
    /// The guard of this name, in the modes that have it.
    Guard(&'static str),
}
