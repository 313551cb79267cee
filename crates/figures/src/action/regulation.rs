//! Regulation of one key: figures that a second of computing gives, and the faults of the key.

use keyboard::KeyIndex;

use super::figure::{Figure, MeasuredFigures};
use super::slope::{self, ForceCurve};
use super::stroke::{Miss, Stroke, play};
use super::{again::repeats, drive::StrokeTouch, gather::weigh, subject::PianoSubject};

/// Speed of the slow press (m/s).
const SLOW: f64 = 2e-3;

/// Duration of the stroke (s): the hammer of a grand gets 1 m/s.
const DURATION: f64 = 92.6e-3;

/// Names of the repetitions, with the part of the travel by which the key rises.
const REPETITIONS: [(&str, f64); 2] = [("repetition_third", 1.0 / 3.0), ("repetition_full", 1.0)];

/// Fastest tried rate (1/s); slower ones follow, as a key may lose a rate and keep a faster one.
const FASTEST: u32 = 25;

/// Slower rates that are tried, as parts of the expected one.
const SLOWER: [f64; 3] = [0.75, 0.5, 0.25];

/// Figures and faults of one key.
#[derive(Clone, PartialEq, Debug)]
pub struct Regulation {
    /// The measured figures, with what the instrument expects.
    pub figures: Vec<Figure>,
    /// A sentence on each fault, the worst first.
    pub warnings: Vec<String>,
}

struct RegulationFault {
    name: &'static str,
    sentence: String,
}

/// Measures `key` of an instrument as it is `now`, and compares it with the instrument as `usual`.
///
/// A fault that the usual key has as well is not reported, except a blocked hammer and a slower
/// repetition. Returns `None` if `is_cancelled`, which is polled some times a second.
pub fn regulation(
    now: &PianoSubject<'_>,
    usual: &PianoSubject<'_>,
    key: KeyIndex,
    is_cancelled: &dyn Fn() -> bool,
) -> Option<Regulation> {
    let (figures, mut faults) = examine(now, key.number(), is_cancelled)?;
    if faults.iter().any(|it| it.name != BLOCKED) {
        let (before, accepted) = examine(usual, key.number(), is_cancelled)?;
        let value = |all: &[Figure], name| all.iter().find(|it| it.name == name)?.value;
        let is_slower = |name| {
            let is_rate = REPETITIONS.iter().any(|it| it.0 == name);
            is_rate && value(&figures, name) < value(&before, name)
        };
        let is_accepted = |it: &RegulationFault| accepted.iter().any(|other| other.name == it.name);
        faults.retain(|it| it.name == BLOCKED || is_slower(it.name) || !is_accepted(it));
    }
    let warnings = faults.into_iter().map(|it| format!("{key} {}", it.sentence)).collect();
    Some(Regulation { figures, warnings })
}

const BLOCKED: &str = "blocked";

fn examine(
    subject: &PianoSubject<'_>,
    key: u8,
    is_cancelled: &dyn Fn() -> bool,
) -> Option<(Vec<Figure>, Vec<RegulationFault>)> {
    let mut measured = MeasuredFigures::default();
    let slow = slope::measure(subject, key, SLOW);
    if let Some(slow) = &slow {
        weigh(subject.dip(key), std::slice::from_ref(slow), &mut measured);
    }
    let string = subject.parameter("string_height", key);
    let let_off = string.zip(slow.as_ref().and_then(|it| it.highest)).map(|(at, top)| at - top);
    measured.maybe("let_off", let_off.map(|it| 1e3 * it));
    if is_cancelled() {
        return None;
    }
    let stroke = play(subject, key, (StrokeTouch::Pressed, DURATION));
    for (name, part) in REPETITIONS {
        let wanted = subject.expected.iter().find(|it| it.0 == name).map(|it| it.1.0);
        if let Some(wanted) = wanted.filter(|it| 0.0 < *it && stroke.is_ok()) {
            let rate = quickest(subject, key, (part, wanted), is_cancelled)?;
            measured.set(name, rate);
        }
    }
    let figures = measured.figures(subject.expected);
    let figures: Vec<_> = figures.into_iter().filter(|it| it.value.is_some()).collect();
    let mut faults: Vec<_> = mechanical(slow.as_ref(), stroke, let_off).into_iter().collect();
    faults.extend(figures.iter().filter(|it| it.pass == Some(false)).map(RegulationFault::of));
    Some((figures, faults))
}

/// Returns the fastest of some rates about `wanted` at which the key repeats (1/s), or 0.
fn quickest(
    subject: &PianoSubject<'_>,
    key: u8,
    (part, wanted): (f64, f64),
    is_cancelled: &dyn Fn() -> bool,
) -> Option<f64> {
    let fast = (0..=2 * FASTEST).rev().map(|halves| 0.5 * f64::from(halves));
    let fast = fast.take_while(|it| wanted <= *it);
    for rate in fast.chain(SLOWER.map(|it| it * wanted)) {
        if is_cancelled() {
            return None;
        }
        if repeats(subject, key, (part, rate)) {
            return Some(rate);
        }
    }
    Some(0.0)
}

fn mechanical(
    slow: Option<&ForceCurve>,
    stroke: Result<Stroke, Miss>,
    let_off: Option<f64>,
) -> Option<RegulationFault> {
    let fault =
        |name, sentence: &str| Some(RegulationFault { name, sentence: sentence.to_owned() });
    let is_at_string = |height: Option<f64>| height.is_some_and(|it| it <= 0.0);
    match stroke {
        _ if slow.is_none() => fault("failed", "cannot be computed in a slow press"),
        Err(Miss::Failed) => fault("failed", "cannot be computed in a stroke"),
        _ if is_at_string(let_off) => {
            fault(BLOCKED, "blocks: the hammer is not let off below the string in a slow press")
        }
        Ok(stroke) if is_at_string(stroke.checked) => {
            fault(BLOCKED, "blocks: the hammer stays at the string while the key is held")
        }
        Ok(Stroke { strikes, .. }) if 1 < strikes => {
            fault("second_strikes", &format!("strikes {strikes} times in one stroke"))
        }
        Ok(_) => None,
        Err(Miss::Silent) => fault("silent", "does not sound in a normal stroke"),
    }
}

impl RegulationFault {
    fn of(figure: &Figure) -> Self {
        let (name, unit) = figure.title.rsplit_once(" [").unwrap_or((figure.title, ""));
        let unit = unit.trim_end_matches(']');
        let number = |it: Option<f64>| it.map_or_else(|| "?".to_owned(), |it| format!("{it:.1}"));
        let range = match (figure.low, figure.high) {
            (Some(f64::NEG_INFINITY), high) => format!("at most {}", number(high)),
            (low, Some(f64::INFINITY)) => format!("at least {}", number(low)),
            (low, high) => format!("{} to {}", number(low), number(high)),
        };
        let value = number(figure.value);
        let name = name.split(':').next().unwrap_or(name);
        let sentence = format!("is out of range: {name} {value} {unit}, expected {range} {unit}");
        Self { name: figure.name, sentence }
    }
}

#[cfg(test)]
mod tests {
    use scene::{Instrument, Library};

    use super::*;

    fn load(name: &str) -> Instrument {
        Instrument::load(&Library::default(), name).expect("an instrument of ours")
    }

    fn place(instrument: &Instrument, parameter: &str) -> usize {
        let place = instrument.model().parameters.iter().position(|it| it.name == parameter);
        place.expect("a parameter")
    }

    /// Returns the let-off of a slow press (mm) with the parameter at `place` set to `value`.
    fn let_off(instrument: &Instrument, key: u8, (place, value): (usize, f64)) -> f64 {
        let values = |key| {
            let mut values = instrument.values(key);
            values[place] = value;
            values
        };
        let (name, model) = (instrument.name.as_str(), instrument.model());
        let subject = PianoSubject { name, model, values: &values, expected: &[] };
        let slow = slope::measure(&subject, key, SLOW).expect("a press");
        let string = subject.parameter("string_height", key).expect("a string");
        1e3 * (string - slow.highest.expect("a hammer"))
    }

    #[test]
    fn the_reading_of_a_let_off_moves_as_a_slow_press_measures() {
        for (name, parameter, keys, readings) in [
            ("grand", "button", [0, 39, 87], [0.7, 1.4, 2.2, 3.0]),
            ("upright", "off", [0, 39, 87], [2.0, 2.6, 3.2, 4.4]),
            ("viennese", "off", [0, 39, 87], [0.4, 0.7, 1.0, 1.6]),
        ] {
            let instrument = load(name);
            for key in keys {
                let (own, errors) = reading_errors(&instrument, parameter, key, readings);
                // The reading is that of C4; heavier and lighter hammers shift it.
                let most = [0.5, 0.1][usize::from(key == 39)];
                assert!(own.abs() < most, "{name} {key}: {own} mm");
                assert!(errors.iter().all(|it| it.abs() < 0.1), "{name} {key}: {errors:?} mm");
            }
        }
    }

    /// Returns errors of a reading at the usual value of `key`, and at `readings` (mm).
    fn reading_errors<const N: usize>(
        instrument: &Instrument,
        parameter: &str,
        key: u8,
        readings: [f64; N],
    ) -> (f64, [f64; N]) {
        let place = place(instrument, parameter);
        let reading = instrument.model().parameters[place].reading;
        let usual = instrument.values(key)[place];
        let shown = 1e3 * (reading.per * usual + reading.offset);
        let own = let_off(instrument, key, (place, usual)) - shown;
        let errors = readings.map(|expected| {
            let value = (1e-3 * expected - reading.offset) / reading.per;
            let_off(instrument, key, (place, value)) - own - expected
        });
        (own, errors)
    }

    fn grand(key: u8, millimetres: f64) -> Regulation {
        let instrument = load("grand");
        let place = place(&instrument, "button");
        let moved = |key| {
            let mut values = instrument.values(key);
            values[place] += 1e-3 * millimetres;
            values
        };
        let usual = PianoSubject {
            name: "grand",
            model: instrument.model(),
            values: &|key| instrument.values(key),
            expected: &instrument.figures,
        };
        let now = PianoSubject { values: &moved, ..usual };
        let key = KeyIndex::new(key).expect("a key");
        regulation(&now, &usual, key, &|| false).expect("it is not cancelled")
    }

    #[test]
    fn a_hammer_that_blocks_is_found_and_a_close_let_off_is_not_one() {
        for key in [75, 87] {
            let blocked = grand(key, 1.0);
            for fault in ["blocks", "repetition"] {
                assert!(blocked.warnings.iter().any(|it| it.contains(fault)), "{blocked:?}");
            }
            // 1.5 mm of let-off less.
            let close = grand(key, 1.5 / 5.86);
            assert!(!close.warnings.iter().any(|it| it.contains("blocks")), "{close:?}");
            assert!(close.warnings.iter().any(|it| it.contains("let-off")), "{close:?}");
        }
    }

    #[test]
    fn the_instrument_as_it_is_has_no_fault() {
        for key in [0, 39, 87] {
            let good = grand(key, 0.0);
            assert_eq!(good.warnings, Vec::<String>::new());
            let names: Vec<_> = good.figures.iter().map(|it| it.name).collect();
            for name in [
                "down_weight_2mm_s",
                "up_weight_2mm_s",
                "aftertouch",
                "let_off",
                "repetition_third",
            ] {
                assert!(names.contains(&name), "{name} of {names:?}");
            }
        }
    }
}
