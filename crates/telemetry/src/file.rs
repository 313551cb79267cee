//! Files with random access.

use std::fs::{self, File};
use std::{io, path::Path};

/// Opens `path`; rejects pipes, which would block, and files without a size.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    if fs::metadata(path)?.is_file() {
        return File::open(path);
    }
    let text = "it is a folder, a pipe or a device, and no file";
    Err(io::Error::new(io::ErrorKind::InvalidInput, text))
}
