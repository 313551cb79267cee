//! The tick's wait-free end of telemetry: what changed, into rings; full is dropped and counted.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use rtrb::{Consumer, Producer, RingBuffer};
use scheduler::look::{ModelSnapshot, Switch};
use scheduler::motion::{KEYS, KeyEvent, KeySample, Moment};
use scheduler::port::{FinishedTick, TickObserver};
use scheduler::voice::{VoiceFault, VoiceOutput};

/// Ticks whose rows may wait: a quarter of a second of all keys at 1 kHz.
const TICKS: usize = 256;

/// A key in a tick in which anything changed.
#[derive(Clone, Copy, Debug)]
pub struct KeyRow {
    pub tick: u64,
    pub key: u8,
    /// What its sensor said.
    pub sample: KeySample,
    /// The voice's force (N).
    pub force: f64,
    /// The force sent (N).
    pub sent: f64,
    /// The model at the end; as it was if it was not run.
    pub look: ModelSnapshot,
    /// Why the force could not be trusted.
    pub fault: Option<VoiceFault>,
    /// How the turn stands.
    pub stands: RowFlags,
    /// In which of the last ticks the voice was run: this one is bit 0.
    pub ran: u32,
    /// Key events that the turn told of.
    pub events: u8,
}

/// How a turn stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RowFlags {
    /// The voice was at rest.
    pub idle: bool,
    /// Its lane was not done.
    pub late: bool,
    /// Its force knows nothing of the one before.
    pub fresh: bool,
}

/// What the tap says.
#[derive(Clone, Copy, Debug)]
pub enum RecorderRow {
    Key(KeyRow),
    /// Of a tick, after its keys.
    Tick(TickRow),
}

/// A tick that was run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TickRow {
    pub tick: u64,
    /// Ticks before it that were not run.
    pub skipped: u64,
    /// Whether voices could be felt.
    pub armed: bool,
}

/// What happened within a tick.
#[derive(Clone, Copy, Debug)]
pub struct TickEvent {
    /// The tick that told of it.
    pub tick: u64,
    pub key: u8,
    pub what: EventKind,
}

/// See [`TickEvent`].
#[derive(Clone, Copy, Debug)]
pub enum EventKind {
    /// A change of mode, by the voice of this revision.
    Switch(u32, Switch),
    /// Something of the note.
    Note(Moment, KeyEvent),
}

/// The rings' other ends.
#[derive(Debug)]
pub struct TickRecorderRings {
    pub rows: Consumer<RecorderRow>,
    pub happenings: Consumer<TickEvent>,
    /// How much found no room.
    pub dropped: Arc<AtomicU64>,
}

/// Watches ticks for telemetry.
#[derive(Debug)]
pub struct TickRecorder {
    rows: Producer<RecorderRow>,
    happenings: Producer<TickEvent>,
    dropped: Arc<AtomicU64>,
    known: Box<[LastRow; KEYS]>,
}

/// A key as it was told of last.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
struct LastRow {
    /// Position, force and force sent, if it lay still under a voice at rest.
    still: Option<[u64; 3]>,
    look: ModelSnapshot,
}

impl TickRecorder {
    /// A tap, and where it leads.
    pub fn new() -> (Self, TickRecorderRings) {
        let (rows, rows_out) = RingBuffer::new(TICKS * (KEYS + 1));
        let (happenings, happenings_out) = RingBuffer::new(TICKS * KEYS);
        let dropped = Arc::new(AtomicU64::new(0));
        let known = vec![LastRow::default(); KEYS].into_boxed_slice().try_into();
        let known = known.unwrap_or_else(|_| unreachable!("KEYS long"));
        let tapped = TickRecorderRings {
            rows: rows_out,
            happenings: happenings_out,
            dropped: Arc::clone(&dropped),
        };
        (Self { rows, happenings, dropped, known }, tapped)
    }

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

    /// Whether anything of `key` is not as it was; notes how it is.
    fn is_news(&mut self, key: usize, seen: &FinishedTick<'_>) -> bool {
        let (turn, sample) = (&seen.turns[key], &seen.samples[key]);
        let still = is_still(turn, sample)
            .then(|| [sample.position, turn.force, seen.forces[key]].map(f64::to_bits));
        let known = &mut self.known[key];
        let is_news = still.is_none() || still != known.still;
        known.still = still;
        is_news
    }

    /// What the model of `key` was like when it was run last.
    ///
    /// A lane's words may be those of an earlier tick, if the voice was not run in this one.
    fn look(&mut self, key: usize, turn: &VoiceOutput) -> ModelSnapshot {
        if turn.idle || turn.look.revision == 0 {
            return self.known[key].look;
        }
        self.known[key].look = turn.look;
        turn.look
    }

    fn row(&mut self, key: usize, seen: &FinishedTick<'_>) -> KeyRow {
        let turn = &seen.turns[key];
        KeyRow {
            tick: seen.tick,
            key: u8::try_from(key).unwrap_or(u8::MAX),
            sample: seen.samples[key],
            force: turn.force,
            sent: seen.forces[key],
            look: self.look(key, turn),
            fault: turn.fault,
            stands: RowFlags { idle: turn.idle, late: turn.late, fresh: turn.fresh },
            ran: turn.ran,
            events: u8::try_from(turn.events.as_slice().len()).unwrap_or(u8::MAX),
        }
    }

    /// Tells what happened to a key whose voice has this revision.
    fn tell_of(&mut self, key: usize, revision: u32, tick: u64, turn: &VoiceOutput) {
        let key = u8::try_from(key).unwrap_or(u8::MAX);
        for switch in turn.switches.as_slice() {
            let what = EventKind::Switch(revision, *switch);
            self.tell(TickEvent { tick, key, what });
        }
        for (at, event) in turn.events.as_slice() {
            self.tell(TickEvent { tick, key, what: EventKind::Note(*at, *event) });
        }
    }
}

/// Whether a key lies still on a fresh sample, and its voice sleeps.
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
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for (key, turn) in seen.turns.iter().enumerate() {
            if self.is_news(key, seen) {
                let row = self.row(key, seen);
                self.tell_of(key, row.look.revision, seen.tick, turn);
                self.push(RecorderRow::Key(row));
            }
        }
        let FinishedTick { tick, skipped, armed, .. } = *seen;
        self.push(RecorderRow::Tick(TickRow { tick, skipped, armed }));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tap, and what it saw of `ticks` with these positions (mm), asleep or not.
    fn tapped(ticks: &[(f64, bool)]) -> Vec<RecorderRow> {
        let (mut tap, mut tapped) = TickRecorder::new();
        let mut samples = [KeySample::default(); KEYS];
        let mut turns = vec![VoiceOutput { idle: true, ran: 1, ..VoiceOutput::default() }; KEYS];
        let forces = [0.0; KEYS];
        for (tick, (position, idle)) in (0..).zip(ticks) {
            samples[5] = KeySample::fresh(position * 1e-3);
            turns[5] = VoiceOutput { idle: *idle, ..VoiceOutput::default() };
            let turns = turns.as_slice().try_into().expect("all turns");
            tap.observe(&FinishedTick {
                tick,
                skipped: 0,
                armed: true,
                samples: &samples,
                turns,
                forces: &forces,
            });
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

    #[test]
    fn a_key_at_rest_is_shown_as_it_was_when_it_was_run_last() {
        let (mut tap, mut tapped) = TickRecorder::new();
        let run = VoiceOutput {
            look: ModelSnapshot { revision: 7, mode: 2, ..ModelSnapshot::default() },
            ..VoiceOutput::default()
        };
        // A lane has several lists of turns: that of a voice at rest may never have been shown.
        let rest = VoiceOutput { idle: true, ..VoiceOutput::default() };
        for (tick, turn) in (0..).zip([run, run.held(), rest, rest.held(), rest]) {
            let mut turns = vec![VoiceOutput::default(); KEYS];
            turns[5] = turn;
            let turns = turns.as_slice().try_into().expect("all turns");
            tap.observe(&FinishedTick {
                tick,
                skipped: 0,
                armed: true,
                samples: &[KeySample::fresh(0.0); KEYS],
                turns,
                forces: &[0.0; KEYS],
            });
        }
        let mut seen = Vec::new();
        while let Ok(row) = tapped.rows.pop() {
            if let RecorderRow::Key(row) = row
                && row.key == 5
            {
                seen.push((row.tick, row.look.revision, row.look.mode));
            }
        }
        assert_eq!(seen, [(0, 7, 2), (1, 7, 2), (2, 7, 2), (3, 7, 2), (4, 7, 2)]);
    }

    #[test]
    fn what_finds_no_room_is_counted() {
        let (mut tap, tapped) = TickRecorder::new();
        let samples = [KeySample::fresh(1.0); KEYS];
        let turns = vec![VoiceOutput::default(); KEYS];
        let turns = turns.as_slice().try_into().expect("all turns");
        for tick in 0..TICKS as u64 + 2 {
            tap.observe(&FinishedTick {
                tick,
                skipped: 0,
                armed: true,
                samples: &samples,
                turns,
                forces: &[0.0; KEYS],
            });
        }
        assert_eq!(tapped.dropped.load(Ordering::Relaxed), 2 * (KEYS as u64 + 1));
        assert_eq!(tapped.rows.slots(), TICKS * (KEYS + 1));
    }
}
