//! A recording through the scheduler.

use std::sync::mpsc;

use midi::PedalMove;
use scheduler::motion::{KEYS, KeySample};
use scheduler::time::{Nanos, Period, Timetable};
use serde::Serialize;
use telemetry::event::Kind;
use telemetry::{Catalogue, Event, Ticks, Update, Voice};

use super::ReplayError;
use super::agreement::Agreement;
use super::compare::{Comparison, ReplayDifference, Said};
use super::damage::{MissingTicks, UnreadParts};
use super::feed::{Arm, Feed, ticks};
use super::lanes::{RecordedVoice, ReplayBus, ReplayLanes};
use super::versions::RecordedVersions;
use crate::adapters::observer::{LiveCounters, TickPublisher};
use crate::adapters::tick_recorder::TickRecorder;
use crate::midi_thread::MidiDispatcher;
use crate::observe::{Origin, Pulses, TelemetryMessage, TelemetryThread, pedal_move, voice};
use crate::session::{MonitoredOutput, Watchers, nowhere};
use realtime::clock;
use realtime::run::scheduler;
use realtime::wake_fd::WakeFd;
use scene::{KeyVoice, Library, Render, Scene};

/// What a replay came to.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Replayed {
    pub scene: String,
    /// Ticks that were run again and compared to the last bit.
    pub ticks: u64,
    /// Ticks that the recording tells of.
    pub recorded: u64,
    /// Messages that were compared to the last bit: rows, events, MIDI.
    pub compared: u64,
    /// Of these, how many are not the same.
    pub different: u64,
    /// The first of them.
    pub first_difference: Option<ReplayDifference>,
    /// The tick from which on the recording does not tell all that decided, since rows are missing
    /// or a lane was late for too long, so that nothing is compared to the last bit.
    pub incomplete_from: Option<u64>,
    /// What is damaged in the recording.
    pub missing: Vec<MissingTicks>,
    pub faults: u64,
    pub strikes: u64,
}

/// Runs what `messages` recorded, in their order, and compares.
///
/// Where messages cannot be read, ticks are missing; that is no difference. What voices were like
/// behind them is not in the recording: it is compared to the last bit up to there, and behind
/// them every voice begins anew at rest where its key is, and forces are compared.
///
/// # Errors
/// If it cannot be run; a difference is none.
pub fn replay(
    messages: impl Iterator<Item = Result<Update, String>>,
    mut progress: impl FnMut(u64),
) -> Result<Replayed, ReplayError> {
    let mut replay: Option<Box<Replay>> = None;
    for message in messages {
        match (&mut replay, message) {
            // Whatever comes then, it does not begin where the run did.
            (None, Err(why)) => return Err(ReplayError::Beginning(why)),
            (None, Ok(Update::Catalogue(catalogue))) => replay = Some(Replay::begin(&catalogue)?),
            (None, Ok(_too_early)) => {}
            (Some(replay), Err(why)) => replay.missing.lose(why),
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
    /// The settings by which voices are computed that are told of next.
    render: Render,
    versions: RecordedVersions,
    scheduler: Box<scheduler::tick::Scheduler>,
    timetable: Timetable,
    feed: Feed,
    bus: ReplayBus,
    lanes: ReplayLanes,
    watchers: Watchers,
    pump: Box<TelemetryThread>,
    desk: MidiDispatcher,
    told: mpsc::Sender<TelemetryMessage>,
    said: Said,
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
    missing: UnreadParts,
    knowledge: Knowledge,
    /// The tick from which on it is not.
    whole_until: Option<u64>,
}

/// How much is known of what decided.
#[derive(Debug)]
enum Knowledge {
    /// All of it: everything is compared to the last bit.
    Whole,
    /// Ticks are missing; what is read next tells where the keys are.
    Lost,
    /// Every voice began anew behind missing ticks: forces are compared.
    Resumed(Agreement),
    /// A voice behind missing ticks could not be built.
    Over,
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
        let (tap, tapped) = TickRecorder::new();
        let (_no_times, times) = Pulses::new();
        let (told, hear) = mpsc::channel();
        let system = |error: String| ReplayError::Read(error);
        let pump = TelemetryThread::new(
            tapped,
            times,
            hear,
            clock::from_seconds(period.as_secs_f64()).as_u64(),
        );
        let mut pump = pump.map_err(|error| system(error.to_string()))?;
        let said = Said::default();
        // Before it begins, so that all keys are followed from the first tick on; whoever hears is
        // there as long as this is.
        let _heard = told.send(TelemetryMessage::Sink(Box::new(said.clone())));
        pump.begin(catalogue.began, catalogue.clone());
        let (ring, events) = rtrb::RingBuffer::new(RING);
        let bell = WakeFd::new().map_err(|error| system(error.to_string()))?;
        let counters = std::sync::Arc::<LiveCounters>::default();
        let publisher = TickPublisher::new(
            ring,
            std::sync::Arc::new(bell),
            counters,
            Box::default(),
            period.as_secs_f64(),
        );
        let output = Box::new(MonitoredOutput { output: nowhere(), sender: told.clone() });
        let desk = MidiDispatcher::new(events, output, scene.midi.curve);
        Ok(Box::new(Self {
            // What was left out and who waited is in the recording.
            scheduler: scheduler(timetable, scene.render.slew_limit),
            timetable,
            feed: Feed::new(),
            bus: ReplayBus { samples: [KeySample::default(); KEYS] },
            lanes: ReplayLanes::new(scene.clone()),
            render: scene.render,
            scene,
            versions,
            watchers: Watchers { publisher, recorder: tap },
            pump,
            desk,
            told,
            said,
            comparison: Comparison::default(),
            pedals: Vec::new(),
            pass: None,
            is_running: false,
            ticks: 0,
            recorded: 0,
            last: 0,
            faults: 0,
            strikes: 0,
            missing: UnreadParts::new(period.as_secs_f64()),
            knowledge: Knowledge::Whole,
            whole_until: None,
        }))
    }

    fn take(&mut self, message: Update) -> Result<(), ReplayError> {
        self.note_damage(&message);
        if self.feed.gap().is_some() {
            return Ok(());
        }
        let followed = self.follow(message);
        if followed.is_err() && self.is_lost() {
            self.knowledge = Knowledge::Over;
            return Ok(());
        }
        followed
    }

    /// Whether ticks are missing before the one that is run next.
    const fn is_lost(&self) -> bool {
        !matches!(self.knowledge, Knowledge::Whole)
    }

    /// Notes whether ticks are missing before `message`.
    fn note_damage(&mut self, message: &Update) {
        let is_said_again = matches!(message, Update::Catalogue(_) | Update::Voice(_));
        if self.missing.is_damaged() && !is_said_again {
            if self.feed.gap().is_none() {
                self.end_part();
                self.knowledge = Knowledge::Lost;
            }
            self.missing.begin();
        }
        if let Update::Ticks(message) = message {
            for tick in ticks(message) {
                self.missing.end(tick);
                self.recorded += 1;
            }
        }
    }

    /// Ends what was compared up to a hole, or to the end behind one.
    fn end_part(&mut self) {
        match &self.knowledge {
            Knowledge::Whole => {
                self.pump.pump();
                self.comparison.forget_unrun();
                self.comparison.window(self.last, &self.said);
                let timed = self.comparison.n_sent();
                self.comparison.sort_sent(timed);
                self.comparison.tear(timed);
                self.comparison.finish(self.last, timed);
                self.whole_until = Some(if self.is_running { self.last + 1 } else { 0 });
            }
            Knowledge::Resumed(agreement) => {
                let period = self.timetable.period().as_secs_f64();
                self.missing.resumed(agreement.result(period));
            }
            Knowledge::Lost | Knowledge::Over => {}
        }
    }

    fn follow(&mut self, message: Update) -> Result<(), ReplayError> {
        match &message {
            Update::Voice(voice) => self.voice(voice)?,
            Update::Block(block) => {
                self.feed.block(block);
                if let Knowledge::Resumed(agreement) = &mut self.knowledge {
                    agreement.expect(block);
                }
            }
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
        if !self.is_lost() {
            self.comparison.expect(message);
        }
        Ok(())
    }

    fn event(&mut self, event: &Event) {
        self.feed.event(event);
        let is_counted = u64::from(!self.is_lost());
        match event.kind() {
            Kind::Pedal => {
                self.pedals.extend(pedal_move(event));
                self.pass = Some(event.every).filter(|every| 0 < *every);
            }
            Kind::Fault => self.faults += is_counted,
            Kind::Strike => self.strikes += is_counted,
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

    /// Runs the ticks of a window, whose rows have come before.
    fn window(&mut self, message: &Ticks) -> Result<(), ReplayError> {
        match &self.knowledge {
            Knowledge::Whole => {
                let from = self.last;
                for tick in ticks(message) {
                    self.tick(tick)?;
                }
                self.pump.pump();
                if self.lanes.is_unknown() {
                    // Behind the ticks before, nothing can be compared.
                    self.feed.lose(from + 1);
                    self.said.take_all();
                } else {
                    self.comparison.window(self.last, &self.said);
                }
            }
            Knowledge::Lost => {
                // The rows of this window may be lost in part: they tell where the keys are.
                for tick in ticks(message) {
                    self.steer(tick);
                    self.feed.tick(tick);
                }
                self.lanes.begin_anew()?;
                self.knowledge = Knowledge::Resumed(Agreement::default());
            }
            Knowledge::Resumed(_) => {
                for tick in ticks(message) {
                    self.tick(tick)?;
                }
                self.pump.pump();
                if let Knowledge::Resumed(agreement) = &mut self.knowledge {
                    ticks(message).for_each(|tick| agreement.run(tick));
                    agreement.window(&self.said);
                }
            }
            Knowledge::Over => {}
        }
        Ok(())
    }

    /// Learns of a voice, and tells the pump, so that it sees with the same probes.
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
        // Whoever hears is there as long as this is.
        let _heard = self.told.send(voice(key, &played, origin));
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
            if 0 < tick && !self.is_lost() && self.feed.begins_late(tick) {
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
        self.desk.drain();
        self.ticks += u64::from(done.is_some() && !self.is_lost());
        self.last = tick;
        Ok(())
    }

    fn finish(mut self) -> Replayed {
        if self.is_lost() {
            self.end_part();
        } else {
            self.end_run();
        }
        if self.whole_until.is_some() {
            // What could not be read at the end is the reason, or one of them.
            self.missing.begin();
        }
        let Comparison { compared, different, first, .. } = self.comparison;
        Replayed {
            scene: self.scene.name,
            ticks: self.ticks,
            recorded: self.recorded,
            compared,
            different,
            first_difference: first,
            incomplete_from: self.whole_until,
            missing: self.missing.list,
            faults: self.faults,
            strikes: self.strikes,
        }
    }

    /// Ends what was compared up to the end of the recording.
    fn end_run(&mut self) {
        self.pump.pump();
        let mut is_torn = self.comparison.forget_unrun() || !self.missing.list.is_empty();
        self.comparison.window(self.last, &self.said);
        let timed = self.comparison.n_sent();
        // Ends the notes, as the run did.
        self.desk.end_notes(self.comparison.ending());
        self.pump.pump();
        self.comparison.window(self.last, &self.said);
        self.comparison.sort_sent(timed);
        is_torn |= self.comparison.lacks_end(timed);
        if is_torn {
            self.comparison.tear(timed);
        }
        let gap = self.feed.gap();
        if gap.is_none() {
            self.comparison.finish(self.last, timed);
        }
        self.whole_until = gap.or_else(|| is_torn.then_some(self.last + 1));
    }
}
