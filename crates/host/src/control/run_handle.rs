use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};

use documents::escaped;
use engine::realtime::pool::{VoiceChange, VoiceSwaps};
use engine::voice::AuditCell;
use firmware_protocol::key::KeyIndex;
use haptics::HandCommand;
use pode::EnergyAudit;
use rtrb::Producer;
use telemetry::{Log, Update, log, recording::RecordingLimits};

use super::key_port::{KeyPort, Lights};
use super::run_status::nanos_now;
use super::voice_port::VoicePort;
use super::{BackgroundWork, EmergencyStop, FingerOwner, FingerQueue, NOT_RUNNING, RunStatus};
use crate::observe::{LogSink, MessageSink as _, RecordingHandle, TelemetryMessage};
use crate::rehearsal_cache::RehearsalCache;

/// Access of requests to a run, from its preparation to its end.
///
/// The tick reads the rings behind it, and does the one load of [`EmergencyStop::is_asked`].
#[derive(Debug, Default)]
pub struct RunHandle {
    pub emergency: EmergencyStop,
    pub background: BackgroundWork,
    pub status: Arc<RunStatus>,
    guardian: Option<PathBuf>,
    rehearsals: Option<RehearsalCache>,
    voices: Mutex<VoicePort>,
    keys: Mutex<KeyPort>,
    telemetry: Mutex<TelemetryPort>,
    /// Log of a host whose telemetry does not run yet.
    early_log: Mutex<Option<LogSink>>,
}

#[derive(Debug, Default)]
struct TelemetryPort {
    sender: Option<mpsc::Sender<TelemetryMessage>>,
    recording: Option<RecordingHandle>,
}

impl RunHandle {
    /// Returns the handle of a run with a guardian at `path`; this program must be able to start
    /// as a guardian.
    pub fn guarded_at(path: PathBuf) -> Self {
        Self { guardian: Some(path), ..Self::default() }
    }

    /// Returns the handle of a run that looks for rehearsals in a folder, and keeps its own there.
    #[must_use]
    pub fn keeping_rehearsals(self, rehearsals: Option<RehearsalCache>) -> Self {
        Self { rehearsals, ..self }
    }

    pub(crate) const fn rehearsals(&self) -> Option<&RehearsalCache> {
        self.rehearsals.as_ref()
    }

    pub(crate) fn guardian(&self) -> Option<&Path> {
        self.guardian.as_deref()
    }
}

impl RunHandle {
    pub fn open(&self, swaps: VoiceSwaps) {
        lock(&self.voices).swaps = Some(swaps);
    }

    pub fn close(&self) {
        lock(&self.voices).swaps = None;
    }

    pub fn new_revision(&self) -> u32 {
        lock(&self.voices).new_revision()
    }

    /// Returns a new cell in which a voice publishes its energy audit.
    pub fn new_cell(&self) -> Arc<AuditCell> {
        lock(&self.voices).new_cell()
    }

    pub fn energy(&self) -> EnergyAudit {
        lock(&self.voices).energy()
    }

    /// Sends `messages` to telemetry and `changes` to voices, all or none; errors are sentences.
    pub fn send(
        &self,
        changes: Vec<(usize, VoiceChange)>,
        messages: Vec<TelemetryMessage>,
    ) -> Result<(), String> {
        let tell = || messages.into_iter().for_each(|it| self.tell(it));
        lock(&self.voices).send(changes, tell)
    }
}

impl RunHandle {
    pub fn lend_lights(&self, lights: Lights) {
        *lock(&self.keys) = KeyPort::Boards(lights);
    }

    pub fn lend_fingers(&self, hands: Producer<(KeyIndex, HandCommand)>) {
        *lock(&self.keys) = KeyPort::Simulated(FingerQueue::new(hands));
    }

    /// Presses a simulated key or grips it for `by`; no weight releases it.
    ///
    /// # Errors
    /// A sentence if the key is missing or real, or the ring is full.
    pub fn press(&self, key: u8, hand: HandCommand, by: FingerOwner) -> Result<(), String> {
        lock(&self.keys).press(key, hand, by)
    }

    /// Releases the keys and cancels the loads of `connection`.
    pub fn leave(&self, connection: u64) {
        self.background.cancel(connection);
        lock(&self.keys).leave(connection);
    }

    /// Switches on a board's light; the error is a sentence.
    pub fn identify(&self, line: u32, board: u32) -> Result<String, String> {
        lock(&self.keys).identify(line, board)
    }
}

impl RunHandle {
    /// Sets the path for messages to telemetry.
    pub fn connect(&self, sender: mpsc::Sender<TelemetryMessage>) {
        lock(&self.telemetry).sender = Some(sender);
    }

    /// Sends `message` to the telemetry thread, if there is one.
    pub fn tell(&self, message: TelemetryMessage) {
        lock(&self.telemetry).tell(message);
    }

    pub fn log(&self, text: String) {
        let entry = Update::Log(Log { level: log::Level::Info.into(), text });
        match lock(&self.early_log).as_mut() {
            Some(log) => log.take(nanos_now(), &entry),
            None => self.tell(TelemetryMessage::Update(Box::new(entry))),
        }
    }

    /// Writes to `log` until the telemetry of a run does.
    pub fn log_early(&self, log: LogSink) {
        *lock(&self.early_log) = Some(log);
    }

    /// Returns the log for the telemetry of a run, which writes to it from now on.
    pub fn take_log(&self) -> Option<LogSink> {
        lock(&self.early_log).take()
    }

    /// Records the whole run into `file`, independently of requests. The error is a sentence.
    pub fn record_run(
        &self,
        file: &Path,
        limits: RecordingLimits,
    ) -> Result<RecordingHandle, String> {
        lock(&self.telemetry).begin(file, limits)
    }

    /// Begins a recording into `file`, or ends the one that was begun so. The error is a sentence.
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

/// Locks `mutex`, also after a panic: every change is one assignment or push, so data are whole.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
