//! Where the action comes to rest under a finger that does not move.

use super::{Mode, ReducedGrand};

impl ReducedGrand {
    /// The mode and state at rest with the finger at `s` (m).
    ///
    /// The head lies on the jack; pressed beyond the button, on the jack as it trips; and
    /// beyond that on the repetition lever, as after a slow press.
    pub(super) fn balance(&self, s: f64) -> (Mode, [f64; 4]) {
        let p = &self.values;
        let (highest, lowest) = self.reach(s);
        if let Some(y) = self.balanced(s, (highest, p.button), |_| p.ratio) {
            return (Mode::Acc, [y, p.ratio * y, 0.0, 0.0]);
        }
        let trip = self.let_off.trip;
        if let Some(y) = self.balanced(s, (p.button, trip), |y| self.let_off.head(p, y).1) {
            return (Mode::Lo, [y, self.let_off.head(p, y).0, 0.0, 0.0]);
        }
        let y = self.balanced(s, (trip, lowest), |y| self.lever(y).ratio).unwrap_or(lowest);
        let sag = p.hammer_mass * p.g / p.lever_stiffness;
        let x = [y, self.lever(y).height - sag, 0.0, 0.0];
        (self.on_lever(&x), x)
    }

    /// The highest and the lowest place that the key can have: weights, and springs that have
    /// hardly set in, bend the coupling by so much and no more.
    fn reach(&self, s: f64) -> (f64, f64) {
        let p = &self.values;
        let square = p.felt_width * p.felt_width;
        let weights = p.key_weight.abs() + p.ratio * p.hammer_mass * p.g;
        let corners =
            p.jack_stiffness * p.jack_width + (p.bed_stiffness + p.rail_stiffness) * square;
        let most = (weights + corners) / p.coupling;
        (s.min(p.button).min(p.bed).min(0.0) - most, s.max(self.let_off.trip).max(0.0) + most)
    }

    /// Where between two places k1 (s − y) = S + r mh g, with r the head's `ratio` there;
    /// none if the finger presses the key beyond both.
    fn balanced(
        &self,
        s: f64,
        (mut above, mut below): (f64, f64),
        ratio: impl Fn(f64) -> f64,
    ) -> Option<f64> {
        /// Halvings that leave two neighbouring numbers, from any two places.
        const ROUNDS: usize = 128;
        let p = &self.values;
        let sinks = |y: f64| {
            let load = self.key_load(y, 0.0) + ratio(y) * p.hammer_mass * p.g;
            p.coupling * (s - y) > load
        };
        if sinks(below) {
            return None;
        }
        for _ in 0..ROUNDS {
            let middle = 0.5 * (above + below);
            if sinks(middle) {
                above = middle;
            } else {
                below = middle;
            }
        }
        Some(below)
    }
}
