//! Prints, runs and becomes other programs.

use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::mpsc::channel;
use std::time::Duration;
use std::{env, ffi::OsStr, thread};

use crate::error::Error;

/// Returns the cargo that started us, to run `arguments` at the workspace's root.
pub(crate) fn cargo<A: AsRef<OsStr>>(arguments: impl IntoIterator<Item = A>) -> Command {
    let program = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root());
    for (name, _value) in env::vars_os() {
        if is_of_our_build(&name) {
            command.env_remove(name);
        }
    }
    command
}

/// Returns `true` if cargo set this for us: build scripts that read it would run again.
fn is_of_our_build(name: &OsStr) -> bool {
    name.to_str()
        .is_some_and(|name| name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_"))
}

/// Returns the workspace's root, two folders above this crate.
pub(crate) fn root() -> &'static Path {
    let ours = Path::new(env!("CARGO_MANIFEST_DIR"));
    ours.ancestors().nth(2).unwrap_or(ours)
}

/// Returns the folder that cargo builds into, two levels above us: `target/debug/xtask`.
pub(crate) fn target() -> Result<PathBuf, Error> {
    let ours = env::current_exe().map_err(|cause| Error::file("this program", cause))?;
    let target = ours.ancestors().nth(2).map(PathBuf::from);
    target.ok_or_else(|| Error::unobtainable("cargo's target folder", "this program was moved"))
}

pub(crate) fn words(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let name = program.file_stem().unwrap_or(program.as_os_str());
    let all: Vec<_> =
        std::iter::once(name).chain(command.get_args()).map(OsStr::to_string_lossy).collect();
    all.join(" ")
}

pub(crate) fn run(command: &mut Command) -> Result<(), Error> {
    println!("$ {}", words(command));
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(Error::Failed { command: words(command) }),
        Err(cause) => Err(Error::NotStarted { command: words(command), cause }),
    }
}

/// Runs a command that may run tests; the error names those that failed.
pub(crate) fn run_tests(command: &mut Command) -> Result<(), Error> {
    let typed = words(command);
    println!("$ {typed}");
    let not_started = |cause| Error::NotStarted { command: typed.clone(), cause };
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(not_started)?;
    let (names, failed) = channel();
    let output = child.stdout.take().into_iter();
    // Not joined: a process that outlives its test may hold the pipe.
    thread::spawn(move || {
        for line in output.flat_map(|it| BufReader::new(it).lines()).map_while(Result::ok) {
            println!("{line}");
            let test = line.strip_prefix("test ").and_then(|it| it.strip_suffix(" ... FAILED"));
            let _is_awaited = test.map(|it| names.send(it.to_owned()));
        }
    });
    let status = child.wait();
    let next = || failed.recv_timeout(Duration::from_secs(1)).ok();
    let failed: String =
        std::iter::from_fn(next).flat_map(|it| ["\n  failed: ".to_owned(), it]).collect();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(Error::Failed { command: format!("{typed}{failed}") }),
        Err(cause) => Err(not_started(cause)),
    }
}

/// Returns the trimmed output of the command; its errors are printed.
pub(crate) fn answer(command: &mut Command) -> Result<String, Error> {
    let output = command.stderr(Stdio::inherit()).output();
    let output = output.map_err(|cause| Error::NotStarted { command: words(command), cause })?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    } else {
        Err(Error::Failed { command: words(command) })
    }
}

/// Replaces this process, so that signals and the exit code are the command's own.
#[cfg(unix)]
pub(crate) fn become_command(command: &mut Command) -> Result<(), Error> {
    use std::os::unix::process::CommandExt as _;
    println!("$ {}", words(command));
    let cause = command.exec();
    Err(Error::NotStarted { command: words(command), cause })
}

/// Runs the command to its end, where no process can be replaced.
#[cfg(not(unix))]
pub(crate) fn become_command(command: &mut Command) -> Result<(), Error> {
    run(command)
}
