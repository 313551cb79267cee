//! `letoff dash`: the window, which is a program of its own beside this one.

use std::io::{self, IsTerminal as _, Write};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use clap::Args;

use super::{Failure, tell};
use crate::control::{ControlError, Reply, Request, send, socket_path};

/// What `letoff dash` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff dash                        the host that runs here; offers to start one if none does
  letoff dash --start                starts one on the simulated keybed, and ends it with the window
  letoff dash take1.mcap             a recording
  letoff dash wss://piano.local:8765 --fingerprint AB:CD:…   a host elsewhere, LETOFF_TOKEN has its token")]
pub struct DashArgs {
    /// A host's address, or a recording; the host that runs here without.
    #[arg(value_name = "ADDRESS|RECORDING")]
    pub target: Option<String>,
    /// Starts a host on the simulated keybed if none runs here, without asking.
    #[arg(long, conflicts_with = "target")]
    pub start: bool,
    /// What the certificate of a host elsewhere must be, as it printed it.
    #[arg(long, requires = "target")]
    pub fingerprint: Option<String>,
}

/// The window's program.
const PROGRAM: &str = "letoff-dashboard";

/// How long a host may take until it runs: it may have a piece to rehearse.
const PATIENCE: Duration = Duration::from_mins(1);

/// Opens the window and waits until it is closed.
pub(super) fn run(args: &DashArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let mut window = Command::new(program()?);
    if let Some(target) = &args.target {
        window.arg(target);
        if let Some(fingerprint) = &args.fingerprint {
            window.args(["--fingerprint", fingerprint]);
        }
        return show(window);
    }
    let (host, (address, token)) = match whereabouts() {
        Ok(place) => (None, place),
        Err(Absent::Nobody(why)) => {
            if !args.start && !wants_one(&why, out)? {
                return Err(Failure::Running(why));
            }
            let host = Started(start()?);
            let place = wait()?;
            (Some(host), place)
        }
        Err(Absent::Refused(why)) => return Err(Failure::Running(why)),
    };
    window.arg(address);
    if let Some(token) = token {
        // Not as an argument, which everybody on the machine can read.
        window.env("LETOFF_TOKEN", token);
    }
    let shown = show(window);
    // Ends with the window.
    drop(host);
    shown
}

/// Why there is no stream.
enum Absent {
    /// No host runs here.
    Nobody(String),
    /// One runs, and streams nothing.
    Refused(String),
}

/// Where the host that runs here streams, and what it must be told.
fn whereabouts() -> Result<(String, Option<String>), Absent> {
    match send(&socket_path(), &Request::Where {}) {
        Ok(Ok(Reply::Where { address, token })) => Ok((address, token)),
        Ok(Ok(Reply::Done { .. } | Reply::Scene { .. })) => {
            Err(Absent::Refused("the host that runs here said something else".into()))
        }
        Ok(Err(why)) => Err(Absent::Refused(why)),
        Err(nobody @ ControlError::NoHost { .. }) => Err(Absent::Nobody(nobody.to_string())),
        Err(other) => Err(Absent::Refused(other.to_string())),
    }
}

/// Asks whoever sits there.
fn wants_one(why: &str, out: &mut dyn Write) -> Result<bool, Failure> {
    if !io::stdin().is_terminal() {
        return Ok(false);
    }
    write!(out, "{why}\nStart one on the simulated keybed, until the window is closed? [Y/n] ")?;
    out.flush()?;
    let mut line = String::new();
    io::stdin().read_line(&mut line)?;
    Ok(matches!(line.trim(), "" | "y" | "Y" | "yes"))
}

/// A host that ends when it is dropped.
struct Started(Child);

impl Drop for Started {
    fn drop(&mut self) {
        let id = i32::try_from(self.0.id()).ok().and_then(rustix::process::Pid::from_raw);
        if let Some(id) = id {
            // As Ctrl-C would: forces fade, notes end. One that is gone is as good.
            let _gone = rustix::process::kill_process(id, rustix::process::Signal::INT);
        }
        let _ended = self.0.wait();
    }
}

/// Starts a host on the simulated keybed, which nobody plays but the window.
fn start() -> Result<Child, Failure> {
    let own = std::env::current_exe().map_err(|error| Failure::Running(error.to_string()))?;
    let mut host = Command::new(own);
    host.args(["run", "--performance", "none"]).stdin(Stdio::null()).stdout(Stdio::null());
    tell("starting a host on the simulated keybed");
    host.spawn().map_err(|error| Failure::Running(format!("the host cannot be started: {error}")))
}

/// Waits until the host that was started answers.
fn wait() -> Result<(String, Option<String>), Failure> {
    let deadline = Instant::now() + PATIENCE;
    loop {
        match whereabouts() {
            Ok(place) => return Ok(place),
            Err(Absent::Refused(why)) => return Err(Failure::Running(why)),
            Err(Absent::Nobody(why)) if deadline < Instant::now() => {
                return Err(Failure::Running(why));
            }
            Err(Absent::Nobody(_)) => std::thread::sleep(Duration::from_millis(100)),
        }
    }
}

/// The window's program: beside this one, or where programs are looked for.
fn program() -> Result<PathBuf, Failure> {
    let beside = std::env::current_exe().ok().map(|own| own.with_file_name(PROGRAM));
    let path = std::env::var_os("PATH").unwrap_or_default();
    let others = std::env::split_paths(&path).map(|folder| folder.join(PROGRAM));
    let found = beside.into_iter().chain(others).find(|file| file.is_file());
    found.ok_or_else(|| {
        Failure::Running(format!(
            "the window is a program of its own, {PROGRAM}, and is not installed: `cargo build \
             --release --package dashboard` makes it"
        ))
    })
}

/// Shows the window until it is closed.
fn show(mut window: Command) -> Result<(), Failure> {
    let status = window.status();
    match status {
        Ok(status) if status.success() => Ok(()),
        // It has said why.
        Ok(status) => Err(Failure::Running(format!("the window ended: {status}"))),
        Err(error) => Err(Failure::Running(format!("the window cannot be opened: {error}"))),
    }
}
