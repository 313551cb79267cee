//! What a run shares with those who switch its voices: the way in, and the audits.

use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};

use pode::EnergyAudit;

use crate::adapters::audit::AuditCell;
use crate::observe::Told;
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

    /// Sends `voices` to their keys; returns how many.
    ///
    /// # Errors
    /// Why one was not taken, in a sentence; those before it are on their way.
    pub fn send(&self, voices: Vec<(usize, BoxedVoice)>, way: Way) -> Result<usize, String> {
        let mut swaps = lock(&self.swaps);
        let swaps = swaps.as_mut().ok_or("the host is not running yet, or not any more")?;
        let n = voices.len();
        for (key, voice) in voices {
            swaps.send(key, voice, way).map_err(|refused| format!("key {key}: {refused}"))?;
        }
        Ok(n)
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
