//! What the samples of a board tell of it: that it is there, and that it renders forces.

use crate::rt::board::BoardStatistics;
use crate::rt::sample_interval::SampleIntervals;

/// A board that sent nothing for so long is gone (us).
const SILENT_US: u64 = 100_000;
/// A board that renders no force for so long though it was armed has tripped (us).
const FLAGGED_US: u64 = 5_000;

/// Looks in which nothing came before several samples at once, that make a burst.
const EMPTY_LOOKS: u32 = 3;
/// Samples at once that make a burst.
const AT_ONCE: u64 = 3;
/// Bursts, more than other samples, from which on they are a habit.
const HABIT: u8 = 8;

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
    /// What the board's own stamps tell of their intervals.
    intervals: Option<SampleIntervals>,
    /// Looks since the newest samples, bursts of late, and the time between two (us).
    empty_looks: u32,
    bursts: u8,
    burst_us: u64,
}

impl SampleWatch {
    pub(super) const fn new(now: u64) -> Self {
        Self {
            frames: 0,
            refused: 0,
            newest: now,
            clear: now,
            is_safe: true,
            intervals: None,
            empty_looks: 0,
            bursts: 0,
            burst_us: 0,
        }
    }

    /// Returns the intervals between samples of late.
    pub(super) const fn intervals(&self) -> Option<SampleIntervals> {
        self.intervals
    }

    /// Returns the time between two bursts (us), if samples usually come in bursts.
    pub(super) fn burst_us(&self) -> Option<u64> {
        (HABIT <= self.bursts).then_some(self.burst_us)
    }

    /// Takes note that so many frames have come at once, at `now` (us).
    ///
    /// The host looks all the time, so what comes at once after several looks was held back on its
    /// way; a host that is late has not looked.
    const fn look(&mut self, at_once: u64, now: u64) {
        if AT_ONCE <= at_once && EMPTY_LOOKS <= self.empty_looks {
            if self.bursts < 2 * HABIT {
                self.bursts += 1;
            }
            self.burst_us = now.saturating_sub(self.newest);
        } else {
            self.bursts = self.bursts.saturating_sub(1);
        }
        self.empty_looks = 0;
    }

    /// Takes what the board has sent until `now` (us).
    pub(super) const fn update(&mut self, statistics: &BoardStatistics, now: u64) {
        (self.refused, self.is_safe) = (statistics.refused, statistics.is_safe);
        self.intervals = statistics.intervals;
        if self.frames == statistics.samples.frames {
            self.empty_looks = self.empty_looks.saturating_add(1);
            return;
        }
        self.look(statistics.samples.frames - self.frames, now);
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
