//! The values of a model's parameters, on their way to a voice that plays.

/// Most parameters of a voice's model; the builder of a voice rejects a model with more.
pub const MAX_VALUES: usize = 128;

/// One value per parameter of a model, each in its parameter's unit.
///
/// Owns no memory, so the tick can receive it from a ring and drop it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ModelValues {
    model: u64,
    revision: u32,
    n: usize,
    values: [f64; MAX_VALUES],
}

impl ModelValues {
    /// Returns `values` for voices of the model version `model`, with `revision` as their number;
    /// `None` if there are more than [`MAX_VALUES`].
    ///
    /// Two versions of one description may have different parameters.
    pub fn new(model: u64, revision: u32, values: &[f64]) -> Option<Self> {
        let mut all = [0.0; MAX_VALUES];
        all.get_mut(..values.len())?.copy_from_slice(values);
        Some(Self { model, revision, n: values.len(), values: all })
    }

    pub const fn model(&self) -> u64 {
        self.model
    }

    /// Returns the number among all voices of a run that the voice has with these values.
    pub const fn revision(&self) -> u32 {
        self.revision
    }

    pub fn as_slice(&self) -> &[f64] {
        self.values.get(..self.n).unwrap_or_default()
    }
}
