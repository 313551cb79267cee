//! Compares the messages of a run with those of its replay.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use firmware_protocol::key::KeyIndex;
use midi::{Controller, Message};
use serde::Serialize;
use telemetry::{KeyBlock, Topic, Update, event::Kind};

use crate::{midi_thread::NoteEnding, observe::MessageSink};

/// A difference between a replay and its recording.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct ReplayDifference {
    pub tick: u64,
    pub text: String,
}

impl std::fmt::Display for ReplayDifference {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "tick {}: {}", self.tick, self.text)
    }
}

/// Messages of the replay that are not compared yet.
#[derive(Clone, Debug, Default)]
pub(super) struct ReplayedMessages(Arc<Mutex<VecDeque<Update>>>);

impl ReplayedMessages {
    pub(super) fn take_all(&self) -> VecDeque<Update> {
        std::mem::take(&mut *self.lock())
    }

    fn lock(&self) -> MutexGuard<'_, VecDeque<Update>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns `true` for messages that follow from the inputs and contain no clock times.
fn is_compared(update: &Update) -> bool {
    match update {
        Update::Block(_) | Update::Midi(_) => true,
        Update::Event(event) => matches!(
            event.kind(),
            Kind::Switch
                | Kind::Strike
                | Kind::DamperLift
                | Kind::Pressure
                | Kind::DamperFall
                | Kind::Fault
                | Kind::Recovery
                | Kind::Overload
        ),
        Update::Catalogue(_)
        | Update::Voice(_)
        | Update::Overview(_)
        | Update::State(..)
        | Update::Ticks(_)
        | Update::Deadlines(_)
        | Update::Links(_)
        | Update::Log(_)
        | Update::Status(_) => false,
    }
}

impl MessageSink for ReplayedMessages {
    fn take(&mut self, _at: u64, update: &Update) {
        if is_compared(update) {
            self.lock().push_back(update.clone());
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        !matches!(topic, Topic::State(_))
    }
}

/// Compares messages, each kind in its own order.
#[derive(Debug, Default)]
pub(super) struct Comparison {
    recorded: VecDeque<Update>,
    midi: VecDeque<Update>,
    replayed_midi: VecDeque<Update>,
    pub(super) compared: u64,
    pub(super) first: Option<ReplayDifference>,
    pub(super) different: u64,
}

impl Comparison {
    pub(super) fn expect(&mut self, update: Update) {
        if matches!(update, Update::Midi(_)) {
            self.midi.push_back(update);
        } else if is_compared(&update) {
            self.recorded.push_back(update);
        }
    }

    pub(super) fn window(&mut self, tick: u64, replayed: &ReplayedMessages) {
        let (midi, mut rest): (VecDeque<_>, VecDeque<_>) =
            replayed.take_all().into_iter().partition(|it| matches!(it, Update::Midi(_)));
        self.replayed_midi.extend(midi);
        while let Some(recorded) = self.recorded.pop_front() {
            let replayed = rest.pop_front();
            self.pair(tick, &recorded, replayed.as_ref());
        }
        for extra in rest {
            self.note(tick, &format!("the replay also says {}", short(&extra)));
        }
    }

    /// Drops messages recorded after the last ticks, which cannot be replayed. Returns `true` if
    /// there were any: the recording breaks off.
    pub(super) fn forget_unrun(&mut self) -> bool {
        let is_torn = !self.recorded.is_empty();
        self.recorded.clear();
        is_torn
    }

    /// Returns `true` if the replay, after `timed` messages, ended notes that the recording does
    /// not end: the recording breaks off before.
    pub(super) fn lacks_end(&self, timed: usize) -> bool {
        self.midi.len() <= timed && timed < self.replayed_midi.len()
    }

    /// Sorts the first `timed` messages of both by time: the MIDI thread of a late run sends in
    /// order of arrival, and one of an older version by keys.
    pub(super) fn sort_sent(&mut self, timed: usize) {
        for sent in [&mut self.midi, &mut self.replayed_midi] {
            let n = timed.min(sent.len());
            sent.make_contiguous()[..n].sort_by(|a, b| match (a, b) {
                (Update::Midi(a), Update::Midi(b)) => {
                    a.at.total_cmp(&b.at).then_with(|| a.bytes.cmp(&b.bytes))
                }
                _no_midi => std::cmp::Ordering::Equal,
            });
        }
    }

    /// Drops the messages that only one of both sent: the recording breaks off.
    pub(super) fn tear(&mut self, timed: usize) {
        let both = self.midi.len().min(timed);
        self.midi.truncate(both);
        self.replayed_midi.truncate(both);
    }

    pub(super) fn ending(&self) -> NoteEnding {
        let cuts_off = |update: &Update| {
            let Update::Midi(midi) = update else { return false };
            let controller = Controller::AllSoundOff;
            Message::decode(&midi.bytes) == Ok(Message::ControlChange { controller, value: 0 })
        };
        let is_emergency = self.midi.iter().any(cuts_off);
        if is_emergency { NoteEnding::Emergency } else { NoteEnding::Regular }
    }

    pub(super) fn n_sent(&self) -> usize {
        self.replayed_midi.len()
    }

    /// Compares the messages to the synthesizer, the first `timed` ones with their times. The end
    /// of a run and of its held notes depends on a clock.
    pub(super) fn finish(&mut self, tick: u64, timed: usize) {
        let mut n = 0;
        while let Some(mut recorded) = self.midi.pop_front() {
            let replayed = self.replayed_midi.pop_front();
            if let (true, Update::Midi(recorded), Some(Update::Midi(replayed))) =
                (timed <= n, &mut recorded, &replayed)
            {
                recorded.at = replayed.at;
            }
            self.pair(tick, &recorded, replayed.as_ref());
            n += 1;
        }
        for extra in std::mem::take(&mut self.replayed_midi) {
            self.note(tick, &format!("the replay also sends {}", short(&extra)));
        }
    }

    fn pair(&mut self, tick: u64, recorded: &Update, replayed: Option<&Update>) {
        self.compared += 1;
        let Some(replayed) = replayed else {
            return self.note(tick, &format!("the replay does not say {}", short(recorded)));
        };
        // As bytes, so that NaN equals itself.
        if recorded.encode() == replayed.encode() {
            return;
        }
        if let (Update::Block(recorded), Update::Block(replayed)) = (recorded, replayed) {
            let (tick, text) = blocks(recorded, replayed);
            return self.note(tick, &text);
        }
        let text = format!("{} was recorded, {} is replayed", short(recorded), short(replayed));
        self.note(tick, &text);
    }

    fn note(&mut self, tick: u64, text: &str) {
        self.different += 1;
        self.first.get_or_insert_with(|| ReplayDifference { tick, text: text.to_owned() });
    }
}

fn blocks(recorded: &KeyBlock, replayed: &KeyBlock) -> (u64, String) {
    let key = u8::try_from(recorded.key).ok().and_then(KeyIndex::new);
    let key = key.map_or_else(|| recorded.key.to_string(), |key| key.to_string());
    let tick = |block: &KeyBlock, row: usize| {
        block.after.get(row).map(|after| block.tick + u64::from(*after))
    };
    for row in 0..recorded.after.len() {
        let (was, is) = (tick(recorded, row), tick(replayed, row));
        let at = was.unwrap_or(recorded.tick);
        if was != is {
            let text = is.map_or_else(
                || "no row of this tick".to_owned(),
                |is| format!("a row of tick {is} instead"),
            );
            return (at, format!("key {key}: the replay has {text}"));
        }
        for (name, cell) in COLUMNS {
            let (was, is) = (cell(recorded, row), cell(replayed, row));
            if was != is {
                return (at, format!("key {key}: {name} {was} was recorded, {is} is replayed"));
            }
        }
    }
    (recorded.tick, format!("key {key}: the replay has rows beyond the recorded ones"))
}

/// Returns a cell as text that is equal only for equal bits.
type CellText = fn(&KeyBlock, usize) -> String;

const COLUMNS: [(&str, CellText); 15] = [
    ("position", |it, row| bits(&it.position, row)),
    ("age", |it, row| cell(&it.age, row)),
    ("taken", |it, row| bits(&it.taken, row)),
    ("measured speed", |it, row| bits(&it.velocity, row)),
    ("force", |it, row| bits(&it.force, row)),
    ("sent force", |it, row| bits(&it.sent, row)),
    ("mode", |it, row| cell(&it.mode, row)),
    ("flags", |it, row| cell(&it.flags, row)),
    ("fault", |it, row| cell(&it.fault, row)),
    ("revision", |it, row| cell(&it.revision, row)),
    ("ticks not run", |it, row| cell(&it.unrun, row)),
    ("number of events", |it, row| cell(&it.events, row)),
    ("limit", |it, row| cell(&it.limit, row)),
    ("limit of a late turn", |it, row| cell(&it.late_limit, row)),
    ("signals", |it, row| {
        let width = (it.signals.len() / it.after.len().max(1)).max(1);
        it.signals.chunks(width).nth(row).map_or_else(String::new, |them| format!("{them:?}"))
    }),
];

fn cell<T: std::fmt::Debug>(column: &[T], row: usize) -> String {
    column.get(row).map_or_else(|| "nothing".to_owned(), |value| format!("{value:?}"))
}

fn bits(column: &[f64], row: usize) -> String {
    let show = |value: &f64| format!("{value:?} ({:016x})", value.to_bits());
    column.get(row).map_or_else(|| "nothing".to_owned(), show)
}

fn short(update: &Update) -> String {
    match update {
        Update::Block(block) => format!("rows of key {} from tick {}", block.key, block.tick),
        Update::Event(event) => format!(
            "{:?} of key {} at tick {} + {:?}",
            event.kind(),
            event.key,
            event.tick,
            event.theta
        ),
        Update::Midi(midi) => format!("{} at {:?} s", midi.text, midi.at),
        other @ (Update::Catalogue(_)
        | Update::Voice(_)
        | Update::Overview(_)
        | Update::State(..)
        | Update::Ticks(_)
        | Update::Deadlines(_)
        | Update::Links(_)
        | Update::Log(_)
        | Update::Status(_)) => other.topic().map_or_else(String::new, |topic| topic.to_string()),
    }
}
