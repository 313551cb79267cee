//! From rings to messages to sinks.

use std::collections::BTreeMap;
use std::sync::atomic::Ordering;
use std::sync::mpsc;

use rtrb::Consumer;
use scheduler::motion::KEYS;
use scheduler::overload::{Simplification, Simplifications};
use scheduler::voice::VoiceFault;
use telemetry::event::Kind;
use telemetry::{Catalogue, Topic, Update, Voice};

use super::block::{BlockBuilder, flag, flags, states};
use super::deadlines::DeadlinesBuilder;
use super::overview::OverviewBuilder;
use super::pulses::PulseRow;
use super::ticks::TicksBuilder;
use super::{LinksWatch, ModelProbe, events};
use crate::adapters::tick_recorder::{
    EventKind, KeyRow, RecorderRow, TickEvent, TickRecorderRings, TickRow,
};
use engine::realtime::run::CreationError;

/// Somebody who takes messages.
pub trait MessageSink: Send {
    /// Takes a message that was made at `at` (ns since 1970).
    fn take(&mut self, at: u64, update: &Update);

    /// Whether messages of `topic` are of use to it.
    fn wants(&self, topic: Topic) -> bool;

    /// Returns the keys whose models are to be observed for it: bit n is key n.
    ///
    /// Those whose rows it wants; all, if it wants what is made of the rows of all.
    fn followed_keys(&self) -> u128 {
        let wants_all = [Topic::Overview, Topic::Events].map(|topic| self.wants(topic));
        let keys = (0..=u8::MAX).take(KEYS).filter(|key| {
            wants_all != [false; 2]
                || self.wants(Topic::Block(*key))
                || self.wants(Topic::State(*key))
        });
        keys.fold(0, |followed, key| followed | 1 << key)
    }

    /// Whether somebody is there who was not when this was asked last: they are told how the keys
    /// are of which it wants rows.
    fn has_newcomers(&mut self) -> bool {
        false
    }

    /// Whether it can do without rows of single keys while the tick has too much to do.
    fn is_thinned(&self) -> bool {
        false
    }

    /// Looks after what it holds, a few times a second; `now` is (ns since 1970). Says whether it
    /// will take more.
    fn attend(&mut self, now: u64) -> Attention {
        let _ = now;
        Attention::Goes
    }
}

/// Whether a sink takes more.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Attention {
    Goes,
    /// It is over, and may be dropped.
    Over,
}

/// Messages to telemetry from other threads than the tick's.
pub enum TelemetryMessage {
    /// A voice that may be put in from now on, and what to see it with.
    Voice(Box<Voice>, Option<Box<dyn ModelProbe>>),
    Update(Box<Update>),
    /// What there is to see and to change now.
    Catalogue(Box<Catalogue>),
    /// Where lines and boards are seen.
    Links(Box<LinksWatch>),
    /// One more who takes messages.
    Sink(Box<dyn MessageSink>),
}

impl std::fmt::Debug for TelemetryMessage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Voice(voice, _probe) => f.debug_tuple("Voice").field(voice).finish(),
            Self::Update(update) => f.debug_tuple("Update").field(update).finish(),
            Self::Catalogue(_catalogue) => f.write_str("Catalogue(..)"),
            Self::Links(links) => f.debug_tuple("Links").field(links).finish(),
            Self::Sink(_sink) => f.write_str("Sink(..)"),
        }
    }
}

/// Moves what rings tell to sinks.
pub struct TelemetryThread {
    tapped: TickRecorderRings,
    pulses: Consumer<PulseRow>,
    told: mpsc::Receiver<TelemetryMessage>,
    sinks: Vec<Box<dyn MessageSink>>,
    /// What whoever comes later must know: the catalogue, and the voice of each key.
    latched: BTreeMap<Option<u32>, Update>,
    /// Moves of pedals, which are told beforehand.
    pedals: Vec<Update>,
    probes: BTreeMap<u32, SeenVoice>,
    /// Time at tick 0 (ns since 1970), and that of a tick (ns).
    time: (u64, u64),
    keys: Vec<KeyTelemetry>,
    overview: OverviewBuilder,
    ticks: TicksBuilder,
    deadlines: DeadlinesBuilder,
    links: Option<Box<LinksWatch>>,
    /// Times that came before their tick.
    early: Option<PulseRow>,
    /// The last tick that was told of, and whether voices were felt then.
    now: u64,
    armed: bool,
    simplified: Simplifications,
    dropped: u64,
    /// Ticks at which the slower messages were made last.
    looked: u64,
    summed: u64,
}

/// What a voice is seen with, and on which key.
type SeenVoice = (u32, Box<dyn ModelProbe>);

/// What is known of a key.
#[derive(Debug, Default)]
struct KeyTelemetry {
    /// Of the voice that its last row was of.
    revision: u32,
    builder: BlockBuilder,
    /// Its last row, which holds as long as it lies still.
    last: Option<KeyRow>,
    fault: Option<VoiceFault>,
    /// What its next row is marked with.
    mark: u8,
}

impl KeyTelemetry {
    /// Notes the newest row.
    fn note(&mut self, row: &KeyRow) {
        if row.stands.followed {
            self.revision = row.look.revision;
        }
        self.last = Some(*row);
    }
}

/// Voices of a key that may be known at once while it is not followed; a slider makes some in a
/// tick.
const MOST_PROBES: usize = 128;

/// Time between two overviews (ns).
const LOOK: u64 = 33_000_000;

/// Time between two sums (ns).
const SUM: u64 = 1_000_000_000;

impl TelemetryThread {
    /// Returns telemetry of ticks of `period` (ns), on the heap since it is large.
    ///
    /// # Errors
    /// If a histogram cannot be made, which their constants rule out.
    pub fn new(
        tapped: TickRecorderRings,
        pulses: Consumer<PulseRow>,
        told: mpsc::Receiver<TelemetryMessage>,
        period: u64,
    ) -> Result<Box<Self>, CreationError> {
        Ok(Box::new(Self {
            tapped,
            pulses,
            told,
            sinks: Vec::new(),
            latched: BTreeMap::new(),
            pedals: Vec::new(),
            probes: BTreeMap::new(),
            time: (0, period),
            keys: (0..KEYS).map(|_| KeyTelemetry::default()).collect(),
            overview: OverviewBuilder::new(),
            ticks: TicksBuilder::default(),
            deadlines: DeadlinesBuilder::new()?,
            links: None,
            early: None,
            now: 0,
            armed: true,
            simplified: Simplifications::NONE,
            dropped: 0,
            looked: 0,
            summed: 0,
        }))
    }

    /// Ticks count from `began` (ns since 1970).
    pub fn begin(&mut self, began: u64, catalogue: Catalogue) {
        self.time.0 = began;
        // Before anybody is welcome: what is told of voices means nothing without it.
        self.catalogue(catalogue);
        self.hear();
        self.follow();
    }

    /// Tells all who are there, and will tell those who come, what there is.
    fn catalogue(&mut self, mut catalogue: Catalogue) {
        catalogue.began = self.time.0;
        catalogue.run = format!("{}-{}", catalogue.began, catalogue.version);
        let catalogue = Update::Catalogue(catalogue);
        self.give(&catalogue);
        self.latched.insert(None, catalogue);
    }

    /// Tells the tick which keys are followed.
    fn follow(&self) {
        let sinks = self.sinks.iter().filter(|sink| !(self.is_sparse() && sink.is_thinned()));
        let followed = sinks.fold(0, |keys, sink| keys | sink.followed_keys());
        self.tapped.followed.store(followed);
    }

    /// Whether rows of single keys are left out where that is possible.
    const fn is_sparse(&self) -> bool {
        self.simplified.contains(Simplification::Telemetry)
    }

    /// Moves all that is there.
    pub fn pump(&mut self) {
        // Counted first: a voice is told of before the first row that it makes.
        let rows = self.whole_ticks();
        self.hear();
        if self.sinks.is_empty() {
            return self.pass_over(rows);
        }
        self.note_gap();
        for _ in 0..rows {
            match self.tapped.rows.pop() {
                Ok(RecorderRow::Key(row)) => self.key(&row),
                Ok(RecorderRow::Tick(row)) => self.tick(row),
                Err(_empty) => break,
            }
        }
        self.flush_keys();
        while self.tapped.happenings.peek().is_ok_and(|it| it.tick <= self.now) {
            let Ok(happening) = self.tapped.happenings.pop() else { break };
            self.happening(&happening);
        }
        if let Some(ticks) = self.ticks.take() {
            self.give(&Update::Ticks(ticks));
        }
        self.sum_up();
        self.tell_newcomers();
        self.forget_probes();
        let now = self.at(self.now);
        self.sinks.retain_mut(|sink| sink.attend(now) == Attention::Goes);
        self.follow();
    }

    /// Nobody wants to know: what is there is passed over, and costs next to nothing.
    fn pass_over(&mut self, rows: usize) {
        for _ in 0..rows {
            match self.tapped.rows.pop() {
                Ok(RecorderRow::Key(row)) => {
                    self.keys[usize::from(row.key)].note(&row);
                }
                Ok(RecorderRow::Tick(row)) => {
                    (self.now, self.armed) = (row.tick, row.armed);
                    self.simplified = row.simplified;
                }
                Err(_empty) => break,
            }
        }
        while self.tapped.happenings.pop().is_ok() {}
        while self.pulses.pop().is_ok() {}
        // Whoever comes will want the newest, and the ring holds the oldest.
        let _unseen = self.links.as_mut().and_then(|links| links.look());
        self.forget_probes();
    }

    /// Drops what saw voices that do not play any more: a slider makes many in a second.
    fn forget_probes(&mut self) {
        let keys = &self.keys;
        let playing = |key: u32| usize::try_from(key).ok().and_then(|key| keys.get(key));
        self.probes.retain(|revision, (key, _probe)| {
            playing(*key).is_none_or(|key| key.revision <= *revision)
        });
    }

    /// Drops what saw the oldest voices of a key, of which no row says whether they play.
    fn limit_probes(&mut self, key: u32) {
        let of_key = self.probes.iter().filter(|(_revision, (of, _probe))| *of == key);
        if let Some(oldest) = of_key.map(|(revision, _probe)| *revision).rev().nth(MOST_PROBES) {
            self.probes.remove(&oldest);
        }
    }

    /// Rows of ticks that are there as a whole.
    fn whole_ticks(&mut self) -> usize {
        let rows = &mut self.tapped.rows;
        let Ok(chunk) = rows.read_chunk(rows.slots()) else { return 0 };
        let (first, second) = chunk.as_slices();
        let is_tick = |row: &RecorderRow| matches!(row, RecorderRow::Tick(_));
        let last = second.iter().rposition(is_tick).map(|place| first.len() + place);
        last.or_else(|| first.iter().rposition(is_tick)).map_or(0, |place| place + 1)
    }

    /// Takes what others tell.
    fn hear(&mut self) {
        while let Ok(told) = self.told.try_recv() {
            match told {
                TelemetryMessage::Voice(voice, probe) => {
                    let key = voice.key;
                    self.probes.extend(probe.map(|probe| (voice.revision, (key, probe))));
                    self.limit_probes(key);
                    let voice = Update::Voice(*voice);
                    self.give(&voice);
                    self.latched.insert(Some(key), voice);
                }
                TelemetryMessage::Catalogue(catalogue) => self.catalogue(*catalogue),
                TelemetryMessage::Update(update) => {
                    self.give(&update);
                    self.pedals.extend(Some(*update).filter(is_pedal));
                }
                TelemetryMessage::Links(links) => self.links = Some(links),
                TelemetryMessage::Sink(sink) => self.welcome(sink),
            }
        }
    }

    /// Tells one who came later what it must know.
    fn welcome(&mut self, mut sink: Box<dyn MessageSink>) {
        let at = self.at(self.now);
        self.latched.values().chain(&self.pedals).for_each(|update| sink.take(at, update));
        self.tell_keys(sink.as_mut());
        if self.sinks.is_empty() {
            self.look_over_keys();
        }
        self.sinks.push(sink);
    }

    /// Puts every key as it was last into the overview, which nobody made until now.
    fn look_over_keys(&mut self) {
        for row in self.keys.iter().filter_map(|key| key.last.as_ref()) {
            let is_known = self.probes.contains_key(&row.look.revision);
            let mode = if is_known { row.look.structure() } else { u8::MAX };
            self.overview.push(row, flags(row.stands), mode);
        }
    }

    /// Tells those who came since the last time how the keys are.
    fn tell_newcomers(&mut self) {
        let mut sinks = std::mem::take(&mut self.sinks);
        for sink in sinks.iter_mut().filter_map(|sink| sink.has_newcomers().then_some(sink)) {
            self.tell_keys(sink.as_mut());
        }
        self.sinks = sinks;
    }

    /// Tells how each key is that a sink wants: as in its last row, however long it lies still.
    fn tell_keys(&self, sink: &mut dyn MessageSink) {
        // Of others the next tick tells.
        let last = self.keys.iter().filter_map(|key| key.last.as_ref());
        for last in last.filter(|row| row.stands.followed) {
            let wants = [Topic::Block(last.key), Topic::State(last.key)].map(|it| sink.wants(it));
            if wants == [false; 2] {
                continue;
            }
            let row = KeyRow { tick: self.now, ran: u32::MAX, events: 0, ..*last };
            let probe = self.probes.get(&row.look.revision).map(|(_key, probe)| probe.as_ref());
            let mut builder = BlockBuilder::default();
            builder.push(&row, flags(row.stands), probe);
            let Some(block) = builder.take() else { continue };
            let at = self.at(self.now);
            for state in states(&block).filter(|_| wants[1]) {
                sink.take(at, &Update::State(last.key, state));
            }
            if wants[0] {
                sink.take(at, &Update::Block(block));
            }
        }
    }

    /// Marks all keys if rows found no room in the ring.
    fn note_gap(&mut self) {
        let dropped = self.tapped.dropped.load(Ordering::Relaxed);
        if self.dropped < dropped {
            self.dropped = dropped;
            self.keys.iter_mut().for_each(|key| key.mark = flag::GAP);
        }
    }

    fn key(&mut self, row: &KeyRow) {
        let Some(key) = self.keys.get_mut(usize::from(row.key)) else { return };
        if key.builder.is_of_another(row) {
            let done = key.builder.take();
            self.give_block(done);
        }
        let probe = self.probes.get(&row.look.revision).map(|(_key, probe)| probe.as_ref());
        let Some(key) = self.keys.get_mut(usize::from(row.key)) else { return };
        key.note(row);
        let flags = flags(row.stands) | key.mark;
        if row.stands.followed {
            key.mark = 0;
            key.builder.push(row, flags, probe);
        }
        self.overview.push(
            row,
            flags,
            if probe.is_some() { row.look.structure() } else { u8::MAX },
        );
        if let Some(event) = events::trust(row, &mut key.fault) {
            self.give(&Update::Event(event));
        }
    }

    fn tick(&mut self, row: TickRow) {
        self.now = row.tick;
        let pulse = self.pulse(row.tick);
        self.ticks.push(row.tick, pulse.as_ref());
        self.overview.tick(row.tick);
        if 0 < row.skipped {
            self.deadlines.skip(row.skipped);
            self.give(&Update::Event(events::skip(row.tick, row.skipped)));
        }
        if row.armed != self.armed {
            self.armed = row.armed;
            self.give(&Update::Event(events::armed(&row)));
        }
        if row.simplified != self.simplified {
            self.simplified = row.simplified;
            self.give(&Update::Event(events::overload(&row)));
        }
        if let Some(pulse) = pulse {
            self.deadlines.push(&pulse);
            if let Some(event) = events::miss(&pulse) {
                self.give(&Update::Event(event));
            }
            if pulse.is_starved {
                self.give(&Update::Event(events::starved(pulse.tick)));
            }
        }
    }

    /// The times of `tick`, if they were taken; those of earlier ticks are passed over.
    fn pulse(&mut self, tick: u64) -> Option<PulseRow> {
        loop {
            let pulse = self.early.take().or_else(|| self.pulses.pop().ok())?;
            if pulse.tick == tick {
                return Some(pulse);
            }
            if tick < pulse.tick {
                self.early = Some(pulse);
                return None;
            }
        }
    }

    fn happening(&mut self, it: &TickEvent) {
        let event = match &it.what {
            EventKind::Switch(revision, switch) => {
                let probe = self.probes.get(revision).map(|(_key, probe)| probe.as_ref());
                events::switch(it.tick, it.key, switch, probe)
            }
            EventKind::Note(moment, event) => events::note(it.key, *moment, *event),
        };
        self.give(&Update::Event(event));
    }

    fn flush_keys(&mut self) {
        for key in 0..self.keys.len() {
            let done = self.keys[key].builder.take();
            self.give_block(done);
        }
    }

    fn give_block(&mut self, block: Option<telemetry::KeyBlock>) {
        let Some(block) = block else { return };
        let key = u8::try_from(block.key).unwrap_or(u8::MAX);
        if self.sinks.iter().any(|sink| sink.wants(Topic::State(key))) {
            for state in states(&block) {
                let at = self.at(state.tick);
                self.give_at(at, &Update::State(key, state));
            }
        }
        let at = self.at(block.tick);
        self.give_at(at, &Update::Block(block));
    }

    /// Makes what is made less often.
    fn sum_up(&mut self) {
        let now = self.at(self.now);
        if LOOK <= now.saturating_sub(self.looked) {
            self.looked = now;
            if let Some(overview) = self.overview.take(self.dropped) {
                self.give(&Update::Overview(overview));
            }
        }
        if SUM <= now.saturating_sub(self.summed) {
            self.summed = now;
            let deadlines = self.deadlines.read();
            if 0 < deadlines.ticks {
                self.give(&Update::Deadlines(deadlines));
            }
            self.look_at_links();
        }
    }

    /// Tells how lines and boards are, and what became of them.
    fn look_at_links(&mut self) {
        let Some(watch) = &mut self.links else { return };
        let Some(changes) = watch.look() else { return };
        let links = Update::Links(watch.links().clone());
        for text in changes {
            self.give(&Update::Event(events::board(self.now, text)));
        }
        self.give(&links);
    }

    /// When `tick` was due (ns since 1970).
    const fn at(&self, tick: u64) -> u64 {
        let (began, period) = self.time;
        began.saturating_add(tick.saturating_mul(period))
    }

    fn give(&mut self, update: &Update) {
        let at = self.at(self.now);
        self.give_at(at, update);
    }

    fn give_at(&mut self, at: u64, update: &Update) {
        let Some(topic) = update.topic() else { return };
        let is_left_out = self.is_sparse() && matches!(topic, Topic::Block(_) | Topic::State(_));
        let sinks = self.sinks.iter_mut().filter(|sink| sink.wants(topic));
        for sink in sinks.filter(|sink| !(is_left_out && sink.is_thinned())) {
            sink.take(at, update);
        }
    }
}

fn is_pedal(update: &Update) -> bool {
    matches!(update, Update::Event(event) if event.kind() == Kind::Pedal)
}

impl std::fmt::Debug for TelemetryThread {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pump").field("now", &self.now).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use scheduler::motion::KeySample;
    use scheduler::observation::VoiceObservation;
    use scheduler::port::{FinishedTick as SeenTick, TickObserver as _};
    use scheduler::voice::VoiceOutput;

    use super::*;
    use crate::adapters::tick_recorder::TickRecorder;
    use crate::observe::Pulses;

    /// What a window that follows key 5 is told, from when it is there.
    #[derive(Clone, Default)]
    struct Window(Arc<Mutex<(bool, Vec<Update>)>>);

    impl MessageSink for Window {
        fn take(&mut self, _at: u64, update: &Update) {
            self.0.lock().expect("nobody panics with it").1.push(update.clone());
        }

        fn wants(&self, topic: Topic) -> bool {
            topic == Topic::Block(5) && self.0.lock().expect("nobody panics with it").0
        }

        fn has_newcomers(&mut self) -> bool {
            let it = self.0.lock().expect("nobody panics with it");
            it.0 && it.1.is_empty()
        }
    }

    #[expect(clippy::large_stack_arrays, reason = "all turns; a test has the stack")]
    #[test]
    fn whoever_comes_late_is_told_how_a_key_is_that_lies_still() {
        let (mut tap, tapped) = TickRecorder::new();
        let (_no_times, pulses) = Pulses::new();
        let (told, hear) = mpsc::channel();
        let mut telemetry =
            TelemetryThread::new(tapped, pulses, hear, 1_000_000).expect("telemetry");
        let window = Window::default();
        assert!(told.send(TelemetryMessage::Sink(Box::new(window.clone()))).is_ok());
        let mut samples = [KeySample::default(); KEYS];
        samples[5] = KeySample::fresh(0.004);
        let turns = [VoiceOutput { idle: true, ..VoiceOutput::default() }; KEYS];
        let observed = [VoiceObservation { ran: u32::MAX, ..VoiceObservation::default() }; KEYS];
        for tick in 0..50 {
            if tick == 40 {
                window.0.lock().expect("nobody panics with it").0 = true;
            }
            let followed = tap.followed();
            tap.observe(&SeenTick {
                tick,
                skipped: 0,
                armed: true,
                simplified: Simplifications::NONE,
                samples: &samples,
                turns: &turns,
                forces: &[0.0; KEYS],
                followed,
                observed: &observed,
            });
            telemetry.pump();
        }
        let told = window.0.lock().expect("nobody panics with it").1.clone();
        let [Update::Block(block)] = told.as_slice() else { panic!("{told:?}") };
        // With the first tick that knows that somebody follows it.
        assert_eq!((block.key, block.tick, block.position.as_slice()), (5, 41, &[0.004][..]));
    }
}
