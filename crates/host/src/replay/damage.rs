//! What of a recording cannot be read.

use serde::Serialize;

use super::agreement::ResumedTicks;

/// Ticks that a recording has lost.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct MissingTicks {
    /// The first of them.
    pub from: u64,
    /// The last of them; none if nothing comes after them.
    pub to: Option<u64>,
    /// When the first of them began \[s\].
    pub from_s: f64,
    /// When the last of them began \[s\].
    pub to_s: Option<f64>,
    /// What is damaged, in a sentence.
    pub why: String,
    /// What came of the ticks behind them; none if no voice could be run there.
    pub behind: Option<ResumedTicks>,
}

/// What could not be read so far.
#[derive(Debug)]
pub(super) struct UnreadParts {
    /// The time from tick to tick \[s\].
    period: f64,
    /// Why messages could not be read that would come now.
    damaged: Option<String>,
    /// The last tick that was told of, run again or not.
    told: Option<u64>,
    pub(super) list: Vec<MissingTicks>,
}

impl UnreadParts {
    pub(super) const fn new(period: f64) -> Self {
        Self { period, damaged: None, told: None, list: Vec::new() }
    }

    /// Notes that messages which come now could not be read.
    pub(super) fn lose(&mut self, why: String) {
        self.damaged.get_or_insert(why);
    }

    /// Whether messages that come now could not be read.
    pub(super) const fn is_damaged(&self) -> bool {
        self.damaged.is_some()
    }

    /// Notes that something comes after what could not be read: ticks are missing.
    pub(super) fn begin(&mut self) {
        let Some(why) = self.damaged.take() else { return };
        let from = self.told.map_or(0, |told| told + 1);
        let from_s = from as f64 * self.period;
        self.list.push(MissingTicks { from, to: None, from_s, to_s: None, why, behind: None });
    }

    /// Notes that `tick` was read.
    pub(super) fn end(&mut self, tick: u64) {
        self.told = Some(tick);
        if let Some(last) = self.list.last_mut()
            && last.to.is_none()
        {
            let to = tick.saturating_sub(1).max(last.from);
            (last.to, last.to_s) = (Some(to), Some(to as f64 * self.period));
        }
    }

    /// Notes what came of the ticks behind those that were lost last.
    pub(super) fn resumed(&mut self, behind: ResumedTicks) {
        if let Some(last) = self.list.last_mut() {
            last.behind = Some(behind);
        }
    }
}
