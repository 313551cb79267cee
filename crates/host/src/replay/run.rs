//! A recording through the scheduler.

use std::sync::mpsc;

use midi::PedalMove;
use scheduler::motion::{KEYS, KeySample};
use scheduler::time::{Nanos, Period, Timetable};
use serde::Serialize;
use telemetry::event::Kind;
use telemetry::{Catalogue, Event, Ticks, Update, Voice};

use super::ReplayError;
use super::compare::{Comparison, ReplayDifference, ReplayedMessages};
use super::feed::{Arm, Feed, ticks};
use super::lanes::{RecordedVoice, ReplayBus, ReplayLanes};
use super::versions::RecordedVersions;
use crate::adapters::observer::{LiveCounters, TickPublisher};
use crate::adapters::tick_recorder::TickRecorder;
use crate::midi_thread::MidiDispatcher;
use crate::observe::{Origin, Pulses, TelemetryMessage, TelemetryThread, pedal_move, voice};
use crate::session::{MonitoredOutput, Watchers, nowhere};
use engine::realtime::clock;
use engine::realtime::run::scheduler;
use engine::realtime::wake_fd::WakeFd;
use scene::{KeyVoice, Library, Render, Scene};

/// The result of a replay.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Replayed {
    pub scene: String,
    /// Ticks that were run again and compared to the last bit.
    pub ticks: u64,
    /// Ticks in the recording, up to its first hole.
    pub recorded: u64,
    /// Messages that were compared to the last bit: rows, events, MIDI.
    pub compared: u64,
    /// Messages among these that differ.
    pub different: u64,
    pub first_difference: Option<ReplayDifference>,
    /// First tick with incomplete inputs, if any: the recording breaks off or has a hole, rows are
    /// missing, or a lane was late for too long. Nothing is compared from there on.
    pub incomplete_from: Option<u64>,
    /// The damage that ended the replay, in a sentence.
    pub damage: Option<String>,
    pub faults: u64,
    pub strikes: u64,
}

/// Replays what `messages` recorded, in their order, and compares.
///
/// The replay ends where a message cannot be read: the recording does not contain the state of the
/// voices behind such a hole. A hole is no difference.
///
/// # Errors
/// If the recording cannot be replayed; a difference is no error.
pub fn replay(
    messages: impl Iterator<Item = Result<Update, String>>,
    mut progress: impl FnMut(u64),
) -> Result<Replayed, ReplayError> {
    let mut replay: Option<Box<Replay>> = None;
    for message in messages {
        match (&mut replay, message) {
            // Messages behind the damage do not begin where the run did.
            (None, Err(why)) => return Err(ReplayError::Beginning(why)),
            (None, Ok(Update::Catalogue(catalogue))) => replay = Some(Replay::begin(&catalogue)?),
            (None, Ok(_too_early)) => {}
            (Some(replay), Err(why)) => _ = replay.damage.get_or_insert(why),
            (Some(replay), Ok(message)) if replay.damage.is_some() => {
                // Catalogue and voices are repeated, also behind the last tick.
                if !matches!(message, Update::Catalogue(_) | Update::Voice(_)) {
                    replay.has_hole = true;
                    break;
                }
            }
            (Some(replay), Ok(message)) => {
                replay.take(message)?;
                progress(replay.ticks);
            }
        }
    }
    Ok(replay.ok_or(ReplayError::NoCatalogue)?.finish())
}

/// Returns the recorded scene.
fn scene_of(catalogue: &Catalogue, library: &Library) -> Result<Scene, ReplayError> {
    let scene = Scene::from_text(library, "recording", catalogue.scene_text.clone());
    scene.map_err(|wrong| ReplayError::Scene(wrong.to_string()))
}

struct Replay {
    scene: Scene,
    /// Render settings for the voices that follow in the recording.
    render: Render,
    versions: RecordedVersions,
    scheduler: Box<scheduler::tick::Scheduler>,
    timetable: Timetable,
    feed: Feed,
    bus: ReplayBus,
    lanes: ReplayLanes,
    watchers: Watchers,
    telemetry: Box<TelemetryThread>,
    dispatcher: MidiDispatcher,
    sender: mpsc::Sender<TelemetryMessage>,
    replayed: ReplayedMessages,
    comparison: Comparison,
    pedals: Vec<PedalMove>,
    /// Ticks after which pedals move again, if they do.
    pass: Option<u64>,
    is_running: bool,
    ticks: u64,
    recorded: u64,
    last: u64,
    faults: u64,
    strikes: u64,
    /// Why the next messages could not be read, if they could not.
    damage: Option<String>,
    /// Whether messages follow that damage.
    has_hole: bool,
}

/// Key events between two windows; a second of all keys.
const RING: usize = 1 << 16;

impl Replay {
    #[expect(clippy::large_stack_frames, reason = "once, at set-up, on its way to the heap")]
    fn begin(catalogue: &Catalogue) -> Result<Box<Self>, ReplayError> {
        let mut versions = RecordedVersions::default();
        versions.learn(catalogue)?;
        let scene = scene_of(catalogue, &versions.library)?;
        let period = Period::from_hz(scene.tick_hz)
            .ok_or_else(|| ReplayError::Scene(format!("no tick has {} Hz", scene.tick_hz)))?;
        let timetable = Timetable::new(Nanos::ZERO, period);
        let (recorder, rings) = TickRecorder::new();
        let (_no_times, times) = Pulses::new();
        let (sender, receiver) = mpsc::channel();
        let system = |error: String| ReplayError::Read(error);
        let nanos = clock::from_seconds(period.as_secs_f64()).as_u64();
        let telemetry = TelemetryThread::new(rings, times, receiver, nanos);
        let mut telemetry = telemetry.map_err(|error| system(error.to_string()))?;
        let replayed = ReplayedMessages::default();
        // Sent before the beginning, so that all keys are followed from the first tick on. The
        // receiver exists as long as the replay.
        let _received = sender.send(TelemetryMessage::Sink(Box::new(replayed.clone())));
        telemetry.begin(catalogue.began, catalogue.clone());
        let (ring, events) = rtrb::RingBuffer::new(RING);
        let wake = WakeFd::new().map_err(|error| system(error.to_string()))?;
        let counters = std::sync::Arc::<LiveCounters>::default();
        let publisher = TickPublisher::new(
            ring,
            std::sync::Arc::new(wake),
            counters,
            Box::default(),
            period.as_secs_f64(),
        );
        let output = Box::new(MonitoredOutput { output: nowhere(), sender: sender.clone() });
        let dispatcher = MidiDispatcher::new(events, output, scene.midi.curve);
        Ok(Box::new(Self {
            // The recording contains what was left out and which keys waited.
            scheduler: scheduler(timetable, scene.render.slew_limit),
            timetable,
            feed: Feed::new(),
            bus: ReplayBus { samples: [KeySample::default(); KEYS] },
            lanes: ReplayLanes::new(scene.clone()),
            render: scene.render,
            scene,
            versions,
            watchers: Watchers { publisher, recorder },
            telemetry,
            dispatcher,
            sender,
            replayed,
            comparison: Comparison::default(),
            pedals: Vec::new(),
            pass: None,
            is_running: false,
            ticks: 0,
            recorded: 0,
            last: 0,
            faults: 0,
            strikes: 0,
            damage: None,
            has_hole: false,
        }))
    }

    fn take(&mut self, message: Update) -> Result<(), ReplayError> {
        if let Update::Ticks(message) = &message {
            self.recorded += message.after.len() as u64;
        }
        if self.feed.gap().is_some() {
            return Ok(());
        }
        match &message {
            Update::Voice(voice) => self.voice(voice)?,
            Update::Block(block) => self.feed.block(block),
            Update::Event(event) => self.event(event),
            Update::Ticks(message) => self.window(message)?,
            Update::Catalogue(catalogue) => {
                self.versions.learn(catalogue)?;
                self.render = scene_of(catalogue, &self.versions.library)?.render;
            }
            Update::Overview(_)
            | Update::State(..)
            | Update::Deadlines(_)
            | Update::Links(_)
            | Update::Midi(_)
            | Update::Log(_) => {}
        }
        self.comparison.expect(message);
        Ok(())
    }

    fn event(&mut self, event: &Event) {
        self.feed.event(event);
        match event.kind() {
            Kind::Pedal => {
                self.pedals.extend(pedal_move(event));
                self.pass = Some(event.every).filter(|every| 0 < *every);
            }
            Kind::Fault => self.faults += 1,
            Kind::Strike => self.strikes += 1,
            Kind::Unknown
            | Kind::Switch
            | Kind::DamperLift
            | Kind::Pressure
            | Kind::DamperFall
            | Kind::Recovery
            | Kind::Miss
            | Kind::Skip
            | Kind::Board
            | Kind::Change
            | Kind::Disarm
            | Kind::Arm
            | Kind::Starved
            | Kind::Overload => {}
        }
    }

    /// Runs the ticks of a window. Their rows precede the window in the recording.
    fn window(&mut self, message: &Ticks) -> Result<(), ReplayError> {
        let from = self.last;
        for tick in ticks(message) {
            self.tick(tick)?;
        }
        self.telemetry.pump();
        if self.lanes.is_unknown() {
            // Nothing can be compared behind the ticks before this window.
            self.feed.lose(from + 1);
            self.replayed.take_all();
        } else {
            self.comparison.window(self.last, &self.replayed);
        }
        Ok(())
    }

    /// Learns of a voice, and sends it to the telemetry, which then uses the same probes.
    fn voice(&mut self, message: &Voice) -> Result<(), ReplayError> {
        let model = self.versions.model(message)?;
        let played = KeyVoice { model, values: message.values.clone() };
        let origin = Origin {
            revision: message.revision,
            instrument: Some(&message.instrument),
            writer: &message.writer,
            kept: message.kept,
        };
        let key = u8::try_from(message.key).unwrap_or(u8::MAX);
        // The receiver exists as long as the replay.
        let _received = self.sender.send(voice(key, &played, origin));
        let part = RecordedVoice { voice: played, kept: message.kept, render: self.render };
        self.lanes.learn(message.key, message.revision, part)
    }

    /// Arms voices and leaves things out as it was done before `tick`.
    fn steer(&mut self, tick: u64) {
        match self.feed.arm(tick) {
            Some(Arm::Off) => self.scheduler.disarm(),
            Some(Arm::On) => self.scheduler.arm(),
            None => {}
        }
        if let Some(simplified) = self.feed.simplified(tick) {
            self.scheduler.simplify(simplified);
        }
    }

    fn tick(&mut self, tick: u64) -> Result<(), ReplayError> {
        if !self.is_running {
            if 0 < tick && self.feed.begins_late(tick) {
                return Err(ReplayError::Middle(tick));
            }
            let length =
                self.pass.map(|ticks| ticks as f64 * self.timetable.period().as_secs_f64());
            self.watchers.publisher.set_pedals(std::mem::take(&mut self.pedals).into());
            self.watchers.publisher.repeat_pedals_after(length);
            self.is_running = true;
        }
        self.steer(tick);
        let fed = self.feed.tick(tick);
        for (sample, fed) in self.bus.samples.iter_mut().zip(&fed) {
            *sample = fed.sample;
        }
        self.lanes.feed(fed);
        let now = self.timetable.due(tick);
        let done = self.scheduler.poll(now, &mut self.bus, &mut self.lanes, &mut self.watchers);
        if let Some(failed) = self.lanes.failed.take() {
            return Err(failed);
        }
        self.dispatcher.drain();
        self.ticks += u64::from(done.is_some());
        self.last = tick;
        Ok(())
    }

    /// Compares the rest, up to the end of the recording or to its first hole.
    fn finish(mut self) -> Replayed {
        self.telemetry.pump();
        let mut is_torn = self.comparison.forget_unrun() || self.has_hole;
        self.comparison.window(self.last, &self.replayed);
        let timed = self.comparison.n_sent();
        // Ends the notes, as the run did.
        self.dispatcher.end_notes(self.comparison.ending());
        self.telemetry.pump();
        self.comparison.window(self.last, &self.replayed);
        self.comparison.sort_sent(timed);
        is_torn |= self.comparison.lacks_end(timed);
        if is_torn {
            self.comparison.tear(timed);
        }
        let gap = self.feed.gap();
        if gap.is_none() {
            self.comparison.finish(self.last, timed);
        }
        let next = if self.is_running { self.last + 1 } else { 0 };
        let incomplete_from = gap.or_else(|| is_torn.then_some(next));
        let Comparison { compared, different, first, .. } = self.comparison;
        Replayed {
            scene: self.scene.name,
            ticks: self.ticks,
            recorded: self.recorded,
            compared,
            different,
            first_difference: first,
            incomplete_from,
            // Damage behind the last tick takes nothing away that would be replayed.
            damage: self.damage.filter(|_| incomplete_from.is_some()),
            faults: self.faults,
            strikes: self.strikes,
        }
    }
}
