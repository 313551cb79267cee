//! Values of a range of keys as an instrument's file.

use std::fmt::Write as _;
use std::ops::RangeInclusive;

use telemetry::Parameter;

/// Largest deviation from a straight line between the ends (share of the larger end).
const STRAIGHT: f64 = 1e-6;

/// Values of a range of keys, to be written as an instrument's file.
#[derive(Clone, Debug)]
pub struct SavedPreset<'a> {
    pub title: &'a str,
    pub model: &'a str,
    pub parameters: &'a [Parameter],
    pub range: RangeInclusive<u8>,
}

impl SavedPreset<'_> {
    /// Returns the file's text: a number if all keys share it, else the values of both ends.
    /// `value` returns a parameter's value on a key.
    pub fn text(&self, value: impl Fn(u8, &str) -> Option<f64>) -> String {
        let mut text = format!("title = {}\n", quoted(self.title));
        let keys = crate::names::range_name(&self.range);
        let _infallible = writeln!(text, "doc = \"Tuned by hand on {keys}.\"");
        let _infallible = writeln!(text, "model = {}\n\n[parameters]", quoted(self.model));
        for parameter in self.parameters {
            let values: Vec<f64> =
                self.range.clone().filter_map(|key| value(key, &parameter.name)).collect();
            if let Some(line) = line(&parameter.name, &parameter.unit, &values) {
                text.push_str(&line);
            }
        }
        text
    }
}

fn line(name: &str, unit: &str, values: &[f64]) -> Option<String> {
    let (bass, treble) = (*values.first()?, *values.last()?);
    let tolerance = STRAIGHT * bass.abs().max(treble.abs());
    let last = values.len() - 1;
    let slope = (treble - bass) / crate::number::f64(last.max(1));
    let off = |(i, value): (usize, &f64)| {
        tolerance < (bass + slope * crate::number::f64(i) - value).abs()
    };
    let note = if values.iter().enumerate().any(off) { "not straight between" } else { "" };
    let value = if (treble - bass).abs() <= tolerance && note.is_empty() {
        format!("{bass:?}")
    } else {
        format!("{{ bass = {bass:?}, treble = {treble:?} }}")
    };
    Some(format!("{name} = {value}{}\n", comment(unit, note)))
}

/// Returns the unit and a note, as far as there are any.
fn comment(unit: &str, note: &str) -> String {
    let unit = crate::unit::bracketed(unit);
    let parts = [unit.as_str(), note].into_iter().filter(|part| !part.is_empty());
    let text = parts.collect::<Vec<_>>().join(", ");
    if text.is_empty() { text } else { format!(" # {text}") }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameter(name: &str, unit: &str) -> Parameter {
        Parameter { name: name.into(), unit: unit.into(), ..Parameter::default() }
    }

    #[test]
    fn equal_values_are_a_number_and_graded_ones_two() {
        let parameters = [parameter("k2", "N/m"), parameter("m", "kg"), parameter("d", "m")];
        let preset = SavedPreset {
            title: "Soft \"one\"",
            model: "key-hammer-springs",
            parameters: &parameters,
            range: 0..=10,
        };
        let value = |key: u8, name: &str| match name {
            "k2" => Some(5800.0),
            "m" => Some(0.01 - 0.0005 * f64::from(key)),
            _ => Some(f64::from(key * key)),
        };
        let expected = concat!(
            "title = \"Soft \\\"one\\\"\"\n",
            "doc = \"Tuned by hand on A0..G1.\"\n",
            "model = \"key-hammer-springs\"\n\n",
            "[parameters]\n",
            "k2 = 5800.0 # [N/m]\n",
            "m = { bass = 0.01, treble = 0.005 } # [kg]\n",
            "d = { bass = 0.0, treble = 100.0 } # [m], not straight between\n",
        );
        assert_eq!(preset.text(value), expected);
    }
}
