//! Simulated boards in real time, for `letoff board`: what a builder has before the first
//! board is soldered, and what tests break.
//!
//! One thread lets all of them live; each has a link of its own, and a fate that may be
//! written beforehand ([`fate`]).

pub mod fate;
mod living;
mod wire;

use std::sync::atomic::{AtomicBool, Ordering};

use hardware::sim::board::BoardCounts;
use scheduler::time::Nanos;
use serde::Serialize;

use fate::FaultScript;
pub use living::BoardProcess;
use realtime::clock;
pub use wire::{Placed, WireEndpoint, place};

/// Time between two looks at the links.
const LOOK: Nanos = Nanos::from_micros(500);

/// What a board was like in the end.
#[derive(Clone, Debug, Serialize)]
pub struct ExitReport {
    pub number: u8,
    pub keys: String,
    /// Where it was to be found.
    pub link: String,
    /// Why it renders no force, or that it does.
    pub state: &'static str,
    /// Largest force of its motors now (N).
    pub force_n: f64,
    /// Longest time from losing its right to render until all its motors were without force
    /// (ms); none if it never lost it.
    pub quiet_after_ms: Option<f64>,
    /// Largest force of its motors while it had no right to render, once they had had time to
    /// fade (N).
    pub force_while_safe_n: f64,
    /// Longest time that it was not looked after while it rendered forces [ms]: by nobody's
    /// fault but this machine's.
    pub longest_gap_ms: f64,
    /// Times that its light went on.
    pub lights: u64,
    pub counts: BoardCounts,
}

/// Lets `boards` live until `stop`, or for `duration`; `lit` hears of each whose light goes on.
pub fn live(
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
            let lights = board.lights();
            board.live(now);
            if lights < board.lights() {
                lit(board);
            }
        }
        // What was missed is not made up for: boards go by their clock.
        due = due.after(LOOK).max(now);
        clock::sleep_until(due);
        now = clock::monotonic();
    }
}

/// The fates of the board `number` among all that were written.
pub fn fates_of(fates: &[FaultScript], number: u8) -> Vec<FaultScript> {
    let mut its: Vec<_> = fates.iter().copied().filter(|it| it.number == number).collect();
    its.sort_by(|one, other| one.at.total_cmp(&other.at));
    its
}
