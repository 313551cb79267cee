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

use crate::realtime::clock;
use fate::Fate;
pub use living::Living;
pub use wire::{Place, Placed, place};

/// Time between two looks at the links.
const LOOK: Nanos = Nanos::from_micros(500);

/// What a board was like in the end.
#[derive(Clone, Debug, Serialize)]
pub struct Epitaph {
    /// Its number.
    pub number: u8,
    /// Its keys.
    pub keys: String,
    /// Where it was to be found.
    pub link: String,
    /// Why it renders no force, or that it does.
    pub state: &'static str,
    /// Largest force of its motors now [N].
    pub force_n: f64,
    /// Longest time from losing its right to render until all its motors were without force
    /// [ms]; none if it never lost it.
    pub quiet_after_ms: Option<f64>,
    /// Largest force of its motors while it had no right to render, once they had had time to
    /// fade [N].
    pub force_while_safe_n: f64,
    /// What it counted.
    pub counts: Counts,
}

/// What a board counted.
#[derive(Clone, Copy, Debug, Serialize)]
#[expect(missing_docs, reason = "hardware::sim::board::BoardCounts says it")]
pub struct Counts {
    pub samples: u64,
    pub unsent: u64,
    pub forces: u64,
    pub corrupt: u64,
    pub refused: u64,
    pub stale: u64,
    pub unarmed: u64,
    pub unanswered: u64,
    pub trips: u64,
    pub armings: u64,
    pub oldest_us: u64,
}

impl From<BoardCounts> for Counts {
    fn from(it: BoardCounts) -> Self {
        Self {
            samples: it.samples,
            unsent: it.unsent,
            forces: it.forces,
            corrupt: it.corrupt,
            refused: it.refused,
            stale: it.stale,
            unarmed: it.unarmed,
            unanswered: it.unanswered,
            trips: it.trips,
            armings: it.armings,
            oldest_us: it.oldest_us,
        }
    }
}

/// Lets `boards` live until `stop`, or for `duration`; `look` sees them now and then.
pub fn live(
    boards: &mut [Living],
    duration: Option<Nanos>,
    stop: &AtomicBool,
    mut look: impl FnMut(&[Living]),
) {
    /// Looks between two calls of `look`.
    const SELDOM: u32 = 1_000;
    let began = clock::monotonic();
    let mut due = began;
    for n in (0..SELDOM).cycle() {
        let now = clock::monotonic();
        let is_over = duration.is_some_and(|duration| duration <= now.since(began));
        if is_over || stop.load(Ordering::Acquire) {
            return;
        }
        for board in boards.iter_mut() {
            board.live(now);
        }
        if n == 0 {
            look(boards);
        }
        // What was missed is not made up for: boards go by their clock.
        due = due.after(LOOK).max(now);
        clock::sleep_until(due);
    }
}

/// The fates of the board `number` among all that were written.
pub fn fates_of(fates: &[Fate], number: u8) -> Vec<Fate> {
    let mut its: Vec<_> = fates.iter().copied().filter(|it| it.number == number).collect();
    its.sort_by(|one, other| one.at.total_cmp(&other.at));
    its
}
