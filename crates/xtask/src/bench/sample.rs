//! Reads criterion's samples of a bench, JSON of one known form.

use std::{collections::BTreeMap, fs, path::Path};

use crate::error::Error;

/// Returns the fastest sample of each bench under `home` (ns per iteration).
pub(super) fn fastest_of(home: &Path) -> Result<BTreeMap<String, f64>, Error> {
    let mut all = BTreeMap::new();
    for bench in fs::read_dir(home).map_err(|cause| Error::file(home, cause))? {
        let bench = bench.map_err(|cause| Error::file(home, cause))?;
        let path = bench.path().join("new/sample.json");
        // Criterion's other folders, as that of its report.
        let Ok(text) = fs::read_to_string(&path) else { continue };
        let time = fastest(&text).ok_or_else(|| {
            Error::unobtainable(path.display().to_string(), "it is not as criterion writes it")
        })?;
        all.insert(bench.file_name().to_string_lossy().into_owned(), time);
    }
    Ok(all)
}

/// Returns the least time of an iteration in `text`, a `sample.json`.
fn fastest(text: &str) -> Option<f64> {
    let (iterations, times) = (numbers(text, "iters")?, numbers(text, "times")?);
    let each = times.iter().zip(&iterations).map(|(time, n)| time / n);
    each.filter(|time| time.is_finite()).reduce(f64::min)
}

fn numbers(text: &str, name: &str) -> Option<Vec<f64>> {
    let (_, behind) = text.split_once(&format!("\"{name}\":["))?;
    let (list, _) = behind.split_once(']')?;
    list.split(',').map(|number| number.trim().parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fastest_sample_is_the_least_time_of_an_iteration() {
        let text =
            r#"{"sampling_mode":"Linear","iters":[10.0,20.0,30.0],"times":[50.0,80.0,1.5e2]}"#;
        assert_eq!(fastest(text), Some(4.0));
        for foreign in ["", "{}", r#"{"iters":[],"times":[]}"#, r#"{"iters":[1.0],"times":[x]}"#] {
            assert_eq!(fastest(foreign), None, "{foreign}");
        }
    }
}
