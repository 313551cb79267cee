//! What the samples of a board tell of it: that it is there, and that it renders forces.

use crate::rt::board::BoardStatistics;

/// A board that sent nothing for so long is gone (us).
const SILENT_US: u64 = 100_000;
/// A board that renders no force for so long though it was armed has tripped (us).
const FLAGGED_US: u64 = 5_000;

/// When samples of one board came, and when they came without the flag.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleWatch {
    frames: u64,
    refused: u64,
    /// When the newest samples came (us).
    newest: u64,
    /// When the newest samples without the flag came (us).
    clear: u64,
    /// The newest samples say that the board renders no force.
    is_safe: bool,
}

impl SampleWatch {
    pub(super) const fn new(now: u64) -> Self {
        Self { frames: 0, refused: 0, newest: now, clear: now, is_safe: true }
    }

    /// Takes what the board has sent until `now` (us).
    pub(super) const fn update(&mut self, statistics: &BoardStatistics, now: u64) {
        (self.refused, self.is_safe) = (statistics.refused, statistics.is_safe);
        if self.frames == statistics.samples.frames {
            return;
        }
        (self.frames, self.newest) = (statistics.samples.frames, now);
        if !statistics.is_safe {
            self.clear = now;
        }
    }

    /// Returns how many frames of samples could not be read.
    pub(super) const fn refused(&self) -> u64 {
        self.refused
    }

    /// Tells whether nothing has come for so long that the board is gone.
    pub(super) const fn is_silent(&self, now: u64) -> bool {
        is_silence(self.newest, now)
    }

    /// Tells whether samples have said for a while that the board renders no force.
    pub(super) const fn is_flagged(&self) -> bool {
        self.clear + FLAGGED_US < self.newest
    }

    /// Tells whether the samples that came at `now` say that the board renders forces.
    pub(super) const fn is_clear_at(&self, now: u64) -> bool {
        self.newest == now && !self.is_safe
    }

    /// Tells whether samples came after `since`.
    pub(super) const fn have_come_since(&self, since: u64) -> bool {
        since < self.newest
    }
}

/// Tells whether the time from `since` to `now` is longer than any board is silent (us).
pub(super) const fn is_silence(since: u64, now: u64) -> bool {
    since + SILENT_US < now
}
