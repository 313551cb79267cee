//! Distinguishable events on the time axis.

use super::track::Columns;

/// Events in one pixel column.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct EventMark {
    /// Time of the first one (s).
    pub(super) t: f64,
    names: Vec<&'static str>,
    count: u64,
}

impl EventMark {
    fn join(&mut self, other: &Self) {
        self.count += other.count;
        for name in &other.names {
            if !self.names.contains(name) {
                self.names.push(name);
            }
        }
    }

    /// Returns `release 0.503 s`, or `floor, settled ×12 from 1.806 s`.
    fn text(&self, decimals: usize) -> String {
        let t = self.t;
        let names = match self.names.as_slice() {
            [first, second, _, ..] => format!("{first}, {second}…"),
            few => few.join(", "),
        };
        match self.count {
            1 => format!("{names} {t:.decimals$} s"),
            count => format!("{names} ×{count} from {t:.decimals$} s"),
        }
    }
}

/// Events in the order of their time; those of one pixel column are one mark.
#[derive(Debug)]
pub(super) struct EventMarks {
    axis: Columns,
    pub(super) all: Vec<EventMark>,
}

impl EventMarks {
    pub(super) const fn new(axis: Columns) -> Self {
        Self { axis, all: Vec::new() }
    }

    pub(super) fn add(&mut self, t: f64, name: &'static str) {
        let mark = EventMark { t, names: vec![name], count: 1 };
        match self.all.last_mut() {
            Some(last) if self.axis.of(last.t) == self.axis.of(t) => last.join(&mark),
            _ => self.all.push(mark),
        }
    }

    /// Returns labels with their times (s), with distances of `apart` and at most `astray` behind
    /// their marks (columns); marks share labels if necessary.
    pub(super) fn labels(&self, apart: f64, astray: f64) -> Vec<(f64, String)> {
        let mut groups: Vec<(f64, EventMark)> = Vec::new();
        for mark in &self.all {
            let x = mark.t / self.axis.until * self.axis.n as f64;
            let free = groups.last().map_or(x, |(place, _)| x.max(place + apart));
            match groups.last_mut() {
                Some((_, group)) if free > x + astray => group.join(mark),
                _ => groups.push((free, mark.clone())),
            }
        }
        let decimals = decimals(self.axis.until);
        groups.into_iter().map(|(_, mark)| (mark.t, mark.text(decimals))).collect()
    }
}

/// Returns the decimals that distinguish thousandths of `until` (s).
#[expect(clippy::cast_possible_truncation, reason = "a logarithm of an f64 is below 400")]
#[expect(clippy::cast_sign_loss, reason = "clamped")]
fn decimals(until: f64) -> usize {
    (3 - until.log10().floor() as i32).clamp(0, 12) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    const AXIS: Columns = Columns { n: 100, until: 1.0 };

    fn marks(events: &[(f64, &'static str)]) -> EventMarks {
        let mut marks = EventMarks::new(AXIS);
        for (t, name) in events {
            marks.add(*t, name);
        }
        marks
    }

    fn check(events: &[(f64, &'static str)], expected: &[&str]) {
        let labels = marks(events).labels(10.0, 15.0);
        let found: Vec<_> = labels.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn far_marks_have_their_own_labels() {
        check(&[(0.1, "a"), (0.5, "b")], &["a 0.100 s", "b 0.500 s"]);
    }

    #[test]
    fn near_labels_give_way_and_crowded_ones_are_one() {
        let events = [(0.1, "a"), (0.12, "b"), (0.14, "c"), (0.16, "b"), (0.5, "a")];
        check(&events, &["a 0.100 s", "b, c ×2 from 0.120 s", "b 0.160 s", "a 0.500 s"]);
        let crowded = [events[0], events[1], (0.125, "c"), (0.126, "c"), events[4]];
        check(&crowded, &["a 0.100 s", "b, c ×3 from 0.120 s", "a 0.500 s"]);
    }

    #[test]
    fn marks_are_bounded_by_the_columns() {
        let mut marks = EventMarks::new(AXIS);
        for event in 0..10_000 {
            marks.add(f64::from(event) * 1e-4, "bounce");
        }
        assert_eq!(marks.all.len(), AXIS.n);
        assert_eq!(marks.all.iter().map(|mark| mark.count).sum::<u64>(), 10_000);
    }

    #[test]
    fn times_are_as_fine_as_the_axis() {
        for (until, expected) in [(0.02, 5), (1.0, 3), (3.0, 3), (100.0, 1), (1e9, 0)] {
            assert_eq!(decimals(until), expected, "{until}");
        }
    }
}
