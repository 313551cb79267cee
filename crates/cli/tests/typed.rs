//! `letoff` in a folder of the test's own.

use std::fs::File;
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use rustix::fs::{CWD, FileType, Mode, mknodat};

/// Maximum wait, for any machine: it only ends failed tests.
const PATIENCE: Duration = Duration::from_mins(1);

/// A folder of one test, deleted after it.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let name = format!("typed-{}-{name}", std::process::id());
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        std::fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }

    /// Creates the folder among temporary files, where every user of the machine has access.
    pub(crate) fn shared(name: &str) -> Self {
        use std::os::unix::fs::PermissionsExt as _;
        let folder = std::env::temp_dir().join(format!("letoff-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let everybody = std::fs::Permissions::from_mode(0o755);
        std::fs::set_permissions(&folder, everybody).expect("a folder");
        Self(folder)
    }

    /// Writes a file, and returns its path.
    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        let path = self.join(name);
        std::fs::write(&path, text).expect("a file");
        path
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.join(name)).expect("a file")
    }

    /// Returns `program` with `arguments`, without access to other hosts, windows or homes.
    pub(crate) fn command(&self, program: &Path, arguments: &[&str]) -> Command {
        let mut command = Command::new(program);
        command.args(arguments).current_dir(&self.0).stdin(Stdio::null());
        command.env("LETOFF_SOCKET", self.socket()).env("PATH", &self.0).env("HOME", &self.0);
        command.env_remove("XDG_STATE_HOME").env_remove("LETOFF_TOKEN");
        // Rehearsals of other tests are not found.
        command.env_remove("XDG_CONFIG_HOME").env("XDG_CACHE_HOME", "/dev/null");
        command
    }

    /// Returns the socket of a host that is started here.
    pub(crate) fn socket(&self) -> PathBuf {
        self.join("socket")
    }

    /// Runs `letoff`; returns its exit code, output and errors.
    pub(crate) fn letoff(&self, arguments: &[&str]) -> (Option<i32>, String, String) {
        let mut command = self.command(Path::new(env!("CARGO_BIN_EXE_letoff")), arguments);
        let output = command.output().expect("a process");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    }

    /// Asserts that `letoff` ends with `code` and without output, in one sentence with `words`.
    #[track_caller]
    pub(crate) fn refuses(&self, arguments: &[&str], code: i32, words: &[&str]) {
        let (ended, out, err) = self.letoff(arguments);
        assert_eq!((ended, out.as_str()), (Some(code), ""), "{err}");
        assert_eq!(err.lines().count(), 1, "{err}");
        for word in words {
            assert!(err.contains(word), "no `{word}` in {err}");
        }
    }
}

impl Deref for Folder {
    type Target = Path;

    fn deref(&self) -> &Path {
        &self.0
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _left = std::fs::remove_dir_all(&self.0);
    }
}

/// Creates a cable at `path`: also open for writing, since a writer's death must not end it.
pub(crate) fn cable(path: &Path) -> File {
    mknodat(CWD, path, FileType::Fifo, Mode::RUSR | Mode::WUSR, 0).expect("a FIFO");
    File::options().read(true).write(true).open(path).expect("both ends")
}

/// Waits until `found` returns a result.
#[track_caller]
pub(crate) fn eventually<T>(what: &str, mut found: impl FnMut() -> Option<T>) -> T {
    let begun = Instant::now();
    loop {
        if let Some(found) = found() {
            return found;
        }
        assert!(begun.elapsed() < PATIENCE, "not even after {PATIENCE:?}: {what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}
