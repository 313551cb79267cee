//! Quantities in readable units: millimetres rather than 0.0032 m.

use std::ops::RangeInclusive;

mod typed;

use telemetry::Parameter;

use typed::{TypedUnit, number_and_unit, unit_of};

/// Units on the screen: SI unit, the one that is shown, and the largest values (SI) of quantities
/// that are shown so. The first match counts; any other unit is shown as it is.
///
/// Forces are in newtons, as in the plots; grams-force can be typed.
const SHOWN: [(&str, &str, RangeInclusive<f64>); 11] = [
    ("m", "mm", ANY),
    ("rad", "mrad", ANY),
    ("s", "ms", ANY),
    ("kg", "g", 0.0..=10.0),
    ("N", "GN", 1e10..=f64::INFINITY),
    ("J", "mJ", 0.0..=1.0),
    ("N·m", "mN·m", 0.0..=10.0),
    ("kg·m²", "kg·mm²", 0.0..=1.0),
    ("N/m", "N/mm", 1e4..=f64::INFINITY),
    ("N/m²", "N/mm²", 1e6..=f64::INFINITY),
    ("N·m/rad", "mN·m/rad", 0.0..=10.0),
];

const ANY: RangeInclusive<f64> = 0.0..=f64::INFINITY;

/// Part of a step to which moved values are rounded.
const ROUNDED: f64 = 1e-3;

/// Display of a unit: its name, and the factor of values.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Shown {
    pub(crate) unit: &'static str,
    pub(crate) factor: f64,
}

/// Returns the display of a quantity of any size.
pub(crate) fn shown(unit: &str) -> Option<Shown> {
    shown_up_to(unit, |largest| *largest == ANY)
}

fn shown_up_to(unit: &str, fits: impl Fn(&RangeInclusive<f64>) -> bool) -> Option<Shown> {
    let (si, unit, _) = SHOWN.iter().find(|it| it.0 == unit && fits(&it.2))?;
    let factor = unit_of(si)?.number_in(1.0, &unit_of(unit)?);
    Some(Shown { unit, factor })
}

/// Formats `value` with its unit, with useful digits only.
pub(crate) fn text(value: f64, unit: &str) -> String {
    let (value, unit) =
        shown(unit).map_or((value, unit), |shown| (value * shown.factor, shown.unit));
    join(&digits(value), unit)
}

/// A parameter as people read, move and type it: let-off in mm rather than a button's height in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ParameterReading<'a> {
    parameter: &'a Parameter,
    unit: &'a str,
    units: Option<(TypedUnit, TypedUnit)>,
}

/// Returns the display of `parameter`.
pub(crate) fn of(parameter: &Parameter) -> ParameterReading<'_> {
    let Parameter { unit, min, max, .. } = parameter;
    let largest = min.abs().max(max.abs());
    let unit = shown_up_to(unit, |it| it.contains(&largest)).map_or(unit.as_str(), |it| it.unit);
    ParameterReading { parameter, unit, units: unit_of(&parameter.unit).zip(unit_of(unit)) }
}

impl ParameterReading<'_> {
    /// Returns the factor of the reading, which is 0 in old recordings, and what is added.
    fn affine(&self) -> (f64, f64) {
        let Parameter { reading_per: per, reading_offset, .. } = *self.parameter;
        if per == 0.0 || !per.is_finite() { (1.0, 0.0) } else { (per, reading_offset) }
    }

    /// Returns the number that is shown for `value` (SI).
    pub(crate) fn number(&self, value: f64) -> f64 {
        let (per, offset) = self.affine();
        let number = self.in_shown(per * value + offset);
        // The difference of two lengths has digits that no step has made.
        let least = 1e-6 * self.in_shown(self.parameter.step);
        if number.abs() < least { 0.0 } else { number }
    }

    fn in_shown(&self, si: f64) -> f64 {
        self.units.map_or(si, |(unit, shown)| unit.number_in(si, &shown))
    }

    /// Returns the value (SI) for which `number` is shown.
    fn value(&self, number: f64, unit: Option<TypedUnit>) -> f64 {
        let si = match (unit, self.units) {
            (Some(typed), Some((unit, _))) => typed.number_in(number, &unit),
            (None, Some((unit, shown))) => shown.number_in(number, &unit),
            (_, None) => number,
        };
        let (per, offset) = self.affine();
        (si - offset) / per
    }

    pub(crate) fn step(&self) -> f64 {
        let Parameter { step, min, max, .. } = *self.parameter;
        let (per, _) = self.affine();
        if 0.0 < step && step.is_finite() {
            self.in_shown(step)
        } else {
            // Hosts before this field give none.
            crate::number::round(self.in_shown(per.abs() * (max - min) / 200.0))
        }
    }

    /// Returns `value` (SI) moved by some steps, within the model's limits.
    pub(crate) fn moved(&self, value: f64, steps: f64) -> f64 {
        let parts = 1.0 / (ROUNDED * self.step());
        let number = self.number(value) + steps * self.step();
        let moved = self.value((number * parts).round() / parts, None);
        moved.clamp(self.parameter.min, self.parameter.max)
    }

    /// Returns the least and the largest number within `steps` steps of `usual` (SI).
    pub(crate) fn around(&self, usual: f64, steps: f64) -> RangeInclusive<f64> {
        let [a, b] = [-steps, steps].map(|it| self.number(self.moved(usual, it)));
        a.min(b)..=a.max(b)
    }

    pub(crate) fn digits(&self, value: f64) -> String {
        exact(self.number(value))
    }

    pub(crate) fn text(&self, value: f64) -> String {
        join(&self.digits(value), self.unit)
    }

    /// Parses `text` to a value (SI). A number without a unit is in the displayed unit.
    ///
    /// # Errors
    /// A sentence.
    pub(crate) fn parse(&self, text: &str) -> Result<f64, String> {
        let Some((number, rest)) = number_and_unit(text) else {
            return Err(format!("This is not a number; write {}.", self.named()));
        };
        let is_plain = rest.is_empty() || rest == self.unit;
        let typed =
            unit_of(&rest).filter(|it| self.units.is_some_and(|(unit, _)| it.is_like(&unit)));
        if !is_plain && typed.is_none() {
            return Err(format!("\"{rest}\" is another unit; write {}.", self.named()));
        }
        let value = self.value(number, typed.filter(|_| !is_plain));
        let Parameter { min, max, .. } = *self.parameter;
        // A limit that is typed as it is shown counts, whatever its last digit is.
        let slack = 1e-9 * min.abs().max(max.abs()).min(f64::MAX);
        if !value.is_finite() || value < min - slack || max + slack < value {
            let [a, b] = [min, max].map(|it| self.number(it));
            let (low, high) = (exact(a.min(b)), exact(a.max(b)));
            return Err(join(&format!("It must be {low} to {high}"), self.unit) + ".");
        }
        Ok(value.clamp(min, max))
    }

    fn named(&self) -> String {
        if is_none(self.unit) {
            "a number".to_owned()
        } else {
            format!("a number of {}", self.unit)
        }
    }
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
    fn quantities_are_read_in_the_units_of_a_workshop() {
        assert_eq!(text(0.0032, "m"), "3.2 mm");
        assert_eq!(text(0.04, "rad"), "40 mrad");
        assert_eq!(text(1.5, "N"), "1.5 N");
        assert_eq!(text(5800.0, "N/m"), "5800 N/m");
        assert_eq!(text(0.0, ""), "0");
    }

    fn parameter(unit: &str, (min, max): (f64, f64), step: f64) -> Parameter {
        Parameter { unit: unit.to_owned(), min, max, step, ..Parameter::default() }
    }

    /// A let-off button: 1 mm higher is 6 mm less of let-off, of 2.2 mm at 61.522 mm.
    fn button() -> Parameter {
        let (reading_per, reading_offset) = (-6.0, 2.2e-3 + 6.0 * 61.522e-3);
        Parameter { reading_per, reading_offset, ..parameter("m", (0.058, 0.07), 1e-4) }
    }

    #[test]
    fn parameters_are_formatted_in_units_of_their_size() {
        for (unit, max, value, expected) in [
            ("m", 0.5, 0.061_522, "61.522 mm"),
            ("kg", 0.03, 0.008_706_1, "8.7061 g"),
            ("kg", 100.0, 12.5, "12.5 kg"),
            ("kg·m²", 1e-4, 6e-6, "6 kg·mm²"),
            ("N·m", 1.0, 0.0127, "12.7 mN·m"),
            ("N/m", 1e7, 95_100.0, "95.1 N/mm"),
            ("N/m", 50.0, 0.5, "0.5 N/m"),
            ("N/m²", 1e12, 6.02e7, "60.2 N/mm²"),
            ("N", 1e15, 2.0656e12, "2065.6 GN"),
            ("N", 2.0, 0.15, "0.15 N"),
            ("s", 0.2, 0.031, "31 ms"),
            ("1", 1.0, 0.622, "0.622"),
            ("K·m/s", 1.0, 0.5, "0.5 K·m/s"),
        ] {
            assert_eq!(of(&parameter(unit, (0.0, max), 1e-3)).text(value), expected);
        }
        assert_eq!(of(&button()).text(0.061_522), "2.2 mm");
        assert_eq!(of(&button()).text(0.061_522 + 2.2e-3 / 6.0), "0 mm");
    }

    #[test]
    fn typed_texts_are_numbers_with_or_without_a_unit() {
        let (length, force) = (parameter("m", (0.0, 1.0), 1e-4), parameter("N", (-1.0, 2.0), 0.1));
        let stiffness = parameter("N/m", (0.0, 1e7), 100.0);
        for (parameter, typed, value) in [
            (&length, "62 mm", 0.062),
            (&length, " 62", 0.062),
            (&length, "62,5", 0.0625),
            (&length, "6.2 cm", 0.062),
            (&length, "0,062 m", 0.062),
            (&length, "1.5e-3", 1.5e-6),
            (&force, "50 gf", 0.490_332_5),
            (&force, "\u{2212}0.5", -0.5),
            (&force, "300mN", 0.3),
            (&stiffness, "5800 N/m", 5800.0),
            (&stiffness, "5.8", 5800.0),
            (&stiffness, "5.8 kN/m", 5800.0),
            (&button(), "1.6", 0.061_622),
            (&button(), "0.16 cm", 0.061_622),
        ] {
            let found = of(parameter).parse(typed);
            assert!(found.is_ok_and(|it| (it - value).abs() <= 1e-12 * value.abs()), "{typed}");
        }
        for (parameter, typed, why) in [
            (&length, "", "not a number"),
            (&length, "mm", "not a number"),
            (&length, "1 kg", "\"kg\" is another unit; write a number of mm."),
            (&length, "1.2.3", "another unit"),
            (&length, "1e999", "must be 0 to 1000 mm"),
            (&length, "1001", "must be 0 to 1000 mm"),
            (&force, "3 N*m", "another unit"),
            (&force, "300 gf", "must be -1 to 2 N"),
            (&button(), "30", "must be -48.668 to 23.332 mm"),
        ] {
            let refused = of(parameter).parse(typed).expect_err(typed);
            assert!(refused.contains(why), "{typed}: {refused}");
        }
    }

    #[test]
    fn a_step_moves_what_is_read_and_stays_within_the_limits() {
        let button = button();
        let reading = of(&button);
        assert!((reading.step() - 0.1).abs() < 1e-12);
        assert_eq!(reading.text(reading.moved(0.061_522, -6.0)), "1.6 mm");
        assert_eq!(reading.text(reading.moved(0.061_522, 0.1)), "2.21 mm");
        let around = reading.around(0.061_522, 25.0);
        assert!((around.start() + 0.3).abs() < 1e-9 && (around.end() - 4.7).abs() < 1e-9);
        let length = parameter("m", (0.0, 0.01), 1e-4);
        assert_eq!(of(&length).around(1e-3, 25.0), 0.0..=3.5);
        let old = Parameter { step: 0.0, ..length };
        assert!((of(&old).step() - 0.05).abs() < 1e-12);
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
