//! Rejects scenes with unstable keys.

use std::path::Path;

use documents::{Diagnostic, Diagnostics};
use figures::stability::{RangeStability, examine, instabilities};
use scene::{Library, Scene};

use super::Failure;

/// Tries the keys of `scene`; fails with a sentence for each unstable range.
pub(super) fn refuse_unstable(scene: &Scene) -> Result<(), Failure> {
    let unstable = instabilities(scene).map_err(|error| Failure::Usage(error.to_string()))?;
    if unstable.is_empty() { Ok(()) } else { Err(Failure::Usage(unstable.join("\nletoff: "))) }
}

/// Tries the keys of the valid scene in `file`; returns each range with its margin, or mistakes.
pub(super) fn check_stability(file: &Path) -> Result<Vec<RangeStability>, Diagnostics> {
    let scene = Scene::load(&Library::default(), &file.to_string_lossy(), &[])?;
    let wrong = |message: String, help: String| Diagnostic {
        file: file.to_string_lossy().into_owned(),
        line: None,
        column: None,
        message,
        help,
    };
    let refused =
        |error: String| Diagnostics::new(vec![wrong(error, "change the scene".to_owned())]);
    let ranges = examine(&scene).map_err(|error| refused(error.to_string()))?;
    let unstable: Vec<_> = ranges.iter().filter_map(|it| it.unstable.as_ref()).collect();
    if !unstable.is_empty() {
        let all = unstable.iter().map(|it| wrong(it.what(), it.help())).collect();
        return Err(Diagnostics::new(all));
    }
    let with_figures = |it: RangeStability| it.with_figures(&scene);
    let ranges: Result<_, _> = ranges.into_iter().map(with_figures).collect();
    ranges.map_err(|error| refused(error.to_string()))
}
