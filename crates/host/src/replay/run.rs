//! Runs a recording through the scheduler.

use std::sync::{Arc, mpsc};

use midi::{PedalMove, VelocityCurve};
use scheduler::motion::{KEYS, KeySample};
use scheduler::time::{Nanos, Period, Timetable};
use serde::Serialize;
use telemetry::{Catalogue, Event, Ticks, Update, Voice, event::Kind};

use super::compare::{Comparison, ReplayDifference, ReplayedMessages};
use super::feed::{Arm, Feed, ticks};
use super::lanes::{RecordedVoice, ReplayBus, ReplayLanes};
use super::{ReplayError, versions::RecordedVersions};
use crate::adapters::observer::{LiveCounters, TickPublisher};
use crate::observe::{Origin, Pulses, TelemetryMessage, TelemetryThread, pedal_move, voice};
use crate::session::{MonitoredOutput, Watchers, nowhere};
use crate::{adapters::tick_recorder::TickRecorder, midi_thread::MidiDispatcher};
use engine::realtime::{clock, run::scheduler, wake_fd::WakeFd};
use scene::{KeyVoice, Library, Render, Scene};

/// Result of a replay.
#[derive(Clone, PartialEq, Debug, Default, Serialize)]
pub struct Replayed {
    pub scene: String,
    /// Ticks that were replayed and compared to the last bit.
    pub ticks: u64,
    /// Ticks in the recording, up to its first hole.
    pub recorded: u64,
    /// Messages that were compared to the last bit: rows, events, MIDI.
    pub compared: u64,
    pub different: u64,
    pub first_difference: Option<ReplayDifference>,
    /// First tick with incomplete inputs, if any: the recording breaks off or has a hole, rows are
    /// missing, or a lane was late for too long. Nothing is compared from there on.
    pub incomplete_from: Option<u64>,
    pub damage: Option<String>,
    pub faults: u64,
    pub strikes: u64,
}

/// Replays `messages` in their order and compares.
///
/// The replay ends at a message that cannot be read, since the recording does not contain the
/// state of the voices behind such a hole. A hole is no difference.
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
            // Messages behind the damage do not begin with the run.
            (None, Err(why)) => return Err(ReplayError::Beginning(why)),
            (None, Ok(Update::Catalogue(catalogue))) => replay = Some(Replay::begin(&catalogue)?),
            (None, Ok(_too_early)) => {}
            (Some(replay), Err(why)) => _ = replay.result.damage.get_or_insert(why),
            (Some(replay), Ok(message)) if replay.result.damage.is_some() => {
                // Catalogue and voices are repeated, also behind the last tick.
                if !matches!(message, Update::Catalogue(_) | Update::Voice(_)) {
                    replay.recording.has_hole = true;
                    break;
                }
            }
            (Some(replay), Ok(message)) => {
                replay.take(message)?;
                progress(replay.result.ticks);
            }
        }
    }
    Ok(replay.ok_or(ReplayError::NoCatalogue)?.finish())
}

fn scene_of(catalogue: &Catalogue, library: &Library) -> Result<Scene, ReplayError> {
    let scene = Scene::from_text(library, "recording", catalogue.scene_text.clone());
    scene.map_err(|wrong| ReplayError::Scene(wrong.to_string()))
}

struct Replay {
    recording: RecordedInputs,
    engine: ReplayEngine,
    sinks: ReplaySinks,
    comparison: Comparison,
    result: Replayed,
}

/// Inputs of the following ticks, as far as the recording was read.
struct RecordedInputs {
    /// Render settings for the voices that follow in the recording.
    render: Render,
    versions: RecordedVersions,
    feed: Feed,
    pedals: Vec<PedalMove>,
    /// Ticks of a pass, if the pedals repeat.
    pass: Option<u64>,
    has_hole: bool,
}

struct ReplayEngine {
    scheduler: Box<scheduler::tick::Scheduler>,
    timetable: Timetable,
    bus: ReplayBus,
    lanes: ReplayLanes,
    is_running: bool,
    last: u64,
}

struct ReplaySinks {
    watchers: Watchers,
    telemetry: Box<TelemetryThread>,
    dispatcher: MidiDispatcher,
    sender: mpsc::Sender<TelemetryMessage>,
    replayed: ReplayedMessages,
}

/// Key events between two windows; a second of all keys.
const RING: usize = 1 << 16;

impl ReplayEngine {
    /// Runs `tick` with the inputs of `feed`. Returns `true` if the scheduler did.
    fn run(
        &mut self,
        tick: u64,
        feed: &mut Feed,
        watchers: &mut Watchers,
    ) -> Result<bool, ReplayError> {
        match feed.arm(tick) {
            Some(Arm::Off) => self.scheduler.disarm(),
            Some(Arm::On) => self.scheduler.arm(),
            None => {}
        }
        if let Some(simplified) = feed.simplified(tick) {
            self.scheduler.simplify(simplified);
        }
        let fed = feed.tick(tick);
        for (sample, fed) in self.bus.samples.iter_mut().zip(&fed) {
            *sample = fed.sample;
        }
        self.lanes.feed(fed);
        self.last = tick;
        let now = self.timetable.due(tick);
        let done = self.scheduler.poll(now, &mut self.bus, &mut self.lanes, watchers);
        self.lanes.failed.take().map_or(Ok(done.is_some()), Err)
    }
}

impl ReplaySinks {
    fn connect(
        catalogue: &Catalogue,
        curve: VelocityCurve,
        period: Period,
    ) -> Result<Self, ReplayError> {
        let (recorder, rings) = TickRecorder::new();
        let (_no_times, times) = Pulses::new();
        let (sender, receiver) = mpsc::channel();
        let system = |error: String| ReplayError::Read(error);
        let seconds = period.as_secs_f64();
        let nanos = clock::from_seconds(seconds).as_u64();
        let telemetry = TelemetryThread::new(rings, times, receiver, nanos);
        let mut telemetry = telemetry.map_err(|error| system(error.to_string()))?;
        let replayed = ReplayedMessages::default();
        // Sent before the beginning, so that all keys are followed from the first tick on. The
        // receiver exists as long as the replay.
        let _received = sender.send(TelemetryMessage::Sink(Box::new(replayed.clone())));
        telemetry.begin(catalogue.began, catalogue.clone());
        let (ring, events) = rtrb::RingBuffer::new(RING);
        let wake = Arc::new(WakeFd::new().map_err(|error| system(error.to_string()))?);
        let counters = Arc::<LiveCounters>::default();
        let publisher = TickPublisher::new(ring, wake, counters, Box::default(), seconds);
        let output = Box::new(MonitoredOutput { output: nowhere(), sender: sender.clone() });
        let dispatcher = MidiDispatcher::new(events, output, curve);
        let watchers = Watchers { publisher, recorder };
        Ok(Self { watchers, telemetry, dispatcher, sender, replayed })
    }
}

impl Replay {
    #[expect(clippy::large_stack_frames, reason = "once, at set-up, on its way to the heap")]
    fn begin(catalogue: &Catalogue) -> Result<Box<Self>, ReplayError> {
        let mut versions = RecordedVersions::default();
        versions.learn(catalogue)?;
        let scene = scene_of(catalogue, &versions.library)?;
        let period = Period::from_hz(scene.tick_hz)
            .ok_or_else(|| ReplayError::Scene(format!("no tick has {} Hz", scene.tick_hz)))?;
        let timetable = Timetable::new(Nanos::ZERO, period);
        let render = scene.render;
        Ok(Box::new(Self {
            recording: RecordedInputs {
                render,
                versions,
                feed: Feed::new(),
                pedals: Vec::new(),
                pass: None,
                has_hole: false,
            },
            sinks: ReplaySinks::connect(catalogue, scene.midi.curve, period)?,
            comparison: Comparison::default(),
            result: Replayed { scene: scene.name.clone(), ..Replayed::default() },
            engine: ReplayEngine {
                // The recording contains the omissions and the waiting keys.
                scheduler: scheduler(timetable, render.slew_limit),
                timetable,
                bus: ReplayBus { samples: [KeySample::default(); KEYS] },
                lanes: ReplayLanes::new(scene),
                is_running: false,
                last: 0,
            },
        }))
    }

    fn take(&mut self, message: Update) -> Result<(), ReplayError> {
        if let Update::Ticks(message) = &message {
            self.result.recorded += message.after.len() as u64;
        }
        if self.recording.feed.gap().is_some() {
            return Ok(());
        }
        match &message {
            Update::Voice(voice) => self.voice(voice)?,
            Update::Block(block) => self.recording.feed.block(block),
            Update::Event(event) => self.event(event),
            Update::Ticks(message) => self.window(message)?,
            Update::Catalogue(catalogue) => {
                let RecordedInputs { versions, render, .. } = &mut self.recording;
                versions.learn(catalogue)?;
                *render = scene_of(catalogue, &versions.library)?.render;
            }
            Update::Overview(_)
            | Update::State(..)
            | Update::Deadlines(_)
            | Update::Links(_)
            | Update::Midi(_)
            | Update::Log(_)
            | Update::Status(_) => {}
        }
        self.comparison.expect(message);
        Ok(())
    }

    fn event(&mut self, event: &Event) {
        self.recording.feed.event(event);
        match event.kind() {
            Kind::Pedal => {
                self.recording.pedals.extend(pedal_move(event));
                self.recording.pass = Some(event.every).filter(|every| 0 < *every);
            }
            Kind::Fault => self.result.faults += 1,
            Kind::Strike => self.result.strikes += 1,
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
        let from = self.engine.last;
        for tick in ticks(message) {
            self.tick(tick)?;
        }
        self.sinks.telemetry.pump();
        if self.engine.lanes.is_unknown() {
            // Nothing after the ticks before this window can be compared.
            self.recording.feed.lose(from + 1);
            self.sinks.replayed.take_all();
        } else {
            self.comparison.window(self.engine.last, &self.sinks.replayed);
        }
        Ok(())
    }

    /// Adds a voice and sends it to the telemetry, which then uses the same probes.
    fn voice(&mut self, message: &Voice) -> Result<(), ReplayError> {
        let model = self.recording.versions.model(message)?;
        let played = KeyVoice { model, values: message.values.clone(), file: None };
        let origin = Origin {
            revision: message.revision,
            instrument: Some(&message.instrument),
            writer: &message.writer,
            kept: message.kept,
        };
        let key = u8::try_from(message.key).unwrap_or(u8::MAX);
        // The receiver exists as long as the replay.
        let _received = self.sinks.sender.send(voice(key, &played, origin));
        let (kept, render) = (message.kept, self.recording.render);
        let recorded = RecordedVoice { voice: played, kept, render };
        self.engine.lanes.learn(message.key, message.revision, recorded)
    }

    fn tick(&mut self, tick: u64) -> Result<(), ReplayError> {
        let Self { recording, engine, sinks, result, .. } = self;
        if !engine.is_running {
            if 0 < tick && recording.feed.begins_late(tick) {
                return Err(ReplayError::Middle(tick));
            }
            let period = engine.timetable.period().as_secs_f64();
            let publisher = &mut sinks.watchers.publisher;
            publisher.set_pedals(std::mem::take(&mut recording.pedals).into());
            publisher.repeat_pedals_after(recording.pass.map(|ticks| ticks as f64 * period));
            engine.is_running = true;
        }
        let was_run = engine.run(tick, &mut recording.feed, &mut sinks.watchers)?;
        sinks.dispatcher.drain();
        result.ticks += u64::from(was_run);
        Ok(())
    }

    /// Compares the rest, up to the end of the recording or to its first hole.
    fn finish(mut self) -> Replayed {
        self.sinks.telemetry.pump();
        let mut is_torn = self.comparison.forget_unrun() || self.recording.has_hole;
        self.comparison.window(self.engine.last, &self.sinks.replayed);
        let timed = self.comparison.n_sent();
        self.sinks.dispatcher.end_notes(self.comparison.ending());
        self.sinks.telemetry.pump();
        self.comparison.window(self.engine.last, &self.sinks.replayed);
        self.comparison.sort_sent(timed);
        is_torn |= self.comparison.lacks_end(timed);
        if is_torn {
            self.comparison.tear(timed);
        }
        let gap = self.recording.feed.gap();
        if gap.is_none() {
            self.comparison.finish(self.engine.last, timed);
        }
        let next = if self.engine.is_running { self.engine.last + 1 } else { 0 };
        let incomplete_from = gap.or_else(|| is_torn.then_some(next));
        let Comparison { compared, different, first, .. } = self.comparison;
        Replayed {
            compared,
            different,
            first_difference: first,
            incomplete_from,
            // Damage behind the last tick does not shorten the replay.
            damage: self.result.damage.filter(|_| incomplete_from.is_some()),
            ..self.result
        }
    }
}
