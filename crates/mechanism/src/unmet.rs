use instruments::{LoadedModel, Playable, Visitor};

struct UnmetOf<'a>(&'a [f64]);

impl Visitor for UnmetOf<'_> {
    type Output = Vec<String>;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let mut unmet = Vec::new();
        model.with_values(self.0).unmet(&mut |condition| unmet.push(condition.to_owned()));
        unmet
    }
}

/// Returns the conditions on `model` that `values` do not meet, as written: `string > trip`.
pub fn unmet(model: &LoadedModel, values: &[f64]) -> Vec<String> {
    model.visit(UnmetOf(values))
}
