//! Downloads and unpacks a kernel of the distribution, without installing it.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{apt, command, error::Error, files, tools};

/// Packages that depend on the newest kernel: Debian's, Ubuntu's.
const NEWEST: [&str; 2] = ["linux-image-amd64", "linux-image-generic"];

const PARTS: [&str; 3] = ["linux-image-", "linux-modules-", "linux-binary-"];

pub(super) struct Kernel {
    pub image: PathBuf,
    pub modules: PathBuf,
}

/// Returns the newest kernel of the distribution, unpacked below `folder` if necessary.
pub(super) fn obtain(folder: &Path) -> Result<Kernel, Error> {
    let packages = packages()?;
    let name = packages.first().map_or("kernel", String::as_str);
    let unpacked = folder.join(name);
    if !unpacked.exists() {
        let part = folder.join("part");
        files::empty(&part)?;
        download(&part, &packages)?;
        std::fs::rename(&part, &unpacked).map_err(|cause| Error::file(&unpacked, cause))?;
    }
    find(&unpacked)
}

/// Returns the packages of the newest kernel; updates the package lists once if there are none.
fn packages() -> Result<Vec<String>, Error> {
    let known = known_packages();
    if !known.is_empty() {
        return Ok(known);
    }
    apt::update()?;
    let known = known_packages();
    let because = || format!("apt knows neither {} nor {}", NEWEST[0], NEWEST[1]);
    if known.is_empty() { Err(Error::unobtainable("a kernel", because())) } else { Ok(known) }
}

fn known_packages() -> Vec<String> {
    let newest = NEWEST.iter().map(|package| dependencies(package));
    let mut packages = newest.into_iter().find(|found| !found.is_empty()).unwrap_or_default();
    let deeper: Vec<_> = packages.iter().flat_map(|package| dependencies(package)).collect();
    for package in deeper {
        if !packages.contains(&package) {
            packages.push(package);
        }
    }
    packages
}

fn dependencies(package: &str) -> Vec<String> {
    let output = Command::new("apt-cache").args(["depends", package]).output();
    output.map_or_else(|_no_apt| Vec::new(), |it| parts(&String::from_utf8_lossy(&it.stdout)))
}

fn parts(depends: &str) -> Vec<String> {
    let names = depends.lines().filter_map(|line| line.trim().strip_prefix("Depends: "));
    let is_part = |name: &&str| PARTS.iter().any(|part| name.starts_with(part));
    names.filter(is_part).map(str::to_owned).collect()
}

fn download(folder: &Path, packages: &[String]) -> Result<(), Error> {
    let fetch = || {
        let mut command = Command::new("apt-get");
        command::run(command.arg("download").args(packages).current_dir(folder))
    };
    if fetch().is_err() {
        // The lists are older than the archive.
        apt::update()?;
        fetch()?;
    }
    for package in files::list(folder)? {
        command::run(Command::new("dpkg-deb").arg("-x").args([package.as_path(), folder]))?;
        std::fs::remove_file(&package).map_err(|cause| Error::file(&package, cause))?;
    }
    // Newer releases have everything below /usr, where depmod does not look.
    if !folder.join("lib").exists() {
        link(folder)?;
    }
    let modules = modules(folder)?;
    let version = modules.file_name().unwrap_or_default();
    command::run(Command::new(tools::path("depmod")?).arg("-b").args([folder.as_os_str(), version]))
}

#[cfg(unix)]
fn link(folder: &Path) -> Result<(), Error> {
    let lib = folder.join("lib");
    std::os::unix::fs::symlink("usr/lib", &lib).map_err(|cause| Error::file(&lib, cause))
}

#[cfg(not(unix))]
fn link(_folder: &Path) -> Result<(), Error> {
    Ok(())
}

fn find(folder: &Path) -> Result<Kernel, Error> {
    let images = files::list(&folder.join("boot"))?.into_iter();
    let is_image = |path: &PathBuf| {
        path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"vmlinuz-"))
    };
    let image = images.into_iter().find(is_image);
    let image = image.ok_or_else(|| Error::unobtainable("a kernel", "its package has none"))?;
    Ok(Kernel { image, modules: modules(folder)? })
}

fn modules(folder: &Path) -> Result<PathBuf, Error> {
    let versions = files::list(&folder.join("lib/modules"))?;
    let none = || Error::unobtainable("the kernel's modules", "its package has none");
    versions.into_iter().next().ok_or_else(none)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kernel_of_debian_is_one_package() {
        let depends = "linux-image-amd64\n  Depends: linux-image-6.1.0-56-amd64\n";
        assert_eq!(parts(depends), ["linux-image-6.1.0-56-amd64"]);
    }

    #[test]
    fn a_kernel_of_ubuntu_is_several_and_its_firmware_is_none_of_them() {
        let depends = "linux-image-generic\n  Depends: linux-image-6.8.0-60-generic\n  \
                       Depends: linux-modules-extra-6.8.0-60-generic\n  Depends: linux-firmware\n \
                       |Depends: linux-image-other\n  Recommends: thermald\n";
        let expected = ["linux-image-6.8.0-60-generic", "linux-modules-extra-6.8.0-60-generic"];
        assert_eq!(parts(depends), expected);
    }
}
