//! One key's rows, column by column.

use scheduler::voice::VoiceFault;
use telemetry::{KeyBlock, KeyState};

use super::ModelProbe;
use crate::adapters::tick_recorder::{KeyRow, RowFlags};

/// Bits of `KeyBlock.flags`.
pub(crate) mod flag {
    pub(crate) const IDLE: u8 = 1;
    pub(crate) const LATE: u8 = 2;
    pub(crate) const FRESH: u8 = 4;
    pub(crate) const GAP: u8 = 8;
    pub(crate) const WAITED: u8 = 16;
}

pub(super) const fn flags(stands: RowFlags) -> u8 {
    (if stands.idle { flag::IDLE } else { 0 })
        | (if stands.late { flag::LATE } else { 0 })
        | (if stands.fresh { flag::FRESH } else { 0 })
        | (if stands.waited { flag::WAITED } else { 0 })
}

/// Returns a fault's number in messages; the larger the worse.
pub(super) const fn fault_number(fault: Option<VoiceFault>) -> u8 {
    match fault {
        None => 0,
        Some(VoiceFault::NotFinite) => 1,
        Some(VoiceFault::BadSample) => 2,
        Some(VoiceFault::Capped { .. }) => 3,
        Some(VoiceFault::Diverged) => 4,
        Some(VoiceFault::Panicked) => 5,
        Some(VoiceFault::MakesEnergy) => 6,
        Some(VoiceFault::Muted) => 7,
    }
}

fn push_velocity(block: &mut KeyBlock, velocity: Option<f64>) {
    if velocity.is_some() || !block.velocity.is_empty() {
        block.velocity.resize(block.taken.len(), f64::NAN);
        if let (Some(last), Some(velocity)) = (block.velocity.last_mut(), velocity) {
            *last = velocity;
        }
    }
}

/// Adds the `limit` of row `index`; the column is empty as long as no turn was cut off.
fn push_limit(limits: &mut Vec<u32>, index: usize, limit: u32) {
    if 0 < limit || !limits.is_empty() {
        limits.resize(index, 0);
        limits.push(limit);
    }
}

#[derive(Debug, Default)]
pub(super) struct BlockBuilder {
    block: KeyBlock,
}

impl BlockBuilder {
    /// Adds a row with the signals of `probe`, if its model is known.
    pub(super) fn push(&mut self, row: &KeyRow, flags: u8, probe: Option<&dyn ModelProbe>) {
        let block = &mut self.block;
        if block.after.is_empty() {
            (block.key, block.tick) = (row.key.into(), row.tick);
        }
        block.after.push(u32::try_from(row.tick - block.tick).unwrap_or(u32::MAX));
        block.position.push(row.sample.position);
        block.age.push(row.sample.age);
        block.taken.push(row.sample.taken);
        push_velocity(block, row.sample.velocity);
        let index = block.taken.len() - 1;
        push_limit(&mut block.limit, index, row.limit);
        push_limit(&mut block.late_limit, index, row.late_limit);
        block.force.push(row.force);
        block.sent.push(row.sent);
        block.mode.push(if probe.is_some() { row.look.structure() } else { u8::MAX });
        block.flags.push(flags);
        block.fault.push(fault_number(row.fault));
        block.revision.push(row.look.revision);
        block.unrun.push(!row.ran);
        block.events.push(row.events.into());
        if let Some(probe) = probe {
            probe.see(&row.look, &mut block.signals);
        }
    }

    /// Takes the block so far, if any. All its voices have the same number of signals.
    pub(super) fn take(&mut self) -> Option<KeyBlock> {
        (!self.block.after.is_empty()).then(|| std::mem::take(&mut self.block))
    }

    /// Returns `true` if `row` is of another voice than the rows so far.
    pub(super) fn is_of_another(&self, row: &KeyRow) -> bool {
        self.block.revision.last().is_some_and(|last| *last != row.look.revision)
    }
}

/// Returns the rows of `block` one by one, for viewers of single values.
pub(super) fn states(block: &KeyBlock) -> impl Iterator<Item = KeyState> {
    let rows = block.after.len().max(1);
    let width = block.signals.len() / rows;
    (0..block.after.len()).map(move |row| KeyState {
        tick: block.tick + u64::from(block.after[row]),
        position: block.position[row],
        force: block.sent[row],
        mode: u32::from(block.mode[row]),
        signals: block.signals[row * width..(row + 1) * width].to_vec(),
    })
}
