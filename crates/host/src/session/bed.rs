//! The keys of a run: simulated in this process, or on boards.

use firmware_protocol::key::BoardId;
use hardware::keybed::{
    Armed, BoardReport, Calibrated, Keybed, LineReport, Offline, Terms, Wanted,
};
use hardware::plan::{BusPlan, Verdict};
use hardware::sim::keybed::SimulatedKeybed;
use performance::Performance;
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus;
use scheduler::time::Nanos;

use super::keys::Keys;
use super::{SessionError, all_keys};
use crate::boards::{PATIENCE_US, calibration, now_us, open_all, planning};
use crate::config::{Boards, period_us};
use crate::control::Patchbay;
use crate::realtime::clock;
use crate::report::{BoardLine, LinkLine, Links};

/// Time between two looks at the boards before the first tick.
const LOOK: Nanos = Nanos::from_millis(1);

/// Weights that may wait to be laid on simulated keys.
const WEIGHTS: usize = 256;

/// The keys before a run.
pub(super) enum Bed {
    /// Simulated in this process.
    Simulated(Box<SimulatedKeybed>),
    /// On boards that were found and may be armed.
    Boards(Box<Keybed<Calibrated>>, Terms, Plans),
}

/// What each line shall carry; none where times are not known.
type Plans = Vec<Option<BusPlan>>;

/// The keys in a run.
pub(super) enum Bus {
    /// Simulated in this process.
    Simulated(Keys),
    /// On armed boards, with what each line shall carry.
    Boards(Box<Keybed<Armed>>, Plans),
}

/// Finds the boards that a scene at `tick_hz` asks for; they are not armed yet.
///
/// What their links cannot carry is refused: before they are opened if the scene says who is
/// there, else when that is known.
pub(super) fn find(boards: &Boards, tick_hz: u32) -> Result<Bed, SessionError> {
    let terms = terms(boards, tick_hz)?;
    refuse_overload(&planning::listed(boards, tick_hz))?;
    let lines = open_all(&boards.buses).map_err(SessionError::Links)?;
    let keybed = Keybed::<Offline>::new(lines, now_us).identify(PATIENCE_US)?;
    let buses = boards.buses.iter().enumerate();
    let wanted = Wanted {
        samples: boards.samples,
        forces: boards.forces,
        boards: buses
            .flat_map(|(line, bus)| bus.boards.iter().map(move |(n, keys)| (line, *n, *keys)))
            .collect(),
        hz: tick_hz,
    };
    let calibrated = keybed.calibrate(&wanted, |found, name| calibration(found, name, boards))?;
    let plans = planning::found(boards, &calibrated, tick_hz);
    refuse_overload(plans.iter().flatten())?;
    Ok(Bed::Boards(Box::new(calibrated), terms, plans))
}

/// Refuses plans that are more than their links can carry.
fn refuse_overload<'a, P: IntoIterator<Item = &'a BusPlan>>(plans: P) -> Result<(), SessionError> {
    let refused = planning::sentences(plans, Verdict::Refused);
    if refused.is_empty() {
        Ok(())
    } else {
        Err(SessionError::Overload(refused.join("\nletoff: ")))
    }
}

/// What is agreed with all boards.
fn terms(boards: &Boards, tick_hz: u32) -> Result<Terms, SessionError> {
    Ok(Terms {
        period_us: period_us(tick_hz).ok_or(SessionError::BoardRate { tick_hz })?,
        samples: boards.samples,
        forces: boards.forces,
        valid_ms: boards.valid_ms,
    })
}

impl Bed {
    /// Whether there is a motor for the key with this index.
    pub(super) fn carries(&self, key: usize) -> bool {
        match self {
            Self::Simulated(_) => true,
            Self::Boards(keybed, ..) => keybed.places().any(|it| it.keys().contains(&key)),
        }
    }

    /// Whether there are fingers that can play.
    pub(super) fn has_fingers(&self) -> bool {
        match self {
            Self::Simulated(_) => true,
            Self::Boards(keybed, ..) => keybed.has_fingers(),
        }
    }

    /// Gives the performance's gestures to the simulated fingers.
    pub(super) fn seat(&mut self, performance: &Performance) {
        if let Self::Simulated(keybed) = self {
            for (key, gestures) in all_keys().zip(&performance.gestures) {
                keybed.play(key, gestures.clone());
            }
        }
    }

    /// Arms boards, hands them the performance's gestures, and says from when on they count.
    pub(super) fn arm(
        self,
        performance: Option<&Performance>,
        lead: Nanos,
        patchbay: &Patchbay,
    ) -> Result<(Bus, Nanos), SessionError> {
        match self {
            Self::Simulated(keybed) => {
                let (weights, laid) = rtrb::RingBuffer::new(WEIGHTS);
                patchbay.lend_fingers(weights);
                Ok((Bus::Simulated(Keys::new(*keybed, laid)), clock::monotonic().after(lead)))
            }
            Self::Boards(keybed, terms, plans) => {
                let mut keybed = keybed.arm(terms, PATIENCE_US)?;
                for (key, gestures) in
                    performance.into_iter().flat_map(|it| all_keys().zip(&it.gestures))
                {
                    keybed.play(key, gestures);
                }
                let start = clock::monotonic().after(lead);
                keybed.begin_at(start.as_u64() / 1_000);
                Ok((Bus::Boards(Box::new(keybed), plans), start))
            }
        }
    }
}

impl KeyBus for Bus {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        match self {
            Self::Simulated(keys) => keys.receive(tick, samples),
            Self::Boards(keybed, _) => keybed.receive(tick, samples),
        }
    }

    fn send(&mut self, tick: u64, forces: &[f64; KEYS]) {
        match self {
            Self::Simulated(keys) => keys.send(tick, forces),
            Self::Boards(keybed, _) => keybed.send(tick, forces),
        }
    }

    fn send_sloped(&mut self, tick: u64, forces: &[f64; KEYS], slopes: &[KeySlope; KEYS]) {
        match self {
            Self::Simulated(keys) => keys.send(tick, forces),
            Self::Boards(keybed, _) => keybed.send_sloped(tick, forces, slopes),
        }
    }
}

impl Bus {
    /// Takes what boards send until `start` is near, so that the first tick finds what is new.
    pub(super) fn attend_until(&mut self, start: Nanos) {
        let Self::Boards(keybed, _) = self else { return };
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
    pub(super) fn stop(&mut self) {
        /// Told so often, since nobody answers.
        const TIMES: u8 = 3;
        match self {
            Self::Simulated(_) => {}
            Self::Boards(keybed, _) => (0..TIMES).for_each(|_| keybed.stop(1)),
        }
    }

    /// Tells boards to render no force; a simulated keybed ends with the run.
    pub(super) fn disarm(&mut self) {
        match self {
            Self::Simulated(_) => {}
            Self::Boards(keybed, _) => keybed.disarm(),
        }
    }

    /// What happened on all links together.
    pub(super) fn links(&self) -> Links {
        match self {
            Self::Simulated(keys) => simulated_links(keys),
            Self::Boards(keybed, _) => board_links(keybed),
        }
    }

    /// What became of each line; nothing of simulated ones.
    pub(super) fn lines(&self, seconds: f64) -> Vec<LinkLine> {
        match self {
            Self::Simulated(_) => Vec::new(),
            Self::Boards(keybed, plans) => {
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
        match self {
            Self::Simulated(_) => Vec::new(),
            Self::Boards(keybed, _) => {
                keybed.board_reports().iter().map(|it| BoardLine::new(it, seconds)).collect()
            }
        }
    }
}

fn simulated_links(keys: &Keys) -> Links {
    let mut sum = Links { rearmed: keys.rearmed, ..Links::default() };
    for board in BoardId::all() {
        let (it, wire) = (keys.keybed.statistics(board), keys.keybed.wire(board));
        sum.frames += it.samples.frames;
        sum.gaps += it.samples.gaps;
        sum.refused += wire.corrupt + wire.foreign + it.refused + wire.down;
    }
    sum
}

fn board_links(keybed: &Keybed<Armed>) -> Links {
    let mut sum = Links::default();
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
