//! File names from clients of the stream, confined to folders of the host's owner.

use std::fs::{self, DirBuilder};
use std::os::unix::fs::DirBuilderExt as _;
use std::path::{Component, Path, PathBuf};

use documents::{choice, is_unprintable, quoted, shown};
use scene::{instruments, is_description};
use telemetry::recording::RecordingLimits;

const MAX_LISTED: usize = 500;

/// Folders in which clients of the stream may name files; `None` allows none.
#[derive(Clone, Debug, Default)]
pub struct Folders {
    /// Folder of recordings that clients begin.
    pub recordings: Option<PathBuf>,
    pub limits: RecordingLimits,
    /// Folder of instruments that clients may use beside the embedded ones.
    pub instruments: Option<PathBuf>,
}

impl Folders {
    /// Returns the path of a client's recording `name`; makes its folder if needed.
    ///
    /// # Errors
    /// A sentence if the path is not allowed.
    pub(super) fn recording(&self, name: &str) -> Result<String, String> {
        let folder = self.recordings.as_deref();
        let folder =
            folder.ok_or("this host lets no client record: give it --recordings FOLDER")?;
        let file = file_in(folder, name).filter(|file| has_ending(file, "mcap")).ok_or_else(|| {
            let (name, folder) = (quoted(name), shown(folder));
            format!(
                "recordings go into {folder} on the host's machine: give a file's name without a \
                 folder and with .mcap, not {name}"
            )
        })?;
        let made = DirBuilder::new().recursive(true).mode(0o700).create(folder);
        made.map_err(|error| format!("the folder {} cannot be made: {error}", shown(folder)))?;
        Ok(file.to_string_lossy().into_owned())
    }

    /// Returns the instrument `name` of a client: an embedded one, or a file's path.
    ///
    /// # Errors
    /// A sentence that reveals no file, if no such instrument is allowed.
    pub(super) fn instrument(&self, name: &str) -> Result<String, String> {
        let embedded: Vec<_> = instruments().into_iter().map(|it| it.name).collect();
        if embedded.iter().any(|it| it == name) {
            return Ok(name.to_owned());
        }
        self.file(name).ok_or_else(|| {
            let own = self.instruments.as_deref().map_or_else(String::new, |folder| {
                format!(", or a file in {} on the host's machine", shown(folder))
            });
            let (wanted, choice) = (quoted(name), choice(name, &embedded));
            format!("there is no instrument {wanted} for clients: {choice}{own}")
        })
    }

    /// Returns the path of a new instrument `name` of a client; makes its folder if needed.
    ///
    /// # Errors
    /// A sentence if the name is not allowed.
    pub(super) fn new_instrument(&self, name: &str) -> Result<PathBuf, String> {
        let folder = self.instruments.as_deref();
        let folder =
            folder.ok_or("this host has no folder of instruments: give it --instruments FOLDER")?;
        if is_embedded(name) {
            return Err(format!("{name} is an instrument of the program: choose another name"));
        }
        let file = file_in(folder, name).filter(|_| !name.contains('.')).ok_or_else(|| {
            format!("{} is no name of an instrument: give one without / and .", quoted(name))
        })?;
        let made = DirBuilder::new().recursive(true).mode(0o700).create(folder);
        made.map_err(|error| format!("the folder {} cannot be made: {error}", shown(folder)))?;
        Ok(file.with_added_extension("toml"))
    }

    /// Returns names and paths of the instruments in the folder, at most [`MAX_LISTED`].
    pub(super) fn own_instruments(&self) -> Vec<(String, PathBuf)> {
        let entries = self.instruments.as_deref().and_then(|folder| fs::read_dir(folder).ok());
        let paths = entries.into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path()));
        let files = paths.filter(|path| has_ending(path, "toml") && !is_description(path));
        let mut named: Vec<_> =
            files.filter_map(|path| Some((stem(&path)?, path))).take(MAX_LISTED).collect();
        named.sort();
        named
    }

    /// Returns the path of a client's description `name` among the instruments.
    ///
    /// # Errors
    /// A sentence that reveals no file, if no such description is allowed.
    pub(super) fn description(&self, name: &str) -> Result<String, String> {
        self.file(name).ok_or_else(|| {
            let place = self.instruments.as_deref().map_or_else(
                || "this host has no folder of them: give it --instruments FOLDER".to_owned(),
                |folder| format!("they are in {} on the host's machine", shown(folder)),
            );
            format!("there is no description {} for clients: {place}", quoted(name))
        })
    }

    fn file(&self, name: &str) -> Option<String> {
        let folder = self.instruments.as_deref()?;
        let file = file_in(folder, name)?;
        let file = if has_ending(&file, "toml") { file } else { file.with_added_extension("toml") };
        // A symbolic link may lead out of the folder.
        let file = fs::canonicalize(file).ok().filter(|file| file.is_file())?;
        let is_inside = file.starts_with(fs::canonicalize(folder).ok()?);
        is_inside.then(|| file.to_string_lossy().into_owned())
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Overwriting {
    Allowed,
    Refused,
}

pub(super) fn is_embedded(name: &str) -> bool {
    instruments().iter().any(|head| head.name == name)
}

fn stem(path: &Path) -> Option<String> {
    Some(path.file_stem()?.to_str()?.to_owned())
}

/// Returns the file `name` in `folder`; `None` if it would be elsewhere or hidden.
fn file_in(folder: &Path, name: &str) -> Option<PathBuf> {
    let name = Path::new(name);
    let name = name.strip_prefix(folder).unwrap_or(name);
    let mut parts = name.components();
    let (Some(Component::Normal(file)), None) = (parts.next(), parts.next()) else { return None };
    let text = file.to_str()?;
    let is_plain =
        !text.starts_with('.') && !text.contains(is_unprintable) && file == name.as_os_str();
    is_plain.then(|| folder.join(file))
}

fn has_ending(file: &Path, ending: &str) -> bool {
    file.extension().is_some_and(|it| it == ending)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_in_the_folder_are_named() {
        let folder = Path::new("/var/lib/x");
        for good in ["a.mcap", "/var/lib/x/a.mcap"] {
            assert_eq!(file_in(folder, good), Some(folder.join("a.mcap")), "{good}");
        }
        for bad in [
            "",
            ".",
            "..",
            "../a.mcap",
            "/a.mcap",
            "b/a.mcap",
            "./a.mcap",
            ".a.mcap",
            "a.mcap/",
            "/var/lib/x/../a.mcap",
            "/var/lib/x",
            "a\nb.mcap",
            "a\u{202e}b.mcap",
            "/var/lib/x/y/a.mcap",
        ] {
            assert_eq!(file_in(folder, bad), None, "{bad:?}");
        }
    }

    #[test]
    fn a_client_reads_no_file_that_is_no_instrument_of_its_folder() {
        let folder = folder();
        fs::write(folder.join("mine.toml"), "").expect("a file");
        std::os::unix::fs::symlink("/etc/passwd", folder.join("link.toml")).expect("a link");
        let folders = Folders { instruments: Some(folder.clone()), ..Folders::default() };
        assert_eq!(folders.instrument("grand-springs"), Ok("grand-springs".to_owned()));
        let mine = fs::canonicalize(folder.join("mine.toml")).expect("the file");
        assert_eq!(folders.instrument("mine"), Ok(mine.to_string_lossy().into_owned()));
        for foreign in ["/etc/passwd", "../mine.toml", "link.toml", "no", "Cargo.toml"] {
            let refused = folders.instrument(foreign).expect_err(foreign);
            assert!(refused.contains("no instrument") && !refused.contains("root:"), "{refused}");
        }
        assert_eq!(folders.description("mine.toml"), Ok(mine.to_string_lossy().into_owned()));
        for foreign in ["/etc/passwd", "../mine.toml", "link.toml", "spring-wall"] {
            let refused = folders.description(foreign).expect_err(foreign);
            assert!(refused.contains("no description") && !refused.contains("root:"), "{refused}");
        }
        assert!(Folders::default().instrument("mine").is_err());
        assert!(Folders::default().recording("a.mcap").is_err());
        fs::remove_dir_all(folder).expect("the folder");
    }

    fn folder() -> PathBuf {
        let folder = std::env::temp_dir().join(format!("letoff-folders-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        folder
    }
}
