//! Installs missing packages on Debian and Ubuntu, or names what to install elsewhere.

use std::process::Command;

use crate::needs::{self, has_program, succeeds};
use crate::{command, error::Error};

/// Wait for another package manager before giving up (s).
const LOCK_TIMEOUT: &str = "DPkg::Lock::Timeout=120";

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

/// Installs `packages`; updates the package lists only if necessary.
pub(crate) fn install(packages: &[&str]) -> Result<(), Error> {
    let prefix = prefix().map_err(|because| Error::unobtainable(packages.join(" "), because))?;
    let mut arguments = vec!["install", "--yes", "--no-install-recommends"];
    arguments.extend(packages);
    if packages.iter().all(|package| is_known(package)) {
        // The lists may be older than the archive: update them and try again.
        if command::run(&mut apt_get(prefix, &arguments)).is_ok() {
            return Ok(());
        }
        println!("that did not work: reading the package lists anew");
    }
    command::run(&mut apt_get(prefix, &["update"]))?;
    command::run(&mut apt_get(prefix, &arguments))
}

pub(crate) fn update() -> Result<(), Error> {
    let prefix = prefix().map_err(|it| Error::unobtainable("the lists of packages", it))?;
    command::run(&mut apt_get(prefix, &["update"]))
}

fn confirm() -> Result<(), Error> {
    let needs = needs::missing();
    let because = "installing its packages has not brought it";
    if needs.is_empty() { Ok(()) } else { Err(Error::Missing { needs, because }) }
}

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

fn is_known(package: &str) -> bool {
    succeeds("apt-cache", &["show", "--no-all-versions", package])
}

fn apt_get(prefix: &[&str], arguments: &[&str]) -> Command {
    let fixed = ["env", "DEBIAN_FRONTEND=noninteractive", "apt-get", "-q", "-o", LOCK_TIMEOUT];
    let mut all = prefix.iter().chain(&fixed).chain(arguments);
    let mut command = Command::new(all.next().unwrap_or(&"apt-get"));
    command.args(all);
    command
}
