//! `letoff run [SCENE]`: the host.

use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use super::signals::Signals;
use super::{Failure, live, print_json, tell};
use hardware::link::address::Address;

use crate::config::{Scene, link_overrides};
use crate::control::{Clients, Server, Switchboard, serve, socket_path};
use crate::report::Report;
use crate::session::{Options, Session, SessionError};

/// What `letoff run` takes.
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff run                                  the default scene, until its piece is over
  letoff run --duration 30 --json             half a minute, with a report for a program
  letoff run bach --virtual-time --midi bach-played.mid
  letoff run --set tick_hz=4000 --set keys.0.instrument=grand-rigid
  letoff run --link serial:/dev/ttyACM0 --link can:can0 --performance none")]
pub struct RunArgs {
    /// A scene's name or file.
    #[arg(default_value = "default")]
    pub scene: String,
    /// The scene again, for those who prefer it as an option.
    #[arg(long = "scene", value_name = "SCENE", conflicts_with = "scene")]
    pub scene_option: Option<String>,
    /// Length of the run [s]; without it, to the end of the performance.
    #[arg(long, value_name = "SECONDS", value_parser = positive, allow_negative_numbers = true)]
    pub duration: Option<f64>,
    /// What the virtual pianist plays: an embedded piece's name or a MIDI file.
    #[arg(long, value_name = "FILE.mid")]
    pub performance: Option<String>,
    /// Where strikes go: a port's name, `virtual`, a file, or `none`.
    #[arg(long, value_name = "PORT|virtual|FILE.mid|none")]
    pub midi: Option<String>,
    /// Boards instead of those of the scene: serial:PORT[@BAUD], can:INTERFACE or
    /// classic-can:INTERFACE; once for each link.
    #[arg(long = "link", value_name = "LINK", value_parser = Address::parse)]
    pub links: Vec<Address>,
    /// As fast as it goes, with the same bits every time.
    #[arg(long)]
    pub virtual_time: bool,
    /// Any value of the scene, as `tick_hz=4000` or `midi.curve=linear`.
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = assignment)]
    pub set: Vec<(String, String)>,
    /// Prints the report as JSON.
    #[arg(long)]
    pub json: bool,
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    let seconds: f64 = text.parse().map_err(|_not_a_number| format!("`{text}` is not a number"))?;
    if seconds > 0.0 && seconds.is_finite() {
        Ok(seconds)
    } else {
        Err(format!("`{text}` s is no length: give a number above 0"))
    }
}

fn assignment(text: &str) -> Result<(String, String), String> {
    let (name, value) =
        text.split_once('=').ok_or_else(|| format!("`{text}` has no `=`: write name=value"))?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

impl RunArgs {
    fn scene(&self) -> &str {
        self.scene_option.as_deref().unwrap_or(&self.scene)
    }

    /// Everything that overrides the scene, the named options last.
    fn overrides(&self) -> Vec<(String, String)> {
        let named = [("pianist.performance", &self.performance), ("midi.output", &self.midi)];
        let named = named
            .into_iter()
            .filter_map(|(name, value)| Some((name.to_owned(), value.as_ref()?.clone())));
        link_overrides(&self.links)
            .into_iter()
            .chain(self.set.iter().cloned())
            .chain(named)
            .collect()
    }
}

/// Runs the host and prints its report.
pub(super) fn run(args: &RunArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let scene = Scene::load(args.scene(), &args.overrides())
        .map_err(|diagnostics| Failure::Usage(diagnostics.to_string()))?;
    let options = Options { duration: args.duration, virtual_time: args.virtual_time };
    let report = perform(&scene, options)?;
    if args.json {
        print_json(&report, out)?;
    } else {
        write!(out, "{report}")?;
    }
    match &report.midi.trouble {
        Some(trouble) if report.midi.failed > 0 => Err(Failure::Running(trouble.clone())),
        Some(_) | None => Ok(()),
    }
}

/// Rehearses, runs until the end or a signal, and reports.
fn perform(scene: &Scene, options: Options) -> Result<Box<Report>, Failure> {
    let rehearsal = live::Rehearsal::new();
    let session = Session::prepare(scene, options, &|progress| rehearsal.show(progress))
        .map_err(|error| failure(&error))?;
    rehearsal.finish();
    let stop = Arc::new(AtomicBool::new(false));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    runtime.block_on(async {
        let counters = session.counters();
        let line = live::Line::new(session.tick_hz(), session.ticks());
        let clients = listen(scene, options, &session);
        let its_stop = Arc::clone(&stop);
        let _stops = StopOnDrop(Arc::clone(&stop));
        let mut running = tokio::task::spawn_blocking(move || session.run(&its_stop).map(Box::new));
        let mut signals = Signals::new()?;
        let mut every = tokio::time::interval(live::REFRESH);
        loop {
            tokio::select! {
                done = &mut running => {
                    line.finish();
                    clients.leave().await;
                    return done.map_err(|panic| Failure::Running(panic.to_string()))?.map_err(|error| failure(&error));
                }
                () = signals.next() => stop.store(true, Ordering::Release),
                _ = every.tick() => line.show(&counters),
            }
        }
    })
}

/// Listens for `letoff instruments use`; in virtual time there is nobody to talk to.
fn listen(scene: &Scene, options: Options, session: &Session) -> Clients {
    let clients = Clients::default();
    if options.virtual_time {
        return clients;
    }
    let path = socket_path();
    match Server::listen(&path) {
        Ok(server) => {
            let switchboard = Switchboard::new(scene.clone(), session.patchbay());
            // Ends with the runtime, and takes the socket with it.
            tokio::spawn(serve(server, Arc::new(switchboard), clients.clone()));
        }
        // A second host, or a machine without a place for sockets, runs all the same.
        Err(error) => tell(&format!(
            "`letoff stop` and `letoff instruments use` do not reach this host: {}: {error}; give \
             it a place of its own with LETOFF_SOCKET",
            path.display()
        )),
    }
    clients
}

/// Ends the run when this thread unwinds: notes off, forces down.
struct StopOnDrop(Arc<AtomicBool>);

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
    }
}

fn failure(error: &SessionError) -> Failure {
    match error {
        // A board that has no power yet is no mistake of the scene's: who starts hosts tries again.
        SessionError::System(_)
        | SessionError::Panicked(_)
        | SessionError::Link(_)
        | SessionError::Boards(_) => Failure::Running(error.to_string()),
        SessionError::Assemble(_)
        | SessionError::BoardRate { .. }
        | SessionError::Overload(_)
        | SessionError::RealBoards
        | SessionError::NoFingers
        | SessionError::Performance { .. }
        | SessionError::NoFolder { .. }
        | SessionError::Midi(_)
        | SessionError::Endless => Failure::Usage(error.to_string()),
    }
}
