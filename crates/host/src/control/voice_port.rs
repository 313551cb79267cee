use std::sync::Arc;

use engine::realtime::pool::{VoiceChange, VoiceSwaps};
use engine::voice::AuditCell;
use pode::EnergyAudit;

use super::NOT_RUNNING;

/// Numbers voices, sends changes to them and sums up their energy audits.
#[derive(Debug, Default)]
pub(super) struct VoicePort {
    pub(super) swaps: Option<VoiceSwaps>,
    revisions: u32,
    audits: EnergySum,
}

#[derive(Debug, Default)]
struct EnergySum {
    /// Sum over voices that are gone.
    settled: EnergyAudit,
    open: Vec<Arc<AuditCell>>,
}

impl VoicePort {
    pub(super) const fn new_revision(&mut self) -> u32 {
        self.revisions += 1;
        self.revisions
    }

    pub(super) fn new_cell(&mut self) -> Arc<AuditCell> {
        let cell = Arc::new(AuditCell::default());
        self.audits.settle();
        self.audits.open.push(Arc::clone(&cell));
        cell
    }

    pub(super) fn energy(&self) -> EnergyAudit {
        let mut sum = self.audits.settled;
        self.audits.open.iter().for_each(|cell| sum.add(&cell.read()));
        sum
    }

    /// Calls `tell`, then sends `changes` to the voices of their keys; all or none. They wait a
    /// moment for earlier changes. The error is a sentence.
    pub(super) fn send(
        &mut self,
        changes: Vec<(usize, VoiceChange)>,
        tell: impl FnOnce(),
    ) -> Result<(), String> {
        let swaps = self.swaps.as_mut().ok_or(NOT_RUNNING)?;
        let keys: Vec<_> = changes.iter().map(|(key, _change)| *key).collect();
        swaps.wait_for_room(&keys)?;
        tell();
        for (key, change) in changes {
            swaps.send(key, change).map_err(|refused| format!("key {key}: {refused}"))?;
        }
        Ok(())
    }
}

impl EnergySum {
    /// Adds the voices that are gone to the sum, which frees their cells.
    fn settle(&mut self) {
        let settled = &mut self.settled;
        self.open.retain(|cell| {
            let plays = 1 < Arc::strong_count(cell);
            if !plays {
                settled.add(&cell.read());
            }
            plays
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn voices_that_are_gone_stay_in_the_sum_and_take_no_room() {
        let mut port = VoicePort::default();
        let audit = EnergyAudit { supplied: 1.0, ..EnergyAudit::default() };
        for _ in 0..100 {
            port.new_cell().publish(&audit);
        }
        let plays = port.new_cell();
        plays.publish(&audit);
        assert_eq!(port.energy().supplied.to_bits(), 101.0_f64.to_bits());
        assert_eq!(port.audits.open.len(), 1);
    }

    #[test]
    fn voices_are_numbered_from_one_and_reached_only_while_they_run() {
        let mut port = VoicePort::default();
        assert_eq!([port.new_revision(), port.new_revision()], [1, 2]);
        let refused = port.send(Vec::new(), || panic!("nothing is told of what is refused"));
        assert_eq!(refused, Err(NOT_RUNNING.to_owned()));
    }
}
