//! What a run shares with those who switch its voices: the way in, and the audits.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};

use firmware_protocol::key::KeyIndex;
use pode::EnergyAudit;
use rtrb::Producer;

use crate::adapters::audit::AuditCell;
use crate::observe::{Recording, Told};
use crate::realtime::pool::{BoxedVoice, VoiceSwaps, Way};

/// Off the tick on both sides; the tick itself only sees the rings behind it.
#[derive(Debug, Default)]
pub struct Patchbay {
    /// The way into the lanes, while there are any.
    swaps: Mutex<Option<VoiceSwaps>>,
    /// The audits of all voices that ever played.
    cells: Mutex<Vec<Arc<AuditCell>>>,
    /// Everything shall stop.
    alarm: AtomicBool,
    /// Every board was told to.
    stopped: AtomicBool,
    /// To the fingers of a simulated keybed.
    weights: Mutex<Option<Producer<(KeyIndex, f64)>>>,
    /// What is being recorded since somebody asked for it.
    recording: Mutex<Option<Recording>>,
    /// Voices so far.
    voices: AtomicU32,
    /// To whoever observes.
    told: Mutex<Option<mpsc::Sender<Told>>>,
}

impl Patchbay {
    /// Lets voices in.
    pub fn open(&self, swaps: VoiceSwaps) {
        *lock(&self.swaps) = Some(swaps);
    }

    /// Lets no more voices in.
    pub fn close(&self) {
        *lock(&self.swaps) = None;
    }

    /// Tells `told` of what is sent from now on.
    pub fn connect(&self, told: mpsc::Sender<Told>) {
        *lock(&self.told) = Some(told);
    }

    /// Tells whoever observes, if anybody does.
    pub fn tell(&self, told: Told) {
        if let Some(sender) = lock(&self.told).as_ref() {
            // Who does not listen any more need not know.
            let _gone = sender.send(told);
        }
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
        told: Vec<Told>,
    ) -> Result<usize, String> {
        let mut swaps = lock(&self.swaps);
        let swaps = swaps.as_mut().ok_or("the host is not running yet, or not any more")?;
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
        let _ = (line, board);
        Err("the boards of a running host cannot show their lights yet: use `letoff devices \
             --light` while it does not run"
            .into())
    }

    /// Begins to record into `file`, or ends.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn record(&self, file: Option<&str>) -> Result<String, String> {
        let mut recording = lock(&self.recording);
        let Some(file) = file else {
            let going = recording.take().ok_or("nothing is recorded that could be ended")?;
            going.stop();
            return Ok(format!("{} is complete in a moment", going.report().file));
        };
        if let Some(going) = recording.as_ref().filter(|it| it.report().trouble.is_none()) {
            return Err(format!("{} is being recorded: end it first", going.report().file));
        }
        let begun = Recording::begin(std::path::Path::new(file));
        let (begun, sink) = begun.map_err(|error| error.to_string())?;
        *recording = Some(begun);
        self.tell(Told::Sink(sink));
        Ok(format!("{file} is being recorded"))
    }

    /// Lets weights be laid on simulated keys.
    pub fn lend_fingers(&self, weights: Producer<(KeyIndex, f64)>) {
        *lock(&self.weights) = Some(weights);
    }

    /// Presses a simulated key with `newtons`; 0 lets go.
    ///
    /// # Errors
    /// If there is no such key, or it is a real one, or too much is waiting, in a sentence.
    pub fn press(&self, key: u8, newtons: f64) -> Result<(), String> {
        /// A finger's weight and a blow with it [N].
        const HARDEST: f64 = 50.0;
        let key =
            KeyIndex::new(key).ok_or_else(|| format!("there is no key {key}, give 0 to 87"))?;
        if !(0.0..=HARDEST).contains(&newtons) {
            return Err(format!("a key is pressed with 0 to {HARDEST} N, not {newtons}"));
        }
        let mut weights = lock(&self.weights);
        let weights = weights.as_mut().ok_or("these keys are real: press them yourself")?;
        let pushed = weights.push((key, newtons));
        pushed.map_err(|_full| "too many keys are pressed at once; try again".to_owned())
    }

    /// Ends the run with the next tick, without a ramp.
    pub fn sound_alarm(&self) {
        self.alarm.store(true, Ordering::Release);
    }

    /// Whether everything shall stop.
    ///
    /// # Real-time
    /// One load.
    pub fn is_alarmed(&self) -> bool {
        self.alarm.load(Ordering::Acquire)
    }

    /// Says that every board was told to render no force.
    pub fn note_stopped(&self) {
        self.stopped.store(true, Ordering::Release);
    }

    /// Whether every board was told to render no force until it is seen to.
    pub fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Acquire)
    }

    /// A place for one more voice's energy audit.
    pub fn new_cell(&self) -> Arc<AuditCell> {
        let cell = Arc::new(AuditCell::default());
        lock(&self.cells).push(Arc::clone(&cell));
        cell
    }

    /// The audits of all voices together.
    pub fn energy(&self) -> EnergyAudit {
        let mut sum = EnergyAudit::default();
        for cell in lock(&self.cells).iter() {
            sum.add(&cell.read());
        }
        sum
    }
}

/// What a panicking thread left behind is whole: every change is one assignment or push.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
