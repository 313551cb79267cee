use crate::digits::trimmed;

/// Fraction of a range below which a remainder of zero is rounding.
const ROUNDING: f64 = 1e-9;

/// Returns multiples of 1, 2 or 5 times a power of ten between both, about `wanted`, with numbers.
pub(super) fn ticks((low, high): (f64, f64), wanted: f64) -> Vec<(f64, Option<String>)> {
    let size = high - low;
    // The length of the widest range overflows, its half does not.
    let least = (0.5 * high - 0.5 * low) / wanted * 2.0;
    let power = 10_f64.powf(least.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power);
    let step = steps.into_iter().find(|step| *step >= least * (1.0 - ROUNDING));
    let Some(step) = step.filter(|step| step.is_normal()) else { return Vec::new() };
    let first = (low / step).ceil();
    let values = (0_u32..).map(|n| (first + f64::from(n)) * step);
    let values = values.take_while(|value| *value <= high);
    values.map(|value| (value, Some(number(value, size)))).collect()
}

/// Formats `value` with the digits that an axis over a range of `size` needs.
fn number(value: f64, size: f64) -> String {
    let value = if value.abs() < ROUNDING * size { 0.0 } else { value };
    if !(1e-3..1e5).contains(&size) {
        return if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") };
    }
    trimmed(&format!("{value:.6}")).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(ends: (f64, f64), wanted: f64, expected: &[&str]) {
        let found: Vec<_> =
            ticks(ends, wanted).into_iter().filter_map(|(_, label)| label).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn numbers_are_round_and_not_more_than_wanted() {
        check((-1.36, 2.04), 6.0, &["-1", "0", "1", "2"]);
        check((-0.06, 1.06), 6.0, &["0", "0.2", "0.4", "0.6", "0.8", "1"]);
        check((0.0, 3.0), 12.0, &["0", "0.5", "1", "1.5", "2", "2.5", "3"]);
        check((0.0, 1e-5), 6.0, &["0", "2.0e-6", "4.0e-6", "6.0e-6", "8.0e-6", "1.0e-5"]);
    }

    #[test]
    fn numbers_are_as_short_as_can_be() {
        assert_eq!(number(0.1 + 0.2, 1.0), "0.3");
        assert_eq!(number(-1e-17, 2.0), "0");
        assert_eq!(number(200.0, 1000.0), "200");
        assert_eq!(number(2e-6, 1e-5), "2.0e-6");
    }

    #[test]
    fn a_range_without_length_has_no_lines() {
        check((1.0, 1.0), 6.0, &[]);
        check((f64::NAN, 1.0), 6.0, &[]);
    }
}
