//! What a run shares with those who switch its voices: the way in, and the audits.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};

use firmware_protocol::key::KeyIndex;
use hardware::rt::board_supervisor::LIGHT_S;
use pode::EnergyAudit;
use rtrb::Producer;
use telemetry::{Log, Update, log};

use super::{Connection, EmergencyStop, FingerQueue};
use crate::observe::{RecordingHandle, TelemetryMessage};
use realtime::pool::{BoxedVoice, VoiceSwaps, Way};
use voice::AuditCell;

/// Off the tick on both sides; the tick itself only sees the rings behind it.
#[derive(Debug, Default)]
pub struct RunHandle {
    /// The way into the lanes, while there are any.
    swaps: Mutex<Option<VoiceSwaps>>,
    /// The audits of all voices that ever played.
    audits: Mutex<Audits>,
    pub emergency: EmergencyStop,
    /// The fingers of a simulated keybed.
    fingers: Mutex<Option<FingerQueue>>,
    lights: Mutex<Option<Lights>>,
    /// What is being recorded since somebody asked for it.
    recording: Mutex<Option<RecordingHandle>>,
    voices: AtomicU32,
    told: Mutex<Option<mpsc::Sender<TelemetryMessage>>>,
}

/// What is said of a host that is being prepared, or has ended.
const NOT_RUNNING: &str = "the host is not running yet, or not any more";

/// What the voices of a run did with energy.
#[derive(Debug, Default)]
struct Audits {
    /// Of voices that are gone.
    settled: EnergyAudit,
    /// Of those that somebody holds.
    open: Vec<Arc<AuditCell>>,
}

/// The boards of a run, and the way to their lights.
#[derive(Debug)]
pub struct Lights {
    /// In the order in which the bus has them.
    pub boards: Vec<IdentifyTarget>,
    /// Takes a place among them.
    pub sought: Producer<usize>,
}

/// A board that has a light.
#[derive(Debug)]
pub struct IdentifyTarget {
    /// Which link it is on.
    pub line: u32,
    /// What that is called.
    pub name: String,
    pub board: u32,
}

impl std::fmt::Display for IdentifyTarget {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "board {} on {} (link {})", self.board, self.name, self.line)
    }
}

impl RunHandle {
    /// Lets voices in.
    pub fn open(&self, swaps: VoiceSwaps) {
        *lock(&self.swaps) = Some(swaps);
    }

    /// Lets no more voices in.
    pub fn close(&self) {
        *lock(&self.swaps) = None;
    }

    /// Tells `told` of what is sent from now on.
    pub fn connect(&self, told: mpsc::Sender<TelemetryMessage>) {
        *lock(&self.told) = Some(told);
    }

    /// Tells whoever observes, if anybody does.
    pub fn tell(&self, told: TelemetryMessage) {
        if let Some(sender) = lock(&self.told).as_ref() {
            // Who does not listen any more need not know.
            let _gone = sender.send(told);
        }
    }

    /// Writes a sentence into the host's log.
    pub fn log(&self, text: String) {
        let entry = Log { level: log::Level::Info.into(), text };
        self.tell(TelemetryMessage::Update(Box::new(Update::Log(entry))));
    }

    /// A number for one more voice, from 1.
    pub fn new_revision(&self) -> u32 {
        self.voices.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Sends `voices` to their keys, after those who observe were told; all of them or none.
    ///
    /// # Errors
    /// Why none was taken, in a sentence.
    pub fn send(
        &self,
        voices: Vec<(usize, BoxedVoice)>,
        way: Way,
        told: Vec<TelemetryMessage>,
    ) -> Result<usize, String> {
        let mut swaps = lock(&self.swaps);
        let swaps = swaps.as_mut().ok_or(NOT_RUNNING)?;
        let n = voices.len();
        let keys: Vec<_> = voices.iter().map(|(key, _voice)| *key).collect();
        swaps.refuse_without_room(&keys)?;
        for it in told {
            self.tell(it);
        }
        for (key, voice) in voices {
            swaps.send(key, voice, way).map_err(|refused| format!("key {key}: {refused}"))?;
        }
        Ok(n)
    }

    /// Lets a board show its light.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn identify(&self, line: u32, board: u32) -> Result<String, String> {
        let mut lights = lock(&self.lights);
        let Lights { boards, sought } = lights
            .as_mut()
            .ok_or_else(|| self.lack("these keys are simulated here, and have no lights"))?;
        let which = boards.iter().position(|it| (it.line, it.board) == (line, board));
        let which = which.ok_or_else(|| {
            let all: Vec<_> = boards.iter().map(IdentifyTarget::to_string).collect();
            format!("there is no board {board} on link {line}, but {}", all.join(", "))
        })?;
        sought.push(which).map_err(|_full| "too many lights are wanted at once; try again")?;
        Ok(format!("{} is asked to show its light for {LIGHT_S} s", boards[which]))
    }

    /// Begins to record into `file`, or ends.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn record(&self, file: Option<&str>) -> Result<String, String> {
        let mut recording = lock(&self.recording);
        if lock(&self.told).is_none() {
            return Err(NOT_RUNNING.to_owned());
        }
        let Some(file) = file else {
            let going = recording.take().ok_or("nothing is recorded that could be ended")?;
            going.stop();
            return Ok(format!("{} is complete in a moment", going.report().file));
        };
        if let Some(going) = recording.as_ref().filter(|it| it.report().trouble.is_none()) {
            return Err(format!("{} is being recorded: end it first", going.report().file));
        }
        let begun = RecordingHandle::begin(std::path::Path::new(file));
        let (begun, sink) = begun.map_err(|error| error.to_string())?;
        *recording = Some(begun);
        self.tell(TelemetryMessage::Sink(sink));
        Ok(format!("{file} is being recorded"))
    }

    /// Lets boards show their lights.
    pub fn lend_lights(&self, lights: Lights) {
        *lock(&self.lights) = Some(lights);
    }

    /// Lets weights be laid on simulated keys.
    pub fn lend_fingers(&self, weights: Producer<(KeyIndex, f64)>) {
        *lock(&self.fingers) = Some(FingerQueue::new(weights));
    }

    /// Presses a simulated key with `newtons` for `by`; 0 lets go.
    ///
    /// # Errors
    /// If there is no such key, or it is a real one, or too much is waiting, in a sentence.
    pub fn press(&self, key: u8, newtons: f64, by: Connection) -> Result<(), String> {
        /// A finger's weight and a blow with it (N).
        const HARDEST: f64 = 50.0;
        let key =
            KeyIndex::new(key).ok_or_else(|| format!("there is no key {key}, give 0 to 87"))?;
        if !(0.0..=HARDEST).contains(&newtons) {
            return Err(format!("a key is pressed with 0 to {HARDEST} N, not {newtons}"));
        }
        let mut fingers = lock(&self.fingers);
        let fingers = fingers.as_mut();
        let fingers =
            fingers.ok_or_else(|| self.lack("these keys are real: press them yourself"))?;
        fingers.press(key, newtons, by)
    }

    /// Lets go of all keys that the client with this connection has pressed.
    pub fn leave(&self, connection: u64) {
        if let Some(fingers) = lock(&self.fingers).as_mut() {
            fingers.leave(connection);
        }
    }

    /// Why something is not there: `why`, or that the host does not run.
    fn lack(&self, why: &'static str) -> &'static str {
        if lock(&self.swaps).is_some() { why } else { NOT_RUNNING }
    }

    /// A place for one more voice's energy audit.
    pub fn new_cell(&self) -> Arc<AuditCell> {
        let cell = Arc::new(AuditCell::default());
        let mut audits = lock(&self.audits);
        audits.settle();
        audits.open.push(Arc::clone(&cell));
        cell
    }

    /// The audits of all voices together.
    pub fn energy(&self) -> EnergyAudit {
        let audits = lock(&self.audits);
        let mut sum = audits.settled;
        audits.open.iter().for_each(|cell| sum.add(&cell.read()));
        sum
    }
}

impl Audits {
    /// Sums up the voices that are gone: a slider leaves many behind in a second.
    fn settle(&mut self) {
        let settled = &mut self.settled;
        self.open.retain(|cell| {
            let plays = 1 < Arc::strong_count(cell);
            if !plays {
                settled.add(&cell.read());
            }
            plays
        });
    }
}

/// What a panicking thread left behind is whole: every change is one assignment or push.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn voices_that_are_gone_stay_in_the_sum_and_take_no_room() {
        let patchbay = RunHandle::default();
        let audit = EnergyAudit { supplied: 1.0, ..EnergyAudit::default() };
        for _ in 0..100 {
            patchbay.new_cell().publish(&audit);
        }
        let plays = patchbay.new_cell();
        plays.publish(&audit);
        assert_eq!(patchbay.energy().supplied.to_bits(), 101.0_f64.to_bits());
        assert_eq!(lock(&patchbay.audits).open.len(), 1);
    }

    #[test]
    fn a_board_that_is_not_there_is_refused_with_those_that_are() {
        let patchbay = RunHandle::default();
        let refused = patchbay.identify(0, 3).unwrap_err();
        assert!(refused.contains("not running yet"), "{refused}");
        let (sought, mut shown) = rtrb::RingBuffer::new(1);
        let lit = |line, board| IdentifyTarget { line, name: format!("can{line}"), board };
        patchbay.lend_lights(Lights { boards: vec![lit(0, 3), lit(1, 3)], sought });
        let refused = patchbay.identify(0, 4).unwrap_err();
        assert!(refused.contains("board 3 on can1 (link 1)"), "{refused}");
        assert_eq!(
            patchbay.identify(1, 3).unwrap(),
            "board 3 on can1 (link 1) is asked to show its light for 10 s"
        );
        assert_eq!(shown.pop(), Ok(1));
    }
}
