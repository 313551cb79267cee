//! The Debian package: programs, service, man pages, completions, and licences of what is linked.

mod control;
mod deny;
mod licences;
mod tree;

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{self, cargo, target};
use crate::tools::{self, Tool};
use crate::{apt, error::Error, files};
use control::PackageFacts;

/// Profile of packages: optimised across crates.
pub(crate) const PROFILE: &str = "dist";

const MAKERS: [Tool; 6] = [
    ("dpkg-deb", "dpkg"),
    ("dpkg-shlibdeps", "dpkg-dev"),
    ("du", "coreutils"),
    ("gzip", "gzip"),
    ("md5sum", "coreutils"),
    ("strip", "binutils"),
];

const PROGRAMS: [&str; 3] = ["letoff", "letoff-dashboard", "letoff-lab"];

/// Builds the programs with `profile`, packs them, and prints the package's path.
pub(crate) fn run(profile: &str) -> Result<(), Error> {
    let package = make(profile)?;
    if tools::find("lintian").is_some() {
        command::run(Command::new("lintian").args(["--fail-on", "error"]).arg(&package))?;
    } else {
        println!("the package was not looked through: apt-get install lintian does that");
    }
    println!("\n{}", package.display());
    println!("install it: sudo apt-get install {}", package.display());
    Ok(())
}

/// Builds the programs with `profile`, packs them, and returns the package's path.
pub(crate) fn make(profile: &str) -> Result<PathBuf, Error> {
    apt::install_missing()?;
    tools::ensure(&[&MAKERS])?;
    let build =
        ["build", "--profile", profile, "--package=cli", "--package=dashboard", "--package=lab"];
    command::run(&mut cargo(build.into_iter().chain(["--bins"])))?;
    let target = target()?;
    let built = target.join(folder_of(profile));
    let folder = target.join("dist");
    let root = folder.join("letoff");
    tree::make(&root, &built)?;
    pack(&folder, &root)
}

fn folder_of(profile: &str) -> &str {
    if profile == "dev" { "debug" } else { profile }
}

fn pack(folder: &Path, root: &Path) -> Result<PathBuf, Error> {
    let programs = PROGRAMS.map(|name| root.join("usr/bin").join(name));
    let facts = PackageFacts {
        architecture: control::architecture()?,
        depends: control::linked_packages(&folder.join("linked"), &programs)?,
        installed_size: size(root)?,
    };
    files::write(&root.join("DEBIAN/control"), facts.control())?;
    let package = folder.join(facts.file_name());
    let mut command = Command::new("dpkg-deb");
    // gzip: a slow machine unpacks it in a second.
    command.args(["--build", "--root-owner-group", "-Zgzip"]).args([root, &package]);
    command::run(command.env("SOURCE_DATE_EPOCH", tree::date("%ct")?))?;
    Ok(package)
}

/// Returns the size of the files below `root` (KiB).
fn size(root: &Path) -> Result<u64, Error> {
    let said = command::answer(Command::new("du").args(["-k", "-s", "--apparent-size"]).arg(root))?;
    let size = said.split_whitespace().next().and_then(|it| it.parse().ok());
    size.ok_or_else(|| Error::unobtainable("the size of the package", format!("du says {said}")))
}
