//! Builds and runs the program.
//!
//! `cargo xtask test` builds the program of `cli` with the tests and passes its path. Otherwise it
//! is built here, once, by the Cargo that runs the tests, into the folder and profile of this test,
//! and is never an old one.
#![allow(dead_code, reason = "each test program uses its own part")]

use std::fmt::Debug;
use std::fs;
use std::io::Write as _;
use std::os::unix::fs::PermissionsExt as _;
use std::os::unix::process::CommandExt as _;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::OnceLock;

pub(crate) fn program() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(build)
}

fn build() -> PathBuf {
    if let Some(built) = std::env::var_os("LETOFF_PROGRAM") {
        return built.into();
    }
    // <target>/<profile's folder>/deps/<this test>
    let test = std::env::current_exe().expect("this test");
    let folder = test.ancestors().nth(2).expect("the profile's folder");
    let target = folder.parent().expect("the target folder");
    let name = folder.file_name().and_then(|name| name.to_str()).expect("the profile's name");
    let profile = if name == "debug" { "dev" } else { name };
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(cargo);
    // Cargo's variables for this test would make build scripts run again.
    for (name, _value) in std::env::vars_os() {
        let of_ours = ["CARGO_PKG_", "CARGO_MANIFEST_"];
        if name.to_str().is_some_and(|name| of_ours.iter().any(|it| name.starts_with(it))) {
            build.env_remove(name);
        }
    }
    let built = build
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["build", "--quiet", "--package", "cli", "--package", "lab", "--bins"])
        .args(["--profile", profile, "--target-dir"])
        .arg(target)
        .status();
    assert!(built.expect("cargo").success(), "the program cannot be built");
    folder.join("letoff")
}

/// Returns a folder for the files of one test; those of an earlier run may be in it.
pub(crate) fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("letoff").join(test);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    with_arguments(Command::new(program()), folder, arguments)
}

fn with_arguments(mut command: Command, folder: &Path, arguments: &[&str]) -> Command {
    command.current_dir(folder).args(arguments).stdin(Stdio::null());
    // A real host on this machine must not be disturbed, nor a rehearsal of another test be found.
    command.env("LETOFF_SOCKET", folder.join("socket")).env("XDG_CACHE_HOME", "/dev/null");
    command
}

#[derive(Debug)]
pub(crate) struct Said {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Said {
    fn new(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("text");
        let said =
            Self { code: output.status.code(), out: text(output.stdout), err: text(output.stderr) };
        assert!(!said.err.contains("panicked") && !said.out.contains("panicked"), "{said:?}");
        said
    }

    pub(crate) fn lines(&self) -> Vec<&str> {
        self.err.lines().collect()
    }

    #[track_caller]
    pub(crate) fn report(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).expect("a report as JSON")
    }
}

pub(crate) fn run(folder: &Path, arguments: &[&str]) -> Said {
    Said::new(command(folder, arguments).output().expect("the program runs"))
}

pub(crate) fn run_after(first: &str, folder: &Path, arguments: &[&str]) -> Said {
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("{first}\nexec \"$0\" \"$@\"")]).arg(program());
    Said::new(with_arguments(shell, folder, arguments).output().expect("a shell"))
}

/// Like [`run_after`], as the user nobody, in a folder that every user may enter; `None` unless
/// this user is root.
pub(crate) fn run_as_nobody(first: &str, arguments: &[&str]) -> Option<Said> {
    const NOBODY: u32 = 65_534;
    if !rustix::process::getuid().is_root() {
        let _unheard = writeln!(std::io::stderr(), "SKIPPED: only root can try it as another user");
        return None;
    }
    let folder = std::env::temp_dir().join(format!("letoff-nobody-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    fs::set_permissions(&folder, fs::Permissions::from_mode(0o755)).expect("a folder");
    fs::copy(program(), folder.join("letoff")).expect("a copy that others may run");
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("{first}\nexec ./letoff \"$@\""), "sh"]).uid(NOBODY).gid(NOBODY);
    let said = Said::new(with_arguments(shell, &folder, arguments).output().expect("a shell"));
    fs::remove_dir_all(&folder).expect("it is ours");
    Some(said)
}

pub(crate) fn run_into(out: impl Into<Stdio>, folder: &Path, arguments: &[&str]) -> Said {
    let mut command = command(folder, arguments);
    command.stdout(out).stderr(Stdio::piped());
    end(command.spawn().expect("the program starts"))
}

/// Runs `letoff` under strace, which writes the system calls of all its threads into `trace`.
pub(crate) fn run_traced(folder: &Path, trace: &Path, arguments: &[&str]) -> Said {
    let mut strace = Command::new("strace");
    strace.args(["-f", "-qq", "-o"]).arg(trace).arg(program());
    Said::new(with_arguments(strace, folder, arguments).output().expect("strace starts"))
}

pub(crate) fn start(folder: &Path, arguments: &[&str]) -> Child {
    let mut command = command(folder, arguments);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

pub(crate) fn start_logged(folder: &Path, log: &Path, arguments: &[&str]) -> Child {
    let log = fs::OpenOptions::new().create(true).append(true).open(log).expect("a log");
    let mut command = command(folder, arguments);
    command.stdout(Stdio::null()).stderr(log).spawn().expect("the program starts")
}

pub(crate) fn end(child: Child) -> Said {
    Said::new(child.wait_with_output().expect("the program ends"))
}

#[track_caller]
pub(crate) fn check(folder: &Path, arguments: &[&str], code: i32, words: &[&str]) -> Said {
    let said = run(folder, arguments);
    assert_eq!(said.code, Some(code), "{said:?}");
    assert_eq!(said.lines().len(), 1, "{said:?}");
    check_words(&said, words);
    said
}

#[track_caller]
pub(crate) fn check_words(said: &Said, words: &[&str]) {
    for word in words {
        assert!(said.err.contains(word), "no `{word}` in {said:?}");
    }
}
