//! `letoff run [SCENE]`: the host.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use super::arguments::seconds;
use super::signals::Signals;
use super::streaming::{self, StreamArgs};
use super::target::Target;
use super::{Failure, live, print_json, system, tell};
use crate::config::{Override, Scene};
use crate::control::{Clients, Server, StreamSink, Studio, Switchboard, serve, socket_path};
use crate::observe::{BlackBoxSink, Recording};
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
    /// What shall be run.
    #[command(flatten)]
    pub target: Target,
    /// The scene again, for those who prefer it as an option.
    #[arg(long = "scene", value_name = "SCENE", conflicts_with = "scene")]
    pub scene_option: Option<String>,
    /// Length of the run [s]; without it, to the end of the performance.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub duration: Option<f64>,
    /// What the virtual pianist plays: an embedded piece's name or a MIDI file.
    #[arg(long, value_name = "FILE.mid")]
    pub performance: Option<String>,
    /// Where strikes go: a port's name, `virtual`, a file, or `none`.
    #[arg(long, value_name = "PORT|virtual|FILE.mid|none")]
    pub midi: Option<String>,
    /// Records everything into a file of MCAP, from before the first tick on.
    #[arg(long, value_name = "FILE.mcap")]
    pub record: Option<PathBuf>,
    /// Where the last seconds are written when a voice fails; the user's own folder for what
    /// programs leave behind if none is given.
    #[arg(long, value_name = "FOLDER|none")]
    pub black_box: Option<PathBuf>,
    /// To whom it tells what it does.
    #[command(flatten)]
    pub stream: StreamArgs,
    /// As fast as it goes, with the same bits every time.
    #[arg(long)]
    pub virtual_time: bool,
    /// Prints the report as JSON.
    #[arg(long)]
    pub json: bool,
}

impl RunArgs {
    fn scene(&self) -> &str {
        self.scene_option.as_deref().unwrap_or(&self.target.scene)
    }

    /// Everything that overrides the scene, the named options last.
    fn overrides(&self) -> Vec<Override> {
        let named = [
            ("--performance", "pianist.performance", &self.performance),
            ("--midi", "midi.output", &self.midi),
        ];
        let named = named.into_iter().filter_map(|(option, name, value)| {
            let value = value.clone()?;
            Some(Override { name: name.into(), typed: format!("{option} {value}"), value })
        });
        self.target.overrides().into_iter().chain(named).collect()
    }
}

/// Runs the host and prints its report.
pub(super) fn run(args: &RunArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let scene = Scene::load_as_typed(args.scene(), &args.overrides())
        .map_err(|diagnostics| Failure::Usage(diagnostics.to_string()))?;
    let options = Options { duration: args.duration, virtual_time: args.virtual_time };
    // A mistake is told before anything is rehearsed or recorded.
    let stream = args.stream.wanted(&scene.name, &state_folder()).map_err(Failure::Usage)?;
    let report = perform(&scene, options, args, stream.as_ref())?;
    if args.json {
        print_json(&report, out)?;
    } else {
        write!(out, "{report}")?;
    }
    if let Some(trouble) = report.recording.as_ref().and_then(|it| it.trouble.clone()) {
        return Err(Failure::Running(trouble));
    }
    match &report.midi.trouble {
        Some(trouble) if report.midi.failed > 0 => Err(Failure::Running(trouble.clone())),
        Some(_) | None => without_faults(&report),
    }
}

/// Whether the models did what they should.
///
/// A run that `letoff stop` ended has done what it was asked, whatever came before: an exit code
/// of failure would have a supervisor start it again, forces and all.
fn without_faults(report: &Report) -> Result<(), Failure> {
    if report.faults == 0 {
        return Ok(());
    }
    let text = format!(
        "voices failed in {} turns, and their keys had no force meanwhile: take a higher tick_hz or \
         parameters that are less stiff; `letoff dash` names keys and reasons while it runs",
        report.faults
    );
    if report.stopped {
        tell(&text);
        return Ok(());
    }
    Err(Failure::Running(text))
}

/// Rehearses, runs until the end or a signal, and reports.
fn perform(
    scene: &Scene,
    options: Options,
    args: &RunArgs,
    wanted: Option<&streaming::Wanted>,
) -> Result<Box<Report>, Failure> {
    let rehearsal = live::Rehearsal::new();
    let session = Session::prepare(scene, options, &|progress| rehearsal.show(progress))
        .map_err(|error| failure(&error))?;
    rehearsal.finish();
    let recording = args.record.as_deref().map(|file| record(&session, file)).transpose()?;
    if !options.virtual_time {
        keep_black_box(&session, args.black_box.as_deref());
    }
    let stop = Arc::new(AtomicBool::new(false));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    let runtime = runtime.map_err(system)?;
    runtime.block_on(async {
        let counters = session.counters();
        let line = live::Line::new(session.tick_hz(), session.ticks());
        let clients = listen(scene, options, &session, wanted)?;
        let its_stop = Arc::clone(&stop);
        let _stops = StopOnDrop(Arc::clone(&stop));
        let mut running = tokio::task::spawn_blocking(move || session.run(&its_stop).map(Box::new));
        let mut signals = Signals::new().map_err(system)?;
        let mut every = tokio::time::interval(live::REFRESH);
        loop {
            tokio::select! {
                done = &mut running => {
                    line.finish();
                    clients.leave().await;
                    let done = done.map_err(|panic| Failure::Running(panic.to_string()))?;
                    let mut report = done.map_err(|error| failure(&error))?;
                    report.recording = recording.map(|it| it.report());
                    return Ok(report);
                }
                () = signals.next() => stop.store(true, Ordering::Release),
                _ = every.tick() => line.show(&counters),
            }
        }
    })
}

/// Records all that the session will do into `file`.
fn record(session: &Session, file: &Path) -> Result<Recording, Failure> {
    let begun = Recording::begin(file).map_err(|error| Failure::Usage(error.to_string()))?;
    let (recording, sink) = begun;
    session.observe(sink);
    Ok(recording)
}

/// Keeps the last seconds for when a voice fails.
fn keep_black_box(session: &Session, folder: Option<&Path>) {
    let folder = match folder {
        Some(folder) if folder == Path::new("none") => return,
        Some(folder) => folder.to_owned(),
        None => state_folder(),
    };
    session.observe(Box::new(BlackBoxSink::new(folder, tell)));
}

/// The user's own folder for what programs leave behind, or one among temporary files.
fn state_folder() -> PathBuf {
    let home = || std::env::var_os("HOME").map(|home| PathBuf::from(home).join(".local/state"));
    let state = std::env::var_os("XDG_STATE_HOME").map(PathBuf::from).or_else(home);
    state.unwrap_or_else(std::env::temp_dir).join("letoff")
}

/// Listens for whoever asks; in virtual time there is nobody to talk to.
fn listen(
    scene: &Scene,
    options: Options,
    session: &Session,
    wanted: Option<&streaming::Wanted>,
) -> Result<Clients, Failure> {
    let clients = Clients::default();
    if options.virtual_time {
        return Ok(clients);
    }
    let switchboard = Arc::new(Switchboard::new(scene.clone(), session.patchbay()));
    if let Some(wanted) = wanted {
        stream(session, wanted, &switchboard)?;
    }
    let path = socket_path();
    match Server::listen(&path) {
        Ok(server) => {
            // Ends with the runtime, and takes the socket with it.
            tokio::spawn(serve(server, switchboard, clients.clone()));
        }
        // A second host, or a machine without a place for sockets, runs all the same.
        Err(error) => tell(&format!(
            "`letoff stop`, `dash` and `instruments use` do not reach this host: {}: {error}; give \
             it a place of its own with LETOFF_SOCKET",
            path.display()
        )),
    }
    Ok(clients)
}

/// Streams to dashboards and viewers, and hears what they ask.
fn stream(
    session: &Session,
    wanted: &streaming::Wanted,
    switchboard: &Arc<Switchboard>,
) -> Result<(), Failure> {
    let Some(server) = wanted.listen().map_err(Failure::Usage)? else { return Ok(()) };
    let mut address = server.url();
    if let Some(fingerprint) = server.fingerprint() {
        tell(&format!(
            "the stream's certificate is {fingerprint}: elsewhere, give it to `letoff dash \
             --fingerprint`"
        ));
        address = format!("{address}#{fingerprint}");
    }
    switchboard.streams_at(address, wanted.owner());
    session.observe(Box::new(StreamSink::new(server.publisher())));
    let studio = Arc::new(Studio(Arc::clone(switchboard)));
    // Ends with the runtime.
    tokio::spawn(telemetry::stream::serve(server, studio));
    Ok(())
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
        | SessionError::Links(_)
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
