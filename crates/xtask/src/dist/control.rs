//! The control data of the Debian package.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{command, error::Error, files};

const MAINTAINER: &str = "The Letoff authors <letoff@users.noreply.github.com>";

/// Libraries that the window loads by name at run time, so no tool finds them in the program.
const FOR_THE_WINDOW: &str = "libegl1, libgl1, libwayland-client0, libwayland-egl1, libx11-6, \
                              libx11-xcb1, libxcursor1, libxi6, libxkbcommon0, libxkbcommon-x11-0";

/// Minimal source package for `dpkg-shlibdeps`.
const STUB: &str = "Source: letoff\n\nPackage: letoff\nArchitecture: any\n";

pub(super) const VERSION: &str = env!("CARGO_PKG_VERSION");

pub(super) struct PackageFacts {
    /// Debian's name of the processor, as `amd64`.
    pub architecture: String,
    /// Linked packages, in dpkg's form.
    pub depends: String,
    /// Size on the disk (KiB).
    pub installed_size: u64,
}

impl PackageFacts {
    pub(super) fn control(&self) -> String {
        let Self { architecture, depends, installed_size } = self;
        format!(
            "Package: letoff\n\
             Version: {VERSION}\n\
             Architecture: {architecture}\n\
             Maintainer: {MAINTAINER}\n\
             Installed-Size: {installed_size}\n\
             Depends: {depends}, systemd | systemd-standalone-sysusers\n\
             Recommends: iproute2, {FOR_THE_WINDOW}\n\
             Suggests: can-utils\n\
             Section: sound\n\
             Priority: optional\n\
             Homepage: {}\n\
             Description: host of force-feedback piano keyboards\n \
             Letoff reads the positions of up to 88 motorised keys, integrates the\n \
             differential equations of a piano action for each of them, and sends the\n \
             force that the finger feels back to the key, a thousand times a second.\n \
             What the hammers strike becomes MIDI.\n \
             .\n \
             The package has the command letoff, the window letoff-dashboard, and a\n \
             service that plays from power-on.\n",
            env!("CARGO_PKG_REPOSITORY"),
        )
    }

    pub(super) fn file_name(&self) -> String {
        format!("letoff_{VERSION}_{}.deb", self.architecture)
    }
}

/// Returns the changelog in Debian's form, for a `date` as in RFC 5322.
pub(super) fn changelog(date: &str) -> String {
    format!(
        "letoff ({VERSION}) stable; urgency=medium\n\n  * The first packages.\n\n -- {MAINTAINER}  {date}\n"
    )
}

pub(super) fn architecture() -> Result<String, Error> {
    command::answer(Command::new("dpkg").arg("--print-architecture"))
}

/// Returns the packages that `programs` are linked with; `folder` gets a stub for `dpkg-shlibdeps`.
pub(super) fn linked_packages(folder: &Path, programs: &[PathBuf]) -> Result<String, Error> {
    files::empty(&folder.join("debian"))?;
    files::write(&folder.join("debian/control"), STUB)?;
    let mut command = Command::new("dpkg-shlibdeps");
    let said = command::answer(command.arg("-O").args(programs).current_dir(folder))?;
    depends(&said).map(str::to_owned).ok_or_else(|| {
        Error::unobtainable("the list of packages that the programs need", format!("\"{said}\""))
    })
}

fn depends(said: &str) -> Option<&str> {
    said.lines().find_map(|line| line.strip_prefix("shlibs:Depends=")).filter(|it| !it.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_control_file_has_its_fields_and_no_empty_line() {
        let depends = "libasound2 (>= 1.0.16), libc6 (>= 2.34)".to_owned();
        let facts = PackageFacts { architecture: "amd64".into(), depends, installed_size: 30_000 };
        let control = facts.control();
        assert!(control.lines().all(|line| !line.trim().is_empty()), "{control}");
        assert!(control.contains("\nDepends: libasound2 (>= 1.0.16), libc6 (>= 2.34), systemd"));
        let (_, description) = control.split_once("\nDescription: ").unwrap();
        assert!(description.lines().skip(1).all(|line| line.starts_with(' ')), "{control}");
        assert_eq!(facts.file_name(), format!("letoff_{VERSION}_amd64.deb"));
    }

    #[test]
    fn programs_that_need_nothing_are_not_believed() {
        assert_eq!(depends("shlibs:Depends=libc6 (>= 2.34)\n"), Some("libc6 (>= 2.34)"));
        assert_eq!(depends("shlibs:Depends=\n"), None);
        assert_eq!(depends(""), None);
    }
}
