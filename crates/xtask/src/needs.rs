//! System libraries and tools that the build needs.

use std::process::{Command, Stdio};
use std::{env, path::Path};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Need {
    Compiler,
    /// Finds the library for `alsa-sys`.
    PkgConfig,
    Alsa,
}

impl Need {
    /// All needs; macOS and Windows have their own MIDI.
    const ALL: &[Self] = if cfg!(target_os = "linux") {
        &[Self::Compiler, Self::PkgConfig, Self::Alsa]
    } else {
        &[]
    };

    pub(crate) const fn description(self) -> &'static str {
        match self {
            Self::Compiler => "a C compiler called cc",
            Self::PkgConfig => "pkg-config",
            Self::Alsa => "the headers of the ALSA library",
        }
    }

    const fn packages(self) -> &'static [&'static str] {
        match self {
            Self::Compiler => &["gcc", "libc6-dev"],
            Self::PkgConfig => &["pkg-config"],
            Self::Alsa => &["libasound2-dev"],
        }
    }

    fn is_met(self) -> bool {
        match self {
            Self::Compiler => has_program("cc"),
            Self::PkgConfig => has_program("pkg-config"),
            Self::Alsa if has_program("pkg-config") => {
                succeeds("pkg-config", &["--exists", "alsa"])
            }
            Self::Alsa => Path::new("/usr/include/alsa/asoundlib.h").exists(),
        }
    }
}

pub(crate) fn missing() -> Vec<Need> {
    missing_by(Need::is_met)
}

fn missing_by(is_met: impl Fn(Need) -> bool) -> Vec<Need> {
    Need::ALL.iter().copied().filter(|need| !is_met(*need)).collect()
}

pub(crate) fn packages(needs: &[Need]) -> Vec<&'static str> {
    needs.iter().flat_map(|need| need.packages()).copied().collect()
}

pub(crate) fn has_program(name: &str) -> bool {
    let path = env::var_os("PATH").unwrap_or_default();
    env::split_paths(&path).any(|folder| folder.join(name).is_file())
}

pub(crate) fn succeeds(program: &str, arguments: &[&str]) -> bool {
    let mut command = Command::new(program);
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    #[track_caller]
    fn check(met: &[Need], expected: &[&str]) {
        assert_eq!(packages(&missing_by(|need| met.contains(&need))), expected, "with {met:?}");
    }

    #[test]
    fn only_what_is_missing_is_installed() {
        check(&[], &["gcc", "libc6-dev", "pkg-config", "libasound2-dev"]);
        check(&[Need::Compiler], &["pkg-config", "libasound2-dev"]);
        check(&[Need::Compiler, Need::PkgConfig], &["libasound2-dev"]);
        check(&[Need::Compiler, Need::PkgConfig, Need::Alsa], &[]);
    }

    #[test]
    fn programs_are_found_on_the_path_only() {
        assert!(has_program("sh"));
        assert!(!has_program("no-such-program-anywhere"));
    }
}
