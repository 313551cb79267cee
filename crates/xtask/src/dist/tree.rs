//! Layout of the package.

use std::{path::Path, process::Command};

use super::{PROGRAMS, control, licences};
use crate::{command, error::Error, files};

/// Copied files with their destinations; documents keep relative places for their links.
const COPIES: [(&str, &str); 5] = [
    ("configs/service/letoff.service", "usr/lib/systemd/system/letoff.service"),
    ("configs/service/letoff.sysusers", "usr/lib/sysusers.d/letoff.conf"),
    ("configs/service/letoff.rules", "usr/lib/udev/rules.d/70-letoff.rules"),
    ("configs/service/letoff.limits", "etc/security/limits.d/letoff.conf"),
    ("configs/service/can.network", "usr/share/doc/letoff/examples/80-can.network"),
];

const DOCUMENTS: [&str; 20] = [
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "REFERENCES.md",
    "configs/README.md",
    "crates/cli/README.md",
    "crates/dashboard/MANUAL.md",
    "crates/dashboard/README.md",
    "crates/host/MANUAL.md",
    "crates/instruments/README.md",
    "crates/lab/FIGURE6.md",
    "crates/lab/IMPEDANCE.md",
    "crates/lab/README.md",
    "crates/lab/STABILITY.md",
    "crates/mechanism/LANGUAGE.md",
    "crates/pode/GUIDE.md",
    "crates/pode/README.md",
    "firmware-protocol/BOARDS.md",
    "firmware-protocol/PROTOCOL.md",
    "firmware-protocol/README.md",
];

const EXAMPLES: [&str; 3] = ["instruments", "models", "scenes"];

const C_SOURCES: [&str; 3] =
    ["firmware-protocol/c", "firmware-protocol/c/firmware", "firmware-protocol/c/rig"];

/// Scripts of dpkg, and the list of the administrator's files.
const CONTROL: [(&str, &str); 4] = [
    ("postinst", include_str!("postinst.sh")),
    ("prerm", include_str!("prerm.sh")),
    ("postrm", include_str!("postrm.sh")),
    ("conffiles", "/etc/security/limits.d/letoff.conf\n"),
];

/// Compresses files as policy requires, makes them readable, and writes the checksums.
const FINISH: &str = "\
find usr/share/man usr/share/doc/letoff -type f \\( -name '*.1' -o -name changelog \\
    -o -name THIRD-PARTY \\) -exec gzip -9n {} +
chmod -R u=rwX,go=rX .
chmod 755 DEBIAN/postinst DEBIAN/prerm DEBIAN/postrm usr/bin/*
find usr -type f -exec md5sum {} + | LC_ALL=C sort -k 2 >DEBIAN/md5sums
";

/// Writes the package's files below `root`, with the programs of the folder `built`.
pub(super) fn make(root: &Path, built: &Path) -> Result<(), Error> {
    files::empty(root)?;
    // For the scene, calibrations and instruments, which do not exist yet.
    files::make(&root.join("etc/letoff"))?;
    for (from, to) in COPIES {
        copy(&command::root().join(from), &root.join(to))?;
    }
    let documents = root.join("usr/share/doc/letoff");
    for document in DOCUMENTS {
        copy(&command::root().join(document), &documents.join(document))?;
    }
    for name in EXAMPLES {
        let from = command::root().join("configs").join(name);
        copy_files(&from, &documents.join("examples").join(name), Path::is_file)?;
    }
    for name in C_SOURCES {
        copy_files(&command::root().join(name), &documents.join(name), is_c_source)?;
    }
    add_programs(root, built)?;
    add_documents(&documents)?;
    for (name, content) in CONTROL {
        write(&root.join("DEBIAN").join(name), content)?;
    }
    command::answer(Command::new("sh").args(["-e", "-c", FINISH]).current_dir(root)).map(drop)
}

fn copy_files(from: &Path, to: &Path, is_wanted: fn(&Path) -> bool) -> Result<(), Error> {
    for path in files::list(from)?.iter().filter(|it| is_wanted(it)) {
        copy(path, &to.join(path.file_name().unwrap_or_default()))?;
    }
    Ok(())
}

/// Returns `true` for sources; a developer's folder also has results.
fn is_c_source(path: &Path) -> bool {
    let end = path.extension().and_then(|it| it.to_str());
    matches!(end, Some("c" | "h" | "ld" | "md"))
}

fn add_programs(root: &Path, built: &Path) -> Result<(), Error> {
    for name in PROGRAMS {
        let program = root.join("usr/bin").join(name);
        copy(&built.join(name), &program)?;
        let mut strip = Command::new("strip");
        strip.args(["--strip-unneeded", "--remove-section=.comment", "--remove-section=.note"]);
        command::run(strip.arg(&program))?;
    }
    let manual = root.with_extension("manual");
    files::empty(&manual)?;
    let [letoff, others @ ..] = PROGRAMS.map(|name| root.join("usr/bin").join(name));
    command::run(Command::new(letoff).arg("manual").arg(&manual))?;
    for program in others {
        command::run(Command::new(program).arg("--manual").arg(&manual))?;
    }
    for page in files::list(&manual)? {
        if let Some(place) = place_of(&page) {
            copy(&page, &root.join(place))?;
        }
    }
    Ok(())
}

/// Returns the install path of a man page or completion file.
fn place_of(page: &Path) -> Option<String> {
    let name = page.file_name()?.to_str()?;
    if let Some(zsh) = name.strip_prefix('_') {
        return Some(format!("usr/share/zsh/vendor-completions/_{zsh}"));
    }
    match name.rsplit_once('.')? {
        (_, "1") => Some(format!("usr/share/man/man1/{name}")),
        (program, "bash") => Some(format!("usr/share/bash-completion/completions/{program}")),
        (_, "fish") => Some(format!("usr/share/fish/vendor_completions.d/{name}")),
        _ => None,
    }
}

fn add_documents(folder: &Path) -> Result<(), Error> {
    let ours = files::read(&command::root().join("LICENSE-MIT"))?;
    write(&folder.join("copyright"), copyright(&ours))?;
    write(&folder.join("README.Debian"), include_str!("README.Debian"))?;
    write(&folder.join("THIRD-PARTY"), licences::third_party()?)?;
    write(&folder.join("changelog"), control::changelog(&date("%cD")?))
}

/// Returns the file `copyright`, with `mit`, the text of our own licence.
fn copyright(mit: &str) -> String {
    let holder = mit.lines().find_map(|line| line.strip_prefix("Copyright (c) "));
    let (_, text) = mit.split_once("\n\n").unwrap_or(("", mit));
    let indented = |line: &str| if line.is_empty() { " .".into() } else { format!(" {line}") };
    let lines: Vec<_> = text.trim_end().lines().map(indented).collect();
    format!(
        "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n\
         Upstream-Name: letoff\n\
         Source: {}\n\
         Comment: The crates that are linked into the programs, and their licences:\n \
         /usr/share/doc/letoff/THIRD-PARTY.gz\n\n\
         Files: *\n\
         Copyright: {}\n\
         License: Expat or Apache-2.0\n\n\
         License: Expat\n{}\n\n\
         License: Apache-2.0\n \
         On Debian systems the text is in /usr/share/common-licenses/Apache-2.0.\n",
        env!("CARGO_PKG_REPOSITORY"),
        holder.unwrap_or("The Letoff authors"),
        lines.join("\n"),
    )
}

/// Returns the time of the newest commit, so that equal sources make equal packages.
pub(super) fn date(format: &str) -> Result<String, Error> {
    let format = format!("--format={format}");
    let mut git = Command::new("git");
    command::answer(git.args(["log", "-1", &format]).current_dir(command::root()))
}

fn copy(from: &Path, to: &Path) -> Result<(), Error> {
    files::make(to.parent().unwrap_or(to))?;
    files::copy(from, to)
}

fn write(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Error> {
    files::make(path.parent().unwrap_or(path))?;
    files::write(path, content)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_file_that_is_copied_exists() {
        for (from, to) in COPIES {
            assert!(command::root().join(from).is_file(), "{from}");
            assert!(!to.starts_with('/'), "{to}");
        }
    }

    #[test]
    fn pages_and_completions_go_where_their_readers_look() {
        let place = |name: &str| place_of(Path::new(name)).unwrap_or_default();
        assert_eq!(place("x/letoff-run.1"), "usr/share/man/man1/letoff-run.1");
        assert_eq!(place("x/_letoff"), "usr/share/zsh/vendor-completions/_letoff");
        assert_eq!(place("x/letoff.bash"), "usr/share/bash-completion/completions/letoff");
        assert_eq!(place("x/letoff.fish"), "usr/share/fish/vendor_completions.d/letoff.fish");
        assert_eq!(place("x/notes.txt"), "");
    }

    #[test]
    fn the_licence_is_quoted_with_its_holder() {
        let mit = "MIT License\n\nCopyright (c) 2026 Somebody\n\nPermission is granted\n";
        let text = copyright(mit);
        assert!(text.contains("\nCopyright: 2026 Somebody\n"), "{text}");
        assert!(text.contains("\n .\n Permission is granted\n"), "{text}");
    }
}
