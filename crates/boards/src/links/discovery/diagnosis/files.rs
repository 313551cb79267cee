//! Small files of the kernel, each with one value.

use std::fs;
use std::path::Path;
use std::str::FromStr;

/// Returns the trimmed text of a file, if readable.
pub(super) fn text(path: &Path) -> Option<String> {
    fs::read_to_string(path).ok().map(|text| text.trim().to_owned())
}

pub(super) fn number<T: FromStr>(path: &Path) -> Option<T> {
    text(path)?.parse().ok()
}
