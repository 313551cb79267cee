//! A folder like `/sys`, for tests.

use std::fs;
use std::path::{Path, PathBuf};

pub(super) struct Root(PathBuf);

impl Root {
    pub(super) fn new(test: &str) -> Self {
        let root = std::env::temp_dir().join(format!("letoff-{test}-{}", std::process::id()));
        fs::create_dir_all(&root).unwrap();
        Self(root.canonicalize().unwrap())
    }

    pub(super) fn with(self, file: &str, text: &str) -> Self {
        let path = self.0.join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, format!("{text}\n")).unwrap();
        self
    }

    pub(super) fn with_all(self, folder: &str, files: &[(&str, &str)]) -> Self {
        files.iter().fold(self, |root, (file, text)| root.with(&format!("{folder}/{file}"), text))
    }

    #[cfg(unix)]
    pub(super) fn with_link(self, link: &str, target: &str) -> Self {
        let path = self.0.join(link);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::os::unix::fs::symlink(self.0.join(target), path).unwrap();
        self
    }

    pub(super) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Root {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).unwrap();
    }
}
