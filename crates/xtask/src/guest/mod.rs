//! A virtual machine with a Debian or Ubuntu kernel, in which `letoff` is checked against real
//! drivers, or as a service.
//!
//! Containers and build servers have no sequencer or CAN bus, and cannot load a kernel's modules. A
//! guest can: its only program `init.sh` loads them and runs the checks of a [`GuestCheck`].

mod image;
mod kernel;
mod machine;
pub(crate) mod piece;
mod system;
mod verdict;

use std::path::{Path, PathBuf};
use std::{sync::mpsc, time::Duration};

use crate::command::{self, cargo, target};
use crate::tools::{self, Tool};
use crate::{apt, dist, error::Error, stage::Done};
use kernel::Kernel;
use machine::VirtualMachine;
pub(crate) use system::GuestSystem;
use verdict::HeardNotes;

/// Four keys of a grand, within reach of an emulated processor.
pub(crate) const SCENE: &str = include_str!("scene.toml");

/// A set of checks in a guest.
pub(crate) struct GuestCheck {
    pub name: &'static str,
    /// Devices that it plays on, in a few words.
    pub plays_on: &'static str,
    pub system: GuestSystem,
    /// Modules with their parameters; their dependencies are loaded first.
    pub modules: &'static [&'static str],
    pub programs: &'static [Tool],
    /// Files of this machine, at the same path in the guest.
    pub copies: &'static [&'static str],
    pub more: Vec<PathBuf>,
    /// Files of the guest: path from its root, and content.
    pub files: Vec<(&'static str, Vec<u8>)>,
    /// Parts of the checks, each in its own emulated machine; `$part` in the guest.
    pub parts: &'static [&'static str],
    pub time_limit: Duration,
    pub program: TriedProgram,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum TriedProgram {
    /// Optimised build of the tests, with checked arithmetic.
    OfTheTests,
    /// Release build, which is built first.
    Release,
    /// A package, `letoff.deb` in the guest, built with this profile.
    Packaged(String),
}

impl TriedProgram {
    /// Returns its path below the folder `target`, and builds it if necessary.
    fn obtain(&self, target: &Path) -> Result<PathBuf, Error> {
        match self {
            Self::OfTheTests => Ok(target.join("debug/letoff")),
            Self::Release => {
                apt::install_missing()?;
                command::run(&mut cargo(["build", "--release", "--package", "cli"]))?;
                Ok(target.join("release/letoff"))
            }
            Self::Packaged(profile) => dist::make(profile),
        }
    }
}

impl GuestCheck {
    /// Obtains a kernel and tools, builds `letoff`, boots, and judges. Skips the run, with the
    /// reason, if something cannot be obtained.
    pub(crate) fn run(&self) -> Result<Done, Error> {
        let target = target()?;
        let folder = target.join("guest");
        let kernel = match self.obtain(&folder) {
            Ok(kernel) => kernel,
            Err(error) => {
                print!("{}", self.skipped(&error));
                return Ok(Done::Skipped(error.to_string()));
            }
        };
        let program = self.program.obtain(&target)?;
        let initrd = image::make(&folder.join(self.name), self, &kernel, &program)?;
        let heard = self.boot(&kernel.image, &initrd)?;
        println!("\n{}: {heard}", self.plays_on);
        heard.into_result().map(|()| Done::All)
    }

    fn boot(&self, kernel: &Path, initrd: &Path) -> Result<HeardNotes, Error> {
        let (console, lines) = mpsc::channel();
        let machine = |&part| VirtualMachine { kernel, initrd, system: self.system, part };
        let boot = |part| machine(part).boot(console.clone());
        let running: Vec<_> = self.parts.iter().map(boot).collect::<Result<_, _>>()?;
        drop(console);
        Ok(machine::listen(&lines, running.len(), self.time_limit))
    }

    fn obtain(&self, folder: &Path) -> Result<Kernel, Error> {
        if !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
            return Err(Error::unobtainable("a guest", "it needs a Debian or Ubuntu on x86_64"));
        }
        tools::ensure(&[&tools::MAKERS, self.programs])?;
        kernel::obtain(folder)
    }

    fn skipped(&self, error: &Error) -> String {
        let bar = "=".repeat(72);
        format!("\n{bar}\nSKIPPED: nothing was played on {}\n{error}\n{bar}\n", self.plays_on)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_skip_cannot_be_taken_for_a_pass() {
        let error = Error::unobtainable("QEMU", "no network");
        let text = crate::guest_midi::guest(TriedProgram::Release).skipped(&error);
        assert!(text.contains("SKIPPED") && text.contains("no network"), "{text}");
        assert!(!text.contains("passed"), "{text}");
    }
}
