//! The parts of a run that requests reach: its voices, its keys, its telemetry and its stop.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};

use documents::escaped;
use engine::realtime::pool::{VoiceChange, VoiceSwaps};
use engine::voice::AuditCell;
use firmware_protocol::key::KeyIndex;
use haptics::HandCommand;
use pode::EnergyAudit;
use rtrb::Producer;
use telemetry::recording::RecordingLimits;
use telemetry::{Log, Update, log};

use super::key_port::{KeyPort, Lights};
use super::voice_port::VoicePort;
use super::{BackgroundWork, EmergencyStop, FingerOwner, FingerQueue, NOT_RUNNING, RunStatus};
use crate::observe::{RecordingHandle, TelemetryMessage};

/// The way from requests into a run, from its preparation to its end.
///
/// It is off the tick on both sides: the tick sees the rings behind it, and the one load of
/// [`EmergencyStop::is_asked`].
#[derive(Debug, Default)]
pub struct RunHandle {
    pub emergency: EmergencyStop,
    /// What is done for it beside the tick.
    pub background: BackgroundWork,
    /// What it does, for whoever asks.
    pub status: Arc<RunStatus>,
    /// The socket of the guardian that is to hold its MIDI port; none holds it otherwise.
    guardian: Option<PathBuf>,
    voices: Mutex<VoicePort>,
    keys: Mutex<KeyPort>,
    telemetry: Mutex<TelemetryPort>,
}

/// The way to the telemetry thread of a run.
#[derive(Debug, Default)]
struct TelemetryPort {
    sender: Option<mpsc::Sender<TelemetryMessage>>,
    /// The recording that was begun by a request.
    recording: Option<RecordingHandle>,
}

/// What holds its notes.
impl RunHandle {
    /// Returns the handle of a run whose MIDI port is held by the guardian at `path`; this
    /// program must be one that can be started as a guardian.
    pub fn guarded_at(path: PathBuf) -> Self {
        Self { guardian: Some(path), ..Self::default() }
    }

    /// Returns the socket of its guardian, if it is to have one.
    pub(crate) fn guardian(&self) -> Option<&Path> {
        self.guardian.as_deref()
    }
}

/// Changes of its voices, and their energy audits.
impl RunHandle {
    /// Lets changes of voices in.
    pub fn open(&self, swaps: VoiceSwaps) {
        lock(&self.voices).swaps = Some(swaps);
    }

    /// Lets no more changes of voices in.
    pub fn close(&self) {
        lock(&self.voices).swaps = None;
    }

    /// Returns the next number of a voice, from 1.
    pub fn new_revision(&self) -> u32 {
        lock(&self.voices).new_revision()
    }

    /// Returns the cell in which one more voice publishes its energy audit.
    pub fn new_cell(&self) -> Arc<AuditCell> {
        lock(&self.voices).new_cell()
    }

    /// Returns the audits of all voices together.
    pub fn energy(&self) -> EnergyAudit {
        lock(&self.voices).energy()
    }

    /// Sends `changes` to the voices of their keys, after `messages` to telemetry; all or none.
    ///
    /// # Errors
    /// Why none was taken, in a sentence.
    pub fn send(
        &self,
        changes: Vec<(usize, VoiceChange)>,
        messages: Vec<TelemetryMessage>,
    ) -> Result<(), String> {
        let tell = || messages.into_iter().for_each(|it| self.tell(it));
        lock(&self.voices).send(changes, tell)
    }
}

/// Fingers and lights of its keys, and the way to them.
impl RunHandle {
    /// Lets boards show their lights.
    pub fn lend_lights(&self, lights: Lights) {
        *lock(&self.keys) = KeyPort::Boards(lights);
    }

    /// Lets simulated keys be pressed.
    pub fn lend_fingers(&self, hands: Producer<(KeyIndex, HandCommand)>) {
        *lock(&self.keys) = KeyPort::Simulated(FingerQueue::new(hands));
    }

    /// Presses a simulated key or grips it for `by`; no weight releases it.
    ///
    /// # Errors
    /// If there is no such key, or it is a real one, or too much is waiting, in a sentence.
    pub fn press(&self, key: u8, hand: HandCommand, by: FingerOwner) -> Result<(), String> {
        lock(&self.keys).press(key, hand, by)
    }

    /// Releases all keys that the client with this connection has pressed, and cancels what it
    /// waits for.
    pub fn leave(&self, connection: u64) {
        self.background.cancel(connection);
        lock(&self.keys).leave(connection);
    }

    /// Has a board show its light.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn identify(&self, line: u32, board: u32) -> Result<String, String> {
        lock(&self.keys).identify(line, board)
    }
}

/// Messages to its telemetry thread.
impl RunHandle {
    /// Sends messages to telemetry by `sender` from now on.
    pub fn connect(&self, sender: mpsc::Sender<TelemetryMessage>) {
        lock(&self.telemetry).sender = Some(sender);
    }

    /// Sends `message` to the telemetry thread, if there is one.
    pub fn tell(&self, message: TelemetryMessage) {
        lock(&self.telemetry).tell(message);
    }

    /// Writes a sentence into the host's log.
    pub fn log(&self, text: String) {
        let entry = Log { level: log::Level::Info.into(), text };
        self.tell(TelemetryMessage::Update(Box::new(Update::Log(entry))));
    }

    /// Records the whole run into `file`, whatever is begun by requests.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn record_run(
        &self,
        file: &Path,
        limits: RecordingLimits,
    ) -> Result<RecordingHandle, String> {
        lock(&self.telemetry).begin(file, limits)
    }

    /// Begins to record into `file`, or ends what was begun so.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn record(&self, file: Option<&str>, limits: RecordingLimits) -> Result<String, String> {
        let mut telemetry = lock(&self.telemetry);
        let done = telemetry.record(file, limits)?;
        self.status.records(telemetry.recording.clone());
        Ok(done)
    }
}

impl TelemetryPort {
    fn tell(&self, message: TelemetryMessage) {
        if let Some(sender) = &self.sender {
            // A thread that has ended needs no more messages.
            let _gone = sender.send(message);
        }
    }

    fn begin(&self, file: &Path, limits: RecordingLimits) -> Result<RecordingHandle, String> {
        let sender = self.sender.as_ref().ok_or(NOT_RUNNING)?;
        RecordingHandle::begin(file, limits, sender).map_err(|error| error.to_string())
    }

    fn record(&mut self, file: Option<&str>, limits: RecordingLimits) -> Result<String, String> {
        if self.sender.is_none() {
            return Err(NOT_RUNNING.to_owned());
        }
        let Some(file) = file else {
            let going = self.recording.take().ok_or("nothing is recorded that could be ended")?;
            going.stop();
            return Ok(format!("{} is complete in a moment", going.report().file));
        };
        if let Some(going) = self.recording.as_ref().filter(|it| it.report().trouble.is_none()) {
            return Err(format!("{} is being recorded: end it first", going.report().file));
        }
        self.recording = Some(self.begin(Path::new(file), limits)?);
        Ok(format!("{} is being recorded", escaped(file)))
    }
}

/// Locks `mutex`; a thread that panicked left it whole, since every change is one assignment or
/// push.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
