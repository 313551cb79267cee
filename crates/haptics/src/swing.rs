//! Oscillation of a key, and the limit of shaking.

/// Travel of a key, up and down (m).
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Swing {
    up: f64,
    down: f64,
}

impl Swing {
    /// Oscillation of a shaking key in 0.15 s, as a fraction of its dip. The paper's springs move a
    /// key of 10 mm by 2.4 while their hammer hops; loops that generate energy, by more than 5.5.
    pub const SHAKING: f64 = 0.4;

    /// Oscillation of a key that starts to shake, and its ratio to that in the previous 0.15 s.
    const GROWING: (f64, f64) = (0.15, 1.25);

    /// Adds a displacement (m), down positive.
    pub const fn add(&mut self, way: f64) {
        self.down += way.max(0.0);
        self.up -= way.min(0.0);
    }

    /// Returns the oscillation (m): a key on its way up has none.
    pub const fn to_and_fro(self) -> f64 {
        2.0 * self.up.min(self.down)
    }

    /// Returns `true` if a key starts to shake; oscillations are fractions of its dip.
    pub fn grows(before: f64, now: f64) -> bool {
        let (least, times) = Self::GROWING;
        least.max(times * before) < now
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_way_is_no_swing_and_the_shorter_of_both_counts_twice() {
        let mut swing = Swing::default();
        swing.add(3e-3);
        assert!(swing.to_and_fro().abs() < f64::EPSILON);
        swing.add(-1e-3);
        assert!((swing.to_and_fro() - 2e-3).abs() < 1e-12);
    }

    #[test]
    fn what_grows_is_neither_small_nor_steady() {
        assert!(Swing::grows(0.1, 0.16));
        assert!(!Swing::grows(0.1, 0.14), "too little to be felt");
        assert!(!Swing::grows(0.3, 0.36), "hardly more than before");
    }
}
