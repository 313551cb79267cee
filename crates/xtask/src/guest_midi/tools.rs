//! The programs that make the guest, or run in it.

use std::env;
use std::path::{Path, PathBuf};

use crate::apt;
use crate::error::Error;

/// Each program with Debian's and Ubuntu's package for it.
const TOOLS: [(&str, &str); 8] = [
    ("qemu-system-x86_64", "qemu-system-x86"),
    ("busybox", "busybox-static"),
    ("cpio", "cpio"),
    ("depmod", "kmod"),
    ("aseqdump", "alsa-utils"),
    ("aconnect", "alsa-utils"),
    ("dpkg-deb", "dpkg"),
    ("ldd", "libc-bin"),
];

/// Folders of programs that are not on everybody's path.
const SYSTEM: [&str; 2] = ["/usr/sbin", "/sbin"];

/// Installs what is missing.
///
/// # Errors
/// Says what cannot be had, and why.
pub(super) fn install_missing() -> Result<(), Error> {
    if !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
        return Err(Error::unobtainable("a guest", "it needs a Debian or Ubuntu on x86_64"));
    }
    let packages = packages(|program| find(program).is_some());
    if packages.is_empty() {
        return Ok(());
    }
    println!("installing what is missing: {}", packages.join(" "));
    apt::install(&packages)?;
    match TOOLS.iter().find(|(program, _)| find(program).is_none()) {
        None => Ok(()),
        Some((program, package)) => {
            Err(Error::unobtainable(*program, format!("installing {package} has not brought it")))
        }
    }
}

/// The packages of the programs that are not there.
fn packages(is_there: impl Fn(&str) -> bool) -> Vec<&'static str> {
    let missing = TOOLS.iter().filter(|(program, _)| !is_there(program));
    let mut packages: Vec<_> = missing.map(|(_, package)| *package).collect();
    packages.dedup();
    packages
}

/// Where `program` is.
///
/// # Errors
/// If it is nowhere.
pub(super) fn path(program: &str) -> Result<PathBuf, Error> {
    find(program).ok_or_else(|| Error::unobtainable(program, "it is not installed"))
}

fn find(program: &str) -> Option<PathBuf> {
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = env::split_paths(&path).chain(SYSTEM.map(PathBuf::from));
    folders.map(|folder| folder.join(program)).find(|path| Path::is_file(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_missing_package_is_named_once() {
        assert!(packages(|_| true).is_empty());
        assert_eq!(packages(|program| !program.starts_with('a')), ["alsa-utils"]);
        assert_eq!(packages(|_| false).len(), 7);
    }
}
