//! Checks arguments completely before the first tick.

use std::fs;
use std::path::{Path, PathBuf};

use instruments::{Described, ModelEntry, Parameter, Playable};
use pode::stepper::{Any, ByNeed};
use pode::{Limits, State as _};

use super::args::SimulateArgs;
use super::error::SimulateMistake;
use super::input::InputSignal;

/// Maximum ticks: a day's work at least, so more is a slip of the exponent.
const MOST_TICKS: f64 = 1e11;
/// Share of a tick below which a remainder is rounding.
const CRUMB: f64 = 1e-9;
const TOLERANCES: (f64, f64) = (1e-16, 0.5);
const LAST_KEY: u8 = 87;

/// Tick (s) of the choice of `by-need`, so that a shorter step for a check keeps the method.
const USUAL_TICK: f64 = 1e-3;

/// Returns the method with its tolerance; RK4 after a mistake.
fn method(args: &SimulateArgs, mistakes: &mut Vec<SimulateMistake>) -> Any {
    let Some(method) = Any::named(&args.method) else {
        mistakes.push(SimulateMistake::unknown("method", &args.method, Any::NAMES));
        return Any::default();
    };
    // `by-need` has a budget even without a tolerance.
    let is_by_need = matches!(method, Any::ByNeed(_));
    let by_default = is_by_need.then_some(ByNeed::BUDGET);
    let Some(tolerance) = args.tolerance.or(by_default) else { return method };
    method.with_tolerance(tolerance, USUAL_TICK).unwrap_or_else(|| {
        mistakes.push(SimulateMistake::NoTolerance {
            method: args.method.clone(),
            known: Any::TOLERANT.to_vec(),
        });
        method
    })
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct TickClock {
    /// Length of a tick (s).
    pub(super) step: f64,
    /// End of the last tick (s).
    pub(super) until: f64,
    /// Number of ticks; the last may be shorter.
    pub(super) ticks: u64,
    /// Number of the first tick, which starts at 0 s.
    pub(super) first: u64,
    pub(super) method: Any,
    pub(super) limits: Limits,
}

impl TickClock {
    pub(super) fn check(args: &SimulateArgs, mistakes: &mut Vec<SimulateMistake>) -> Self {
        let SimulateArgs { until, step, .. } = *args;
        let default = Limits::default();
        let event_tolerance = args.event_tolerance.unwrap_or(default.event_tolerance);
        let before = mistakes.len();
        for (option, value) in [("--until", until), ("--step", step)] {
            if !(value > 0.0 && value.is_finite()) {
                mistakes.push(SimulateMistake::NotADuration { option, value });
            }
        }
        let ticks = (until / step - CRUMB).ceil().max(1.0);
        if mistakes.len() == before && ticks > MOST_TICKS {
            mistakes.push(SimulateMistake::TooManyTicks { ticks, most: MOST_TICKS });
        }
        check_range("--event-tolerance", event_tolerance, TOLERANCES, "of a tick", mistakes);
        if let Some(tolerance) = args.tolerance {
            check_range("--tolerance", tolerance, (1e-15, 1.0), "of the state", mistakes);
        }
        let limits = Limits { longest_step: step, event_tolerance, ..default };
        #[expect(clippy::cast_possible_truncation, reason = "at most MOST_TICKS, or a mistake")]
        #[expect(clippy::cast_sign_loss, reason = "at least 1")]
        let ticks = ticks as u64;
        let method = method(args, mistakes);
        Self { step, until, ticks, first: args.caller.first_tick, method, limits }
    }

    /// Returns the length of tick `tick` (s).
    pub(super) fn length(&self, tick: u64) -> f64 {
        if tick + 1 < self.ticks { self.step } else { self.until - tick as f64 * self.step }
    }

    /// Returns the instant `theta` of tick `tick` (s); its end is the next start bit for bit.
    pub(super) fn time(&self, tick: u64, theta: f64) -> f64 {
        if tick + 1 < self.ticks {
            return (tick as f64 + theta) * self.step;
        }
        let start = tick as f64 * self.step;
        if theta < 1.0 { start + theta * (self.until - start) } else { self.until }
    }
}

/// Checks all that does not depend on the model: the key, and that no file is used twice.
pub(super) fn rest(args: &SimulateArgs, mistakes: &mut Vec<SimulateMistake>) {
    if args.key > LAST_KEY {
        check_range("--key", args.key.into(), (0.0, LAST_KEY.into()), "(A0 to C8)", mistakes);
    }
    let input = args.input.as_ref().map(PathBuf::from);
    let files = [
        ("--input", &input),
        ("--out", &args.output.out),
        ("--events", &args.output.events),
        ("--plot", &args.output.plot),
    ];
    for (index, (first, a)) in files.iter().enumerate() {
        for (second, b) in &files[index + 1..] {
            if let (Some(a), Some(b)) = (a, b)
                && is_same_file(a, b)
            {
                mistakes.push(SimulateMistake::SameFile { first, second, path: b.clone() });
            }
        }
    }
}

/// Returns `true` if both paths lead to one regular file, existing or not; devices may be repeated.
fn is_same_file(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| {
        fs::canonicalize(path).ok().or_else(|| {
            let parent = path.parent().filter(|parent| *parent != "");
            let parent = fs::canonicalize(parent.unwrap_or_else(|| ".".as_ref())).ok()?;
            Some(parent.join(path.file_name()?))
        })
    };
    match (place(a), place(b)) {
        (Some(a), Some(b)) => a == b && (a.is_file() || !a.exists()),
        _ => false,
    }
}

fn check_range(
    what: &str,
    value: f64,
    (low, high): (f64, f64),
    unit: &'static str,
    mistakes: &mut Vec<SimulateMistake>,
) {
    if !(low..=high).contains(&value) {
        mistakes.push(SimulateMistake::OutOfRange {
            what: what.to_owned(),
            value,
            low,
            high,
            unit,
        });
    }
}

#[derive(Debug)]
pub(super) struct Start<M: Described> {
    pub(super) model: M,
    pub(super) mode: M::Mode,
    pub(super) state: M::State,
}

impl<M: Playable> Start<M> {
    /// Returns the model with its parameters, at rest except for given values.
    pub(super) fn check(
        model: &M,
        args: &SimulateArgs,
        input: &InputSignal,
        mistakes: &mut Vec<SimulateMistake>,
    ) -> Option<Self> {
        let entry = model.entry();
        let model = model.with_values(&parameters(entry, args, mistakes)?);
        let name = entry.name;
        model.unmet(&mut |condition| {
            mistakes.push(SimulateMistake::Unmet { model: name, condition: condition.to_owned() });
        });
        let s = input.at(0.0);
        let (rest_mode, rest) = model.at_rest(&s);
        let given = named_values("--initial", "state", &args.initial, &entry.states, mistakes);
        let mode = args.mode.as_deref().map_or(Some(rest_mode), |name| {
            let found = model.modes().find(|(_, known)| *known == name);
            if found.is_none() {
                let known: Vec<_> = model.modes().map(|(_, known)| known).collect();
                mistakes.push(SimulateMistake::unknown("mode", name, &known));
            }
            found.map(|(mode, _)| mode)
        })?;
        let state = model.constrain(mode, &with_entries::<M>(rest, &given), &s);
        if !state.entries().iter().all(|entry| entry.is_finite()) {
            mistakes.push(SimulateMistake::NoStart);
        }
        Some(Self { model, mode, state })
    }
}

/// Returns one value per parameter: the preset's, then those of `--set`; `None` without a preset.
fn parameters(
    entry: &ModelEntry,
    args: &SimulateArgs,
    mistakes: &mut Vec<SimulateMistake>,
) -> Option<Vec<f64>> {
    let ModelEntry { presets, parameters, .. } = entry;
    let preset = match args.preset.as_deref() {
        None => presets.first(),
        Some(name) => {
            let found = presets.iter().find(|preset| preset.name == name);
            if found.is_none() {
                let known: Vec<_> = presets.iter().map(|preset| preset.name).collect();
                mistakes.push(SimulateMistake::unknown("preset", name, &known));
            }
            // Use the default to find other mistakes.
            found.or_else(|| presets.first())
        }
    }?;
    let key = args.key.min(LAST_KEY);
    let mut values = preset.values(key);
    let names: Vec<_> = parameters.iter().map(|parameter| parameter.name).collect();
    let before = mistakes.len();
    for (index, value) in named_values("--set", "parameter", &args.set, &names, mistakes) {
        let Parameter { name, unit, range, .. } = &parameters[index];
        check_range(&format!("parameter `{name}`"), value, *range, unit, mistakes);
        values[index] = value;
    }
    if mistakes.len() > before {
        values = preset.values(key);
    }
    Some(values)
}

/// Parses `name=value` pairs as (index of the name, value); adds to `mistakes`.
fn named_values(
    option: &'static str,
    what: &'static str,
    pairs: &[String],
    names: &[&'static str],
    mistakes: &mut Vec<SimulateMistake>,
) -> Vec<(usize, f64)> {
    let mut values: Vec<(usize, f64)> = Vec::new();
    for text in pairs {
        let Some((name, number)) = text.split_once('=') else {
            mistakes.push(SimulateMistake::NotNameValue { option, text: text.clone() });
            continue;
        };
        let index = names.iter().position(|known| *known == name);
        let value = number.parse::<f64>().ok().filter(|value| value.is_finite());
        if index.is_none() {
            mistakes.push(SimulateMistake::unknown(what, name, names));
        }
        if value.is_none() {
            let (name, text) = (name.to_owned(), number.to_owned());
            mistakes.push(SimulateMistake::NotANumber { option, name, text });
        }
        let (Some(index), Some(value)) = (index, value) else { continue };
        if values.iter().any(|(known, _)| *known == index) {
            mistakes.push(SimulateMistake::Twice { option, name: name.to_owned() });
        } else {
            values.push((index, value));
        }
    }
    values
}

fn with_entries<M: Described>(mut state: M::State, given: &[(usize, f64)]) -> M::State {
    let entries = state.as_mut();
    for (index, value) in given {
        entries[*index] = *value;
    }
    state
}
