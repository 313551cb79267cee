//! A valid request for maps of stability.

use std::path::Path;

use crate::stability::{
    AxisTarget, FINGERS, LoopPoint, LoopQuantity, LoopValues, MapAxis, QUANTITIES, StabilityStudy,
    StabilitySubject,
};
use documents::{choice, quoted};
use haptics::{EstimatorName, Kalman, RigParameters};
use instruments::{ModelEntry, Parameter};
use keyboard::KeyIndex;
use scene::{Instrument, Library};

use super::quantities::{quantity, range};
use super::{ClosedLoopArgs, StabilityArgs, voices::InstrumentVoices};

const WALL: &str = "wall";

/// Default period of a loop (s).
pub(crate) const PERIOD: f64 = 1e-3;

/// Default axes of a wall, and of an instrument without springs.
const WALL_AXES: [&str; 2] = ["stiffness", "damping"];
const VOICE_AXES: [&str; 2] = ["period", "mass"];
/// Default axes of model B: the coupling spring and the string's.
const SPRINGS: [&str; 2] = ["k1", "k2"];

pub(super) struct StabilityQuestion {
    name: String,
    pub(super) voices: Option<InstrumentVoices>,
    pub(super) estimators: Vec<EstimatorName>,
    rig: RigParameters,
    base: LoopPoint,
    chosen: Vec<String>,
    axes: [MapAxis; 2],
    cells: usize,
}

impl StabilityQuestion {
    pub(super) fn new(args: &StabilityArgs) -> Result<Self, Vec<String>> {
        let (name, voices, mut parameters) = subject(args)?;
        let mut mistakes = Vec::new();
        let rig =
            voices.as_ref().map_or_else(|| Ok(RigParameters::default()), InstrumentVoices::rig);
        let rig = rig.map_err(|wrong| vec![wrong])?;
        let jerk = Kalman::KEY_JERK_DENSITY;
        let mut values = if voices.is_some() {
            LoopValues::of_rig(&rig, PERIOD, jerk)
        } else {
            LoopValues::ideal(&rig, PERIOD, jerk)
        };
        let model: Option<&ModelEntry> = voices.as_ref().map(|it| &**it.model);
        set_values(&args.closed_loop, &mut values, &mut mistakes);
        let known = model.map_or(&[][..], |it| &it.parameters);
        let chosen = set_parameters(known, &args.set, &mut parameters, &mut mistakes);
        let usual = [EstimatorName::BackwardDifference, EstimatorName::Kalman];
        let usual = if model.is_some() { &usual[..] } else { &usual[..1] };
        let estimators = estimators(&args.estimator, usual, &mut mistakes);
        let base = LoopPoint { values, parameters };
        let usual = usual_axes(model);
        let mut axis = |option: &str, text: &Option<String>, usual: &str| {
            let text = text.as_deref().unwrap_or(usual);
            let axis = axis(text, model, &base);
            axis.map_err(|wrong| mistakes.push(format!("--{option} {wrong}"))).ok()
        };
        let axes = (axis("x", &args.x, usual[0]), axis("y", &args.y, usual[1]));
        let (Some(x), Some(y)) = axes else { return Err(mistakes) };
        if x.target == y.target {
            mistakes.push(format!("--x and --y are both {}; choose two axes", x.name));
        }
        if !mistakes.is_empty() {
            return Err(mistakes);
        }
        // A boundary is searched along y, and named values have nothing between them.
        let axes = if y.names().is_some() { [y, x] } else { [x, y] };
        let cells = usize::from(args.cells);
        Ok(Self { name, voices, estimators, rig, base, chosen, axes, cells })
    }

    pub(super) fn study<'a>(&self, subject: StabilitySubject<'a>) -> StabilityStudy<'a> {
        StabilityStudy {
            name: self.name.clone(),
            subject,
            rig: self.rig,
            base: self.base.clone(),
            chosen: self.chosen.clone(),
            axes: self.axes.clone(),
            cells: self.cells,
        }
    }
}

type AskedSubject = (String, Option<InstrumentVoices>, Vec<f64>);

fn subject(args: &StabilityArgs) -> Result<AskedSubject, Vec<String>> {
    if args.what == WALL {
        return Ok((WALL.to_owned(), None, Vec::new()));
    }
    let (name, voices, values) = voices(&args.what, &args.key)?;
    Ok((name, Some(voices), values))
}

/// Returns name, voices and parameters of an instrument or model on a key, or all mistakes.
pub(crate) fn voices(
    what: &str,
    key: &str,
) -> Result<(String, InstrumentVoices, Vec<f64>), Vec<String>> {
    let mut mistakes = Vec::new();
    let key = key_named(key).map_err(|wrong| mistakes.push(wrong));
    let library = Library::default();
    let instrument = Instrument::load(&library, what).or_else(|wrong| {
        let model = library.find(what, Path::new("")).ok();
        let of_model = model.and_then(|model| Instrument::of_model(&model).into_iter().next());
        of_model.map(|instrument| Instrument::clone(&instrument)).ok_or(wrong)
    });
    let instrument = instrument.map_err(|wrong| mistakes.push(mechanism::rendered(&wrong)));
    let (Ok(key), Ok(instrument)) = (key, instrument) else { return Err(mistakes) };
    let values = instrument.values(key.number());
    let name = format!("{} on {key}", instrument.name);
    let voices = InstrumentVoices::new(instrument.model()).map_err(|wrong| vec![wrong])?;
    Ok((name, voices, values))
}

pub(crate) fn key_named(name: &str) -> Result<KeyIndex, String> {
    name.parse().map_err(|_no_key| {
        format!("--key {} is no key; give one from A0 to C8, as C4 or F#3", quoted(name))
    })
}

fn set_values(args: &ClosedLoopArgs, values: &mut LoopValues, mistakes: &mut Vec<String>) {
    let given = [
        (LoopQuantity::Stiffness, &args.stiffness),
        (LoopQuantity::Damping, &args.damping),
        (LoopQuantity::Period, &args.period),
        (LoopQuantity::Delay, &args.delay),
        (LoopQuantity::EncoderStep, &args.encoder_step),
        (LoopQuantity::Friction, &args.friction),
        (LoopQuantity::Mass, &args.mass),
        (LoopQuantity::DeviceDamping, &args.device_damping),
        (LoopQuantity::Bandwidth, &args.bandwidth),
        (LoopQuantity::JerkDensity, &args.jerk_density),
    ];
    set_quantities(&given, values, mistakes);
    let Some(name) = &args.finger else { return };
    if let Some(number) = FINGERS.iter().position(|it| it == name) {
        values.set(LoopQuantity::Finger, number as f64);
    } else {
        mistakes.push(format!("--finger {} is none: {}", quoted(name), choice(name, FINGERS)));
    }
}

pub(crate) fn set_quantities(
    given: &[(LoopQuantity, &Option<String>)],
    values: &mut LoopValues,
    mistakes: &mut Vec<String>,
) {
    for (what, text) in given {
        let (Some(text), entry) = (text, what.entry()) else { continue };
        match quantity(text, entry.unit) {
            Ok(value) => values.set(*what, value),
            Err(wrong) => mistakes.push(format!("--{} {wrong}", entry.name)),
        }
        let (low, high) = entry.range;
        let value = values.get(*what);
        if !(low..=high).contains(&value) {
            let unit = entry.unit;
            mistakes.push(format!("--{} {value:?} is not from {low} to {high} {unit}", entry.name));
        }
    }
}

/// Sets values of the model, each given as name=value; returns the valid ones.
pub(crate) fn set_parameters(
    known: &[Parameter],
    given: &[String],
    values: &mut [f64],
    mistakes: &mut Vec<String>,
) -> Vec<String> {
    let mut chosen = Vec::new();
    for text in given {
        match set_parameter(known, text, values) {
            Ok(()) => chosen.push(text.clone()),
            Err(wrong) => mistakes.push(format!("--set {wrong}")),
        }
    }
    chosen
}

fn set_parameter(known: &[Parameter], text: &str, values: &mut [f64]) -> Result<(), String> {
    let (name, value) = cli::arguments::assignment(text)?;
    let place = known.iter().position(|it| it.name == name);
    let Some((place, parameter)) = place.and_then(|it| Some((it, known.get(it)?))) else {
        let help = choice(&name, known.iter().map(|it| it.name));
        return Err(format!("there is no parameter {}: {help}", quoted(&name)));
    };
    let value = in_range(parameter, quantity(&value, parameter.unit)?)?;
    if let Some(old) = values.get_mut(place) {
        *old = value;
    }
    Ok(())
}

fn in_range(parameter: &Parameter, value: f64) -> Result<f64, String> {
    let Parameter { name, unit, range: (low, high), .. } = *parameter;
    if (low..=high).contains(&value) {
        return Ok(value);
    }
    Err(format!("{name} = {value:?} is not from {low} to {high} {unit}"))
}

pub(crate) fn estimators(
    named: &[String],
    usual: &[EstimatorName],
    mistakes: &mut Vec<String>,
) -> Vec<EstimatorName> {
    let all = EstimatorName::ALL;
    if named.is_empty() {
        return usual.to_vec();
    }
    let mut found = Vec::new();
    for name in named {
        match all.into_iter().find(|it| it.name() == name) {
            Some(estimator) if found.contains(&estimator) => {}
            Some(estimator) => found.push(estimator),
            None => {
                let help = choice(name, all.map(EstimatorName::name));
                mistakes.push(format!("--estimator {} is none: {help}", quoted(name)));
            }
        }
    }
    found
}

fn usual_axes(model: Option<&ModelEntry>) -> [&'static str; 2] {
    let Some(model) = model else { return WALL_AXES };
    let has = |name: &&str| model.parameters.iter().any(|it| it.name == *name);
    if SPRINGS.iter().all(has) { SPRINGS } else { VOICE_AXES }
}

fn axis(text: &str, model: Option<&ModelEntry>, base: &LoopPoint) -> Result<MapAxis, String> {
    let (name, ends) = match text.split_once('=') {
        Some((name, ends)) => (name.trim(), Some(ends)),
        None => (text.trim(), None),
    };
    let parameters = model.map_or(&[][..], |it| &it.parameters);
    let place = parameters.iter().position(|it| it.name == name);
    if let Some((place, parameter)) = place.and_then(|it| Some((it, parameters.get(it)?))) {
        let value = base.parameters.get(place).copied().unwrap_or_default();
        return of_parameter((place, parameter), value, ends);
    }
    let Some(found) = LoopQuantity::named(name) else {
        let quantities = QUANTITIES.iter().map(|it| it.name);
        let names: Vec<_> = quantities.chain(parameters.iter().map(|it| it.name)).collect();
        return Err(format!("there is no axis {}: {}", quoted(name), choice(name, names)));
    };
    let entry = found.entry();
    if found == LoopQuantity::Finger && ends.is_some() {
        return Err("finger has no ends: its cells are none, limp, ordinary and stiff".to_owned());
    }
    let ends = ends.map_or(Ok(entry.axis), |ends| range(ends, entry.unit))?;
    Ok(MapAxis::of_quantity(found, ends))
}

/// Returns the axis of a parameter: the given range, or 0.1 to 10 times its value.
fn of_parameter(
    (place, parameter): (usize, &Parameter),
    value: f64,
    ends: Option<&str>,
) -> Result<MapAxis, String> {
    let Parameter { name, ref title, unit, range: (low, high), .. } = *parameter;
    let ends = match ends {
        Some(ends) => range(ends, unit)?,
        None if value > 0.0 => ((0.1 * value).max(low), (10.0 * value).min(high)),
        None => return Err(format!("{name} is {value}; give its ends, as {name}=1..10")),
    };
    for end in [ends.0, ends.1] {
        in_range(parameter, end)?;
    }
    let title = if **title == *name { name.to_owned() } else { format!("{title} ({name})") };
    Ok(MapAxis {
        target: AxisTarget::Parameter(place),
        name: name.to_owned(),
        title,
        unit: unit.to_owned(),
        shown: (unit.to_owned(), 1.0),
        ends,
    })
}
