//! Conformance of a real board with the protocol, tried item by item from outside.
//!
//! | file | trials |
//! |---|---|
//! | `tested_board` | one request and its answer; samples, and forces that answer them |
//! | `requests` | the hello, the time of answers, and requests that must be refused |
//! | `streams` | rate, numbers, times and age of samples, and the clock |
//! | `arming` | nonces, the watchdog, recovery, the emergency stop |
//!
//! The host's own bring-up is not used, since a board may break it. No force is sent before
//! [`ConformanceDepth::Arm`], and then at most [`MOST_FORCE_MN`].

mod arming;
mod requests;
mod streams;
mod tested_board;

use firmware_protocol::frame::hello::Introduction;
use serde::Serialize;

pub use tested_board::{TestedBoard, introductions};

/// Largest force on any key (mN): a weight of 5 g, up.
pub const MOST_FORCE_MN: i32 = 50;

/// Depth of a board's trial.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ConformanceDepth {
    Quiet,
    /// It is armed, and commanded [`MOST_FORCE_MN`].
    Arm,
    /// Like `Arm`, with a final emergency stop, which only a restart of the board undoes.
    Stop,
}

/// Result of one item.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ConformanceOutcome {
    Kept,
    Broken,
    /// This machine may have caused the observation.
    Undecided,
    NotTried,
}

/// One item of the protocol, with the board's result.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct ConformanceItem {
    /// Required behaviour of a board.
    pub item: &'static str,
    pub outcome: ConformanceOutcome,
    pub seen: String,
}

impl ConformanceItem {
    fn new(item: &'static str, seen: Result<String, String>) -> Self {
        let outcome =
            if seen.is_ok() { ConformanceOutcome::Kept } else { ConformanceOutcome::Broken };
        let (Ok(seen) | Err(seen)) = seen;
        Self { item, outcome, seen }
    }

    /// Like [`Self::new`], but undecided if this machine, late by `late_us`, may have broken it.
    fn judged(item: &'static str, seen: Result<String, String>, late_us: u64) -> Self {
        /// Largest lateness of a machine that is in time (us).
        const IN_TIME_US: u64 = 20_000;
        match seen {
            Err(seen) if IN_TIME_US < late_us => {
                let ms = late_us / 1_000;
                let seen = format!(
                    "{seen}; this machine was late by {ms} ms meanwhile: try again while it does \
                     nothing else"
                );
                Self { item, outcome: ConformanceOutcome::Undecided, seen }
            }
            seen => Self::new(item, seen),
        }
    }

    fn not_tried(item: &'static str, why: &str) -> Self {
        Self { item, outcome: ConformanceOutcome::NotTried, seen: why.to_owned() }
    }
}

/// Tries the board of `introduction`, to the given `depth`; it is disarmed in the end.
pub fn conformance(
    board: &mut TestedBoard<'_>,
    introduction: &Introduction,
    depth: ConformanceDepth,
) -> Vec<ConformanceItem> {
    let mut items = requests::items(board, introduction);
    items.extend(streams::items(board, &introduction.hello));
    if ConformanceDepth::Arm <= depth {
        items.extend(arming::items(board));
    }
    if ConformanceDepth::Stop <= depth {
        items.push(arming::stop(board));
    }
    items.push(streams::ends(board));
    board.leave();
    items
}
