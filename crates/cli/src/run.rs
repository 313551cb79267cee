//! `letoff run [SCENE]`: the host.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Args;

use super::arguments::seconds;
use super::attend::RunAttendant;
use super::endpoints::{self, Endpoints, Reach};
use super::log::{LogFormat, LogLines, StderrLog};
use super::piece::PieceArgs;
use super::recording::RecordingArgs;
use super::reload::{self, SceneFile};
use super::service::ServiceNotifier;
use super::signals::{Signals, runtime};
use super::stable::refuse_unstable;
use super::streaming::{self, StreamArgs};
use super::target::SceneTarget;
use super::{Failure, about, live, print_report, report_interpretation, system, tell};
use host::RehearsalCache;
use host::control::{BoardsTold, Clients, RunHandle, StartingHost, StatusSink, temporary_folder};
use host::guardian::guardian_path;
use host::observe::{BlackBoxSink, LogSink, RecordingHandle};
use host::report::{ChosenFidelity, RunReport};
use host::session::{FoundKeys, Healing, RunOptions, RunSession, SessionError, choose_fidelity};
use scene::{Library, LinksConfig, Override, Scene};
use scheduler::overload::Simplification;
use telemetry::log::Level;

/// What `letoff run` takes.
#[expect(clippy::struct_excessive_bools, reason = "flags of a command line")]
#[derive(Clone, Debug, Args)]
#[command(after_help = "Examples:
  letoff run                                  the default scene, until its piece is over
  letoff run song.mid                         the default scene plays a file of yours
  letoff run --duration 30 --json             half a minute, with a report for a program
  letoff run bach --virtual-time --midi bach-played.mid
  letoff run my-scene.toml --watch            plays descriptions anew when they are saved
  letoff run --set tick_hz=4000 --set keys.0.instrument=grand-reduced
  letoff run --link serial:/dev/ttyACM0 --link can:can0 --performance none
  letoff run --link 'rig:./my-boards --seed 1' --virtual-time --duration 10")]
pub struct RunArgs {
    /// What shall be run.
    #[command(flatten)]
    pub target: SceneTarget,
    /// The scene again, for those who prefer it as an option.
    #[arg(long = "scene", value_name = "SCENE", conflicts_with = "scene")]
    pub scene_option: Option<String>,
    /// Length of the run (s); without it, to the end of the last piece.
    #[arg(long, value_name = "SECONDS", value_parser = seconds, allow_negative_numbers = true)]
    pub duration: Option<f64>,
    #[command(flatten)]
    pub piece: PieceArgs,
    /// Where strikes go, and how they are heard.
    #[command(flatten)]
    pub output: OutputArgs,
    /// Records everything into a file of MCAP, from before the first tick on.
    #[arg(long, value_name = "FILE.mcap")]
    pub record: Option<PathBuf>,
    /// Where the last seconds are written when a voice fails; the user's own folder for what
    /// programs leave behind if none is given.
    #[arg(long, value_name = "FOLDER|none")]
    pub black_box: Option<PathBuf>,
    /// Reads descriptions of models again when they are saved: keys that play them go on with the
    /// new version, and with the one before if it is wrong.
    #[arg(long, conflicts_with = "virtual_time")]
    pub watch: bool,
    /// How much recordings take, this one and those of clients.
    #[command(flatten)]
    pub recordings: RecordingArgs,
    /// To whom it tells what it does.
    #[command(flatten)]
    pub stream: StreamArgs,
    /// Keeps the scene that was last accepted in FILE until the host ends without a failure. If
    /// FILE exists, the host plays that scene: it was started again after a crash.
    #[arg(long, value_name = "FILE", conflicts_with = "virtual_time")]
    pub last_scene: Option<PathBuf>,
    /// As fast as it goes, with the same bits every time; boards only behind rig: links.
    #[arg(long)]
    pub virtual_time: bool,
    /// Prints the report as JSON.
    #[arg(long)]
    pub json: bool,
    /// Writes the log as JSON, an object on each line.
    #[arg(long)]
    pub log_json: bool,
    /// Logs nothing on stderr: boards and clients that come and go, changes, stops.
    #[arg(long)]
    pub quiet: bool,
}

/// Outputs of the strikes.
#[derive(Clone, Debug, Args)]
pub struct OutputArgs {
    /// Where strikes go: a port's name, `virtual`, a device after `raw:`, a file, or `none`.
    #[arg(long, value_name = "PORT|virtual|raw:DEVICE|FILE.mid|none")]
    pub midi: Option<String>,
    /// Plays through the default sound device.
    #[arg(long)]
    pub sound: bool,
    /// Renders the run as sound into a file, when it is over.
    #[arg(long, value_name = "FILE.wav")]
    pub wav: Option<String>,
    /// Draws the notes of the run into a file, when it is over.
    #[arg(long, value_name = "FILE.svg")]
    pub picture: Option<String>,
    /// The sounds of --sound and --wav; an installed SoundFont without it.
    #[arg(long, value_name = "FILE.sf2")]
    pub font: Option<String>,
}

impl RunArgs {
    fn scene(&self) -> &str {
        self.scene_option.as_deref().unwrap_or(&self.target.scene)
    }

    /// Returns all overrides of the scene, the named options last.
    fn overrides(&self) -> Vec<Override> {
        let output = &self.output;
        let named = [
            ("--midi", "midi.output", &output.midi),
            ("--wav", "midi.wav", &output.wav),
            ("--picture", "midi.picture", &output.picture),
            ("--font", "midi.font", &output.font),
        ];
        let sound =
            Override { name: "midi.sound".into(), typed: "--sound".into(), value: "true".into() };
        let named = named.into_iter().filter_map(|(option, name, value)| {
            let value = value.clone()?;
            Some(Override { name: name.into(), typed: format!("{option} {value}"), value })
        });
        let sound = Some(sound).filter(|_| output.sound);
        let scene = self.target.overrides().into_iter().chain(self.piece.overrides());
        scene.chain(named).chain(sound).collect()
    }

    /// Returns these arguments with a MIDI file in place of the scene as piece of the default one.
    fn with_piece_of_scene(&self) -> Result<Self, Failure> {
        let Some(piece) = self.piece.instead_of(self.scene())? else { return Ok(self.clone()) };
        let scene_option = Some("default".to_owned());
        Ok(Self { scene_option, piece, ..self.clone() })
    }
}

/// Runs the host and prints its report. After an end without a failure the last scene is deleted:
/// the next start is no restart after a crash.
pub(super) fn run(args: &RunArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let args = &args.with_piece_of_scene()?;
    perform_and_report(args, out)?;
    // The file is missing if no scene was accepted.
    let _missing = args.last_scene.as_ref().map(fs::remove_file);
    Ok(())
}

fn perform_and_report(args: &RunArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.log_json {
        LogFormat::Json.choose();
    }
    let options = RunOptions { duration: args.duration, virtual_time: args.virtual_time };
    let Some(report) = perform(options, args)? else {
        tell("stopped before it began to play");
        return Ok(());
    };
    if args.json {
        print_report(&report, out)?;
    } else {
        write!(out, "{report}")?;
    }
    let troubles = report.board_troubles();
    if report.has_failed_board() {
        return Err(Failure::Running(troubles.join("\nletoff: ")));
    }
    for trouble in &troubles {
        tell(trouble);
    }
    if let Some(trouble) = report.recording.as_ref().and_then(|it| it.trouble.clone()) {
        return Err(Failure::Running(trouble));
    }
    match &report.midi.trouble {
        Some(trouble) if report.midi.failed > 0 => Err(Failure::Running(trouble.clone())),
        Some(_) | None => without_faults(&report),
    }
}

/// Fails if a model failed.
///
/// A run that `letoff stop` ended succeeds in any case: after a failure the service manager would
/// restart it with its forces.
fn without_faults(report: &RunReport) -> Result<(), Failure> {
    if report.totals.faults == 0 {
        return Ok(());
    }
    let text = format!(
        "voices failed in {} turns, and their keys had no force meanwhile: take a higher tick_hz or \
         parameters that are less stiff; `letoff dash` names keys and reasons while it runs",
        report.totals.faults
    );
    if report.extent.stopped {
        tell(&text);
        return Ok(());
    }
    Err(Failure::Running(text))
}

/// Rehearses, runs until the end or a signal, and reports; `None` if stopped before it began.
fn perform(options: RunOptions, args: &RunArgs) -> Result<Option<Box<RunReport>>, Failure> {
    let runtime = runtime()?;
    let ended = runtime.block_on(host(options, args));
    // Do not wait for rehearsals or loading: no board is armed any more.
    runtime.shutdown_background();
    ended
}

async fn host(options: RunOptions, args: &RunArgs) -> Result<Option<Box<RunReport>>, Failure> {
    let mut begun = BegunHost::begin(options, args)?;
    let (asked, file) = (args.clone(), begun.file.clone());
    let work = move || TriedRun::of(&asked, file.as_ref(), options).map(Box::new);
    let tried = begun.signals.unless_stopped(&begun.handle.emergency, work).await?;
    let Some(tried) = tried.transpose()? else {
        begun.handle.background.cancel_all();
        drop(begun.handle.take_log());
        begun.clients.leave().await;
        return Ok(None);
    };
    Box::pin(play(begun, *tried, options, args)).await
}

/// A host that receives signals and stops, before its trials.
struct BegunHost {
    signals: Signals,
    log: StderrLog,
    handle: Arc<RunHandle>,
    starting: Arc<StartingHost>,
    clients: Clients,
    reach: Reach,
    file: Option<SceneFile>,
}

impl BegunHost {
    fn begin(options: RunOptions, args: &RunArgs) -> Result<Self, Failure> {
        let file = SceneFile::of(args.scene(), args.overrides(), args.last_scene.clone());
        let file = file.filter(|_| !options.virtual_time);
        let signals = Signals::with(reload::meaning(file.as_ref())).map_err(system)?;
        let is_quiet = args.quiet || options.virtual_time;
        let log = if is_quiet { StderrLog::quiet() } else { StderrLog::start().map_err(system)? };
        let handle = Arc::new(run_handle(options, args.piece.rehearsals.as_deref()));
        handle.status.prepare(args.scene());
        let lines = log.lines();
        handle.log_early(LogSink::new(Box::new(move |level, text| lines.say(level, text))));
        let starting = Arc::new(StartingHost::new(Arc::clone(&handle)));
        let (clients, reach) = if options.virtual_time {
            (Clients::default(), Reach::default())
        } else {
            endpoints::listen(&starting)
        };
        Ok(Self { signals, log, handle, starting, clients, reach, file })
    }
}

async fn play(
    begun: BegunHost,
    tried: TriedRun,
    options: RunOptions,
    args: &RunArgs,
) -> Result<Option<Box<RunReport>>, Failure> {
    let BegunHost { mut signals, log, handle, starting, clients, reach, file } = begun;
    let TriedRun { found, fidelity, stream } = tried;
    let scene = &found.scene.clone();
    reach.check_for(&scene.links)?;
    let log = log_with_boards(log, scene, args)?;
    handle.status.prepare(&scene.name);
    let open = || Endpoints::open(scene, &starting, clients, stream.as_ref());
    let endpoints = if options.virtual_time { Endpoints::default() } else { open()? };
    endpoints.publisher().into_iter().for_each(|it| log.stream_to(it));
    let progress = if args.quiet { live::ProgressLines::Quiet } else { live::ProgressLines::Told };
    let mut notifier = ServiceNotifier::new(Arc::clone(&handle));
    let prepared =
        Box::pin(prepare(found, options, &handle, &mut signals, (progress, log.publisher())));
    let Some(session) = notifier.beside(prepared).await? else {
        handle.status.stop(BoardsTold::NONE_ARMED);
        drop(handle.take_log());
        endpoints.leave("the host was stopped before it began to play").await;
        return Ok(None);
    };
    let recording = record(&handle, args)?;
    handle.status.records(recording.clone());
    observe(&session, scene, args, &log);
    endpoints.observe(&session);
    let _watch = if args.watch { endpoints.watch()? } else { None };
    let may_lower = scene.overload.order.contains(&Some(Simplification::Fidelity));
    let _load = if may_lower && !options.virtual_time { endpoints.watch_load()? } else { None };
    let _programs = endpoints.hear_programs();
    let line = live::StatusLine::new(&session);
    log.draw_above(line.bar());
    let stop = Arc::new(AtomicBool::new(false));
    let (its_stop, was_ended) = (Arc::clone(&stop), Arc::clone(&stop));
    let _stops = StopOnDrop(Arc::clone(&stop));
    let mut attendant = RunAttendant {
        signals,
        notifier,
        handle: Arc::clone(&handle),
        endpoints: &endpoints,
        log: &log,
        counters: session.counters(),
        line,
        // In virtual time the run may end before a message is logged: the log would differ.
        news: if options.virtual_time { Vec::new() } else { endpoints.news(scene, &session) },
        stop,
        file,
        is_reload_due: false,
    };
    let running = tokio::task::spawn_blocking(move || session.run(&its_stop).map(Box::new));
    let done = attendant.until_over(running).await;
    drop(attendant);
    handle.background.cancel_all();
    let report = done.as_ref().ok().and_then(|done| done.as_deref().ok());
    let why = note_end(&handle, report.filter(|_| !was_ended.load(Ordering::Acquire)));
    endpoints.leave(why).await;
    let done = done.map_err(|panic| Failure::Panicked(panic.to_string()))?;
    let mut report = done.map_err(|error| failure(&error))?;
    report.recording = recording.map(|it| it.report());
    report.fidelity = fidelity;
    Ok(Some(report))
}

/// Records in the status how the run ended, with its `report` if it came to its end; returns that
/// end in words.
fn note_end(handle: &RunHandle, report: Option<&RunReport>) -> &'static str {
    if let Some(told) = handle.emergency.answered() {
        handle.status.stop(told);
        return STOPPED;
    }
    if let Some(report) = report {
        handle.status.finish(report.sentence());
    }
    "the run is over"
}

/// A tried run: keys that were found, and are stable if simulated.
struct TriedRun {
    found: FoundKeys,
    /// Chosen fidelity of keys that leave it to this machine.
    fidelity: Vec<ChosenFidelity>,
    stream: Option<streaming::WantedStream>,
}

impl TriedRun {
    /// Reads the scene of `args`, from `file` if it has one, and finds its keys. Chooses their
    /// fidelity for ticks in real time. Arms no board.
    fn of(args: &RunArgs, file: Option<&SceneFile>, options: RunOptions) -> Result<Self, Failure> {
        let (scene, text) = match file {
            Some(file) => file.begin().map(|(scene, text)| (scene, Some(text))),
            None => Scene::load_as_typed(&Library::default(), args.scene(), &args.overrides())
                .map(|scene| (scene, None))
                .map_err(|diagnostics| diagnostics.to_string()),
        }
        .map_err(Failure::Usage)?;
        let mut found = FoundKeys::find(&scene, options).map_err(|error| failure(&error))?;
        let scene = &mut *found.scene;
        let chosen = if args.virtual_time { Ok(Vec::new()) } else { choose_fidelity(scene) };
        let fidelity = chosen.map_err(|error| Failure::Usage(error.to_string()))?;
        report_interpretation();
        for chosen in &fidelity {
            tell(&chosen.to_string());
        }
        // A test of this project has tried the embedded scenes, to the same bits. Keys on boards are
        // tried with the delay of their links when the run is prepared.
        let is_embedded = scene::scenes().any(|name| name == args.scene());
        let is_known = is_embedded && args.target.overrides().is_empty() && fidelity.is_empty();
        if scene.links == LinksConfig::Simulated && !is_known {
            refuse_unstable(scene)?;
        }
        // Report mistakes before any rehearsal or recording.
        let mut stream = args.stream.wanted(&scene.name, state_folder()).map_err(Failure::Usage)?;
        if let Some(stream) = &mut stream {
            stream.folders.limits = args.recordings.limits();
        }
        if let Some((file, text)) = file.zip(text) {
            file.keep(&text);
        }
        Ok(Self { found, fidelity, stream })
    }
}

/// Returns the handle of a run; in real time a guardian holds its MIDI port. Rehearsals are kept in
/// the folder `wanted` unless that is `none`.
fn run_handle(options: RunOptions, wanted: Option<&Path>) -> RunHandle {
    let usual = || if options.virtual_time { None } else { Some(guardian_path()) };
    let handle = usual().map_or_else(RunHandle::default, RunHandle::guarded_at);
    let folder = match wanted {
        Some(folder) if folder == Path::new("none") => None,
        Some(folder) => Some(folder.to_owned()),
        None => streaming::own_cache_folder(),
    };
    // A program that was built again may have the same commit.
    let built = std::env::current_exe().and_then(fs::metadata).map(|it| it.modified().ok());
    let program = format!("{} {:?}", about::version(), built.ok());
    handle.keeping_rehearsals(folder.map(|folder| RehearsalCache { folder, program }))
}

const fn has_boards(scene: &Scene) -> bool {
    matches!(scene.links, LinksConfig::Boards(_))
}

/// Returns the log of a run: in virtual time only boards have news, so it writes only with boards.
fn log_with_boards(log: StderrLog, scene: &Scene, args: &RunArgs) -> Result<StderrLog, Failure> {
    let is_wanted = args.virtual_time && has_boards(scene) && !args.quiet;
    if is_wanted { StderrLog::start().map_err(system) } else { Ok(log) }
}

/// Logs the events of the run; in real time also notes its state, and keeps the last seconds.
fn observe(session: &RunSession, scene: &Scene, args: &RunArgs, log: &StderrLog) {
    let early = session.handle().take_log();
    if !args.virtual_time || has_boards(scene) {
        let lines = log.lines();
        let new = || LogSink::new(Box::new(move |level, text| lines.say(level, text)));
        let sink = early.filter(|_| !args.virtual_time).unwrap_or_else(new);
        session.observe(Box::new(if has_boards(scene) { sink.naming_boards() } else { sink }));
    }
    if args.virtual_time {
        return;
    }
    keep_black_box(session, args.black_box.as_deref());
    let status = Arc::clone(&session.handle().status);
    session.observe(Box::new(StatusSink::new(status)));
}

/// Reason for clients of a stopped host.
const STOPPED: &str = "the host was stopped: no board renders a force until it is started anew";

/// Prepares the run, and prints notices about its keys; `None` if a stop or a signal comes first.
async fn prepare(
    found: FoundKeys,
    options: RunOptions,
    handle: &Arc<RunHandle>,
    signals: &mut Signals,
    (progress, log): (live::ProgressLines, LogLines),
) -> Result<Option<RunSession>, Failure> {
    let rehearsal = live::RehearsalProgress::new(progress, log.clone());
    let (its_handle, shown) = (Arc::clone(handle), rehearsal.clone());
    let mut notices = found.notices();
    let prepare = move || {
        RunSession::prepare_behind(its_handle, found, options, &|progress| shown.show(progress))
    };
    let prepared = signals.unless_stopped(&handle.emergency, prepare).await;
    rehearsal.finish();
    let prepared = prepared?.transpose().map_err(|error| failure(&error))?;
    if prepared.is_none() {
        handle.background.cancel_all();
    }
    if prepared.as_ref().is_some_and(RunSession::is_rehearsal_kept) {
        notices.push("rehearsal found: these notes were rehearsed by an earlier run".into());
    }
    for notice in prepared.iter().flat_map(|_| &notices) {
        log.say(Level::Info, notice.clone());
        tell(notice);
    }
    Ok(prepared)
}

fn record(handle: &RunHandle, args: &RunArgs) -> Result<Option<RecordingHandle>, Failure> {
    let limits = args.recordings.limits();
    let recording = args.record.as_deref().map(|file| handle.record_run(file, limits));
    recording.transpose().map_err(Failure::Usage)
}

/// Keeps the last seconds for a voice's failure, in the folder `wanted` unless that is `none`.
fn keep_black_box(session: &RunSession, wanted: Option<&Path>) {
    let folder = match wanted {
        Some(folder) if folder == Path::new("none") => None,
        Some(folder) => Some(folder.to_owned()),
        None => state_folder(),
    };
    if let Some(folder) = folder {
        session.observe(Box::new(BlackBoxSink::new(folder, tell)));
    }
}

/// Returns a folder for state files, also a temporary one; `None` if another user made that one.
fn state_folder() -> Option<PathBuf> {
    streaming::own_state_folder().or_else(|| temporary_folder().ok())
}

/// Ends the run when this thread unwinds: notes off, forces down.
struct StopOnDrop(Arc<AtomicBool>);

impl Drop for StopOnDrop {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Release);
    }
}

fn failure(error: &SessionError) -> Failure {
    match (error, error.healing()) {
        (SessionError::Panicked(_), _) => Failure::Panicked(error.to_string()),
        (_, Healing::Soon | Healing::Later) => Failure::Running(error.to_string()),
        (_, Healing::Never) => Failure::Usage(error.to_string()),
    }
}
