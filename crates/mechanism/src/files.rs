//! Files of descriptions, on the disk or kept in a recording.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use crate::kane::description::Bases;
use instruments::FileContents;

use crate::shipped::description;

const MAX_FILE: u64 = 1 << 18;

/// Problem of an unreadable file, and its remedy.
pub(crate) type Unread = (String, &'static str);

pub(crate) fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_unknown| path.to_owned())
}

#[derive(Debug, Default)]
pub(crate) struct KeptFiles(Mutex<BTreeMap<PathBuf, Arc<[u8]>>>);

impl KeptFiles {
    pub(crate) fn keep(&self, path: &Path, text: &str) {
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        kept.insert(absolute(path), text.as_bytes().into());
    }

    pub(crate) fn read(&self, path: &Path) -> Result<Vec<u8>, Unread> {
        let kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(bytes) = kept.get(&absolute(path)) {
            return Ok(bytes.to_vec());
        }
        drop(kept);
        read_from_disk(path)
    }
}

pub(crate) fn read_from_disk(path: &Path) -> Result<Vec<u8>, Unread> {
    let failed = |error: std::io::Error| {
        if error.kind() == std::io::ErrorKind::NotFound {
            ("there is no such file".to_owned(), "correct the path")
        } else {
            (format!("the file cannot be read, {error}"), "make it readable")
        }
    };
    let bytes = documents::read_input(path, MAX_FILE).map_err(failed)?;
    if bytes.len() as u64 > MAX_FILE {
        let message = format!("the file is longer than {} KiB", MAX_FILE / 1024);
        return Err((message, "this is no description, choose another"));
    }
    Ok(bytes)
}

pub fn contents_now(before: &FileContents) -> FileContents {
    before.read_again(&|path| read_from_disk(path).ok())
}

/// Reader of the files of one description that records their contents.
#[derive(Debug)]
pub(crate) struct DescriptionFiles<'a> {
    kept: &'a KeptFiles,
    contents: RefCell<FileContents>,
}

impl<'a> DescriptionFiles<'a> {
    pub(crate) fn new(kept: &'a KeptFiles) -> Self {
        Self { kept, contents: RefCell::default() }
    }

    pub(crate) fn read(&self, path: &Path) -> Result<Vec<u8>, Unread> {
        let read = self.kept.read(path);
        self.contents.borrow_mut().0.push((path.to_owned(), read.as_ref().ok().cloned()));
        read
    }

    pub(crate) fn contents(&self) -> FileContents {
        self.contents.borrow().clone()
    }
}

/// Bases of descriptions: shipped models by name, and files beside the naming description.
impl Bases for DescriptionFiles<'_> {
    fn load(&self, base: &str, from: &str) -> Result<(String, Vec<u8>), String> {
        if let Some(text) = description(base) {
            return Ok((base.to_owned(), text.as_bytes().to_vec()));
        }
        let path = Path::new(from).parent().unwrap_or_else(|| Path::new("")).join(base);
        let bytes = self.read(&path).map_err(|(message, _help)| message)?;
        Ok((path.to_string_lossy().into_owned(), bytes))
    }
}
