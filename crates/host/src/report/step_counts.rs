use std::fmt;

use serde::Serialize;

/// Steps of all voices, by certainty of their crossings.
///
/// A tick of one key is one step, or several where an event or the model cuts it.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct StepCounts {
    /// Steps in which no crossing of the computed orbit was missed.
    pub certain: u64,
    pub unknown: u64,
    /// Steps of both kinds in ticks of their key with an event.
    pub in_ticks_with_events: u64,
    /// Share of certain steps in the other ticks, 0 to 1; `None` if there are none.
    pub certain_share_without_event: Option<f64>,
}

impl StepCounts {
    /// Counts certain and unknown steps of ticks without and with events.
    pub fn new(quiet: [u64; 2], with_event: [u64; 2]) -> Self {
        let n_quiet: u64 = quiet.iter().sum();
        Self {
            certain: quiet[0] + with_event[0],
            unknown: quiet[1] + with_event[1],
            in_ticks_with_events: with_event.iter().sum(),
            certain_share_without_event: (n_quiet > 0).then(|| quiet[0] as f64 / n_quiet as f64),
        }
    }

    pub(super) fn fmt_lines(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "  steps       {} certain, {} unknown; {} of them in ticks with an event",
            self.certain, self.unknown, self.in_ticks_with_events
        )?;
        if let Some(share) = self.certain_share_without_event {
            writeln!(
                f,
                "              without an event {:.1} % are certain: no crossing of the orbit as it was computed is missed",
                100.0 * share
            )?;
        }
        Ok(())
    }
}
