//! The demo: the simulated keybed and a virtual pianist, for half a minute.

use std::ffi::{OsStr, OsString};
use std::path::Path;

use crate::command::{self, cargo, target};
use crate::{apt, error::Error, files};

/// Default duration (s).
const DURATION: &str = "30";

/// SoundFonts that the host looks for, and the package of the smallest one.
const FONTS: [&str; 3] = [
    "/usr/share/sounds/sf2/FluidR3_GM.sf2",
    "/usr/share/sounds/sf2/default-GM.sf2",
    "/usr/share/sounds/sf2/TimGM6mb.sf2",
];
const FONT_PACKAGE: &str = "timgm6mb-soundfont";

/// Installs what is missing, builds, and becomes `letoff run`.
pub(crate) fn play(forwarded: Vec<OsString>) -> Result<(), Error> {
    apt::install_missing()?;
    println!("building the host, in release mode; the first time takes a few minutes");
    command::run(&mut cargo(["build", "--release", "--package", "cli"]))?;
    let arguments = letoff_arguments(forwarded, &outputs()?);
    let ours = ["run", "--release", "--quiet", "--package", "cli", "--"].map(OsString::from);
    command::become_command(&mut cargo(ours.into_iter().chain(arguments)))
}

fn outputs() -> Result<Vec<String>, Error> {
    let has_font = || FONTS.iter().any(|it| Path::new(it).is_file());
    if !has_font()
        && let Err(error) = apt::install(&[FONT_PACKAGE])
    {
        println!("{error}; the demo is silent");
    }
    let folder = target()?.join("demo");
    files::empty(&folder)?;
    let file = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let mut options = vec!["--picture".into(), file("demo.svg")];
    if has_font() {
        options.extend(["--sound".into(), "--wav".into(), file("demo.wav")]);
    }
    Ok(options)
}

/// Returns our arguments of `letoff`, with the `outputs` unless the user chose some, then the user's; a duration of theirs replaces ours.
fn letoff_arguments(forwarded: Vec<OsString>, outputs: &[String]) -> Vec<OsString> {
    let sets_duration = |argument: &OsString| {
        argument == "--duration" || argument.as_encoded_bytes().starts_with(b"--duration=")
    };
    let ours: &[&str] = if forwarded.iter().any(sets_duration) {
        &["run"]
    } else {
        &["run", "--duration", DURATION]
    };
    let chooses = |it: &OsString| {
        ["--sound", "--wav", "--picture", "--midi"].iter().any(|option| it == option)
    };
    let outputs = if forwarded.iter().any(chooses) { &[] } else { outputs };
    let outputs = outputs.iter().map(OsStr::new);
    ours.iter().map(OsStr::new).chain(outputs).map(OsStr::to_owned).chain(forwarded).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(forwarded: &[&str], expected: &[&str]) {
        let outputs = ["--wav".to_owned(), "a.wav".to_owned()];
        let arguments = letoff_arguments(forwarded.iter().map(OsString::from).collect(), &outputs);
        assert_eq!(arguments, expected);
    }

    #[test]
    fn it_plays_for_half_a_minute_unless_told_otherwise() {
        check(&[], &["run", "--duration", "30", "--wav", "a.wav"]);
        check(&["--json"], &["run", "--duration", "30", "--wav", "a.wav", "--json"]);
        check(&["--duration", "5"], &["run", "--wav", "a.wav", "--duration", "5"]);
        check(&["--duration=5"], &["run", "--wav", "a.wav", "--duration=5"]);
        check(&["--midi", "virtual"], &["run", "--duration", "30", "--midi", "virtual"]);
    }
}
