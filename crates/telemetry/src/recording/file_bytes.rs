//! Bytes of a file or of embedded data, read on demand.

use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::{fmt, path::Path};

use crate::file;

trait ReadSeek: Read + Seek + fmt::Debug + Send {}

impl<T: Read + Seek + fmt::Debug + Send> ReadSeek for T {}

#[derive(Debug)]
pub(super) struct FileBytes {
    file: Mutex<Box<dyn ReadSeek>>,
    pub(super) size: u64,
    read: AtomicU64,
}

impl FileBytes {
    pub(super) fn open(path: &Path) -> io::Result<Self> {
        let file = file::open(path)?;
        let size = file.metadata()?.len();
        Ok(Self { file: Mutex::new(Box::new(file)), size, read: AtomicU64::new(0) })
    }

    pub(super) fn of(bytes: &'static [u8]) -> Self {
        let file = Mutex::new(Box::new(Cursor::new(bytes)) as Box<dyn ReadSeek>);
        Self { file, size: bytes.len() as u64, read: AtomicU64::new(0) }
    }

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

    pub(super) fn bytes_read(&self) -> u64 {
        self.read.load(Ordering::Relaxed)
    }
}
