//! The MIDI side of the rings: what was struck becomes messages, and is remembered.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use hdrhistogram::Histogram;
use midi::{EventKind, KeyEvent, Output, Player, VelocityCurve};
use performance::Struck;
use rtrb::Consumer;
use scheduler::time::Nanos;

use crate::bell::Bell;
use crate::realtime::clock;
use crate::realtime::thread::{DEFAULT_PRIORITY, ask_for_fifo};
use crate::session::whole;

/// Longest wait without a bell: ports that vanished are looked for this often.
const PATIENCE: Duration = Duration::from_millis(50);

/// Below the tick, above the rest: a late note is heard, a late force is felt.
const PRIORITY: u8 = DEFAULT_PRIORITY - 10;

/// An output of any kind.
pub type AnyOutput = Box<dyn Output + Send>;

/// Takes key events out of the ring and plays them.
pub struct Desk {
    events: Consumer<KeyEvent>,
    player: Player<AnyOutput>,
    curve: VelocityCurve,
    struck: Vec<Struck>,
    /// The first error of the output; later ones of the same kind are counted.
    trouble: Option<String>,
    n_troubles: u64,
}

/// What a desk has seen when it is closed.
#[derive(Debug)]
pub struct Played {
    /// Every strike with its velocity.
    pub struck: Vec<Struck>,
    /// The first error of the output.
    pub trouble: Option<String>,
    /// How many messages could not be sent.
    pub n_troubles: u64,
    /// Strikes: handed over − happened [ns], in real time.
    pub handover: Option<Histogram<u64>>,
}

impl std::fmt::Debug for Desk {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Desk").field("struck", &self.struck.len()).finish_non_exhaustive()
    }
}

impl Desk {
    /// A desk between `events` and `output`.
    pub fn new(events: Consumer<KeyEvent>, output: AnyOutput, curve: VelocityCurve) -> Self {
        let player = Player::new(output, curve);
        Self { events, player, curve, struck: Vec::new(), trouble: None, n_troubles: 0 }
    }

    /// Plays all that is in the ring, at once.
    pub fn drain(&mut self) {
        while let Ok(event) = self.events.pop() {
            self.play(event);
        }
    }

    /// Plays from the ring whenever `bell` rings, each event at its time after `start`,
    /// until `stop`.
    pub fn attend(
        &mut self,
        bell: &Bell,
        start: Nanos,
        stop: &AtomicBool,
        handover: &mut Histogram<u64>,
    ) {
        loop {
            let last_round = stop.load(Ordering::Acquire);
            self.play_due(start, handover);
            if last_round {
                return;
            }
            let now = clock::monotonic().since(start).as_secs_f64();
            if let Err(away) = self.player.poll(now) {
                // Nothing was lost by looking.
                self.trouble.get_or_insert_with(|| away.to_string());
            }
            bell.wait(PATIENCE);
        }
    }

    /// Plays what is in the ring, each event at its time after `start`.
    fn play_due(&mut self, start: Nanos, handover: &mut Histogram<u64>) {
        while let Ok(event) = self.events.pop() {
            let due = start.after(Nanos::new(whole(event.at * 1e9)));
            // The tick sees up to one period ahead: wait for the event's own time.
            clock::sleep_until(due);
            self.play(event);
            if matches!(event.kind, EventKind::Strike { .. }) {
                handover.saturating_record(clock::monotonic().since(due).as_u64());
            }
        }
    }

    /// Ends all notes and finishes the output.
    pub fn close(mut self, handover: Option<Histogram<u64>>) -> Played {
        let silenced = self.player.silence();
        self.note(silenced);
        let finished = self.player.finish();
        self.note(finished);
        Played { struck: self.struck, trouble: self.trouble, n_troubles: self.n_troubles, handover }
    }

    fn play(&mut self, event: KeyEvent) {
        if let EventKind::Strike { speed } = event.kind {
            let velocity = self.curve.velocity(speed).get();
            self.struck.push(Struck { key: event.key, at: event.at, velocity });
        }
        let played = self.player.play(event);
        self.note(played);
    }

    fn note(&mut self, result: Result<(), midi::SendError>) {
        if let Err(error) = result {
            self.n_troubles += 1;
            self.trouble.get_or_insert_with(|| error.to_string());
        }
    }
}

/// A desk on its own thread.
#[derive(Debug)]
pub struct Attended {
    stop: Arc<AtomicBool>,
    bell: Arc<Bell>,
    thread: std::thread::JoinHandle<Played>,
}

impl Attended {
    /// Starts attending; event times count from `start`.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(
        mut desk: Box<Desk>,
        bell: Arc<Bell>,
        start: Nanos,
        mut handover: Histogram<u64>,
    ) -> std::io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let (its_stop, its_bell) = (Arc::clone(&stop), Arc::clone(&bell));
        let thread = std::thread::Builder::new().name("letoff-midi".into()).spawn(move || {
            let _as_the_tick_reports = ask_for_fifo(Some(PRIORITY));
            desk.attend(&its_bell, start, &its_stop, &mut handover);
            desk.close(Some(handover))
        })?;
        Ok(Self { stop, bell, thread })
    }

    /// Plays what is left, ends all notes, and returns what was seen.
    ///
    /// # Errors
    /// If the thread panicked; its notes were ended while it unwound.
    pub fn finish(self) -> std::thread::Result<Played> {
        self.stop.store(true, Ordering::Release);
        self.bell.ring();
        self.thread.join()
    }
}
