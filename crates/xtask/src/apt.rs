//! Installing what is missing on Debian and Ubuntu; saying what to install elsewhere.

use std::process::Command;

use crate::command;
use crate::error::Error;
use crate::needs::{self, has_program, succeeds};

/// Waits for another package manager this long before giving up.
const LOCK_TIMEOUT: &str = "DPkg::Lock::Timeout=120";

/// Installs what the build needs and this system lacks; does nothing if nothing is lacking.
///
/// # Errors
/// Names what to install by hand, or the command that failed.
pub(crate) fn install_missing() -> Result<(), Error> {
    let needs = needs::missing();
    if needs.is_empty() {
        return Ok(());
    }
    if let Err(because) = prefix() {
        return Err(Error::Missing { needs, because });
    }
    let packages = needs::packages(&needs);
    println!("installing what is missing: {}", packages.join(" "));
    install(&packages)?;
    confirm()
}

/// Installs `packages`; reads the package lists anew only if that is needed.
///
/// # Errors
/// Says why packages cannot be installed here, or which command failed.
pub(crate) fn install(packages: &[&str]) -> Result<(), Error> {
    let prefix = prefix().map_err(|because| Error::unobtainable(packages.join(" "), because))?;
    let mut arguments = vec!["install", "--yes", "--no-install-recommends"];
    arguments.extend(packages);
    if packages.iter().all(|package| is_known(package)) {
        // Known, but perhaps by a list that is older than the archive: then once more.
        if command::run(&mut apt_get(prefix, &arguments)).is_ok() {
            return Ok(());
        }
        println!("that did not work: reading the package lists anew");
    }
    command::run(&mut apt_get(prefix, &["update"]))?;
    command::run(&mut apt_get(prefix, &arguments))
}

/// Reads the package lists anew.
///
/// # Errors
/// Says why that is impossible here, or which command failed.
pub(crate) fn update() -> Result<(), Error> {
    let prefix = prefix().map_err(|it| Error::unobtainable("the lists of packages", it))?;
    command::run(&mut apt_get(prefix, &["update"]))
}

/// Checks that nothing is lacking any more.
fn confirm() -> Result<(), Error> {
    let needs = needs::missing();
    let because = "installing its packages has not brought it";
    if needs.is_empty() { Ok(()) } else { Err(Error::Missing { needs, because }) }
}

/// What stands before `apt-get`, or why it cannot be used.
fn prefix() -> Result<&'static [&'static str], &'static str> {
    if !has_program("apt-get") {
        Err("there is no apt-get here")
    } else if is_root() {
        Ok(&[])
    } else if has_program("sudo") {
        Ok(&["sudo"])
    } else {
        Err("you are neither root nor have sudo")
    }
}

fn is_root() -> bool {
    Command::new("id").arg("-u").output().is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

/// Whether the package lists offer `package`.
fn is_known(package: &str) -> bool {
    succeeds("apt-cache", &["show", "--no-all-versions", package])
}

/// `apt-get` that never asks.
fn apt_get(prefix: &[&str], arguments: &[&str]) -> Command {
    let fixed = ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q", "-o", LOCK_TIMEOUT];
    let mut all = prefix.iter().chain(&fixed).chain(arguments);
    let mut command = Command::new(all.next().unwrap_or(&"apt-get"));
    command.args(all);
    command
}
