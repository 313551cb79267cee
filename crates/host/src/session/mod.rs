//! One run of the host: prepared from a scene, run in real or virtual time, reported.

mod fidelity;
mod found_keys;
mod key_source;
mod key_transport;
mod measured;
mod midi_out;
mod monitored_output;
mod observed;
mod play_list;
mod real;
mod sound_out;
mod threads;
mod trial;
mod unit_costs;
mod virtual_run;

use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use boards::sim::keybed::SimulatedKeybed;
use firmware_protocol::key::KeyIndex;
use midi::{NoteEvent, VelocityCurve};
use pianist::{Assessor, ExpectedNote, Performance, ShortStroke};
use scheduler::overload::OverloadRules;
use scheduler::tick::Scheduler;
use scheduler::time::{Nanos, Timetable};
use telemetry::key_name;

use crate::adapters::observer::{LiveCounters, TickPublisher};
use engine::voice::{BuildError, VoiceBuilder};

use crate::control::{RunHandle, passes};
use crate::midi_thread::{AnyOutput, MidiDispatcher, PlaybackSummary};
use crate::observe::{MessageSink, TelemetryMessage};
use crate::report::{
    Deadline, Evaluations, LostTicks, NoteCut, NoteReport, OverloadReport, Realtime,
};
use crate::report::{RunExtent, RunReport, StepCounts, VoiceTotals};
use engine::realtime::clock;
use engine::realtime::pool::{BoxedVoice, ThreadedLanes, VoiceSwaps};
use engine::realtime::run::Pause;
use engine::realtime::thread::ThreadPlan;
use engine::realtime::wake_fd::WakeFd;
use figures::rehearsal::RehearsalError;
use key_source::KeySource;
use key_transport::KeyTransport;
use measured::MeasuredRun;
use midi_out::OpenedOutput;
pub(crate) use midi_out::nowhere;
pub(crate) use monitored_output::MonitoredOutput;
use observed::ObservedOutputs;
pub(crate) use observed::Watchers;
use scene::Scene;

pub use fidelity::choose_fidelity;
pub use found_keys::FoundKeys;
pub use play_list::PianistProgress;
use play_list::RehearsedPlayList;
pub use trial::RunTrial;
use unit_costs::UnitCosts;

/// Reason why a run could not be prepared or finished.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    #[error(transparent)]
    Build(#[from] BuildError),
    #[error(transparent)]
    Rehearsal(#[from] RehearsalError),
    #[error("the simulated keybed cannot run the scene: {0}")]
    Keybed(#[from] boards::Error),
    #[error("the performance `{name}` cannot be played: {reason}")]
    Performance {
        name: String,
        /// Mistake and remedy.
        reason: String,
    },
    #[error("{path} cannot be written: there is no folder {folder}; make it first")]
    NoFolder { path: String, folder: String },
    #[error("the MIDI output cannot be opened: {0}")]
    Midi(String),
    #[error(transparent)]
    Sound(#[from] midi::sound::SoundError),
    #[error("the MIDI output cannot be opened: {0}")]
    MidiPort(String),
    #[error("{0}")]
    Links(String),
    #[error(transparent)]
    Boards(#[from] boards::refusal::Refusals),
    #[error(
        "boards exchange in whole steps of 100 us, which {tick_hz} Hz is not; \
         give tick_hz = 1000, 500, 2000 or another that divides 10000"
    )]
    BoardRate {
        /// Tick rate of the scene (Hz).
        tick_hz: u32,
    },
    #[error("{0}")]
    Overload(String),
    /// Keys are not stable with the measured delay of their links; a sentence on each range.
    #[error("with the delay of these links, {0}")]
    Unstable(String),
    #[error(
        "boards go by their own time; leave --virtual-time out, or the links; only programs behind \
         rig: links go by virtual time"
    )]
    RealBoards,
    #[error("the program behind rig:{program} lives in virtual time only; give --virtual-time")]
    VirtualBoards { program: String },
    #[error(
        "the boards have no simulated fingers, so the pianist cannot play; \
         give --performance none, and play yourself"
    )]
    NoFingers,
    #[error("the system refused what a run needs: {0}")]
    System(#[from] std::io::Error),
    #[error("virtual time needs an end: give --duration, or a performance that does not repeat")]
    Endless,
    /// A thread of the host panicked, which is a bug.
    #[error("the {0} thread panicked: its notes were ended; please report what it printed")]
    Panicked(&'static str),
}

/// Chance that waiting removes the reason why a run does not begin.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Healing {
    /// Within seconds: it was measured, or a device is not connected yet.
    Soon,
    /// After a change outside of the scene.
    Later,
    /// Never: it is in files or on the command line.
    Never,
}

impl SessionError {
    pub fn healing(&self) -> Healing {
        match self {
            Self::Boards(refusals) if refusals.may_pass_soon() => Healing::Soon,
            Self::Boards(refusals) if refusals.may_pass() => Healing::Later,
            Self::Links(_) | Self::Unstable(_) | Self::MidiPort(_) => Healing::Soon,
            Self::System(_) | Self::Panicked(_) => Healing::Later,
            Self::Boards(_)
            | Self::Build(_)
            | Self::Rehearsal(_)
            | Self::Keybed(_)
            | Self::BoardRate { .. }
            | Self::Overload(_)
            | Self::RealBoards
            | Self::VirtualBoards { .. }
            | Self::NoFingers
            | Self::Performance { .. }
            | Self::NoFolder { .. }
            | Self::Midi(_)
            | Self::Sound(_)
            | Self::Endless => Healing::Never,
        }
    }
}

const PATIENCE: Duration = Duration::from_secs(5);

const PAUSE: Duration = Duration::from_millis(250);

/// Repeats `attempt` for [`PATIENCE`] while time may heal its failure.
fn patiently<T>(mut attempt: impl FnMut() -> Result<T, SessionError>) -> Result<T, SessionError> {
    let begun = Instant::now();
    loop {
        match attempt() {
            Err(error) if error.healing() == Healing::Soon && begun.elapsed() < PATIENCE => {
                std::thread::sleep(PAUSE);
            }
            outcome => return outcome,
        }
    }
}

/// Options of the command line beyond the scene.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunOptions {
    /// Length of the run (s); `None` for the end of the performance.
    pub duration: Option<f64>,
    /// `true` to run as fast as possible, with the same bits every time.
    pub virtual_time: bool,
}

/// Time from set-up to the first tick, in which threads start and gestures reach their boards.
const LEAD: Nanos = Nanos::from_millis(50);

/// Time after a performance's last event before a run ends by itself (s).
const AFTERGLOW: f64 = 1.0;

/// Key events that may wait for the MIDI thread; a chord of all keys makes 88.
const RING: usize = 4096;

/// A run, connected and at rest.
pub struct RunSession {
    prepared: Box<PreparedRun>,
    keys: KeySource,
    dispatcher: Box<MidiDispatcher>,
    observed: ObservedOutputs,
}

/// Parts of a run without its keys and the MIDI dispatcher, which has its own thread.
struct PreparedRun {
    plan: RunPlan,
    voices: Vec<(usize, BoxedVoice)>,
    unit_costs: UnitCosts,
    play_list: Option<RehearsedPlayList>,
    watchers: Watchers,
    midi: OpenedOutput,
    wake: Arc<WakeFd>,
    counters: Arc<LiveCounters>,
    handle: Arc<RunHandle>,
}

/// Settings fixed before a run's first tick.
#[derive(Debug)]
pub struct RunPlan {
    name: String,
    pub tick_hz: u32,
    /// Fastest change of a force towards a voice (N/s).
    slew_limit: f64,
    overload: OverloadRules,
    pub n_voices: usize,
    n_lanes: NonZeroUsize,
    threads: ThreadPlan,
    pub ticks: Option<u64>,
    virtual_time: bool,
}

impl std::fmt::Debug for RunSession {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("scene", &self.prepared.plan.name).finish_non_exhaustive()
    }
}

impl RunSession {
    /// Connects all parts of `scene` and rehearses its pianist.
    pub fn prepare(
        scene: &Scene,
        options: RunOptions,
        progress: &(dyn Fn(PianistProgress) + Sync),
    ) -> Result<Self, SessionError> {
        let found = FoundKeys::find(scene, options)?;
        Self::prepare_behind(Arc::default(), found, options, progress)
    }

    /// Like [`Self::prepare`], but with keys that were found before, and with a caller-supplied
    /// `handle`. The handle stops the session and carries requests while it runs.
    pub fn prepare_behind(
        handle: Arc<RunHandle>,
        found: FoundKeys,
        options: RunOptions,
        progress: &(dyn Fn(PianistProgress) + Sync),
    ) -> Result<Self, SessionError> {
        handle.status.prepare(&found.scene.name);
        let (scene, mut keys) = (&found.scene, found.source);
        let builder = VoiceBuilder::new(scene)?;
        let period = builder.period().as_secs_f64();
        if scene.play_list.is_some() && !keys.has_fingers() {
            return Err(SessionError::NoFingers);
        }
        let play_list = play_list::rehearse(scene, &builder, options.duration, &handle, progress)?;
        let performance = play_list.as_ref().map(|list| &list.performance);
        let once = performance.filter(|it| it.repeat.is_none());
        let seconds = options.duration.or_else(|| Some(once?.end() + AFTERGLOW));
        if options.virtual_time && seconds.is_none() {
            return Err(SessionError::Endless);
        }
        if let Some(performance) = performance {
            keys.load_gestures(performance);
        }
        let (recorder, observed) = observed::connect(scene, period, &handle)?;
        let (voices, unit_costs) = observed::voices(&builder, &handle, options)?;
        let (producer, consumer) = rtrb::RingBuffer::new(RING);
        let timing = play_list.as_ref().and_then(|it| it.timing.as_ref());
        let (output, mut midi) = midi_out::open(&scene.midi, timing, &handle)?;
        let output = sound_out::add(scene, output, &mut midi)?;
        let output: AnyOutput = Box::new(MonitoredOutput { output, sender: observed.sender() });
        let (wake, counters) = (Arc::new(WakeFd::new()?), Arc::new(LiveCounters::default()));
        let dispatcher = dispatcher(consumer, (output, scene.midi.curve), performance, &counters);
        let pedals = observed::pedals(play_list.as_ref(), &handle);
        let mut publisher = TickPublisher::new(
            producer,
            Arc::clone(&wake),
            Arc::clone(&counters),
            pedals.into(),
            period,
        );
        publisher.repeat_pedals_after(performance.and_then(|it| it.repeat));
        let pass = play_list.as_ref().and_then(|it| it.pass);
        observed::describe(&handle, (scene, pass), &midi.report, &counters);
        let plan = RunPlan {
            name: scene.name.clone(),
            tick_hz: scene.tick_hz,
            slew_limit: scene.render.slew_limit,
            overload: scene.overload,
            n_voices: voices.len(),
            n_lanes: threads::lanes(scene),
            threads: threads::plan(scene, options),
            ticks: seconds.map(|seconds| clock::nearest_integer(seconds / period)),
            virtual_time: options.virtual_time,
        };
        let prepared = PreparedRun {
            plan,
            voices,
            unit_costs,
            play_list,
            watchers: Watchers { publisher, recorder },
            midi,
            wake,
            counters,
            handle,
        };
        Ok(Self { prepared: Box::new(prepared), keys, dispatcher, observed })
    }

    pub const fn plan(&self) -> &RunPlan {
        &self.prepared.plan
    }

    pub fn pass(&self) -> Option<u64> {
        self.prepared.play_list.as_ref()?.pass
    }

    /// Returns `true` if the pianist's rehearsal was kept from an earlier run.
    pub fn is_rehearsal_kept(&self) -> bool {
        self.prepared.play_list.as_ref().is_some_and(|list| list.is_kept)
    }

    /// Returns the name of the MIDI output, or the reason for its absence.
    pub fn midi(&self) -> String {
        self.prepared.midi.report.words()
    }

    pub fn counters(&self) -> Arc<LiveCounters> {
        Arc::clone(&self.prepared.counters)
    }

    /// Returns the handle that reaches its lanes in real time.
    pub fn handle(&self) -> Arc<RunHandle> {
        Arc::clone(&self.prepared.handle)
    }

    /// Inserts `trial` between the scheduler and the simulated keys; not used for real keys.
    pub fn try_keys(
        &mut self,
        prepare: impl FnOnce(&mut SimulatedKeybed),
        trial: Box<dyn RunTrial>,
    ) {
        if let KeySource::Simulated(keys) = &mut self.keys {
            prepare(&mut keys.keybed);
            keys.trial = Some(trial);
        }
    }

    /// Sends MIDI to `output` instead of the scene's.
    pub fn send_midi_to(&mut self, output: AnyOutput) {
        let sender = self.observed.sender();
        self.dispatcher.send_to(Box::new(MonitoredOutput { output, sender }));
    }

    /// Sends all telemetry of the run to `sink`, from before its first tick on.
    pub fn observe(&self, sink: Box<dyn MessageSink>) {
        self.prepared.handle.tell(TelemetryMessage::Sink(sink));
    }

    /// Runs until the end or until `stop`, and reports.
    pub fn run(self, stop: &AtomicBool) -> Result<RunReport, SessionError> {
        let Self { prepared, keys, dispatcher, observed } = self;
        if prepared.plan.virtual_time {
            virtual_run::run(prepared, keys, dispatcher, observed, stop)
        } else {
            real::run(prepared, keys, dispatcher, observed, stop)
        }
    }
}

impl PreparedRun {
    /// Returns the timetable, with tick 0 due at time 0.
    fn timetable(&self) -> Result<Timetable, SessionError> {
        let period = scheduler::time::Period::from_hz(self.plan.tick_hz)
            .ok_or(BuildError::Rate(self.plan.tick_hz))?;
        Ok(Timetable::new(Nanos::ZERO, period))
    }

    fn scheduler(&self) -> Result<Box<Scheduler>, SessionError> {
        let mut scheduler =
            engine::realtime::run::scheduler(self.timetable()?, self.plan.slew_limit);
        scheduler.set_overload(self.plan.overload);
        Ok(scheduler)
    }

    fn start_lanes(&mut self) -> std::io::Result<(ThreadedLanes, VoiceSwaps)> {
        let voices = std::mem::take(&mut self.voices);
        let (mut lanes, swaps) =
            ThreadedLanes::start(voices, self.plan.n_lanes, &self.plan.threads)?;
        self.unit_costs.costs().for_each(|(kind, cost)| lanes.expect_cost(kind, cost));
        Ok((lanes, swaps))
    }

    fn report(
        &self,
        ticks: u64,
        mut played: PlaybackSummary,
        measured: MeasuredRun,
        bus: &KeyTransport,
    ) -> RunReport {
        let duration = (ticks + measured.skipped) as f64 / f64::from(self.plan.tick_hz);
        RunReport {
            scene: self.plan.name.clone(),
            extent: RunExtent {
                voices: self.plan.n_voices,
                tick_hz: self.plan.tick_hz,
                ticks,
                skipped: measured.skipped,
                duration_s: duration,
                stopped: self.handle.emergency.answered().is_some(),
                lanes: self.plan.n_lanes.get(),
            },
            realtime: measured.realtime,
            deadline: measured.deadline,
            notes: self.play_list.as_ref().zip(played.assessor.take()).map(|(list, assessor)| {
                notes(list, assessor, (ticks + measured.skipped, duration))
            }),
            totals: totals(&self.counters),
            links: bus.links(),
            boards: bus.boards(duration),
            lines: bus.lines(duration),
            energy_audit: self.handle.energy().into(),
            midi: self.midi.report(played),
            recording: None,
            overload: OverloadReport::new(&self.counters.overload, self.plan.tick_hz),
            pauses: lost_ticks(&measured.pauses, self.plan.tick_hz),
            fidelity: Vec::new(),
        }
    }
}

fn totals(counters: &LiveCounters) -> VoiceTotals {
    let load = |counter: &AtomicU64| counter.load(Ordering::Relaxed);
    VoiceTotals {
        events: load(&counters.events),
        strikes: load(&counters.strikes),
        faults: load(&counters.faults),
        muted: counters.muted.keys().map(|key| key_name(key.into())).collect(),
        dropped: load(&counters.dropped),
        work: Evaluations {
            derivatives: load(&counters.derivatives),
            guards: load(&counters.guards),
        },
        steps: StepCounts::new(
            counters.quiet_steps.each_ref().map(load),
            counters.event_steps.each_ref().map(load),
        ),
    }
}

/// Returns the player of `events`, which compares them with `performance` and shows life while
/// `counters` count ticks.
fn dispatcher(
    events: rtrb::Consumer<NoteEvent>,
    (output, curve): (AnyOutput, VelocityCurve),
    performance: Option<&Performance>,
    counters: &Arc<LiveCounters>,
) -> Box<MidiDispatcher> {
    let mut dispatcher = Box::new(MidiDispatcher::new(events, output, curve));
    dispatcher.live_while_ticks_go_on(Arc::clone(counters));
    if let Some(performance) = performance {
        dispatcher.assess(assessor(performance));
    }
    dispatcher
}

fn assessor(performance: &Performance) -> Assessor {
    let is_left_out = |note: &ExpectedNote| {
        let same = |it: &&ShortStroke| (it.key, it.onset) == (note.key, note.onset);
        performance.shortfalls.iter().find(same).is_some_and(|it| it.why.is_left_out())
    };
    let expected = performance.expected.iter().copied();
    let (left_out, expected) = expected.partition(is_left_out);
    Assessor::new(expected, left_out, performance.repeat)
}

/// Assesses the notes of the play list up to the run's end, after so many ticks and seconds.
fn notes(
    list: &RehearsedPlayList,
    assessor: Assessor,
    (ticks, duration): (u64, f64),
) -> NoteReport {
    let performance = &list.performance;
    let passes = list.pass.map_or(1, |length| passes(ticks, length));
    let shortfalls =
        performance.shortfalls.iter().filter(|it| it.onset < duration - pianist::WINDOW);
    let shortfalls: Vec<_> = shortfalls.copied().collect();
    let cuts = performance.cuts.iter().filter(|it| it.onset < duration - pianist::WINDOW);
    NoteReport {
        cuts: cuts.map(NoteCut::new).collect(),
        pieces: list.pieces,
        passes,
        unplayed: list.unplayed.clone(),
        range_m_per_s: performance.range,
        ..NoteReport::new(&assessor.finish(duration), &shortfalls)
    }
}

fn lost_ticks(pauses: &[Pause], tick_hz: u32) -> Vec<LostTicks> {
    let seconds = |tick: u64| tick as f64 / f64::from(tick_hz);
    pauses.iter().map(|it| LostTicks { at_s: seconds(it.tick - it.lost), ticks: it.lost }).collect()
}

fn all_keys() -> impl Iterator<Item = KeyIndex> {
    (0..=u8::MAX).map_while(KeyIndex::new)
}

fn no_clock() -> (Realtime, Deadline) {
    let realtime = Realtime {
        policy: "virtual time".into(),
        memory_locked: false,
        latency_held: false,
        advice: Vec::new(),
    };
    (realtime, Deadline::default())
}
