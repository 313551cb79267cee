//! Whether values of a model's parameters go together.

use models::Playable;
use models::catalogue::{self, ModelEntry, Visitor};

/// Asks a model with these values for the conditions that they do not meet.
struct UnmetOf<'a>(&'a [f64]);

impl Visitor for UnmetOf<'_> {
    type Output = Vec<&'static str>;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let mut unmet = Vec::new();
        model.with_values(self.0).unmet(&mut |condition| unmet.push(condition));
        unmet
    }
}

/// Returns the conditions on the parameters of the model of `entry` that `values` do not meet, as
/// its description writes them: `string > trip`.
pub fn unmet(entry: &ModelEntry, values: &[f64]) -> Vec<&'static str> {
    catalogue::visit(entry, UnmetOf(values)).unwrap_or_default()
}
