//! A voice's energy audit, readable from outside the tick.

use std::sync::atomic::{AtomicU64, Ordering};

use pode::EnergyAudit;
use serde::Serialize;

/// Numbers that one voice writes and any thread reads, without waiting.
///
/// Readers may see sums of two neighbouring ticks; they are read when the run is over.
#[derive(Debug, Default)]
pub struct AuditCell([AtomicU64; 6]);

impl AuditCell {
    /// Writes the present sums; wait-free.
    pub fn publish(&self, audit: &EnergyAudit) {
        let EnergyAudit { supplied, dissipated, jumps, sampling, integration, stored, .. } = *audit;
        let sums = [supplied, dissipated, jumps, sampling, integration, stored];
        for (cell, sum) in self.0.iter().zip(sums) {
            cell.store(sum.to_bits(), Ordering::Relaxed);
        }
    }

    /// Reads the newest sums.
    pub fn read(&self) -> EnergyAudit {
        let [supplied, dissipated, jumps, sampling, integration, stored] =
            std::array::from_fn(|i| f64::from_bits(self.0[i].load(Ordering::Relaxed)));
        let level = None;
        EnergyAudit { supplied, dissipated, jumps, sampling, integration, stored, level }
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
    /// Made where the inputs jump from one sample to the next.
    pub sampling: f64,
    /// Made by the integration's error.
    pub integration: f64,
    /// Change of what the models store.
    pub stored: f64,
    /// What these leave unexplained: rounding.
    pub residual: f64,
}

impl From<EnergyAudit> for AuditReport {
    fn from(audit: EnergyAudit) -> Self {
        Self {
            supplied: audit.supplied,
            dissipated: audit.dissipated,
            jumps: audit.jumps,
            sampling: audit.sampling,
            integration: audit.integration,
            stored: audit.stored,
            residual: audit.residual(),
        }
    }
}
