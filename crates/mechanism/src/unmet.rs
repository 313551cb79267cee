use instruments::LoadedModel;

/// Returns the conditions on `model` that `values` do not meet, as written: `string > trip`.
pub fn unmet(model: &LoadedModel, values: &[f64]) -> Vec<String> {
    let mut unmet = Vec::new();
    model.unmet(values, &mut |condition| unmet.push(condition.to_owned()));
    unmet
}
