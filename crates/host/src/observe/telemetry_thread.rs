//! The thread that turns rows of ticks into messages for sinks.

use std::{collections::BTreeMap, sync::atomic::Ordering, sync::mpsc};

use rtrb::Consumer;
use scheduler::overload::{Simplification, Simplifications};
use scheduler::{motion::KEYS, voice::VoiceFault};
use telemetry::{Catalogue, Topic, Update, Voice, event::Kind};

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

/// Receiver of telemetry messages: a recording, the stream, the status.
pub trait MessageSink: Send {
    /// Receives a message of time `at` (ns since 1970).
    fn take(&mut self, at: u64, update: &Update);

    fn wants(&self, topic: Topic) -> bool;

    /// Returns the keys whose models are observed for the sink, bit n for key n: those with rows
    /// that it wants, or all if it wants overviews or events.
    fn followed_keys(&self) -> u128 {
        let wants_all = [Topic::Overview, Topic::Events].map(|topic| self.wants(topic));
        let keys = (0..=u8::MAX).take(KEYS).filter(|key| {
            wants_all != [false; 2]
                || self.wants(Topic::Block(*key))
                || self.wants(Topic::State(*key))
        });
        keys.fold(0, |followed, key| followed | 1 << key)
    }

    /// Returns `true` if a client connected since the last call; the keys' state is then sent.
    fn has_newcomers(&mut self) -> bool {
        false
    }

    /// Returns `true` if the sink can do without rows of single keys under overload.
    fn is_thinned(&self) -> bool {
        false
    }

    /// Does periodic work, a few times a second, at `now` (ns since 1970).
    fn attend(&mut self, now: u64) -> Attention {
        let _ = now;
        Attention::Goes
    }
}

/// Need of a sink for more messages.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Attention {
    Goes,
    /// The sink needs no more messages and may be dropped.
    Over,
}

/// Messages to telemetry from threads other than the tick's.
pub enum TelemetryMessage {
    /// A voice that may be put in from now on, and the probe of its model.
    Voice(Box<Voice>, Option<Box<dyn ModelProbe>>),
    Update(Box<Update>),
    Catalogue(Box<Catalogue>),
    Links(Box<LinksWatch>),
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

/// Builds messages from the rows of the rings for the sinks.
pub struct TelemetryThread {
    sources: TelemetrySources,
    sinks: Vec<Box<dyn MessageSink>>,
    /// Messages for sinks that are added later: the catalogue and the voice of each key.
    retained: BTreeMap<Option<u32>, Update>,
    pedals: Vec<Update>,
    probes: BTreeMap<u32, ProbedVoice>,
    /// Time of tick 0 (ns since 1970).
    began: u64,
    /// Tick period (ns).
    period: u64,
    keys: Vec<KeyTelemetry>,
    overview: OverviewBuilder,
    ticks: TicksBuilder,
    deadlines: DeadlinesBuilder,
    newest: NewestTick,
    /// Times of the last overview and the last sums (ns since 1970).
    overviewed: u64,
    summed: u64,
}

struct TelemetrySources {
    rings: TickRecorderRings,
    pulses: Consumer<PulseRow>,
    early: Option<PulseRow>,
    messages: mpsc::Receiver<TelemetryMessage>,
    links: Option<Box<LinksWatch>>,
}

/// State in the newest tick row; a change of it is an event.
struct NewestTick {
    tick: u64,
    armed: bool,
    simplified: Simplifications,
    dropped: u64,
}

type ProbedVoice = (u32, Box<dyn ModelProbe>);

#[derive(Debug, Default)]
struct KeyTelemetry {
    revision: u32,
    builder: BlockBuilder,
    /// Last row, which holds as long as the key rests.
    last: Option<KeyRow>,
    fault: Option<VoiceFault>,
    mark: u8,
}

impl KeyTelemetry {
    fn note(&mut self, row: &KeyRow) {
        if row.stands.followed {
            self.revision = row.look.revision;
        }
        self.last = Some(*row);
    }
}

/// Voices of an unfollowed key that are kept; a slider makes some per tick.
const MOST_PROBES: usize = 128;

/// Interval of overviews (ns).
const LOOK: u64 = 33_000_000;

/// Interval of sums (ns).
const SUM: u64 = 1_000_000_000;

impl TelemetryThread {
    /// Returns telemetry of ticks of `period` (ns), boxed because it is large.
    pub fn new(
        rings: TickRecorderRings,
        pulses: Consumer<PulseRow>,
        messages: mpsc::Receiver<TelemetryMessage>,
        period: u64,
    ) -> Result<Box<Self>, CreationError> {
        Ok(Box::new(Self {
            sources: TelemetrySources { rings, pulses, early: None, messages, links: None },
            sinks: Vec::new(),
            retained: BTreeMap::new(),
            pedals: Vec::new(),
            probes: BTreeMap::new(),
            began: 0,
            period,
            keys: (0..KEYS).map(|_| KeyTelemetry::default()).collect(),
            overview: OverviewBuilder::new(),
            ticks: TicksBuilder::default(),
            deadlines: DeadlinesBuilder::new()?,
            newest: NewestTick {
                tick: 0,
                armed: true,
                simplified: Simplifications::NONE,
                dropped: 0,
            },
            overviewed: 0,
            summed: 0,
        }))
    }

    /// Counts ticks from `began` (ns since 1970).
    pub fn begin(&mut self, began: u64, catalogue: Catalogue) {
        self.began = began;
        // Sinks need the catalogue before voices.
        self.catalogue(catalogue);
        self.receive();
        self.follow();
    }

    fn catalogue(&mut self, mut catalogue: Catalogue) {
        catalogue.began = self.began;
        catalogue.run = format!("{}-{}", catalogue.began, catalogue.version);
        let catalogue = Update::Catalogue(catalogue);
        self.give(&catalogue);
        self.retained.insert(None, catalogue);
    }

    fn follow(&self) {
        let sinks = self.sinks.iter().filter(|sink| !(self.is_sparse() && sink.is_thinned()));
        let followed = sinks.fold(0, |keys, sink| keys | sink.followed_keys());
        self.sources.rings.followed.store(followed);
    }

    /// Returns `true` if rows of single keys are left out where that is possible.
    const fn is_sparse(&self) -> bool {
        self.newest.simplified.contains(Simplification::Telemetry)
    }

    pub fn pump(&mut self) {
        // Count the rows first: the message about a voice precedes the voice's first row.
        let rows = self.whole_ticks();
        self.receive();
        if self.sinks.is_empty() {
            return self.pass_over(rows);
        }
        self.note_gap();
        for _ in 0..rows {
            match self.sources.rings.rows.pop() {
                Ok(RecorderRow::Key(row)) => self.key(&row),
                Ok(RecorderRow::Tick(row)) => self.tick(row),
                Err(_empty) => break,
            }
        }
        self.flush_keys();
        while self.sources.rings.happenings.peek().is_ok_and(|it| it.tick <= self.newest.tick) {
            let Ok(happening) = self.sources.rings.happenings.pop() else { break };
            self.happening(&happening);
        }
        if let Some(ticks) = self.ticks.take() {
            self.give(&Update::Ticks(ticks));
        }
        self.sum_up();
        self.update_newcomers();
        self.forget_probes();
        let now = self.at(self.newest.tick);
        self.sinks.retain_mut(|sink| sink.attend(now) == Attention::Goes);
        self.follow();
    }

    fn pass_over(&mut self, rows: usize) {
        for _ in 0..rows {
            match self.sources.rings.rows.pop() {
                Ok(RecorderRow::Key(row)) => {
                    self.keys[usize::from(row.key)].note(&row);
                }
                Ok(RecorderRow::Tick(row)) => {
                    let TickRow { tick, armed, simplified, .. } = row;
                    self.newest = NewestTick { tick, armed, simplified, ..self.newest };
                }
                Err(_empty) => break,
            }
        }
        while self.sources.rings.happenings.pop().is_ok() {}
        while self.sources.pulses.pop().is_ok() {}
        // A later sink needs the newest state, and the ring keeps the oldest.
        let _unseen = self.sources.links.as_mut().and_then(|links| links.look());
        self.forget_probes();
    }

    /// Drops the probes of voices that no longer play: a slider makes many voices in a second.
    fn forget_probes(&mut self) {
        let keys = &self.keys;
        let playing = |key: u32| usize::try_from(key).ok().and_then(|key| keys.get(key));
        self.probes.retain(|revision, (key, _probe)| {
            playing(*key).is_none_or(|key| key.revision <= *revision)
        });
    }

    /// Drops the oldest probe of a key above [`MOST_PROBES`]; no row shows whether its voice plays.
    fn limit_probes(&mut self, key: u32) {
        let of_key = self.probes.iter().filter(|(_revision, (of, _probe))| *of == key);
        if let Some(oldest) = of_key.map(|(revision, _probe)| *revision).rev().nth(MOST_PROBES) {
            self.probes.remove(&oldest);
        }
    }

    fn whole_ticks(&mut self) -> usize {
        let rows = &mut self.sources.rings.rows;
        let Ok(chunk) = rows.read_chunk(rows.slots()) else { return 0 };
        let (first, second) = chunk.as_slices();
        let is_tick = |row: &RecorderRow| matches!(row, RecorderRow::Tick(_));
        let last = second.iter().rposition(is_tick).map(|place| first.len() + place);
        last.or_else(|| first.iter().rposition(is_tick)).map_or(0, |place| place + 1)
    }

    fn receive(&mut self) {
        while let Ok(message) = self.sources.messages.try_recv() {
            match message {
                TelemetryMessage::Voice(voice, probe) => {
                    let key = voice.key;
                    self.probes.extend(probe.map(|probe| (voice.revision, (key, probe))));
                    self.limit_probes(key);
                    let voice = Update::Voice(*voice);
                    self.give(&voice);
                    self.retained.insert(Some(key), voice);
                }
                TelemetryMessage::Catalogue(catalogue) => self.catalogue(*catalogue),
                TelemetryMessage::Update(mut update) => {
                    date_change(&mut update, self.newest.tick);
                    self.give(&update);
                    self.pedals.extend(Some(*update).filter(is_pedal));
                }
                TelemetryMessage::Links(links) => self.sources.links = Some(links),
                TelemetryMessage::Sink(sink) => self.welcome(sink),
            }
        }
    }

    /// Adds a sink, and sends it the retained messages and the state of the keys.
    fn welcome(&mut self, mut sink: Box<dyn MessageSink>) {
        let at = self.at(self.newest.tick);
        self.retained.values().chain(&self.pedals).for_each(|update| sink.take(at, update));
        self.send_keys(sink.as_mut());
        if self.sinks.is_empty() {
            self.fill_overview();
        }
        self.sinks.push(sink);
    }

    /// Puts the last row of every key into the overview, which was not built without sinks.
    fn fill_overview(&mut self) {
        for row in self.keys.iter().filter_map(|key| key.last.as_ref()) {
            let is_known = self.probes.contains_key(&row.look.revision);
            let mode = if is_known { row.look.structure() } else { u8::MAX };
            self.overview.push(row, flags(row.stands), mode);
        }
    }

    fn update_newcomers(&mut self) {
        let mut sinks = std::mem::take(&mut self.sinks);
        for sink in sinks.iter_mut().filter_map(|sink| sink.has_newcomers().then_some(sink)) {
            self.send_keys(sink.as_mut());
        }
        self.sinks = sinks;
    }

    /// Sends a sink the last row of each key that it wants, however long the key has rested.
    fn send_keys(&self, sink: &mut dyn MessageSink) {
        // The next tick has rows of the others.
        let last = self.keys.iter().filter_map(|key| key.last.as_ref());
        for last in last.filter(|row| row.stands.followed) {
            let wants = [Topic::Block(last.key), Topic::State(last.key)].map(|it| sink.wants(it));
            if wants == [false; 2] {
                continue;
            }
            let row = KeyRow { tick: self.newest.tick, ran: u32::MAX, events: 0, ..*last };
            let probe = self.probes.get(&row.look.revision).map(|(_key, probe)| probe.as_ref());
            let mut builder = BlockBuilder::default();
            builder.push(&row, flags(row.stands), probe);
            let Some(block) = builder.take() else { continue };
            let at = self.at(self.newest.tick);
            for state in states(&block).filter(|_| wants[1]) {
                sink.take(at, &Update::State(last.key, state));
            }
            if wants[0] {
                sink.take(at, &Update::Block(block));
            }
        }
    }

    fn note_gap(&mut self) {
        let dropped = self.sources.rings.dropped.load(Ordering::Relaxed);
        if self.newest.dropped < dropped {
            self.newest.dropped = dropped;
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
        self.newest.tick = row.tick;
        let pulse = self.pulse(row.tick);
        self.ticks.push(row.tick, pulse.as_ref());
        self.overview.tick(row.tick);
        if 0 < row.skipped {
            self.deadlines.skip(row.skipped);
            self.give(&Update::Event(events::skip(row.tick, row.skipped)));
        }
        if row.armed != self.newest.armed {
            self.newest.armed = row.armed;
            self.give(&Update::Event(events::armed(&row)));
        }
        if row.simplified != self.newest.simplified {
            self.newest.simplified = row.simplified;
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

    fn pulse(&mut self, tick: u64) -> Option<PulseRow> {
        loop {
            let pulse = self.sources.early.take().or_else(|| self.sources.pulses.pop().ok())?;
            if pulse.tick == tick {
                return Some(pulse);
            }
            if tick < pulse.tick {
                self.sources.early = Some(pulse);
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

    fn sum_up(&mut self) {
        let now = self.at(self.newest.tick);
        if LOOK <= now.saturating_sub(self.overviewed) {
            self.overviewed = now;
            if let Some(overview) = self.overview.take(self.newest.dropped) {
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

    fn look_at_links(&mut self) {
        let Some(watch) = &mut self.sources.links else { return };
        let Some(changes) = watch.look() else { return };
        let links = Update::Links(watch.links().clone());
        for text in changes {
            self.give(&Update::Event(events::board(self.newest.tick, text)));
        }
        self.give(&links);
    }

    /// Returns the time at which `tick` was due (ns since 1970).
    const fn at(&self, tick: u64) -> u64 {
        self.began.saturating_add(tick.saturating_mul(self.period))
    }

    fn give(&mut self, update: &Update) {
        let at = self.at(self.newest.tick);
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

/// Sets the tick of an event on a change, whose sender knows no ticks.
fn date_change(update: &mut Update, tick: u64) {
    if let Update::Event(event) = update
        && event.kind() == Kind::Change
    {
        event.tick = tick;
    }
}

fn is_pedal(update: &Update) -> bool {
    matches!(update, Update::Event(event) if event.kind() == Kind::Pedal)
}

impl std::fmt::Debug for TelemetryThread {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TelemetryThread").field("tick", &self.newest.tick).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use scheduler::port::{FinishedTick as SeenTick, TickObserver as _};
    use scheduler::{motion::KeySample, observation::VoiceObservation, voice::VoiceOutput};

    use super::*;
    use crate::{adapters::tick_recorder::TickRecorder, observe::Pulses};

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
    fn a_late_client_gets_the_state_of_a_resting_key() {
        let (mut recorder, rings) = TickRecorder::new();
        let (_no_times, pulses) = Pulses::new();
        let (sender, messages) = mpsc::channel();
        let mut telemetry =
            TelemetryThread::new(rings, pulses, messages, 1_000_000).expect("telemetry");
        let window = Window::default();
        assert!(sender.send(TelemetryMessage::Sink(Box::new(window.clone()))).is_ok());
        let mut samples = [KeySample::default(); KEYS];
        samples[5] = KeySample::fresh(0.004);
        let turns = [VoiceOutput { idle: true, ..VoiceOutput::default() }; KEYS];
        let observed = [VoiceObservation { ran: u32::MAX, ..VoiceObservation::default() }; KEYS];
        for tick in 0..50 {
            if tick == 40 {
                window.0.lock().expect("nobody panics with it").0 = true;
            }
            let followed = recorder.followed();
            recorder.observe(&SeenTick {
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
        let messages = window.0.lock().expect("nobody panics with it").1.clone();
        let [Update::Block(block)] = messages.as_slice() else { panic!("{messages:?}") };
        assert_eq!((block.key, block.tick, block.position.as_slice()), (5, 41, &[0.004][..]));
    }
}
