//! Other programs: how they are shown, run, and become us.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::error::Error;

/// The cargo that started us with `arguments`, to be run at the workspace's root.
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

/// Whether cargo set this for us: build scripts of others look at it, and would run again.
fn is_of_our_build(name: &OsStr) -> bool {
    name.to_str()
        .is_some_and(|name| name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_"))
}

/// The workspace's root: two folders above this crate.
pub(crate) fn root() -> &'static Path {
    let ours = Path::new(env!("CARGO_MANIFEST_DIR"));
    ours.ancestors().nth(2).unwrap_or(ours)
}

/// The folder that cargo builds into, which is ours two levels up: `target/debug/xtask`.
///
/// # Errors
/// If this program lies elsewhere.
pub(crate) fn target() -> Result<PathBuf, Error> {
    let ours = env::current_exe().map_err(|cause| Error::file("this program", cause))?;
    let target = ours.ancestors().nth(2).map(PathBuf::from);
    target.ok_or_else(|| Error::unobtainable("cargo's target folder", "this program was moved"))
}

/// The command as it would be typed; a program's folder is left out.
pub(crate) fn words(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let name = program.file_stem().unwrap_or(program.as_os_str());
    let all: Vec<_> =
        std::iter::once(name).chain(command.get_args()).map(OsStr::to_string_lossy).collect();
    all.join(" ")
}

/// Shows the command, then runs it to its end.
///
/// # Errors
/// Names the command if it cannot be started or ends without success.
pub(crate) fn run(command: &mut Command) -> Result<(), Error> {
    println!("$ {}", words(command));
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(Error::Failed { command: words(command) }),
        Err(cause) => Err(Error::NotStarted { command: words(command), cause }),
    }
}

/// What the command prints, without the white space around it; what it complains of is shown.
///
/// # Errors
/// Names the command if it cannot be started or ends without success.
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
///
/// # Errors
/// Names the command if it cannot be started.
#[cfg(unix)]
pub(crate) fn become_command(command: &mut Command) -> Result<(), Error> {
    use std::os::unix::process::CommandExt as _;
    println!("$ {}", words(command));
    let cause = command.exec();
    Err(Error::NotStarted { command: words(command), cause })
}

/// Runs the command to its end: the next best where no process can be replaced.
#[cfg(not(unix))]
pub(crate) fn become_command(command: &mut Command) -> Result<(), Error> {
    run(command)
}
