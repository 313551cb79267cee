/// Smallest value on an axis: an error below it is as good as none.
const FLOOR: f64 = 1e-17;
/// Room at both ends, as a fraction of the axis.
const ROOM: f64 = 0.05;
/// Least room at both ends (decades).
const LEAST_ROOM: f64 = 0.15;

pub(super) fn log(value: f64) -> f64 {
    value.max(FLOOR).log10()
}

/// Returns the logarithms of the ends of an axis over `values`, with room.
pub(super) fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let logs = values.map(log).filter(|log| log.is_finite());
    let ends = logs
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), log| (low.min(log), high.max(log)));
    let (low, high) = if ends.0 <= ends.1 { ends } else { (0.0, 1.0) };
    let room = (ROOM * (high - low)).max(LEAST_ROOM);
    (low - room, high + room)
}

/// Returns the grid's values between two logarithms, about `wanted` of them with a number.
pub(super) fn ticks((low, high): (f64, f64), wanted: f64) -> Vec<(f64, Option<String>)> {
    let decades = high - low;
    let every = (decades / wanted).ceil().max(1.0);
    let digits: &[f64] = match decades / wanted {
        ..0.1 => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 7.0],
        0.1..0.38 => &[1.0, 2.0, 5.0],
        _ => &[1.0],
    };
    let first = low.floor();
    let powers = (0_u32..).map(|n| first + f64::from(n)).take_while(|log| *log <= high);
    let numbers = powers.flat_map(|power| digits.iter().map(move |digit| (*digit, power)));
    let tick = |(digit, power): (f64, f64)| {
        let log = power + digit.log10();
        let is_named = power.rem_euclid(every) < 0.5;
        let label = is_named.then(|| number(digit, power));
        (low <= log && log <= high).then(|| (10_f64.powf(log), label))
    };
    numbers.filter_map(tick).collect()
}

fn number(digit: f64, power: f64) -> String {
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
        let ends = ends(values.into_iter());
        ticks(ends, wanted).into_iter().filter_map(|(_, label)| label).collect()
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
}
