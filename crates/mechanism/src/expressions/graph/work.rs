//! Work on a graph, counted and limited so that every description ends.

use std::cell::Cell;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::Graph;

/// Largest work on one graph, from its first node to the last of its tapes.
///
/// The unit is an operand that is read, collected or compared. The largest shipped model needs a
/// thirtieth of the limit; the whole limit takes about two seconds on a present processor.
pub const MAX_WORK: u64 = 30_000_000;

/// Reason for which work on a graph was given up.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum WorkEnd {
    TooMuch,
    Cancelled,
}

impl fmt::Display for WorkEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooMuch => {
                write!(f, "its equations take too much work, more than {MAX_WORK} operands")
            }
            Self::Cancelled => f.write_str("its derivation was cancelled before its end"),
        }
    }
}

#[derive(Clone, Debug, Default)]
pub(super) struct WorkMeter {
    done: Cell<u64>,
    end: Cell<Option<WorkEnd>>,
    is_limited: bool,
    is_cancelled: Option<Arc<AtomicBool>>,
}

impl Graph {
    /// Limits work on the graph to [`MAX_WORK`]; there is no limit otherwise.
    pub const fn limit_work(&mut self) {
        self.work.is_limited = true;
    }

    pub fn lift_limits(&mut self) {
        self.work = WorkMeter { done: self.work.done.clone(), ..WorkMeter::default() };
    }

    /// Ends work on the graph as soon as `is_cancelled` is set.
    pub fn cancel_by(&mut self, is_cancelled: Arc<AtomicBool>) {
        self.work.is_cancelled = Some(is_cancelled);
        self.spend(0);
    }

    /// Returns the work done on the graph: equal on every machine.
    pub const fn work(&self) -> u64 {
        self.work.done.get()
    }

    /// Returns the reason for which work on the graph was given up, if it was.
    ///
    /// Results since then are meaningless: every request is answered at once, so that every loop
    /// over the graph ends soon.
    pub const fn given_up(&self) -> Option<WorkEnd> {
        self.work.end.get()
    }

    pub fn spend(&self, units: usize) {
        let WorkMeter { done, end, is_limited, is_cancelled } = &self.work;
        done.set(done.get().saturating_add(units as u64));
        if end.get().is_some() {
            return;
        }
        if *is_limited && done.get() > MAX_WORK {
            end.set(Some(WorkEnd::TooMuch));
        } else if is_cancelled.as_ref().is_some_and(|it| it.load(Ordering::Relaxed)) {
            end.set(Some(WorkEnd::Cancelled));
        }
    }
}
