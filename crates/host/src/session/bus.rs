//! The keys in a run: simulated in this process, or on armed boards.

use firmware_protocol::key::BoardId;
use hardware::keybed::{Armed, BoardReport, Keybed, LineReport};
use hardware::plan::BusPlan;
use hardware::topology::{BoardPlace, standard};
use rtrb::{Consumer, RingBuffer};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;
use scheduler::time::Nanos;
use telemetry::{Board, Line};

use super::PreparedRun;
use super::keys::SimulatedTransport;
use crate::adapters::lookout::LinkMonitor;
use crate::boards::stop_all;
use crate::control::{BoardsTold, IdentifyTarget, Lights};
use crate::observe::{LinksWatch, TelemetryMessage};
use crate::report::{BoardLine, LinkLine, LinkReport};
use realtime::clock;

/// Time between two looks at the boards before the first tick.
const LOOK: Nanos = Nanos::from_millis(1);

/// Lights that may be asked for at once.
const LIGHTS: usize = 32;

/// What each line shall carry; none where times are not known.
pub(super) type Plans = Vec<Option<BusPlan>>;

/// The keys in a run, and who looks at their lines meanwhile.
pub(super) struct MonitoredTransport {
    bed: KeyTransport,
    lookout: LinkMonitor,
}

/// Keys that are played.
enum KeyTransport {
    /// Simulated in this process.
    Simulated(SimulatedTransport),
    /// On armed boards, with what each line shall carry, and who shall show its light.
    Boards(Box<Keybed<Armed>>, Plans, Consumer<usize>),
}

impl MonitoredTransport {
    /// Simulated keys.
    pub(super) fn simulated(keys: SimulatedTransport, stage: &PreparedRun) -> Self {
        let places = standard();
        let line = |it: &BoardPlace| Line {
            name: format!("simulated {}", it.board.number()),
            planned: f64::NAN,
            seen: f64::NAN,
            ..Line::default()
        };
        let lookout = look_out(places.iter().map(line).collect(), &places, stage);
        Self { bed: KeyTransport::Simulated(keys), lookout }
    }

    /// Keys on armed boards whose lines carry what `plans` say.
    pub(super) fn on_boards(keybed: Box<Keybed<Armed>>, plans: Plans, stage: &PreparedRun) -> Self {
        let places: Vec<_> = keybed.terms().map(|it| it.place).collect();
        let names: Vec<_> = keybed.line_names().map(str::to_owned).collect();
        let planned = plans.iter().map(Option::as_ref).chain(std::iter::repeat(None));
        let lines = names.iter().zip(planned).map(|(name, plan)| Line {
            name: name.clone(),
            planned: plan.map_or(f64::NAN, BusPlan::load),
            seen: f64::NAN,
            ..Line::default()
        });
        let lookout = look_out(lines.collect(), &places, stage);
        let (sought, shown) = RingBuffer::new(LIGHTS);
        let lit = |it: &BoardPlace| IdentifyTarget {
            line: number(it.line),
            name: names.get(it.line).cloned().unwrap_or_default(),
            board: it.board.number().into(),
        };
        stage.patchbay.lend_lights(Lights { boards: places.iter().map(lit).collect(), sought });
        Self { bed: KeyTransport::Boards(keybed, plans, shown), lookout }
    }
}

/// Who looks at these lines and boards; whoever observes is told where they are seen.
fn look_out(lines: Vec<Line>, places: &[BoardPlace], stage: &PreparedRun) -> LinkMonitor {
    let (lookout, seen) = LinkMonitor::new(stage.tick_hz);
    let board = |it: &BoardPlace| Board {
        line: number(it.line),
        id: it.board.number().into(),
        first_key: it.first_key.number().into(),
        keys: number(it.n_keys),
        round_trip: f64::NAN,
        ..Board::default()
    };
    let links = telemetry::Links { lines, boards: places.iter().map(board).collect() };
    let watch = LinksWatch::new(seen, links, 1.0 / f64::from(stage.tick_hz));
    stage.patchbay.tell(TelemetryMessage::Links(Box::new(watch)));
    lookout
}

/// A small count.
fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}

impl KeyBus for MonitoredTransport {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        let Self { bed, lookout } = self;
        match bed {
            KeyTransport::Simulated(keys) => {
                keys.receive(tick, samples);
                lookout.take(tick, |place| keys.glance(place));
            }
            KeyTransport::Boards(keybed, _, sought) => {
                if let Ok(board) = sought.pop() {
                    keybed.light(board);
                }
                keybed.receive(tick, samples);
                lookout.take(tick, |place| keybed.glance(place));
            }
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        match &mut self.bed {
            KeyTransport::Simulated(keys) => keys.send(tick, forces, slopes),
            KeyTransport::Boards(keybed, ..) => keybed.send(tick, forces, slopes),
        }
    }
}

impl MonitoredTransport {
    /// Takes what boards send until `start` is near, so that the first tick finds what is new.
    pub(super) fn attend_until(&mut self, start: Nanos) {
        let KeyTransport::Boards(keybed, ..) = &mut self.bed else { return };
        loop {
            let next = clock::monotonic().after(LOOK);
            if start <= next {
                return;
            }
            keybed.attend();
            clock::sleep_until(next);
        }
    }

    /// Tells boards to render no force until they are seen to; a simulated keybed ends with the
    /// run.
    pub(super) fn stop(&mut self) -> BoardsTold {
        match &mut self.bed {
            KeyTransport::Simulated(_) => {
                let boards = standard().len();
                BoardsTold { told: boards, boards }
            }
            KeyTransport::Boards(keybed, ..) => stop_all(keybed),
        }
    }

    /// Tells boards to render no force; a simulated keybed ends with the run.
    pub(super) fn disarm(&mut self) {
        match &mut self.bed {
            KeyTransport::Simulated(_) => {}
            KeyTransport::Boards(keybed, ..) => keybed.disarm(),
        }
    }

    /// What happened on all links together.
    pub(super) fn links(&self) -> LinkReport {
        match &self.bed {
            KeyTransport::Simulated(keys) => simulated_links(keys),
            KeyTransport::Boards(keybed, ..) => board_links(keybed),
        }
    }

    /// What became of each line; nothing of simulated ones.
    pub(super) fn lines(&self, seconds: f64) -> Vec<LinkLine> {
        match &self.bed {
            KeyTransport::Simulated(_) => Vec::new(),
            KeyTransport::Boards(keybed, plans, _) => {
                let boards = keybed.board_reports();
                let lines = keybed.line_reports();
                let plans = plans.iter().map(Option::as_ref).chain(std::iter::repeat(None));
                let lines = lines.iter().zip(plans);
                lines.map(|(line, plan)| LinkLine::new(line, plan, &boards, seconds)).collect()
            }
        }
    }

    /// What became of each board in a run of `seconds`; nothing of simulated ones.
    pub(super) fn boards(&self, seconds: f64) -> Vec<BoardLine> {
        match &self.bed {
            KeyTransport::Simulated(_) => Vec::new(),
            KeyTransport::Boards(keybed, ..) => {
                keybed.board_reports().iter().map(|it| BoardLine::new(it, seconds)).collect()
            }
        }
    }
}

fn simulated_links(keys: &SimulatedTransport) -> LinkReport {
    let mut sum = LinkReport { rearmed: keys.rearmed, ..LinkReport::default() };
    for board in BoardId::all() {
        let (it, wire) = (keys.keybed.statistics(board), keys.keybed.wire(board));
        sum.frames += it.samples.frames;
        sum.gaps += it.samples.gaps;
        sum.refused += wire.corrupt + wire.foreign + it.refused + wire.down;
    }
    sum
}

fn board_links(keybed: &Keybed<Armed>) -> LinkReport {
    let mut sum = LinkReport::default();
    for BoardReport { statistics, condition, .. } in keybed.board_reports() {
        sum.frames += statistics.samples.frames;
        sum.gaps += statistics.samples.gaps;
        sum.refused += statistics.refused;
        sum.rearmed += condition.armings.saturating_sub(1);
    }
    for LineReport { statistics, .. } in keybed.line_reports() {
        sum.refused += statistics.corrupt + statistics.foreign;
    }
    sum
}
