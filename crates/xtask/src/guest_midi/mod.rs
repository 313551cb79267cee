//! Plays to real ALSA ports, in a virtual machine with a Debian or Ubuntu kernel.
//!
//! Containers and build servers have no sequencer, and a kernel's cannot be loaded into them.
//! Here `letoff` runs in a guest whose only program is `init.sh`; what it must be heard to
//! play is written there. Nothing of the machine is changed but for a few packages.

mod files;
mod image;
mod kernel;
mod machine;
mod piece;
mod tools;
mod verdict;

use std::env;
use std::path::{Path, PathBuf};

use crate::apt;
use crate::command::{self, cargo};
use crate::error::Error;
use kernel::Kernel;
use machine::Machine;

/// Obtains a kernel and tools, builds, boots, and judges.
///
/// What cannot be obtained is no error: the run is skipped, and says so.
///
/// # Errors
/// Says what is missing for the build, which command failed, or what was not heard.
pub(crate) fn run() -> Result<(), Error> {
    let target = target()?;
    let folder = target.join("guest-midi");
    let kernel = match obtain(&folder) {
        Ok(kernel) => kernel,
        Err(error) => {
            print!("{}", skipped(&error));
            return Ok(());
        }
    };
    apt::install_missing()?;
    command::run(&mut cargo(["build", "--release", "--package", "host"]))?;
    let initrd = image::make(&folder, &kernel, &target.join("release/letoff"))?;
    let machine = Machine { kernel: kernel.image, initrd };
    let verdict = machine.boot()?;
    println!("\n{verdict}");
    verdict.into_result()
}

/// The folder that cargo builds into, which is ours two levels up: `target/debug/xtask`.
fn target() -> Result<PathBuf, Error> {
    let ours = env::current_exe().map_err(|cause| Error::file("this program", cause))?;
    let target = ours.ancestors().nth(2).map(PathBuf::from);
    target.ok_or_else(|| Error::unobtainable("cargo's target folder", "this program was moved"))
}

/// Everything that comes from elsewhere.
fn obtain(folder: &Path) -> Result<Kernel, Error> {
    tools::install_missing()?;
    kernel::obtain(folder)
}

/// Says so that nobody takes it for a pass.
fn skipped(error: &Error) -> String {
    let bar = "=".repeat(72);
    format!("\n{bar}\nSKIPPED: nothing was played to a real ALSA port\n{error}\n{bar}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_skip_cannot_be_taken_for_a_pass() {
        let error = Error::unobtainable("QEMU", "no network");
        let text = skipped(&error);
        assert!(text.contains("SKIPPED") && text.contains("no network"), "{text}");
        assert!(!text.contains("passed"), "{text}");
    }
}
