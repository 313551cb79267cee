//! `letoff dash`: starts the window, a separate program beside this one.

use std::io::{self, IsTerminal as _, Write};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use clap::Args;

use super::child_program::{ChildProgram, EndMode, program_beside};
use super::signals::{Signals, runtime};
use super::{Failure, system, tell};
use host::control::{ControlError, Reply, Request, STARTING, send, socket_path};

/// What `letoff dash` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff dash                        the host that runs here; offers to start one if none does
  letoff dash --start                starts one on the simulated keybed, and ends it with the window
  letoff dash take1.mcap             a recording
  letoff dash --print                the address for Foxglove and other viewers, with its secret
  letoff dash wss://piano.local:8765 --fingerprint AB:CD:…   a host elsewhere, LETOFF_TOKEN has its token")]
pub struct DashArgs {
    /// A host's address, or a recording; the host that runs here without.
    #[arg(value_name = "ADDRESS|RECORDING")]
    pub target: Option<String>,
    /// Starts a host on the simulated keybed if none runs here, without asking.
    #[arg(long, conflicts_with = "target")]
    pub start: bool,
    /// Prints where the host that runs here streams, with the secret that lets another viewer in,
    /// and opens no window. The secret gives the rights of the host's owner.
    #[arg(long, conflicts_with_all = ["target", "start"])]
    pub print: bool,
    /// What the certificate of a host elsewhere must be, as it printed it.
    #[arg(long, requires = "target")]
    pub fingerprint: Option<String>,
}

const PROGRAM: &str = "letoff-dashboard";

/// Maximum wait for a host, which may have a piece to rehearse.
const PATIENCE: Duration = Duration::from_mins(1);

/// Interval between checks for the host.
const LOOK: Duration = Duration::from_millis(100);

#[derive(Clone, PartialEq, Eq, Debug)]
struct DashTarget {
    target: String,
    token: Option<String>,
    fingerprint: Option<String>,
    /// Control socket of the host of this machine, which the window asks for the rest.
    socket: Option<PathBuf>,
}

/// Opens the window and waits until it is closed, or until a signal ends both.
pub(super) fn run(args: &DashArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.print {
        return print(out);
    }
    let program = program_beside(PROGRAM, "dashboard")?;
    let place = wanted(args, out)?;
    runtime()?.block_on(async {
        // Catch signals before anything is started, so that nothing is left behind.
        let mut signals = Signals::new().map_err(system)?;
        let (host, place) = match place {
            Some(place) => (None, place),
            None => match start(&mut signals).await? {
                Some((host, place)) => (Some(host), place),
                None => return Ok(()),
            },
        };
        let shown = show(place.window(program), &mut signals).await;
        // The host ends with the window.
        drop(host);
        shown
    })
}

fn print(out: &mut dyn Write) -> Result<(), Failure> {
    let place = whereabouts();
    let DashTarget { target, token, fingerprint, .. } = place.map_err(|absent| match absent {
        Absent::Nobody(why) | Absent::Starting(why) | Absent::Refused(why) => Failure::Running(why),
    })?;
    let token = token.map_or_else(String::new, |token| format!("/?token={token}"));
    writeln!(out, "{target}{token}")?;
    if let Some(fingerprint) = fingerprint {
        writeln!(out, "its certificate is {fingerprint}")?;
    }
    Ok(())
}

/// Returns the target of the window; `None` if a host must be started for it.
fn wanted(args: &DashArgs, out: &mut dyn Write) -> Result<Option<DashTarget>, Failure> {
    if let Some(target) = &args.target {
        let (target, fingerprint) = (target.clone(), args.fingerprint.clone());
        return Ok(Some(DashTarget { target, token: None, fingerprint, socket: None }));
    }
    match whereabouts() {
        Ok(place) => Ok(Some(place)),
        Err(Absent::Nobody(why)) if !args.start && !wants_one(&why, out)? => {
            Err(Failure::Running(why))
        }
        Err(Absent::Nobody(_)) => Ok(None),
        Err(Absent::Starting(why) | Absent::Refused(why)) => Err(Failure::Running(why)),
    }
}

impl DashTarget {
    /// Returns the stream of the host of this machine from its address, with the fingerprint, if
    /// any, after `#`.
    fn said(address: &str, token: Option<String>) -> Self {
        let (target, fingerprint) = match address.split_once('#') {
            Some((target, fingerprint)) => (target, Some(fingerprint.to_owned())),
            None => (address, None),
        };
        let socket = Some(socket_path());
        Self { target: target.to_owned(), token, fingerprint, socket }
    }

    fn window(self, program: PathBuf) -> Command {
        let mut window = Command::new(program);
        if let Some(socket) = self.socket {
            // The window learns address and secret there, also of a host that was started again.
            window.arg("--socket").arg(socket);
            return window;
        }
        window.arg(self.target);
        if let Some(fingerprint) = self.fingerprint {
            window.args(["--fingerprint", &fingerprint]);
        }
        window
    }
}

enum Absent {
    Nobody(String),
    /// A host runs, and still tries its keys.
    Starting(String),
    /// A host runs without a stream.
    Refused(String),
}

fn whereabouts() -> Result<DashTarget, Absent> {
    match send(&socket_path(), &Request::Where {}) {
        Ok(Ok(Reply::Where { address, token })) => Ok(DashTarget::said(&address, token)),
        Ok(Ok(
            Reply::Done { .. }
            | Reply::Stopped { .. }
            | Reply::Scene { .. }
            | Reply::Figures { .. }
            | Reply::Status { .. },
        )) => Err(Absent::Refused("the host that runs here said something else".into())),
        Ok(Err(why)) if why == STARTING => Err(Absent::Starting(why)),
        Ok(Err(why)) => Err(Absent::Refused(why)),
        Err(nobody @ ControlError::NoHost { .. }) => Err(Absent::Nobody(nobody.to_string())),
        Err(other) => Err(Absent::Refused(other.to_string())),
    }
}

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

/// Starts a host on the simulated keybed, and waits for its stream; `None` after a signal.
async fn start(signals: &mut Signals) -> Result<Option<(ChildProgram, DashTarget)>, Failure> {
    let failed = |error| Failure::Running(format!("the host cannot be started: {error}"));
    let own = std::env::current_exe().map_err(failed)?;
    let mut host = Command::new(own);
    host.args(["run", "--performance", "none"]).stdin(Stdio::null()).stdout(Stdio::null());
    tell("starting a host on the simulated keybed");
    let mut host = ChildProgram::start(&mut host, EndMode::Patient).map_err(failed)?;
    let deadline = Instant::now() + PATIENCE;
    let mut looks = tokio::time::interval(LOOK);
    loop {
        if signals.come_before(&mut looks).await {
            return Ok(None);
        }
        if let Some(place) = look(deadline)? {
            return Ok(Some((host, place)));
        }
        if let Some(status) = host.ended().map_err(failed)? {
            return Err(Failure::Running(format!("the host that was started ended: {status}")));
        }
    }
}

/// Returns the stream of the started host, once it answers.
fn look(deadline: Instant) -> Result<Option<DashTarget>, Failure> {
    match whereabouts() {
        Ok(place) => Ok(Some(place)),
        Err(Absent::Nobody(_) | Absent::Starting(_)) if Instant::now() < deadline => Ok(None),
        Err(Absent::Nobody(why) | Absent::Starting(why) | Absent::Refused(why)) => {
            Err(Failure::Running(why))
        }
    }
}

/// Shows the window until it is closed, or a signal closes it.
async fn show(mut window: Command, signals: &mut Signals) -> Result<(), Failure> {
    let failed = |error| Failure::Running(format!("the window cannot be opened: {error}"));
    let mut window = ChildProgram::start(&mut window, EndMode::Brief).map_err(failed)?;
    match window.end(signals).await.map_err(system)? {
        Some(status) if !status.success() => {
            Err(Failure::Running(format!("the window ended: {status}")))
        }
        Some(_) | None => Ok(()),
    }
}
