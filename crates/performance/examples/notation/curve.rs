//! A value that changes over a piece: tempo, or dynamics.

/// Corners at ticks, straight lines between them.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Curve {
    corners: Vec<(u32, f64)>,
}

impl Curve {
    /// From `tick` on it is `value`.
    pub(super) fn step(&mut self, tick: u32, value: f64) {
        if !self.corners.is_empty() {
            self.corners.push((tick, self.at(tick)));
        }
        self.corners.push((tick, value));
    }

    /// From `tick` on it goes from `first` to `last` within `span` ticks, and stays there.
    pub(super) fn ramp(&mut self, tick: u32, span: u32, first: f64, last: f64) {
        self.step(tick, first);
        self.corners.push((tick + span, last));
    }

    /// The value at `tick`; that of the first corner before it, zero if there is none.
    pub(super) fn at(&self, tick: u32) -> f64 {
        let after = self.corners.partition_point(|corner| corner.0 <= tick);
        let before = after.checked_sub(1).and_then(|index| self.corners.get(index));
        match (before, self.corners.get(after)) {
            (Some(&(from, low)), Some(&(to, high))) => {
                low + (high - low) * f64::from(tick - from) / f64::from(to - from)
            }
            (Some(only), None) | (None, Some(only)) => only.1,
            (None, None) => 0.0,
        }
    }
}
