//! Path of a key's force from its model to the board.
//!
//! ```text
//! wanted ── share (mute, soften) ── offset after a gap ── limit of the rise ──▶ sent
//! ```
//!
//! A force may always fall to zero. After a gap it continues from the last sent one and the
//! difference decays, so the finger feels no step.

/// Time in which a share fades out or in (s).
const FADE: f64 = 0.02;

/// Time in which the difference after a gap decays (s).
const BLEND: f64 = 5e-3;

/// Largest difference that cannot be felt (N).
const LEAST_OFFSET: f64 = 0.02;

/// Fastest rise of a force (N/s): the key of the loudest strike stays below.
const FASTEST_RISE: f64 = 12e3;

#[derive(Clone, Copy, Debug)]
pub(super) struct ForcePath {
    sent: f64,
    offset: f64,
    share: f64,
    /// Number of limited rises, and of gaps that were blended over.
    pub(super) limited: u64,
    pub(super) blended: u64,
}

impl Default for ForcePath {
    fn default() -> Self {
        Self { sent: 0.0, offset: 0.0, share: 1.0, limited: 0, blended: 0 }
    }
}

impl ForcePath {
    /// Restarts without force, which then grows.
    pub(super) const fn restart(&mut self) {
        (self.sent, self.offset, self.share) = (0.0, 0.0, 0.0);
    }

    pub(super) const fn lead_over(&mut self, wanted: f64) {
        self.offset = self.sent - self.share * wanted;
        self.blended += 1;
    }

    /// Returns the force (N) for `wanted` (N) and share `most`, `elapsed` (s) after the last.
    pub(super) fn next(&mut self, wanted: f64, most: f64, elapsed: f64) -> f64 {
        let step = elapsed / FADE;
        self.share += (most - self.share).clamp(-step, step);
        self.offset *= BLEND / (BLEND + elapsed);
        if self.offset.abs() < LEAST_OFFSET || most <= 0.0 {
            self.offset = 0.0;
        }
        let force = self.share * wanted + self.offset;
        // From zero, if it changes its sign.
        let before = if 0.0 < self.sent * force { self.sent.abs() } else { 0.0 };
        let highest = before + FASTEST_RISE * elapsed;
        self.limited += u64::from(highest < force.abs());
        self.sent = force.clamp(-highest, highest);
        self.sent
    }

    pub(super) fn is_whole(&self) -> bool {
        self.offset == 0.0 && 1.0 <= self.share
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1e-3;

    #[track_caller]
    fn check(force: f64, wanted: f64) {
        assert!((force - wanted).abs() < 1e-9, "{force} N, not {wanted}");
    }

    #[test]
    fn a_force_may_fall_at_once_and_rises_by_12_n_in_a_millisecond() {
        let mut path = ForcePath::default();
        for (wanted, sent) in [(20.0, 12.0), (20.0, 20.0), (0.0, 0.0), (-20.0, -12.0)] {
            check(path.next(wanted, 1.0, H), sent);
        }
        assert_eq!(path.limited, 2);
        check(path.next(5.0, 1.0, H), 5.0);
    }

    #[test]
    fn after_a_gap_the_force_has_no_step_and_is_whole_again_soon() {
        let mut path = ForcePath::default();
        check(path.next(2.0, 1.0, H), 2.0);
        path.lead_over(8.0);
        let forces: Vec<_> = (0..60).map(|_| path.next(8.0, 1.0, H)).collect();
        assert!((forces[0] - 2.0).abs() < 1.1, "{forces:?}");
        assert!(forces.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 1.1), "{forces:?}");
        assert!(path.is_whole(), "{forces:?}");
        check(forces[59], 8.0);
    }

    #[test]
    fn a_muted_key_fades_in_20_ms() {
        let mut path = ForcePath::default();
        path.next(6.0, 1.0, H);
        let forces: Vec<_> = (0..20).map(|_| path.next(6.0, 0.0, H)).collect();
        assert!(forces[18] > 0.0 && forces[19].abs() < 1e-9, "{forces:?}");
    }
}
