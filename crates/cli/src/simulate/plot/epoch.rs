use super::track::Columns;

/// An interval in which one mode held.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Epoch {
    /// Start and end (s).
    pub(super) span: (f64, f64),
    pub(super) mode: usize,
}

/// Epochs in order, at most one start per pixel column.
#[derive(Debug)]
pub(super) struct Epochs {
    axis: Columns,
    pub(super) all: Vec<Epoch>,
}

impl Epochs {
    pub(super) fn new(axis: Columns, mode: usize) -> Self {
        Self { axis, all: vec![Epoch { span: (0.0, 0.0), mode }] }
    }

    /// Extends the present epoch to `t` (s) at least.
    pub(super) fn last_until(&mut self, t: f64) {
        if let Some(epoch) = self.all.last_mut() {
            epoch.span.1 = t;
        }
    }

    /// Starts `mode` at `t` (s); replaces an epoch too short to be visible.
    pub(super) fn begin(&mut self, t: f64, mode: usize) {
        self.last_until(t);
        let mut start = t;
        if let Some(last) = self.all.pop_if(|last| self.axis.of(last.span.0) == self.axis.of(t)) {
            start = last.span.0;
        }
        match self.all.last_mut() {
            Some(last) if last.mode == mode => last.span.1 = t,
            _ => self.all.push(Epoch { span: (start, t), mode }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXIS: Columns = Columns { n: 10, until: 1.0 };

    #[track_caller]
    fn check(begins: &[(f64, usize)], expected: &[(f64, f64, usize)]) {
        let mut epochs = Epochs::new(AXIS, 0);
        for (t, mode) in begins {
            epochs.begin(*t, *mode);
        }
        epochs.last_until(1.0);
        let found: Vec<_> =
            epochs.all.iter().map(|epoch| (epoch.span.0, epoch.span.1, epoch.mode)).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn epochs_follow_each_other() {
        check(&[(0.3, 1), (0.7, 0)], &[(0.0, 0.3, 0), (0.3, 0.7, 1), (0.7, 1.0, 0)]);
        check(&[], &[(0.0, 1.0, 0)]);
    }

    #[test]
    fn what_is_narrower_than_a_pixel_makes_way() {
        check(&[(0.31, 1), (0.32, 0)], &[(0.0, 1.0, 0)]);
        check(&[(0.31, 1), (0.32, 2)], &[(0.0, 0.31, 0), (0.31, 1.0, 2)]);
        check(&[(0.0, 1)], &[(0.0, 1.0, 1)]);
    }
}
