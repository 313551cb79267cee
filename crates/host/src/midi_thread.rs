//! The thread that turns key events into MIDI messages.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use hdrhistogram::Histogram;
use midi::velocity::release_velocity;
use midi::{NoteEvent, NoteEventKind, Output, Player, Schedule, VelocityCurve};
use pianist::{Assessor, Damped, Struck};
use rtrb::Consumer;
use scheduler::time::Nanos;

use crate::adapters::observer::LiveCounters;
use engine::realtime::clock;
use engine::realtime::thread::{DEFAULT_PRIORITY, ThreadPlan};
use engine::realtime::wake_fd::WakeFd;

/// Longest wait without a wake-up, and so the interval of the search for vanished ports.
const PATIENCE: Duration = Duration::from_millis(50);

/// Priority of MIDI: below the tick, above the rest; a late force is worse than a late note.
pub(crate) const PRIORITY: u8 = DEFAULT_PRIORITY - 10;

/// End of a run for its notes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum NoteEnding {
    /// The time is over or a signal arrived: sounding notes decay normally.
    Regular,
    /// A client requested a stop: the receiver falls silent at once.
    Emergency,
}

/// A boxed output.
pub type AnyOutput = Box<dyn Output + Send>;

/// Plays the key events of the ring.
pub struct MidiDispatcher {
    events: Consumer<NoteEvent>,
    schedule: Schedule,
    player: Player<AnyOutput>,
    curve: VelocityCurve,
    assessor: Option<Assessor>,
    /// First error of the output; later ones are counted.
    trouble: Option<String>,
    n_troubles: u64,
    ticks: Option<(Arc<LiveCounters>, u64)>,
}

/// Outcome of a closed dispatcher.
#[derive(Debug)]
pub struct PlaybackSummary {
    pub assessor: Option<Assessor>,
    pub trouble: Option<String>,
    pub n_troubles: u64,
    /// Time from strike to hand-over (ns), in real time.
    pub handover: Option<Histogram<u64>>,
}

impl std::fmt::Debug for MidiDispatcher {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("MidiDispatcher").field("curve", &self.curve).finish_non_exhaustive()
    }
}

impl MidiDispatcher {
    pub fn new(events: Consumer<NoteEvent>, output: AnyOutput, curve: VelocityCurve) -> Self {
        let player = Player::new(output, curve);
        let schedule = Schedule::default();
        Self {
            events,
            schedule,
            player,
            curve,
            assessor: None,
            trouble: None,
            n_troubles: 0,
            ticks: None,
        }
    }

    pub fn assess(&mut self, assessor: Assessor) {
        self.assessor = Some(assessor);
    }

    /// Sends the output no sign of life while the tick of `counters` stands still, so that the
    /// guardian ends its notes.
    pub fn live_while_ticks_go_on(&mut self, counters: Arc<LiveCounters>) {
        self.ticks = Some((counters, 0));
    }

    /// Replaces the output, before anything is played.
    pub fn send_to(&mut self, output: AnyOutput) {
        self.player = Player::new(output, self.curve);
    }

    /// Plays the whole ring at once, in order of time.
    pub fn drain(&mut self) {
        self.collect();
        while let Some(event) = self.schedule.pop() {
            self.play(event);
        }
    }

    fn collect(&mut self) {
        while let Ok(event) = self.events.pop() {
            self.schedule.insert(event);
        }
    }

    /// Waits for `wake` and plays each event at its time after `start`, until `stop`.
    pub fn attend(
        &mut self,
        wake: &WakeFd,
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
            self.look(clock::monotonic().since(start).as_secs_f64());
            wake.wait(PATIENCE);
        }
    }

    /// Polls the player and its output at time `now` (s), if a tick ran since the last poll.
    fn look(&mut self, now: f64) {
        if let Some((counters, before)) = &mut self.ticks {
            let ticks = counters.ticks.load(Ordering::Relaxed);
            if std::mem::replace(before, ticks) == ticks {
                return;
            }
        }
        if let Err(away) = self.player.poll(now) {
            // Polling loses no message.
            self.trouble.get_or_insert_with(|| away.to_string());
        }
    }

    fn play_due(&mut self, start: Nanos, handover: &mut Histogram<u64>) {
        self.collect();
        while let Some(first) = self.schedule.first() {
            let due = start.after(clock::from_seconds(first.at));
            if clock::monotonic() < due {
                // The tick sees up to one period ahead: wait for the event's own time, and poll
                // the ring for earlier events that arrived meanwhile.
                clock::sleep_until(due);
                self.collect();
                continue;
            }
            let Some(event) = self.schedule.pop() else { return };
            self.play(event);
            if matches!(event.kind, NoteEventKind::Strike { .. }) {
                handover.saturating_record(clock::monotonic().since(due).as_u64());
            }
        }
    }

    /// Ends all notes and the output; returns the summary.
    pub fn close(
        mut self,
        ending: NoteEnding,
        handover: Option<Histogram<u64>>,
    ) -> PlaybackSummary {
        self.end_notes(ending);
        PlaybackSummary {
            assessor: self.assessor,
            trouble: self.trouble,
            n_troubles: self.n_troubles,
            handover,
        }
    }

    /// Ends all notes and finishes the output, which accepts no more.
    pub fn end_notes(&mut self, ending: NoteEnding) {
        let silenced = match ending {
            NoteEnding::Regular => self.player.silence(),
            NoteEnding::Emergency => self.player.cut_off(),
        };
        self.note(silenced);
        let finished = self.player.finish();
        self.note(finished);
    }

    fn play(&mut self, event: NoteEvent) {
        let NoteEvent { key, at, kind } = event;
        if let Some(assessor) = &mut self.assessor {
            if let NoteEventKind::Strike { speed, .. } = kind {
                assessor.hear(Struck { key, at, velocity: self.curve.velocity(speed).get() });
            } else if let NoteEventKind::DamperFall { speed } = kind {
                assessor.damp(Damped { key, at, release: release_velocity(speed).get() });
            }
        }
        let played = self.player.play(event);
        self.note(played);
    }

    fn note(&mut self, result: Result<(), midi::MidiSendError>) {
        if let Err(error) = result {
            self.n_troubles += 1;
            self.trouble.get_or_insert_with(|| error.to_string());
        }
    }
}

/// Dispatcher on its own thread.
#[derive(Debug)]
pub struct MidiThread {
    stop: Arc<AtomicBool>,
    emergency: Arc<AtomicBool>,
    wake: Arc<WakeFd>,
    thread: std::thread::JoinHandle<PlaybackSummary>,
}

impl MidiThread {
    /// Starts the thread; event times count from `start`.
    pub fn start(
        mut dispatcher: Box<MidiDispatcher>,
        plan: &ThreadPlan,
        wake: Arc<WakeFd>,
        start: Nanos,
        mut handover: Histogram<u64>,
    ) -> std::io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let emergency = Arc::new(AtomicBool::new(false));
        let (its_stop, its_wake) = (Arc::clone(&stop), Arc::clone(&wake));
        let its_emergency = Arc::clone(&emergency);
        let plan = plan.below(PRIORITY);
        let thread = std::thread::Builder::new().name("letoff-midi".into()).spawn(move || {
            let _as_the_tick_reports = plan.ask(0);
            dispatcher.attend(&its_wake, start, &its_stop, &mut handover);
            let is_emergency = its_emergency.load(Ordering::Acquire);
            let ending = if is_emergency { NoteEnding::Emergency } else { NoteEnding::Regular };
            dispatcher.close(ending, Some(handover))
        })?;
        Ok(Self { stop, emergency, wake, thread })
    }

    /// Plays the remaining events and ends all notes.
    ///
    /// # Errors
    /// If the thread panicked; its notes were ended while it unwound.
    pub fn finish(self, ending: NoteEnding) -> std::thread::Result<PlaybackSummary> {
        self.emergency.store(ending == NoteEnding::Emergency, Ordering::Release);
        self.stop.store(true, Ordering::Release);
        self.wake.ring();
        self.thread.join()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;
    use std::sync::atomic::AtomicU64;

    use midi::{Message, MidiSendError, Pedal, PedalMove};
    use scheduler::motion::{KEYS, KeyEvent as VoiceEvent, KeySample, Loudness, Moment};
    use scheduler::observation::{FollowedKeys, VoiceObservation};
    use scheduler::overload::Simplifications;
    use scheduler::port::{FinishedTick, TickObserver as _};
    use scheduler::voice::VoiceOutput;

    use super::*;
    use crate::adapters::observer::TickPublisher;
    use engine::realtime::run::histogram;

    #[derive(Clone, Default)]
    struct Heard(Arc<Mutex<Vec<(f64, Message)>>>);

    impl Output for Heard {
        fn send(&mut self, at: f64, message: Message) -> Result<(), MidiSendError> {
            self.0.lock().expect("nobody panics with it").push((at, message));
            Ok(())
        }

        fn finish(&mut self) -> Result<(), MidiSendError> {
            Ok(())
        }
    }

    #[derive(Clone, Default)]
    struct Polled(Arc<AtomicU64>);

    impl Output for Polled {
        fn send(&mut self, _at: f64, _message: Message) -> Result<(), MidiSendError> {
            Ok(())
        }

        fn poll(&mut self, _now: f64) -> Result<(), MidiSendError> {
            self.0.fetch_add(1, Ordering::Relaxed);
            Ok(())
        }

        fn finish(&mut self) -> Result<(), MidiSendError> {
            Ok(())
        }
    }

    #[test]
    fn the_output_gets_no_sign_of_life_while_the_tick_hangs() {
        let (_ring, events) = rtrb::RingBuffer::new(1);
        let (polled, counters) = (Polled::default(), Arc::<LiveCounters>::default());
        let mut dispatcher =
            MidiDispatcher::new(events, Box::new(polled.clone()), VelocityCurve::default());
        dispatcher.live_while_ticks_go_on(Arc::clone(&counters));
        let mut look = |ticks, expected| {
            counters.ticks.store(ticks, Ordering::Relaxed);
            dispatcher.look(0.0);
            assert_eq!(polled.0.load(Ordering::Relaxed), expected, "after {ticks} ticks");
        };
        look(0, 0);
        look(50, 1);
        look(50, 1);
        look(51, 2);
    }

    /// Ticks of 100 Hz, so that the MIDI thread has to wait for each event's own time.
    const PERIOD: f64 = 0.01;

    #[expect(clippy::large_stack_arrays, reason = "all turns; a test has the stack")]
    fn publish(tick: u64, events: &[(usize, f64, VoiceEvent)], publisher: &mut TickPublisher) {
        let mut turns = [VoiceOutput::default(); KEYS];
        for &(key, theta, event) in events {
            turns[key].events.push(Moment { tick, theta }, event);
        }
        let samples = [KeySample::default(); KEYS];
        let seen = FinishedTick {
            tick,
            skipped: 0,
            armed: true,
            simplified: Simplifications::NONE,
            samples: &samples,
            turns: &turns,
            forces: &[0.0; KEYS],
            followed: FollowedKeys::NONE,
            observed: &[VoiceObservation::default(); KEYS],
        };
        publisher.observe(&seen);
    }

    #[test]
    fn a_chord_goes_out_to_a_live_port_in_order_of_time() {
        let strike = VoiceEvent::Strike { speed: 2.0, loudness: Loudness::of_hammer(2.0) };
        let fall = VoiceEvent::DamperFall { speed: 0.1 };
        let (ring, events) = rtrb::RingBuffer::new(256);
        let wake = Arc::new(WakeFd::new().expect("an eventfd"));
        let pedals = Box::from([PedalMove { pedal: Pedal::Sustain, at: 0.014, depth: 1.0 }]);
        let counters = Arc::<LiveCounters>::default();
        let mut publisher = TickPublisher::new(ring, Arc::clone(&wake), counters, pedals, PERIOD);
        let heard = Heard::default();
        let mut dispatcher =
            MidiDispatcher::new(events, Box::new(heard.clone()), VelocityCurve::default());
        let start = clock::monotonic();
        publish(0, &[(50, 0.5, strike)], &mut publisher);
        // Strikes of lower keys follow later in the tick, and one note ends as another begins.
        let chord = [(10, 0.9, strike), (30, 0.6, strike), (50, 0.6, fall), (87, 0.1, strike)];
        publish(1, &chord, &mut publisher);
        let stop = AtomicBool::new(true);
        dispatcher.attend(&wake, start, &stop, &mut histogram().expect("a histogram"));
        let sent = heard.0.lock().expect("nobody panics with it").clone();
        let times: Vec<f64> = sent.iter().map(|it| (it.0 * 1e6).round() / 1e6).collect();
        assert_eq!(times, [0.005, 0.011, 0.014, 0.016, 0.016, 0.019], "{sent:?}");
        assert!(matches!(sent[3].1, Message::NoteOff { .. }), "{sent:?}");
        assert!(matches!(sent[4].1, Message::NoteOn { .. }), "{sent:?}");
        assert!(clock::monotonic().since(start).as_secs_f64() >= 0.019, "each at its own time");
    }
}
