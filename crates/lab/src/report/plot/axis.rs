//! A logarithmic scale, its grid and its numbers.

/// A logarithmic scale from one place to another.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Axis {
    /// Decimal logarithms of its ends.
    logs: (f64, f64),
    /// Their places (pixels).
    places: (f64, f64),
}

/// A line of the grid.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct GridLine {
    /// Where (pixels).
    pub(super) place: f64,
    /// Its number; lines between have none.
    pub(super) label: Option<String>,
}

/// Below this an error is as good as none.
const FLOOR: f64 = 1e-17;

/// Room at both ends, as a part of the scale.
const ROOM: f64 = 0.05;

impl Axis {
    /// A scale for all of `values` between two places; one decade around 1 if there are none.
    pub(super) fn new(values: impl Iterator<Item = f64>, places: (f64, f64)) -> Self {
        let logs = values.map(|value| value.max(FLOOR).log10()).filter(|log| log.is_finite());
        let ends = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), log| {
            (low.min(log), high.max(log))
        });
        let (low, high) = if ends.0 <= ends.1 { ends } else { (0.0, 1.0) };
        let room = (ROOM * (high - low)).max(0.15);
        Self { logs: (low - room, high + room), places }
    }

    /// Where `value` is (pixels).
    pub(super) fn place(&self, value: f64) -> f64 {
        let part = (value.max(FLOOR).log10() - self.logs.0) / (self.logs.1 - self.logs.0);
        self.places.0 + part * (self.places.1 - self.places.0)
    }

    /// The lines of the grid, about `wanted` of them with a number.
    pub(super) fn lines(&self, wanted: f64) -> Vec<GridLine> {
        let decades = self.logs.1 - self.logs.0;
        let every = (decades / wanted).ceil().max(1.0);
        let digits: &[f64] = match decades / wanted {
            ..0.1 => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0],
            0.1..0.38 => &[1.0, 2.0, 5.0],
            _ => &[1.0],
        };
        let first = self.logs.0.floor();
        let powers = (0_u32..).map(|n| first + f64::from(n)).take_while(|log| *log <= self.logs.1);
        let numbers = powers.flat_map(|power| digits.iter().map(move |digit| (*digit, power)));
        let line = |(digit, power): (f64, f64)| {
            let log = power + digit.log10();
            let is_named = power.rem_euclid(every) < 0.5;
            let line = GridLine {
                place: self.place(10_f64.powf(log)),
                label: is_named.then(|| label(digit, power)),
            };
            (self.logs.0 <= log && log <= self.logs.1).then_some(line)
        };
        numbers.filter_map(line).collect()
    }
}

/// A power of ten, or a few of them, as people write it.
fn label(digit: f64, power: f64) -> String {
    if (0.0..=3.0).contains(&power) {
        let value = digit * 10_f64.powf(power);
        return if power == 0.0 { format!("{value}") } else { format!("{value:.0}") };
    }
    if (-1.0..0.0).contains(&power) {
        return format!("{}", (10.0 * digit).round() / 100.0);
    }
    format!("{digit}e{power:.0}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(values: [f64; 2], wanted: f64) -> Vec<String> {
        let axis = Axis::new(values.into_iter(), (0.0, 100.0));
        axis.lines(wanted).into_iter().filter_map(|line| line.label).collect()
    }

    #[test]
    fn every_decade_has_a_line_and_some_have_numbers() {
        assert_eq!(labels([2.0, 3000.0], 6.0), ["10", "100", "1000"]);
        assert_eq!(labels([1e-15, 1e-3], 6.0), ["1e-15", "1e-12", "1e-9", "1e-6", "1e-3"]);
        assert_eq!(labels([3.0, 30.0], 6.0), ["5", "10", "20"]);
        assert_eq!(labels([0.02, 0.3], 6.0), ["2e-2", "5e-2", "0.1", "0.2"]);
        assert_eq!(labels([90.0, 250.0], 8.0), ["70", "100", "150", "200", "300"]);
        assert_eq!(labels([2e3, 2e4], 8.0), ["2000", "5000", "1e4", "2e4"]);
    }

    #[test]
    fn values_lie_within_their_ends_and_zero_at_the_floor() {
        let axis = Axis::new([0.0, 1.0].into_iter(), (100.0, 0.0));
        let (low, high) = (axis.place(0.0), axis.place(1.0));
        assert!(0.0 < high && high < low && low < 100.0, "{low}, {high}");
    }

    #[test]
    fn nothing_has_a_scale_too() {
        let axis = Axis::new(std::iter::empty(), (0.0, 100.0));
        assert!(axis.place(1.0) > 0.0 && axis.place(10.0) < 100.0);
    }
}
