//! Whether a real board keeps the protocol: tried item by item, from outside.
//!
//! | file | what is tried |
//! |---|---|
//! | `tested_board` | one request and its answer; samples, and forces that answer them |
//! | `requests` | the hello, how quickly requests are answered, and what must be refused |
//! | `streams` | rate, numbers, times and age of samples, and the clock |
//! | `arming` | nonces, the watchdog, recovery, the emergency stop |
//!
//! Nothing of the host's own bring-up is used, since that is what a board may break. No force is
//! sent before [`ConformanceDepth::Arm`], and then at most [`MOST_FORCE_MN`].

mod arming;
mod requests;
mod streams;
mod tested_board;

use firmware_protocol::frame::hello::Introduction;
use serde::Serialize;

pub use tested_board::{TestedBoard, introductions};

/// Largest force that is asked for on any key (mN): a weight of 5 g, up.
pub const MOST_FORCE_MN: i32 = 50;

/// How far a board is tried.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ConformanceDepth {
    /// It is never armed.
    Quiet,
    /// It is armed, and asked for [`MOST_FORCE_MN`].
    Arm,
    /// The same, and in the end an emergency stop, which only a start of the board undoes.
    Stop,
}

/// What came of one item.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ConformanceOutcome {
    Kept,
    Broken,
    /// What was seen could also be this machine's doing.
    Undecided,
    NotTried,
}

/// One item of the protocol, and how the board keeps it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct ConformanceItem {
    /// What a board shall do.
    pub item: &'static str,
    pub outcome: ConformanceOutcome,
    /// What it was seen to do.
    pub seen: String,
}

impl ConformanceItem {
    /// Returns an item that is kept if `seen` is, or broken.
    fn new(item: &'static str, seen: Result<String, String>) -> Self {
        let outcome =
            if seen.is_ok() { ConformanceOutcome::Kept } else { ConformanceOutcome::Broken };
        let (Ok(seen) | Err(seen)) = seen;
        Self { item, outcome, seen }
    }

    /// Returns an item that is kept if `seen` is, or broken; one that this machine may have broken,
    /// since it was late by `late_us` while it listened, is not decided.
    fn judged(item: &'static str, seen: Result<String, String>, late_us: u64) -> Self {
        /// What a machine with time is late by in all (us).
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

    /// Returns an item that was not tried, and why.
    fn not_tried(item: &'static str, why: &str) -> Self {
        Self { item, outcome: ConformanceOutcome::NotTried, seen: why.to_owned() }
    }
}

/// Tries the board that said `introduction`, as far as `depth` says; it is disarmed in the end.
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
