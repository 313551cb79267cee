use std::fmt;
use std::sync::atomic::Ordering;

use scheduler::overload::Simplification;
use serde::Serialize;
use telemetry::key_name;

use crate::adapters::observer::OverloadCounters;

/// Work that was omitted in a run because ticks had too little time.
#[derive(Clone, PartialEq, Debug, Default, Serialize)]
pub struct OverloadReport {
    pub left_out: Vec<LeftOut>,
    /// Turns of voices that waited because their lanes had no time left.
    pub waited: u64,
    pub waited_keys: Vec<String>,
    /// Ticks in which voices waited although there was time: an error of the host.
    pub starved: u64,
}

/// A kind of omitted work.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct LeftOut {
    /// Name in scenes.
    pub what: &'static str,
    /// Total time (s).
    pub seconds: f64,
}

impl OverloadReport {
    /// Evaluates `counters` of ticks at `tick_hz` (1/s).
    pub(crate) fn new(counters: &OverloadCounters, tick_hz: u32) -> Self {
        let ticks = Simplification::ALL.into_iter().zip(counters.ticks());
        let left_out = ticks.filter(|(_one, ticks)| 0 < *ticks).map(|(one, ticks)| LeftOut {
            what: one.name(),
            seconds: ticks as f64 / f64::from(tick_hz),
        });
        let (waited, keys) = counters.waited();
        let keys = keys.map(|key| key_name(key.into()));
        let starved = counters.starved.load(Ordering::Relaxed);
        Self { left_out: left_out.collect(), waited, waited_keys: keys.collect(), starved }
    }

    pub(super) fn fmt_lines(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.left_out.is_empty() {
            let left_out = self.left_out.iter();
            let left_out: Vec<_> =
                left_out.map(|it| format!("{} for {:.2} s", it.what, it.seconds)).collect();
            writeln!(f, "  overload    left out: {}", left_out.join(", "))?;
        }
        if 0 < self.waited {
            let (turns, keys) = (self.waited, self.waited_keys.join(", "));
            writeln!(f, "  waited      {turns} turns of {keys}: their lanes had no time left")?;
        }
        if 0 < self.starved {
            writeln!(
                f,
                "  ERROR       voices waited in {} ticks that had time: report it with a recording",
                self.starved
            )?;
        }
        Ok(())
    }
}
