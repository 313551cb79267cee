//! A run's telemetry: path from the tick's recorder to the telemetry thread.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::time::Duration;

use midi::PedalMove;
use scheduler::observation::FollowedKeys;
use scheduler::port::{FinishedTick, TickObserver};
use telemetry::Catalogue;

use super::play_list::RehearsedPlayList;
use super::unit_costs::UnitCosts;
use super::{RunOptions, SessionError};
use crate::adapters::observer::{LiveCounters, TickPublisher};
use crate::adapters::tick_recorder::TickRecorder;
use crate::control::{RunDescription, RunHandle, is_absent};
use crate::observe::{self, Origin, Pulses, TelemetryMessage, TelemetryThread};
use crate::report::MidiReport;
use engine::realtime::clock;
use engine::realtime::pool::BoxedVoice;
use engine::voice::VoiceBuilder;
use scene::{KeyVoice, Scene};

/// Interval of the polls of the rings: one frame of a screen.
const LOOK: Duration = Duration::from_millis(16);

pub(crate) struct Watchers {
    pub(crate) publisher: TickPublisher,
    pub(crate) recorder: TickRecorder,
}

impl TickObserver for Watchers {
    fn followed(&mut self) -> FollowedKeys {
        self.recorder.followed()
    }

    fn observe(&mut self, seen: &FinishedTick<'_>) {
        self.publisher.observe(seen);
        self.recorder.observe(seen);
    }
}

pub(super) struct ObservedOutputs {
    pulses: Pulses,
    telemetry: Box<TelemetryThread>,
    catalogue: Box<Catalogue>,
    sender: mpsc::Sender<TelemetryMessage>,
}

/// Returns the tick's recorder for ticks of `period` (s), and its outputs.
pub(super) fn connect(
    scene: &Scene,
    period: f64,
    handle: &RunHandle,
) -> Result<(TickRecorder, ObservedOutputs), SessionError> {
    let (recorder, rings) = TickRecorder::new();
    let (pulses, times) = Pulses::new();
    let (sender, messages) = mpsc::channel();
    let telemetry =
        TelemetryThread::new(rings, times, messages, clock::from_seconds(period).as_u64());
    let telemetry = telemetry.map_err(std::io::Error::other)?;
    handle.connect(sender.clone());
    let models = observe::distinct(scene.keys.iter().flatten().map(|voice| &voice.model));
    let catalogue = Box::new(observe::catalogue(scene, &models));
    Ok((recorder, ObservedOutputs { pulses, telemetry, catalogue, sender }))
}

pub(super) fn voices(
    builder: &VoiceBuilder<'_>,
    handle: &RunHandle,
    options: RunOptions,
) -> Result<(Vec<(usize, BoxedVoice)>, UnitCosts), SessionError> {
    let mut voices = Vec::new();
    let mut costs = UnitCosts::default();
    for (key, voice) in builder.keys() {
        let revision = handle.new_revision();
        handle.tell(of_scene(key, voice, revision));
        let voice = builder.numbered(voice, handle.new_cell(), revision)?;
        // In virtual time a unit has a constant cost.
        if !options.virtual_time {
            costs.try_voice(&voice, builder.period());
        }
        voices.push((key, voice as BoxedVoice));
    }
    Ok((voices, costs))
}

/// Returns the pedals of a play list, and sends all of them to telemetry beforehand.
pub(super) fn pedals(list: Option<&RehearsedPlayList>, handle: &RunHandle) -> Vec<PedalMove> {
    let Some(RehearsedPlayList { performance, pass, .. }) = list else { return Vec::new() };
    for pedal in &performance.pedals {
        let event = telemetry::Update::Event(observe::pedal(*pedal, *pass));
        handle.tell(TelemetryMessage::Update(Box::new(event)));
    }
    performance.pedals.clone()
}

/// Describes the run for clients.
pub(super) fn describe(
    handle: &RunHandle,
    (scene, pass): (&Scene, Option<u64>),
    midi: &MidiReport,
    counters: &Arc<LiveCounters>,
) {
    let voices = scene.keys.iter().flatten().count();
    let absent = (0..).zip(0..scene.keys.len()).filter(|(_, key)| is_absent(scene, *key));
    handle.status.describe(RunDescription {
        tick_hz: scene.tick_hz,
        pass,
        voices: u32::try_from(voices).unwrap_or(u32::MAX),
        midi: midi.words(),
        absent: absent.map(|(number, _)| number).collect(),
        counters: Arc::clone(counters),
    });
}

fn of_scene(key: usize, voice: &KeyVoice, revision: u32) -> TelemetryMessage {
    let origin = Origin { revision, instrument: None, writer: "scene", kept: false };
    observe::voice(u8::try_from(key).unwrap_or(u8::MAX), voice, origin)
}

impl ObservedOutputs {
    pub(super) fn sender(&self) -> mpsc::Sender<TelemetryMessage> {
        self.sender.clone()
    }

    pub(super) fn begin(self, began: u64) -> (Pulses, Box<TelemetryThread>) {
        let Self { pulses, mut telemetry, catalogue, sender: _ } = self;
        telemetry.begin(began, *catalogue);
        (pulses, telemetry)
    }
}

#[derive(Debug)]
pub(super) struct RunningTelemetry {
    stop: Arc<AtomicBool>,
    thread: std::thread::JoinHandle<()>,
}

impl RunningTelemetry {
    pub(super) fn start(mut telemetry: Box<TelemetryThread>) -> std::io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        let thread =
            std::thread::Builder::new().name("letoff-telemetry".into()).spawn(move || {
                while !its_stop.load(Ordering::Acquire) {
                    telemetry.pump();
                    std::thread::park_timeout(LOOK);
                }
                telemetry.pump();
            })?;
        Ok(Self { stop, thread })
    }

    /// Handles the rest, and waits until all sinks are closed.
    ///
    /// # Errors
    /// If the thread panicked, which is a bug.
    pub(super) fn finish(self) -> std::thread::Result<()> {
        self.stop.store(true, Ordering::Release);
        self.thread.thread().unpark();
        self.thread.join()
    }
}
