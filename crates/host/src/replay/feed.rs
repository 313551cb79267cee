//! What decided in each tick, out of a recording's messages.

use std::collections::{BTreeMap, VecDeque};

use scheduler::motion::{KEYS, KeySample};
use scheduler::overload::Simplifications;
use telemetry::event::Kind;
use telemetry::{Event, KeyBlock, Ticks};

use crate::observe::flag;

/// A key in a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct KeyTick {
    pub(super) sample: KeySample,
    /// Which voice it was of; 0 if that is not known.
    pub(super) revision: u32,
    pub(super) lane: LaneStatus,
    /// In which of the last ticks it was not run: bit 1 is the one before. Of a late lane that is
    /// known if bit 0 is not set.
    pub(super) unrun: u32,
    /// Units of work after which its turn was cut off, if it was.
    pub(super) limit: Option<u32>,
}

/// How the key's lane was.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LaneStatus {
    Done,
    Late,
}

/// Whether voices are felt.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Arm {
    On,
    Off,
}

/// Rows of all keys that wait for their tick.
#[derive(Debug)]
pub(super) struct Feed {
    rows: Vec<VecDeque<(u64, KeyTick)>>,
    /// As each key was last.
    last: Vec<KeyTick>,
    /// Ticks from which voices are felt or not.
    arms: BTreeMap<u64, Arm>,
    /// Ticks from which something else is left out.
    simplified: BTreeMap<u64, Simplifications>,
    /// The first tick before which rows are missing.
    gap: Option<u64>,
}

impl Feed {
    pub(super) fn new() -> Self {
        let nothing = KeyTick {
            sample: KeySample::default(),
            revision: 0,
            lane: LaneStatus::Done,
            unrun: 0,
            limit: None,
        };
        Self {
            rows: vec![VecDeque::new(); KEYS],
            last: vec![nothing; KEYS],
            arms: BTreeMap::new(),
            simplified: BTreeMap::new(),
            gap: None,
        }
    }

    /// Takes the rows of a block; columns that are too short end it.
    pub(super) fn block(&mut self, block: &KeyBlock) {
        let Some(rows) = usize::try_from(block.key).ok().and_then(|key| self.rows.get_mut(key))
        else {
            return;
        };
        for row in 0..block.after.len() {
            let Some((tick, fed, flags)) = self::row(block, row) else { return };
            if flags & flag::GAP != 0 {
                self.gap = self.gap.or(Some(tick));
            }
            rows.push_back((tick, fed));
        }
    }

    /// Takes what happened, as far as it decides.
    pub(super) fn event(&mut self, event: &Event) {
        let arm = match event.kind() {
            Kind::Overload => {
                let bits = u8::try_from(event.simplified).unwrap_or(u8::MAX);
                self.simplified.insert(event.tick, Simplifications::of_bits(bits));
                return;
            }
            Kind::Arm => Arm::On,
            Kind::Disarm => Arm::Off,
            Kind::Unknown
            | Kind::Switch
            | Kind::Strike
            | Kind::DamperLift
            | Kind::Pressure
            | Kind::DamperFall
            | Kind::Fault
            | Kind::Recovery
            | Kind::Miss
            | Kind::Skip
            | Kind::Board
            | Kind::Change
            | Kind::Starved
            | Kind::Pedal => return,
        };
        self.arms.insert(event.tick, arm);
    }

    /// Whether voices are felt or not from `tick` on, if that changes there.
    pub(super) fn arm(&mut self, tick: u64) -> Option<Arm> {
        last_until(&mut self.arms, tick)
    }

    /// What is left out from `tick` on, if that changes there.
    pub(super) fn simplified(&mut self, tick: u64) -> Option<Simplifications> {
        last_until(&mut self.simplified, tick)
    }

    /// Whether the first rows of keys say that they were run before `tick`.
    pub(super) fn begins_late(&self, tick: u64) -> bool {
        let of = |rows: &VecDeque<(u64, KeyTick)>| rows.front().copied();
        self.rows.iter().filter_map(of).any(|(at, fed)| {
            // A voice that was never run before says so of all ticks before.
            fed.lane == LaneStatus::Done && at <= tick && fed.unrun != u32::MAX - 1
        })
    }

    /// Takes what decided from `tick` on for missing.
    pub(super) fn lose(&mut self, tick: u64) {
        self.gap.get_or_insert(tick);
    }

    /// The first tick before which rows are missing, if there is one.
    pub(super) const fn gap(&self) -> Option<u64> {
        self.gap
    }

    /// All keys in `tick`.
    pub(super) fn tick(&mut self, tick: u64) -> Vec<KeyTick> {
        for (rows, last) in self.rows.iter_mut().zip(&mut self.last) {
            while rows.front().is_some_and(|(at, _fed)| *at < tick) {
                rows.pop_front();
            }
            let now = rows.front().filter(|(at, _fed)| *at == tick).map(|(_at, fed)| *fed);
            *last = now.unwrap_or(KeyTick {
                // It lies still, as it did before.
                sample: KeySample { age: 0, taken: 0.0, ..last.sample },
                lane: LaneStatus::Done,
                unrun: 0,
                limit: None,
                revision: last.revision,
            });
        }
        self.last.clone()
    }
}

/// Takes the changes up to `tick` out of `changes` and returns the last of them.
fn last_until<T>(changes: &mut BTreeMap<u64, T>, tick: u64) -> Option<T> {
    let later = changes.split_off(&tick.saturating_add(1));
    std::mem::replace(changes, later).into_values().last()
}

/// The ticks that a message tells of.
pub(super) fn ticks(message: &Ticks) -> impl Iterator<Item = u64> {
    message.after.iter().map(|after| message.tick.saturating_add(u64::from(*after)))
}

/// One row with its flags, if all columns have it.
fn row(block: &KeyBlock, row: usize) -> Option<(u64, KeyTick, u8)> {
    let tick = block.tick.checked_add(u64::from(*block.after.get(row)?))?;
    let flags = *block.flags.get(row)?;
    let sample = KeySample {
        position: *block.position.get(row)?,
        age: *block.age.get(row)?,
        taken: *block.taken.get(row)?,
        velocity: block.velocity.get(row).copied().filter(|it| !it.is_nan()),
    };
    let unrun = *block.unrun.get(row)?;
    let lane = if flags & flag::LATE == 0 { LaneStatus::Done } else { LaneStatus::Late };
    let revision = *block.revision.get(row)?;
    // Not needed, but a whole row has it.
    block.events.get(row)?;
    let limit = block.limit.get(row).copied().filter(|limit| 0 < *limit);
    Some((tick, KeyTick { sample, revision, lane, unrun, limit }, flags))
}
