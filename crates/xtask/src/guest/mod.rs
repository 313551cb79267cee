//! A virtual machine with a Debian or Ubuntu kernel, in which `letoff` is checked against real
//! drivers, or as a service.
//!
//! Containers and build servers have neither a sequencer nor a CAN bus, and a kernel's modules
//! cannot be loaded into them. In a guest they can: its only program is `init.sh`, which loads
//! the modules and goes through what a [`GuestCheck`] checks. Nothing of the machine is changed but
//! for a few packages.

mod image;
mod kernel;
mod machine;
pub(crate) mod piece;
mod system;
mod verdict;

use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Duration;

use crate::apt;
use crate::command::{self, cargo, target};
use crate::dist;
use crate::error::Error;
use crate::stage::Done;
use crate::tools::{self, Tool};
use kernel::Kernel;
use machine::VirtualMachine;
pub(crate) use system::GuestSystem;
use verdict::HeardNotes;

/// Four keys of a grand: as many as an emulated processor computes in time.
pub(crate) const SCENE: &str = include_str!("scene.toml");

/// What is checked in a guest.
pub(crate) struct GuestCheck {
    /// Name of the folder in which it is put together.
    pub name: &'static str,
    /// What it plays on, in a few words.
    pub plays_on: &'static str,
    /// What runs beside the checks.
    pub system: GuestSystem,
    /// Modules with their parameters, each with those it needs loaded before.
    pub modules: &'static [&'static str],
    /// Programs of this machine that run in the guest, beside busybox.
    pub programs: &'static [Tool],
    /// Files of this machine that stand in the guest at the same place.
    pub copies: &'static [&'static str],
    /// Other programs in the guest, by path.
    pub more: Vec<PathBuf>,
    /// Files of the guest: path beneath its root, and content.
    pub files: Vec<(&'static str, Vec<u8>)>,
    /// Parts of the checks, each in an emulated machine of its own beside the others; in the guest,
    /// `$part` says which.
    pub parts: &'static [&'static str],
    /// How long everything may take.
    pub time_limit: Duration,
    /// Which `letoff` plays.
    pub program: TriedProgram,
}

/// Which build of `letoff` is tried in a guest.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum TriedProgram {
    /// The one that the tests have built: it is optimised, and checks its arithmetic.
    OfTheTests,
    /// The one that users run, which is built first.
    Release,
    /// A package, `letoff.deb` in the guest, of programs that are built with this profile.
    Packaged(String),
}

impl TriedProgram {
    /// Its path below the folder `target`, built if need be.
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
    /// Obtains a kernel and tools, builds `letoff`, boots, and judges.
    ///
    /// What cannot be obtained is no error: the run is skipped, and says why.
    ///
    /// # Errors
    /// Says what is missing for the build, which command failed, or which check did.
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

    /// Boots a machine for each part, and returns what all of them said.
    fn boot(&self, kernel: &Path, initrd: &Path) -> Result<HeardNotes, Error> {
        let (console, lines) = mpsc::channel();
        let machine = |&part| VirtualMachine { kernel, initrd, system: self.system, part };
        let boot = |part| machine(part).boot(console.clone());
        let running: Vec<_> = self.parts.iter().map(boot).collect::<Result<_, _>>()?;
        drop(console);
        Ok(machine::listen(&lines, running.len(), self.time_limit))
    }

    /// Everything that comes from elsewhere.
    fn obtain(&self, folder: &Path) -> Result<Kernel, Error> {
        if !cfg!(all(target_os = "linux", target_arch = "x86_64")) {
            return Err(Error::unobtainable("a guest", "it needs a Debian or Ubuntu on x86_64"));
        }
        tools::ensure(&[&tools::MAKERS, self.programs])?;
        kernel::obtain(folder)
    }

    /// Says so that nobody takes it for a pass.
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
