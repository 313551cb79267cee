//! Conclusions from a board's samples: it is there, and renders forces.

use crate::rt::{board::BoardStatistics, sample_interval::SampleIntervals};

/// Silence after which a board counts as gone (us).
const SILENT_US: u64 = 100_000;
/// Time without force after which an armed board counts as tripped (us).
const FLAGGED_US: u64 = 5_000;

/// Polls without samples before several at once make a burst.
const EMPTY_LOOKS: u32 = 3;
/// Samples at once that make a burst.
const AT_ONCE: u64 = 3;
/// Excess of bursts over other samples from which they are a habit.
const HABIT: u8 = 8;

/// Arrival times of one board's samples, also of those without the flag.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleWatch {
    frames: u64,
    refused: u64,
    newest: u64,
    /// Arrival of the newest samples without the flag (us).
    clear: u64,
    is_safe: bool,
    intervals: Option<SampleIntervals>,
    /// Polls since the newest samples, recent bursts, and their interval (us).
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

    pub(super) const fn intervals(&self) -> Option<SampleIntervals> {
        self.intervals
    }

    /// Returns the interval of bursts (us), if samples usually arrive in bursts.
    pub(super) fn burst_us(&self) -> Option<u64> {
        (HABIT <= self.bursts).then_some(self.burst_us)
    }

    /// Records that `at_once` frames have arrived together at `now` (us).
    ///
    /// Frames that arrive together after several polls were held back; a late host has not polled.
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

    pub(super) const fn refused(&self) -> u64 {
        self.refused
    }

    pub(super) const fn is_silent(&self, now: u64) -> bool {
        is_silence(self.newest, now)
    }

    /// Returns `true` if samples have reported for [`FLAGGED_US`] that the board renders no force.
    pub(super) const fn is_flagged(&self) -> bool {
        self.clear + FLAGGED_US < self.newest
    }

    /// Returns `true` if the samples of `now` report that the board renders forces.
    pub(super) const fn is_clear_at(&self, now: u64) -> bool {
        self.newest == now && !self.is_safe
    }

    pub(super) const fn have_come_since(&self, since: u64) -> bool {
        since < self.newest
    }
}

/// Returns `true` if no board is silent for as long as from `since` to `now` (us).
pub(super) const fn is_silence(since: u64, now: u64) -> bool {
    since + SILENT_US < now
}
