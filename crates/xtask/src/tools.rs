//! Programs that build the guest, or run in it.

use std::env;
use std::path::{Path, PathBuf};

use crate::{apt, error::Error};

/// A program or file path, with its package in Debian and Ubuntu.
pub(crate) type Tool = (&'static str, &'static str);

pub(crate) const MAKERS: [Tool; 6] = [
    ("qemu-system-x86_64", "qemu-system-x86"),
    ("busybox", "busybox-static"),
    ("cpio", "cpio"),
    ("depmod", "kmod"),
    ("dpkg-deb", "dpkg"),
    ("ldd", "libc-bin"),
];

/// Folders of programs that may be missing on the path.
const SYSTEM: [&str; 2] = ["/usr/sbin", "/sbin"];

pub(crate) fn ensure(wanted: &[&[Tool]]) -> Result<(), Error> {
    let packages = packages(wanted, |program| find(program).is_some());
    if packages.is_empty() {
        return Ok(());
    }
    println!("installing what is missing: {}", packages.join(" "));
    apt::install(&packages)?;
    match wanted.iter().copied().flatten().find(|(program, _)| find(program).is_none()) {
        None => Ok(()),
        Some((program, package)) => {
            Err(Error::unobtainable(*program, format!("installing {package} has not brought it")))
        }
    }
}

pub(crate) fn packages(tools: &[&[Tool]], is_there: impl Fn(&str) -> bool) -> Vec<&'static str> {
    let missing = tools.iter().copied().flatten().filter(|(program, _)| !is_there(program));
    let mut packages: Vec<_> = missing.map(|(_, package)| *package).collect();
    packages.sort_unstable();
    packages.dedup();
    packages
}

pub(crate) fn path(program: &str) -> Result<PathBuf, Error> {
    find(program).ok_or_else(|| Error::unobtainable(program, "it is not installed"))
}

pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = env::split_paths(&path).chain(SYSTEM.map(PathBuf::from));
    folders.map(|folder| folder.join(program)).find(|path| Path::is_file(path))
}
