use std::path::Path;

use documents::Diagnostics;
use keyboard::KeyIndex;
use mechanism::Library;
use toml_edit::{DocumentMut, InlineTable, Item, Table, Value, value};

use super::embedded::INSTRUMENTS;
use super::instrument::Instrument;
use super::source::{SourceError, SourceText, refuse};

/// Digits of a written value.
const DIGITS: usize = 8;

/// Values of one key for an instrument's file.
#[derive(Clone, Copy, Debug)]
pub struct FittedValues<'a> {
    pub title: &'a str,
    pub doc: &'a str,
    pub key: KeyIndex,
    /// Parameters by name with their value on that key (SI units).
    pub values: &'a [(&'a str, f64)],
}

/// Returns the text of the file of the instrument `name_or_path` with the values `fitted`.
///
/// Everything else stays. A graded parameter remains on a straight line through the new value, with
/// the ends in their old proportion.
///
/// # Errors
/// All mistakes in the instrument or in the new one.
pub fn fitted_text(
    library: &Library,
    name_or_path: &str,
    fitted: &FittedValues<'_>,
) -> Result<String, Diagnostics> {
    let instrument = Instrument::load(library, name_or_path)?;
    let wrong = |what: String| refuse(Path::new(name_or_path), None, what, String::new());
    let source = SourceText::find(&INSTRUMENTS, name_or_path, Path::new(""));
    let source = source.map_err(|missing| match missing {
        SourceError::Unknown((message, _help)) => wrong(message),
        SourceError::Unreadable(diagnostics) => diagnostics,
    })?;
    let parsed = source.text.parse::<DocumentMut>();
    let mut document = parsed.map_err(|error| wrong(error.to_string()))?;
    document["title"] = value(fitted.title);
    document["doc"] = value(fitted.doc);
    if let Some(file) = instrument.model().file() {
        let absolute = std::path::absolute(file).unwrap_or_else(|_| file.into());
        document["model"] = value(absolute.to_string_lossy().as_ref());
    }
    let parameters = document.entry("parameters").or_insert_with(|| Item::Table(Table::new()));
    for (name, new) in fitted.values {
        parameters[*name] = Item::Value(graded(&instrument, name, (fitted.key, *new)));
    }
    let text = document.to_string();
    let again = SourceText::from_bytes(Path::new("fitted.toml"), text.clone().into_bytes())?;
    Instrument::check(library, &again)?;
    Ok(text)
}

/// Returns the parameter called `name`, `new` on a key, as a file has it.
fn graded(instrument: &Instrument, name: &str, (key, new): (KeyIndex, f64)) -> Value {
    let parameters = &instrument.model().parameters;
    let place = parameters.iter().position(|it| it.name == name);
    let on = |key: u8| place.and_then(|place| instrument.values(key).get(place).copied());
    let last = KeyIndex::HIGHEST.number();
    let (bass, now, treble) = (on(0), on(key.number()), on(last));
    let range = place.map(|place| parameters[place].range);
    let (Some(bass), Some(now), Some(treble), Some((low, high))) = (bass, now, treble, range)
    else {
        return short(new).into();
    };
    if (bass - treble).abs() <= 1e-12 * now.abs() || now == 0.0 {
        return short(new).into();
    }
    let slope = new / now * (treble - bass) / f64::from(last);
    let at =
        |it: u8| short((new + slope * (f64::from(it) - f64::from(key.number()))).clamp(low, high));
    let ends = [("bass", at(0)), ("treble", at(last))];
    ends.into_iter().map(|(end, value)| (end, Value::from(value))).collect::<InlineTable>().into()
}

fn short(value: f64) -> f64 {
    format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(name: &str, values: &[(&str, f64)]) -> String {
        let key = KeyIndex::new(39).expect("a key");
        let fitted = FittedValues { title: "T", doc: "from data", key, values };
        fitted_text(&Library::default(), name, &fitted).unwrap_or_else(|wrong| panic!("{wrong}"))
    }

    #[test]
    fn a_fitted_instrument_has_the_values_and_the_grading_of_its_source() {
        let text = text("grand-springs", &[("k2", 12345.0), ("M2", 0.01)]);
        for part in ["title = \"T\"", "from data", "model = \"key-hammer-springs\"", "[[stable]]"] {
            assert!(text.contains(part), "no {part} in {text}");
        }
        let source = SourceText::from_bytes(Path::new("a.toml"), text.into_bytes()).expect("text");
        let again = Instrument::check(&Library::default(), &source).expect("an instrument");
        let on = |key: u8, name: &str| {
            let place = again.model().parameters.iter().position(|it| it.name == name);
            again.values(key)[place.expect("a parameter")]
        };
        assert!((on(39, "k2") - 12345.0).abs() < 1e-9 && (on(0, "k2") - on(87, "k2")).abs() < 1e-9);
        assert!((on(39, "M2") - 0.01).abs() < 1e-8, "{}", on(39, "M2"));
        assert!(on(0, "M2") > 0.01 && on(87, "M2") < 0.009, "{} {}", on(0, "M2"), on(87, "M2"));
    }
}
