//! The bytes of a file, read as they are asked for.

use std::fs::File;
use std::io::{self, Read as _, Seek as _, SeekFrom};
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::file;

/// The bytes of an open file.
#[derive(Debug)]
pub(super) struct FileBytes {
    file: Mutex<File>,
    pub(super) size: u64,
    read: AtomicU64,
}

impl FileBytes {
    /// Opens the file `path`.
    pub(super) fn open(path: &Path) -> io::Result<Self> {
        let file = file::open(path)?;
        let size = file.metadata()?.len();
        Ok(Self { file: Mutex::new(file), size, read: AtomicU64::new(0) })
    }

    /// Reads `length` bytes from `offset` on.
    pub(super) fn read(&self, offset: u64, length: u64) -> io::Result<Vec<u8>> {
        if offset.checked_add(length).is_none_or(|end| end > self.size) {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        let mut bytes = vec![0; usize::try_from(length).map_err(io::Error::other)?];
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(offset))?;
        file.read_exact(&mut bytes)?;
        self.read.fetch_add(length, Ordering::Relaxed);
        Ok(bytes)
    }

    /// Returns how much was read so far (B).
    pub(super) fn bytes_read(&self) -> u64 {
        self.read.load(Ordering::Relaxed)
    }
}
