//! Simulated boards in real time, for `letoff board` and for tests that inject faults.
//!
//! One thread runs all of them; each has its own link and list of faults ([`fault_script`]).

mod board_process;
pub mod fault_script;
mod wire;

use std::sync::atomic::{AtomicBool, Ordering};

use boards::sim::board::BoardCounts;
use scheduler::time::Nanos;
use serde::Serialize;

pub use board_process::BoardProcess;
use engine::realtime::clock;
use fault_script::FaultScript;
pub use wire::{Placed, WireEndpoint, place};

const POLL_PERIOD: Nanos = Nanos::from_micros(500);

/// Final state of a board.
#[derive(Clone, Debug, Serialize)]
pub struct ExitReport {
    pub number: u8,
    pub keys: String,
    pub link: String,
    /// Reason why it renders no forces, or `it is armed`.
    pub state: &'static str,
    /// Largest force of its motors now (N).
    pub force_n: f64,
    /// Longest time from the loss of permission until motors were without force (ms), if lost.
    pub quiet_after_ms: Option<f64>,
    /// Largest force without that permission, after the time to fade (N).
    pub force_while_safe_n: f64,
    /// Longest pause in which this machine did not run it while it rendered forces (ms).
    pub longest_gap_ms: f64,
    pub lights: u64,
    pub counts: BoardCounts,
}

/// Runs `boards` until `stop` or for `duration`; calls `lit` for each light that goes on.
pub fn run(
    boards: &mut [BoardProcess],
    duration: Option<Nanos>,
    stop: &AtomicBool,
    lit: &mut dyn FnMut(&BoardProcess),
) {
    let began = clock::monotonic();
    let is_over = |now: Nanos| duration.is_some_and(|duration| duration <= now.since(began));
    let (mut now, mut due) = (began, began);
    while !is_over(now) && !stop.load(Ordering::Acquire) {
        for board in boards.iter_mut() {
            let lights = board.lights;
            board.run(now);
            if lights < board.lights {
                lit(board);
            }
        }
        // Missed periods are not made up for, since boards follow their clock.
        due = due.after(POLL_PERIOD).max(now);
        clock::sleep_until(due);
        now = clock::monotonic();
    }
}

pub fn faults_of(faults: &[FaultScript], number: u8) -> Vec<FaultScript> {
    let mut its: Vec<_> = faults.iter().copied().filter(|it| it.number == number).collect();
    its.sort_by(|one, other| one.at.total_cmp(&other.at));
    its
}
