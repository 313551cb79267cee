//! The tick's wait-free end of telemetry: sends changes into rings, drops and counts when full.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::motion::{KEYS, KeyEvent, KeySample, Moment};
use scheduler::observation::{FollowedKeys, ModelSnapshot, Switch};
use scheduler::overload::Simplifications;
use scheduler::port::{FinishedTick, TickObserver};
use scheduler::voice::{VoiceFault, VoiceOutput};

use super::key_set::AtomicKeySet;

/// Ticks with waiting rows: 0.25 s of all keys at 1 kHz.
const TICKS: usize = 256;

/// A key in a tick with a change.
#[derive(Clone, Copy, Debug)]
pub struct KeyRow {
    pub tick: u64,
    pub key: u8,
    pub sample: KeySample,
    /// Force of the voice (N).
    pub force: f64,
    /// Force sent (N).
    pub sent: f64,
    /// The model at its last run; empty if the key is not followed.
    pub look: ModelSnapshot,
    /// Why the force could not be trusted.
    pub fault: Option<VoiceFault>,
    pub stands: RowFlags,
    /// Recent ticks in which the voice ran; bit 0 is this tick.
    pub ran: u32,
    pub events: u8,
    /// Units of work after which the turn was cut off; 0 if it was not.
    pub limit: u32,
    /// The same of a turn that came too late for an earlier tick.
    pub late_limit: u32,
}

/// State of a turn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "flags that have nothing to do with each other")]
pub struct RowFlags {
    /// `true` if the voice was at rest.
    pub idle: bool,
    /// `true` if its lane was not done.
    pub late: bool,
    /// `true` if it is late because the voice had to wait.
    pub waited: bool,
    /// `true` if its force is unrelated to the one before.
    pub fresh: bool,
    pub followed: bool,
}

/// A row of a tick.
#[expect(clippy::large_enum_variant, reason = "nearly all rows are of keys")]
#[derive(Clone, Copy, Debug)]
pub enum RecorderRow {
    Key(KeyRow),
    Tick(TickRow),
}

/// A tick in numbers, without its keys.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TickRow {
    pub tick: u64,
    pub skipped: u64,
    /// `true` if voices could be felt.
    pub armed: bool,
    /// Omissions of this tick.
    pub simplified: Simplifications,
}

/// An event within a tick.
#[derive(Clone, Copy, Debug)]
pub struct TickEvent {
    pub tick: u64,
    pub key: u8,
    pub what: EventKind,
}

/// The kind of a [`TickEvent`].
#[derive(Clone, Copy, Debug)]
pub enum EventKind {
    /// A change of mode, by the voice of this revision.
    Switch(u32, Switch),
    Note(Moment, KeyEvent),
}

/// The receiving ends of the rings.
#[derive(Debug)]
pub struct TickRecorderRings {
    pub rows: Consumer<RecorderRow>,
    pub happenings: Consumer<TickEvent>,
    /// Number of rows and events without room.
    pub dropped: Arc<AtomicU64>,
    /// Keys to follow, set by the telemetry thread.
    pub followed: Arc<AtomicKeySet>,
}

/// Records ticks for telemetry.
#[derive(Debug)]
pub struct TickRecorder {
    rows: Producer<RecorderRow>,
    happenings: Producer<TickEvent>,
    dropped: Arc<AtomicU64>,
    followed: Arc<AtomicKeySet>,
    /// Keys with a row since they are followed, while their lane was in time: bit n is key n.
    seen: u128,
    known: Box<[LastRow; KEYS]>,
}

/// Position, measured speed, force and sent force of a key's last row, if key and voice rested.
type LastRow = Option<[u64; 4]>;

impl TickRecorder {
    pub fn new() -> (Self, TickRecorderRings) {
        let (rows, rows_out) = RingBuffer::new(TICKS * (KEYS + 1));
        let (happenings, happenings_out) = RingBuffer::new(TICKS * KEYS);
        let (dropped, followed) = (Arc::<AtomicU64>::default(), Arc::<AtomicKeySet>::default());
        let tapped = TickRecorderRings {
            rows: rows_out,
            happenings: happenings_out,
            dropped: Arc::clone(&dropped),
            followed: Arc::clone(&followed),
        };
        let known = Box::new([None; KEYS]);
        (Self { rows, happenings, dropped, followed, seen: 0, known }, tapped)
    }

    #[expect(clippy::large_types_passed_by_value, reason = "it is moved into the ring")]
    fn push(&mut self, row: RecorderRow) {
        if self.rows.push(row).is_err() {
            self.dropped.fetch_add(1, Ordering::Relaxed);
        }
    }

    fn tell(&mut self, happening: TickEvent) {
        if self.happenings.push(happening).is_err() {
            self.dropped.fetch_add(1, Ordering::Relaxed);
        }
    }

    #[inline]
    fn tell_of(&mut self, key: usize, seen: &FinishedTick<'_>) {
        let (turn, observed) = (&seen.turns[key], &seen.observed[key]);
        if seen.followed.contains(key) && !observed.switches.is_empty() {
            for switch in observed.switches.as_slice() {
                let what = EventKind::Switch(observed.snapshot.revision, *switch);
                self.tell(TickEvent { tick: seen.tick, key: number(key), what });
            }
        }
        for (at, event) in turn.events.as_slice() {
            let what = EventKind::Note(*at, *event);
            self.tell(TickEvent { tick: seen.tick, key: number(key), what });
        }
    }
}

fn number(key: usize) -> u8 {
    u8::try_from(key).unwrap_or(u8::MAX)
}

/// Returns `true` if `key` differs from its last row, and updates that.
#[inline]
fn is_news(key: usize, seen: &FinishedTick<'_>, known: &mut LastRow) -> bool {
    let (turn, sample) = (&seen.turns[key], &seen.samples[key]);
    let still = is_still(turn, sample).then(|| {
        let velocity = sample.velocity.unwrap_or(f64::NAN);
        [sample.position, velocity, turn.force, seen.forces[key]].map(f64::to_bits)
    });
    let is_news = still.is_none() || still != *known || seen.followed.is_new(key);
    *known = still;
    is_news
}

#[inline]
fn row(key: usize, seen: &FinishedTick<'_>) -> KeyRow {
    let (turn, observed) = (&seen.turns[key], &seen.observed[key]);
    let followed = seen.followed.contains(key);
    let (look, ran) =
        if followed { (observed.snapshot, observed.ran) } else { (ModelSnapshot::default(), 0) };
    KeyRow {
        tick: seen.tick,
        key: number(key),
        sample: seen.samples[key],
        force: turn.force,
        sent: seen.forces[key],
        look,
        fault: turn.fault,
        stands: RowFlags {
            idle: turn.idle,
            late: turn.late,
            waited: turn.waited,
            fresh: turn.fresh,
            followed,
        },
        ran,
        events: u8::try_from(turn.events.as_slice().len()).unwrap_or(u8::MAX),
        limit: turn.limit,
        late_limit: turn.late_limit,
    }
}

/// Returns `true` if a key lies still on a fresh sample and its voice sleeps.
fn is_still(turn: &VoiceOutput, sample: &KeySample) -> bool {
    turn.idle
        && !turn.late
        && !turn.fresh
        && turn.fault.is_none()
        && turn.events.is_empty()
        && sample.age == 0
        && sample.taken.to_bits() == 0
}

impl TickObserver for TickRecorder {
    fn followed(&mut self) -> FollowedKeys {
        let followed = self.followed.load();
        self.seen &= followed;
        FollowedKeys::new(followed, !self.seen)
    }

    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for (key, turn) in seen.turns.iter().enumerate() {
            if is_news(key, seen, &mut self.known[key]) {
                let is_seen = seen.followed.contains(key) && !turn.late;
                self.seen |= u128::from(is_seen) << key;
                self.tell_of(key, seen);
                self.push(RecorderRow::Key(row(key, seen)));
            }
        }
        // After all other rows of the tick, so that the rows of a tick are complete.
        let FinishedTick { tick, skipped, armed, simplified, .. } = *seen;
        self.push(RecorderRow::Tick(TickRow { tick, skipped, armed, simplified }));
    }
}

#[cfg(test)]
mod tests {
    use scheduler::observation::VoiceObservation;

    use super::*;

    struct Keys {
        samples: [KeySample; KEYS],
        turns: Vec<VoiceOutput>,
        observed: Vec<VoiceObservation>,
    }

    impl Keys {
        fn at_rest() -> Self {
            Self {
                samples: [KeySample::default(); KEYS],
                turns: vec![VoiceOutput { idle: true, ..VoiceOutput::default() }; KEYS],
                observed: vec![VoiceObservation { ran: 1, ..VoiceObservation::default() }; KEYS],
            }
        }

        fn show(&self, tap: &mut TickRecorder, tick: u64) {
            let followed = tap.followed();
            tap.observe(&FinishedTick {
                tick,
                skipped: 0,
                armed: true,
                simplified: Simplifications::NONE,
                samples: &self.samples,
                turns: self.turns.as_slice().try_into().expect("all turns"),
                forces: &[0.0; KEYS],
                followed,
                observed: self.observed.as_slice().try_into().expect("all keys"),
            });
        }
    }

    fn tapped(ticks: &[(f64, bool)]) -> Vec<RecorderRow> {
        let (mut tap, mut tapped) = TickRecorder::new();
        let mut keys = Keys::at_rest();
        for (tick, (position, idle)) in (0..).zip(ticks) {
            keys.samples[5] = KeySample::fresh(position * 1e-3);
            keys.turns[5].idle = *idle;
            keys.show(&mut tap, tick);
        }
        std::iter::from_fn(|| tapped.rows.pop().ok()).collect()
    }

    #[test]
    fn a_key_that_lies_still_is_told_of_once() {
        let rows = tapped(&[(0.0, true), (0.0, true), (1.0, false), (1.0, true), (1.0, true)]);
        let told = |key: u8| -> Vec<u64> {
            let of = |row: &RecorderRow| match row {
                RecorderRow::Key(row) if row.key == key => Some(row.tick),
                RecorderRow::Key(_) | RecorderRow::Tick(_) => None,
            };
            rows.iter().filter_map(of).collect()
        };
        assert_eq!(told(5), [0, 2, 3], "as it was found, as it moved, and as it came to rest");
        assert_eq!(told(6), [0]);
        let ticks = rows.iter().filter(|row| matches!(row, RecorderRow::Tick(_))).count();
        assert_eq!(ticks, 5, "each tick is told of");
    }

    fn rows_of_5(tapped: &mut TickRecorderRings) -> Vec<(u64, u32, bool)> {
        let rows = std::iter::from_fn(|| tapped.rows.pop().ok());
        let row = |row| match row {
            RecorderRow::Key(row) if row.key == 5 => {
                Some((row.tick, row.look.revision, row.stands.followed))
            }
            RecorderRow::Key(_) | RecorderRow::Tick(_) => None,
        };
        rows.filter_map(row).collect()
    }

    #[test]
    fn a_key_that_is_followed_from_now_on_is_told_of_though_it_lies_still() {
        let (mut tap, mut tapped) = TickRecorder::new();
        let mut keys = Keys::at_rest();
        keys.observed[5].snapshot.revision = 7;
        for tick in 0..10 {
            match tick {
                3 => tapped.followed.store(1 << 5 | 1 << 87),
                4 => keys.turns[5].late = true,
                5 => keys.turns[5].late = false,
                8 => tapped.followed.store(1 << 87),
                _ => {}
            }
            keys.show(&mut tap, tick);
        }
        let rows = rows_of_5(&mut tapped);
        assert_eq!(rows, [(0, 0, false), (3, 7, true), (4, 7, true), (5, 7, true)]);
    }

    #[test]
    fn a_key_stays_new_until_its_lane_is_in_time() {
        let (mut tap, mut tapped) = TickRecorder::new();
        let mut keys = Keys::at_rest();
        tapped.followed.store(1 << 5);
        keys.turns[5].late = true;
        for tick in 0..3 {
            assert!(tap.followed().is_new(5), "tick {tick}");
            keys.show(&mut tap, tick);
        }
        keys.turns[5].late = false;
        keys.show(&mut tap, 3);
        assert!(tap.followed().contains(5) && !tap.followed().is_new(5));
        assert_eq!(rows_of_5(&mut tapped).len(), 4);
    }

    #[test]
    fn changes_of_mode_are_told_of_followed_keys() {
        let (mut tap, mut tapped) = TickRecorder::new();
        let mut keys = Keys::at_rest();
        tapped.followed.store(1 << 5);
        for key in 4..7 {
            keys.observed[key].switches.push(Switch::default());
        }
        keys.show(&mut tap, 0);
        let told: Vec<u8> =
            std::iter::from_fn(|| tapped.happenings.pop().ok()).map(|it| it.key).collect();
        assert_eq!(told, [5]);
    }

    #[test]
    fn what_finds_no_room_is_counted() {
        let (mut tap, tapped) = TickRecorder::new();
        let mut keys = Keys::at_rest();
        keys.samples = [KeySample::fresh(1.0); KEYS];
        keys.turns = vec![VoiceOutput::default(); KEYS];
        for tick in 0..TICKS as u64 + 2 {
            keys.show(&mut tap, tick);
        }
        assert_eq!(tapped.dropped.load(Ordering::Relaxed), 2 * (KEYS as u64 + 1));
        assert_eq!(tapped.rows.slots(), TICKS * (KEYS + 1));
    }
}
