//! The programs that make the guest, or run in it.

use std::env;
use std::path::{Path, PathBuf};

use crate::apt;
use crate::error::Error;

/// A program, or the path of a file, and Debian's and Ubuntu's package for it.
pub(crate) type Tool = (&'static str, &'static str);

/// What makes every guest.
pub(crate) const MAKERS: [Tool; 6] = [
    ("qemu-system-x86_64", "qemu-system-x86"),
    ("busybox", "busybox-static"),
    ("cpio", "cpio"),
    ("depmod", "kmod"),
    ("dpkg-deb", "dpkg"),
    ("ldd", "libc-bin"),
];

/// Folders of programs that are not on everybody's path.
const SYSTEM: [&str; 2] = ["/usr/sbin", "/sbin"];

/// Installs what is missing of `wanted`.
///
/// # Errors
/// Says what cannot be had, and why.
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

/// The packages of the programs that are not there, each once.
pub(crate) fn packages(tools: &[&[Tool]], is_there: impl Fn(&str) -> bool) -> Vec<&'static str> {
    let missing = tools.iter().copied().flatten().filter(|(program, _)| !is_there(program));
    let mut packages: Vec<_> = missing.map(|(_, package)| *package).collect();
    packages.sort_unstable();
    packages.dedup();
    packages
}

/// Where `program` is.
///
/// # Errors
/// If it is nowhere.
pub(crate) fn path(program: &str) -> Result<PathBuf, Error> {
    find(program).ok_or_else(|| Error::unobtainable(program, "it is not installed"))
}

/// Where `program` is, if it is anywhere.
pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = env::split_paths(&path).chain(SYSTEM.map(PathBuf::from));
    folders.map(|folder| folder.join(program)).find(|path| Path::is_file(path))
}
