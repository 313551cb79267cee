//! Model B as it ships: the description in `configs/models`, derived and compiled at load.

use std::path::Path;

use instruments::{Described as _, SmallModel};
use mechanism::Library;
use pode::Motion;
use serde_json::Value;

use super::Ours;
use crate::reference::number;

const NAME: &str = "key-hammer-springs";

/// Returns the shipped model with `parameters` by name, at rest.
pub(crate) fn shipped<I>(parameters: &Value, input: I) -> Result<Ours<SmallModel, I>, String> {
    let found = Library::default().find(NAME, Path::new(""));
    let found = found.map_err(|error| format!("{NAME}: {}", error.rendered()))?;
    let model = found.small().ok_or_else(|| format!("{NAME} has another size"))?;
    let model = model.with_values(&model.entry().values(|name| number(&parameters[name])));
    let start = model.at_rest(&Motion::default());
    Ok(Ours { model, input, start })
}
