//! Inputs of each tick, from a recording's messages.

use std::collections::{BTreeMap, VecDeque};

use scheduler::motion::{KEYS, KeySample};
use scheduler::overload::Simplifications;
use telemetry::{Event, KeyBlock, Ticks, event::Kind};

use crate::observe::flag;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct KeyTick {
    pub(super) sample: KeySample,
    /// Revision of the voice; 0 if unknown.
    pub(super) revision: u32,
    pub(super) lane: LaneStatus,
    /// Recent ticks in which it did not run: bit 1 is the one before. For a late lane it is known
    /// if bit 0 is not set.
    pub(super) unrun: u32,
    /// Units of work after which its turn was cut off, if it was.
    pub(super) limit: Option<u32>,
    /// The same of the late turn that is handed over.
    pub(super) late_limit: Option<u32>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LaneStatus {
    Done,
    Late,
    /// It had no time left for the voice.
    Waited,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Arm {
    On,
    Off,
}

#[derive(Debug)]
pub(super) struct Feed {
    rows: Vec<VecDeque<(u64, KeyTick)>>,
    last: Vec<KeyTick>,
    arms: BTreeMap<u64, Arm>,
    simplified: BTreeMap<u64, Simplifications>,
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
            late_limit: None,
        };
        Self {
            rows: vec![VecDeque::new(); KEYS],
            last: vec![nothing; KEYS],
            arms: BTreeMap::new(),
            simplified: BTreeMap::new(),
            gap: None,
        }
    }

    /// Adds the rows of a block; columns that are too short end it.
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

    pub(super) fn arm(&mut self, tick: u64) -> Option<Arm> {
        last_until(&mut self.arms, tick)
    }

    pub(super) fn simplified(&mut self, tick: u64) -> Option<Simplifications> {
        last_until(&mut self.simplified, tick)
    }

    /// Returns `true` if the first rows of keys report runs before `tick`.
    pub(super) fn begins_late(&self, tick: u64) -> bool {
        let of = |rows: &VecDeque<(u64, KeyTick)>| rows.front().copied();
        self.rows.iter().filter_map(of).any(|(at, fed)| {
            // A new voice reports that it never ran, for all ticks before.
            fed.lane == LaneStatus::Done && at <= tick && fed.unrun != u32::MAX - 1
        })
    }

    pub(super) fn lose(&mut self, tick: u64) {
        self.gap.get_or_insert(tick);
    }

    pub(super) const fn gap(&self) -> Option<u64> {
        self.gap
    }

    pub(super) fn tick(&mut self, tick: u64) -> Vec<KeyTick> {
        for (rows, last) in self.rows.iter_mut().zip(&mut self.last) {
            while rows.front().is_some_and(|(at, _fed)| *at < tick) {
                rows.pop_front();
            }
            let now = rows.front().filter(|(at, _fed)| *at == tick).map(|(_at, fed)| *fed);
            *last = now.unwrap_or(KeyTick {
                // It still lies still.
                sample: KeySample { age: 0, taken: 0.0, ..last.sample },
                lane: LaneStatus::Done,
                unrun: 0,
                limit: None,
                late_limit: None,
                revision: last.revision,
            });
        }
        self.last.clone()
    }
}

/// Removes the changes up to `tick` and returns the last of them.
fn last_until<T>(changes: &mut BTreeMap<u64, T>, tick: u64) -> Option<T> {
    let later = changes.split_off(&tick.saturating_add(1));
    std::mem::replace(changes, later).into_values().last()
}

pub(super) fn ticks(message: &Ticks) -> impl Iterator<Item = u64> {
    message.after.iter().map(|after| message.tick.saturating_add(u64::from(*after)))
}

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
    let lane = match flags & (flag::LATE | flag::WAITED) {
        0 => LaneStatus::Done,
        flag::LATE => LaneStatus::Late,
        _ => LaneStatus::Waited,
    };
    let revision = *block.revision.get(row)?;
    block.events.get(row)?;
    let [limit, late_limit] = [&block.limit, &block.late_limit]
        .map(|limits| limits.get(row).copied().filter(|limit| 0 < *limit));
    Some((tick, KeyTick { sample, revision, lane, unrun, limit, late_limit }, flags))
}
