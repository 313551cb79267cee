//! The values of a model's parameters, on their way to a voice that plays.

/// Most parameters of a voice's model; whoever builds a voice refuses a model with more.
pub const MAX_VALUES: usize = 128;

/// One value per parameter of a model, in the unit of each.
///
/// It owns no memory, so that the tick takes it from a ring and drops it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ModelValues {
    model: u64,
    revision: u32,
    n: usize,
    values: [f64; MAX_VALUES],
}

impl ModelValues {
    /// Returns `values` for voices of `model`, which are of `revision` from then on; none if
    /// there are more than [`MAX_VALUES`].
    ///
    /// `model` is the number of the model's version: two versions of one description may have other
    /// parameters.
    pub fn new(model: u64, revision: u32, values: &[f64]) -> Option<Self> {
        let mut all = [0.0; MAX_VALUES];
        all.get_mut(..values.len())?.copy_from_slice(values);
        Some(Self { model, revision, n: values.len(), values: all })
    }

    /// Returns the number of the version of a model that has these parameters.
    pub const fn model(&self) -> u64 {
        self.model
    }

    /// Returns the number that the voice has among all voices of a run once it has the values.
    pub const fn revision(&self) -> u32 {
        self.revision
    }

    /// Returns the values, in the model's order.
    pub fn as_slice(&self) -> &[f64] {
        self.values.get(..self.n).unwrap_or_default()
    }
}
