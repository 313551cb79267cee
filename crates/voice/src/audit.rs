//! A voice's energy audit, readable from outside the tick.

use std::sync::atomic::{AtomicU64, Ordering};

use pode::EnergyAudit;
use serde::Serialize;

/// Four numbers that one voice writes and any thread reads, without waiting.
///
/// Readers may see sums of two neighbouring ticks; they are read when the run is over.
#[derive(Debug, Default)]
pub struct AuditCell([AtomicU64; 4]);

impl AuditCell {
    /// Writes the present sums; wait-free.
    pub fn publish(&self, audit: &EnergyAudit) {
        let sums = [audit.supplied, audit.dissipated, audit.jumps, audit.stored];
        for (cell, sum) in self.0.iter().zip(sums) {
            cell.store(sum.to_bits(), Ordering::Relaxed);
        }
    }

    /// Reads the newest sums.
    pub fn read(&self) -> EnergyAudit {
        let [supplied, dissipated, jumps, stored] =
            [0, 1, 2, 3].map(|i| f64::from_bits(self.0[i].load(Ordering::Relaxed)));
        EnergyAudit { supplied, dissipated, jumps, stored }
    }
}

/// An energy audit as reports show it (J).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct AuditReport {
    /// Work done by the fingers on the voices.
    pub supplied: f64,
    /// Taken by dampers and friction inside the models.
    pub dissipated: f64,
    pub jumps: f64,
    /// Change of what the models store.
    pub stored: f64,
    /// What these leave unexplained: integration error.
    pub residual: f64,
}

impl From<EnergyAudit> for AuditReport {
    fn from(audit: EnergyAudit) -> Self {
        Self {
            supplied: audit.supplied,
            dissipated: audit.dissipated,
            jumps: audit.jumps,
            stored: audit.stored,
            residual: audit.residual(),
        }
    }
}
