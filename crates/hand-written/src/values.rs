//! Values of parameters and outputs.

use models::ModelEntry;

/// Writes `values` to the first entries of `out`, as many as there are.
pub(crate) fn write<const N: usize>(out: &mut [f64], values: [f64; N]) {
    for (slot, value) in out.iter_mut().zip(values) {
        *slot = value;
    }
}

/// `values` with what is missing taken from the default preset of `entry`.
pub(crate) fn filled<const N: usize>(entry: &ModelEntry, values: &[f64]) -> [f64; N] {
    core::array::from_fn(|index| {
        values.get(index).copied().unwrap_or_else(|| entry.default_value(index))
    })
}
