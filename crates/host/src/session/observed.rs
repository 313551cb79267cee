//! A run's telemetry: from the tick's taps to the pump, and the pump's thread.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::time::Duration;

use scheduler::observation::FollowedKeys;
use scheduler::port::{FinishedTick, TickObserver};
use telemetry::Catalogue;

use super::SessionError;
use crate::adapters::observer::TickPublisher;
use crate::adapters::tap::TickRecorder;
use crate::control::RunHandle;
use crate::observe::{self, Origin, Pulses, TelemetryMessage, TelemetryThread};
use realtime::clock;
use scene::{KeyVoice, Scene};

/// Time between two looks at the rings: a frame of a screen.
const LOOK: Duration = Duration::from_millis(16);

/// Both who watch the tick.
pub(crate) struct Watchers {
    pub(crate) publisher: TickPublisher,
    pub(crate) tap: TickRecorder,
}

impl TickObserver for Watchers {
    fn followed(&mut self) -> FollowedKeys {
        self.tap.followed()
    }

    fn observe(&mut self, seen: &FinishedTick<'_>) {
        self.publisher.observe(seen);
        self.tap.observe(seen);
    }
}

/// What becomes of what was tapped.
pub(super) struct ObservedOutputs {
    pulses: Pulses,
    pump: Box<TelemetryThread>,
    catalogue: Box<Catalogue>,
    told: mpsc::Sender<TelemetryMessage>,
}

/// A tap for a run of `scene` with ticks of `period` (s), and where it leads.
pub(super) fn connect(
    scene: &Scene,
    period: f64,
    patchbay: &RunHandle,
) -> Result<(TickRecorder, ObservedOutputs), SessionError> {
    let (tap, tapped) = TickRecorder::new();
    let (pulses, times) = Pulses::new();
    let (tell, told) = mpsc::channel();
    let pump = TelemetryThread::new(tapped, times, told, clock::from_seconds(period).as_u64());
    let pump = pump.map_err(std::io::Error::other)?;
    patchbay.connect(tell.clone());
    let catalogue = Box::new(observe::catalogue(scene));
    Ok((tap, ObservedOutputs { pulses, pump, catalogue, told: tell }))
}

/// What is told of a voice that the scene asks for.
pub(super) fn of_scene(key: usize, voice: &KeyVoice, revision: u32) -> TelemetryMessage {
    let origin = Origin { revision, instrument: None, writer: "scene", kept: false };
    observe::voice(u8::try_from(key).unwrap_or(u8::MAX), voice, origin)
}

impl ObservedOutputs {
    /// For others who tell.
    pub(super) fn teller(&self) -> mpsc::Sender<TelemetryMessage> {
        self.told.clone()
    }

    /// The loop's end and the pump, once tick 0 is due at `began` (ns since 1970).
    pub(super) fn begin(self, began: u64) -> (Pulses, Box<TelemetryThread>) {
        let Self { pulses, mut pump, catalogue, told: _ } = self;
        pump.begin(began, *catalogue);
        (pulses, pump)
    }
}

/// A pump on its own thread.
#[derive(Debug)]
pub(super) struct Pumping {
    stop: Arc<AtomicBool>,
    thread: std::thread::JoinHandle<()>,
}

impl Pumping {
    /// Starts pumping.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(super) fn start(mut pump: Box<TelemetryThread>) -> std::io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        let thread =
            std::thread::Builder::new().name("letoff-telemetry".into()).spawn(move || {
                while !its_stop.load(Ordering::Acquire) {
                    pump.pump();
                    std::thread::park_timeout(LOOK);
                }
                pump.pump();
            })?;
        Ok(Self { stop, thread })
    }

    /// Pumps what is left, and waits until all sinks are closed.
    ///
    /// # Errors
    /// If the thread panicked, which is a bug.
    pub(super) fn finish(self) -> std::thread::Result<()> {
        self.stop.store(true, Ordering::Release);
        self.thread.thread().unpark();
        self.thread.join()
    }
}
