//! Small files of the kernel, each with one value.

use std::fs;
use std::path::Path;
use std::str::FromStr;

/// Returns the text of a file without the white space around it, if it can be read.
pub(super) fn text(path: &Path) -> Option<String> {
    fs::read_to_string(path).ok().map(|text| text.trim().to_owned())
}

/// Returns the number in a file, if it can be read and is one.
pub(super) fn number<T: FromStr>(path: &Path) -> Option<T> {
    text(path)?.parse().ok()
}
