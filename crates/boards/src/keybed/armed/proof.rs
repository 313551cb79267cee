//! Proof of the motors before a model may use them.

use scheduler::motion::{KEYS, KeySlope};
use scheduler::port::KeyBus as _;

use super::{BoardReport, Keybed, refusals::slot_names};
use crate::keybed::{Armed, LOOK};
use crate::refusal::{Refusal, Refusals};
use crate::rt::key_fault::KeyFault;

/// Time without a push, after which the remaining motors wait for a hand to leave (us).
const QUIET_US: u64 = 250_000;

/// Longest time for all proofs, which run in parallel (us).
const LONGEST_US: u64 = 4_000_000;

/// Time in which boards report their counts (us).
const COUNTING_US: u64 = 200_000;

impl Keybed<Armed> {
    /// Guards keys against bad readings, fast force changes, shaking and motors that do not follow.
    pub fn guard(&mut self) {
        let period_us = self.stage.period_us;
        self.stage.is_guarded = true;
        self.stage.bus.guard(period_us);
    }

    /// Lets every motor of guarded keys push its key gently, and waits for the responses.
    ///
    /// A held key is proven in the run, with at most 1 N until then. A key that fails is muted.
    ///
    /// # Errors
    /// The boards without any motor that passed.
    pub fn prove_motors(&mut self) -> Result<(), Refusals> {
        self.stage.bus.demand_proof();
        let start = self.now_us();
        let mut pushed = start;
        loop {
            let now = self.exchange();
            if self.stage.bus.is_proving() {
                pushed = now;
            }
            if pushed + QUIET_US < now || start + LONGEST_US < now || self.is_proven() {
                break;
            }
        }
        let refusals = self.unproven_boards();
        if refusals.is_empty() { Ok(()) } else { Err(Refusals(refusals)) }
    }

    fn is_proven(&self) -> bool {
        let mut boards = self.stage.bus.boards().iter();
        boards.all(|board| board.statistics().keys.unproven == 0)
    }

    /// Exchanges the forces of proofs for one period, to keep boards armed; returns the time (us).
    pub fn exchange(&mut self) -> u64 {
        let end = self.now_us() + self.stage.period_us;
        while self.now_us() < end {
            self.attend();
            self.clock.pause(LOOK);
        }
        self.send(0, &[0.0; KEYS], &[KeySlope::HELD; KEYS]);
        self.forget_exchanges();
        self.now_us()
    }

    fn unproven_boards(&mut self) -> Vec<Refusal> {
        if !self.board_reports().iter().any(has_unmoved_keys) {
            return Vec::new();
        }
        self.stage.supervisor.want_counters();
        let end = self.now_us() + COUNTING_US;
        while self.now_us() < end {
            self.exchange();
        }
        let reports = self.board_reports().into_iter().filter(has_unmoved_keys);
        // A hand may hold one of its keys and prove nothing; untaken forces prove a fault.
        let is_refused =
            |it: &BoardReport| it.statistics.keys.unproven == 0 || it.untaken_forces().is_some();
        reports.filter(is_refused).map(not_proven).collect()
    }
}

fn has_unmoved_keys(report: &BoardReport) -> bool {
    let keys = &report.statistics.keys;
    let muted = keys.muted[..report.place.n_keys].iter().enumerate();
    let is_motor = |it: &KeyFault| matches!(it, KeyFault::Reversed | KeyFault::Unmoved);
    let is_unmoved = |(slot, muted): (usize, &Option<KeyFault>)| match muted {
        Some(fault) => is_motor(fault),
        None => keys.unproven >> slot & 1 == 1,
    };
    muted.clone().all(is_unmoved) && muted.into_iter().any(|(_, it)| it.is_some())
}

fn not_proven(report: BoardReport) -> Refusal {
    let forces = report.untaken_forces();
    let BoardReport { name: board, place, statistics, .. } = report;
    let keys = slot_names(place.first_key, !(u16::MAX << place.n_keys.min(15)));
    if let Some(forces) = forces {
        return Refusal::TakesNoForce { board, keys, forces };
    }
    let first = statistics.keys.muted.into_iter().flatten().next();
    Refusal::NotProven { board, keys, fault: first.unwrap_or(KeyFault::Unmoved) }
}
