//! Quantities in readable units: millimetres rather than 0.0032 m.

/// Display of a unit: its name, and the factor of values.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Shown {
    pub(crate) unit: &'static str,
    pub(crate) factor: f64,
}

pub(crate) fn shown(unit: &str) -> Option<Shown> {
    let (unit, factor) = match unit {
        "m" => ("mm", 1e3),
        "rad" => ("mrad", 1e3),
        _ => return None,
    };
    Some(Shown { unit, factor })
}

/// Formats `value` with its unit, with useful digits only.
pub(crate) fn text(value: f64, unit: &str) -> String {
    let (value, unit) =
        shown(unit).map_or((value, unit), |shown| (value * shown.factor, shown.unit));
    join(&digits(value), unit)
}

pub(crate) fn digits(value: f64) -> String {
    let size = value.abs();
    if !value.is_finite() {
        "–".to_owned()
    } else if size < 1e-12 {
        "0".to_owned()
    } else if (1e-3..1e6).contains(&size) {
        let places = if size < 0.1 {
            4
        } else if size < 10.0 {
            3
        } else if size < 100.0 {
            2
        } else {
            1
        };
        trimmed(&format!("{value:.places$}"))
    } else {
        format!("{value:.3e}")
    }
}

/// Formats a number in five digits, for fields to type in.
pub(crate) fn exact(value: f64) -> String {
    let size = value.abs();
    if !value.is_finite() {
        return "–".to_owned();
    }
    if !(1e-3..1e6).contains(&size) {
        return if size < 1e-300 { "0".to_owned() } else { format!("{value:.4e}") };
    }
    let places = [1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3, 1e4].iter().filter(|it| size < **it).count();
    trimmed(&format!("{value:.places$}"))
}

pub(crate) fn seconds(seconds: f64) -> String {
    let size = seconds.abs();
    if size < 1e-3 {
        format!("{:.0} µs", seconds * 1e6)
    } else if size < 1.0 {
        format!("{:.2} ms", seconds * 1e3)
    } else {
        format!("{seconds:.3} s")
    }
}

/// Formats `unit` in brackets; empty if there is none.
pub(crate) fn bracketed(unit: &str) -> String {
    if is_none(unit) { String::new() } else { format!("[{unit}]") }
}

pub(crate) fn named(name: &str, unit: &str) -> String {
    join(name, &bracketed(unit))
}

/// Formats `unit` as the suffix of a number.
pub(crate) fn suffix(unit: &str) -> String {
    join("", unit)
}

fn trimmed(digits: &str) -> String {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        digits.to_owned()
    }
}

/// Returns `true` if a quantity has no unit: models write 1 for it.
fn is_none(unit: &str) -> bool {
    unit.is_empty() || unit == "1"
}

fn join(text: &str, unit: &str) -> String {
    if is_none(unit) { text.to_owned() } else { format!("{text} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_and_angles_are_read_in_thousandths() {
        assert_eq!(text(0.0032, "m"), "3.2 mm");
        assert_eq!(text(0.04, "rad"), "40 mrad");
        assert_eq!(text(1.5, "N"), "1.5 N");
        assert_eq!(text(5800.0, "N/m"), "5800 N/m");
        assert_eq!(text(1.2e-5, "kg m²"), "1.200e-5 kg m²");
        assert_eq!(text(0.0, ""), "0");
    }

    #[test]
    fn where_there_is_no_unit_there_are_no_brackets() {
        assert_eq!(named("lift", "N"), "lift [N]");
        assert_eq!(named("lift", ""), "lift");
        assert_eq!(bracketed(""), "");
        assert_eq!(suffix("mm"), " mm");
        assert_eq!(suffix(""), "");
        assert_eq!(suffix("1"), "");
        assert_eq!(text(0.1, "1"), "0.1");
    }

    #[test]
    fn what_can_be_typed_has_five_digits() {
        let values = [0.0, 0.1385, 0.213_336, 24_000.0, 300.0, 9.81, -0.010_346_2, 123_456.7];
        let texts = values.map(exact);
        let wanted = ["0", "0.1385", "0.21334", "24000", "300", "9.81", "-0.010346", "123457"];
        assert_eq!(texts, wanted);
        assert_eq!(exact(1.618_33e-4), "1.6183e-4");
        assert_eq!(exact(f64::NAN), "–");
    }

    #[test]
    fn times_are_as_long_as_they_need_to_be() {
        assert_eq!(seconds(2.5e-4), "250 µs");
        assert_eq!(seconds(0.0125), "12.50 ms");
        assert_eq!(seconds(3.0), "3.000 s");
    }
}
