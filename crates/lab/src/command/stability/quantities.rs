//! Parses numbers and ranges with units.

use documents::quoted;

/// Parses a number of `unit`: plain, or with any unit of the same kind, as `1 ms` or `50 gf`.
pub(crate) fn quantity(text: &str, unit: &str) -> Result<f64, String> {
    let text = text.trim();
    let wanted = || if unit.is_empty() { String::new() } else { format!(", as 1.5 {unit}") };
    let read = mechanism::formulas::number_and_unit(text).filter(|(number, _)| number.is_finite());
    let Some((number, given)) = read else {
        return Err(format!("{} is no number{}", quoted(text), wanted()));
    };
    if given.is_empty() {
        return Ok(number);
    }
    mechanism::formulas::converted(number, given, unit)
        .ok_or_else(|| format!("{} is no number of {unit}{}", quoted(text), wanted()))
}

pub(crate) fn range(text: &str, unit: &str) -> Result<(f64, f64), String> {
    let (low, high) = text
        .split_once("..")
        .ok_or_else(|| format!("{} is no range: write two values, as 1..10", quoted(text)))?;
    Ok((quantity(low, unit)?, quantity(high, unit)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_with_and_without_a_unit() {
        for (text, unit, value) in [
            ("1ms", "s", 1e-3),
            ("0.25 ms", "s", 0.25e-3),
            ("3e3", "N/m", 3e3),
            ("-2 kN/m", "N/m", -2e3),
            ("2 N/mm", "N/m", 2e3),
            ("50 gf", "N", 0.490_332_5),
            ("1.5 N*s/m", "N*s/m", 1.5),
            ("10 µm", "m", 1e-5),
            ("1e5 m^2/s^5", "m^2/s^5", 1e5),
            ("40 g", "kg", 0.04),
            ("2 kHz", "Hz", 2e3),
            ("7", "", 7.0),
        ] {
            let read = quantity(text, unit).unwrap();
            assert!((read - value).abs() < 1e-12 * value.abs(), "{text}: {read}");
        }
    }

    #[test]
    fn what_is_no_number_of_that_unit_is_said_with_an_example() {
        for (text, unit, words) in [
            ("fast", "s", "\"fast\" is no number, as 1.5 s"),
            ("1 N", "s", "\"1 N\" is no number of s"),
            ("1 parsec", "m", "is no number of m"),
            ("", "s", "is no number"),
        ] {
            let said = quantity(text, unit).unwrap_err();
            assert!(said.contains(words), "{said}");
        }
    }

    #[test]
    fn a_range_has_two_ends() {
        assert_eq!(range("0.1 ms..2 ms", "s"), Ok((1e-4, 2e-3)));
        assert_eq!(range("-1..1e3", "N/m"), Ok((-1.0, 1e3)));
        assert!(range("5", "s").unwrap_err().contains("no range"));
        assert!(range("5..", "s").unwrap_err().contains("no number"));
    }
}
