//! Numbers with a unit: plain SI, or text such as `"0.5 ms"`.

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Quantity {
    /// SI unit; `"1"` for a ratio.
    pub(super) unit: &'static str,
    pub(super) range: (f64, f64),
}

impl Quantity {
    /// Returns `true` if `value` is allowed; NaN never is.
    pub(super) fn allows(&self, value: f64) -> bool {
        value.is_finite() && self.range.0 <= value && value <= self.range.1
    }

    pub(super) fn show(&self, value: f64) -> String {
        format!("{}{}", number(value), self.suffix())
    }

    pub(super) fn show_range(&self) -> String {
        format!("{} to {}{}", number(self.range.0), number(self.range.1), self.suffix())
    }

    fn suffix(&self) -> String {
        if self.unit == "1" { String::new() } else { format!(" {}", self.unit) }
    }
}

/// Reason why text is not the required quantity.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum QuantityError {
    NoNumber,
    NoUnit(f64),
    WrongUnit(f64, String),
}

pub(super) fn number(value: f64) -> String {
    let size = value.abs();
    if value.is_nan() {
        "not a number".to_owned()
    } else if size == 0.0 || (1e-3..1e6).contains(&size) || size.is_infinite() {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// Reads `text` as a number of `unit`, or of another unit of its kind.
pub(super) fn parse(text: &str, unit: &str) -> Result<f64, QuantityError> {
    let (value, given) =
        mechanism::formulas::number_and_unit(text).ok_or(QuantityError::NoNumber)?;
    match mechanism::formulas::converted(value, given, unit) {
        Some(value) => Ok(value),
        None if given.is_empty() && unit == "1" => Ok(value),
        None if given.is_empty() => Err(QuantityError::NoUnit(value)),
        None => Err(QuantityError::WrongUnit(value, given.to_owned())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, unit: &str, expected: &Result<f64, QuantityError>) {
        assert_eq!(parse(text, unit), *expected, "{text:?} in {unit}");
    }

    fn wrong(value: f64, unit: &str) -> Result<f64, QuantityError> {
        Err(QuantityError::WrongUnit(value, unit.to_owned()))
    }

    #[test]
    fn the_right_unit_and_its_prefixes_are_exact() {
        check("20 N", "N", &Ok(20.0));
        check("20N", "N", &Ok(20.0));
        check(" -2.5e1  mN ", "N", &Ok(-0.025));
        check("0.5 ms", "s", &Ok(0.0005));
        check("3 µs", "s", &Ok(3e-6));
        check("3 μs", "s", &Ok(3e-6));
        check("3 us", "s", &Ok(3e-6));
        check("4 kHz", "Hz", &Ok(4000.0));
        check("12 mm", "m", &Ok(0.012));
        check("11.2 g", "kg", &Ok(0.0112));
        check("11200 mg", "kg", &Ok(0.0112));
        check("0.13 kg", "kg", &Ok(0.13));
        check("2 MN", "N", &Ok(2e6));
        check("2 mm^2", "m²", &Ok(2e-6));
        check("2 mm2", "m²", &Ok(2e-6));
        check("50 gf", "N", &Ok(50.0 * 9.80665 / 1000.0));
    }

    #[test]
    fn compound_units_may_be_written_on_any_keyboard() {
        check("2 N·m/rad", "N·m/rad", &Ok(2.0));
        check("2 N*m/rad", "N·m/rad", &Ok(2.0));
        check("20 kN/m", "N/m", &Ok(20e3));
        check("2 kg m^2", "kg·m²", &Ok(2.0));
        check("2 g m2", "kg·m²", &Ok(0.002));
        check("9.81 m/s2", "m/s²", &Ok(9.81));
    }

    #[test]
    fn a_ratio_has_no_unit() {
        check("0.5", "1", &Ok(0.5));
        check("50 %", "1", &wrong(50.0, "%"));
    }

    #[test]
    fn what_is_meant_otherwise_is_refused() {
        check("20 kg", "N", &wrong(20.0, "kg"));
        check("20", "N", &Err(QuantityError::NoUnit(20.0)));
        check("2 rev/s", "Hz", &wrong(2.0, "rev/s"));
        check("2 N*m", "N·m/rad", &wrong(2.0, "N*m"));
        check("2 km", "m/s", &wrong(2.0, "km"));
        check("2 eV", "s", &wrong(2.0, "eV"));
        for text in ["", "N", "fast", "nan N", "inf N", "--1 N", "½ N"] {
            check(text, "N", &Err(QuantityError::NoNumber));
        }
    }

    #[test]
    fn numbers_are_shown_as_people_write_them() {
        for (value, expected) in [(0.0, "0"), (25.0, "25"), (1e-6, "1e-6"), (1e9, "1e9")] {
            assert_eq!(number(value), expected);
        }
    }
}
