//! Observation of a model: its names, and its signals in any state.
//!
//! Off the tick: a snapshot has mode, state and input; guards and outputs follow from them.

use instruments::draw::{Body, Coil, Ends, Follow, Material, Sketch};
use instruments::{LoadedModel, ModeCode, ModelEntry, Playable, Visitor};
use pode::Motion;
use scheduler::observation::ModelSnapshot;
use telemetry::{Drawing, Follower, Outline, Signal, outline, signal};

use super::short;

/// Outside view of a model with values.
pub trait ModelProbe: Send {
    /// Appends the signals in the order of [`signals`]; a guard not watched in the mode is NaN.
    fn see(&self, look: &ModelSnapshot, signals: &mut Vec<f32>);

    /// Returns the name of a guard that fired in `mode`; `None` if it is not watched there.
    fn guard(&self, mode: u8, guard: u8) -> Option<&'static str>;

    fn drawing(&self) -> Drawing;
}

/// Returns a probe for `model` with one value per parameter.
pub fn probe(model: &LoadedModel, values: &[f64]) -> Box<dyn ModelProbe> {
    model.visit(Opened(values))
}

/// Returns the names of the signals for the model of `entry`, in the order of a probe.
pub fn signals(entry: &ModelEntry) -> Vec<Signal> {
    let of = |name: &str, unit: &str, kind: signal::Kind| Signal {
        name: name.to_owned(),
        unit: unit.to_owned(),
        kind: kind.into(),
        modes: Vec::new(),
    };
    let states = entry.states.iter().zip(&entry.state_units);
    let states = states.map(|(name, unit)| of(name, unit, signal::Kind::State));
    let guards = guards(entry).into_iter().map(|guard| Signal {
        modes: guard.modes.iter().map(|mode| u32::from(*mode)).collect(),
        ..of(guard.name, "", signal::Kind::Guard)
    });
    let outputs = entry.outputs.iter().zip(&entry.output_units);
    let outputs = outputs.map(|(name, unit)| of(name, unit, signal::Kind::Output));
    states.chain(guards).chain(outputs).collect()
}

pub fn modes(entry: &ModelEntry) -> Vec<String> {
    entry.modes.iter().map(|mode| mode.name.to_owned()).collect()
}

struct Opened<'a>(&'a [f64]);

impl Visitor for Opened<'_> {
    type Output = Box<dyn ModelProbe>;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let model = model.with_values(self.0);
        // Only its shape counts; to find a rest may cost more than all signals of a row.
        let (_mode, shape) = model.at_rest(&Motion::default());
        let guards = guards(model.entry());
        Box::new(ProbedModel { model, shape, guards })
    }
}

#[derive(Debug)]
struct WatchedGuard {
    name: &'static str,
    modes: Vec<u8>,
}

fn guards(entry: &ModelEntry) -> Vec<WatchedGuard> {
    let mut all: Vec<WatchedGuard> = Vec::new();
    for (number, mode) in (0..).zip(&entry.modes) {
        for guard in &mode.guards {
            match all.iter_mut().find(|known| known.name == guard.name) {
                Some(known) => known.modes.push(number),
                None => all.push(WatchedGuard { name: guard.name, modes: vec![number] }),
            }
        }
    }
    all
}

/// Maximum number of shown outputs; more are NaN.
const MOST_OUTPUTS: usize = 128;

struct ProbedModel<M: Playable> {
    model: M,
    shape: M::State,
    guards: Vec<WatchedGuard>,
}

impl<M: Playable> ProbedModel<M> {
    /// Returns the value of the guard `name`, where it is watched.
    fn watched(&self, name: &str, mode: M::Mode, state: &M::State, input: &Motion) -> Option<f64> {
        let spec = self.model.guards(mode).iter().find(|spec| spec.name == name)?;
        let is_watched = self.model.is_watched(mode, spec.id);
        is_watched.then(|| self.model.guard(mode, spec.id, state, input).value)
    }
}

impl<M: Playable> ModelProbe for ProbedModel<M> {
    fn see(&self, look: &ModelSnapshot, signals: &mut Vec<f32>) {
        let ModelEntry { states, outputs, .. } = self.model.entry();
        let (states, n_outputs) = (states.len(), outputs.len());
        let wanted = signals.len() + states + self.guards.len() + n_outputs;
        signals.extend(look.state.iter().take(states).map(|value| short(*value)));
        let Some(mode) = self.model.mode(ModeCode(look.mode)) else {
            return signals.resize(wanted, f32::NAN);
        };
        let [position, rate, acceleration, jerk] = look.input;
        let input = Motion { position, rate, acceleration, jerk };
        let mut state = self.shape;
        for (entry, shown) in state.as_mut().iter_mut().zip(look.state) {
            *entry = shown;
        }
        for guard in &self.guards {
            let value = self.watched(guard.name, mode, &state, &input);
            signals.push(value.map_or(f32::NAN, short));
        }
        let mut outputs = [0.0; MOST_OUTPUTS];
        self.model.outputs(mode, &state, &input, &mut outputs);
        signals.extend(outputs.iter().take(n_outputs).map(|value| short(*value)));
        signals.resize(wanted, f32::NAN);
    }

    fn guard(&self, mode: u8, guard: u8) -> Option<&'static str> {
        let mode = self.model.mode(ModeCode::structural(mode))?;
        self.model.guards(mode).iter().find(|it| it.id.0 == guard).map(|it| it.name)
    }

    fn drawing(&self) -> Drawing {
        let mut drawn = Drawn::default();
        self.model.draw(&mut drawn);
        drawn.0
    }
}

#[derive(Default)]
struct Drawn(Drawing);

fn follower(follow: Follow) -> Follower {
    Follower {
        offset: follow.offset,
        scale: follow.scale,
        signal: follow.signal.unwrap_or_default().to_owned(),
    }
}

fn numbers(modes: &[u8]) -> Vec<u32> {
    modes.iter().map(|mode| u32::from(*mode)).collect()
}

impl Sketch for Drawn {
    fn view(&mut self, [left, bottom, right, top]: [f64; 4]) {
        let it = &mut self.0;
        (it.left, it.bottom, it.right, it.top) = (left, bottom, right, top);
    }

    fn body(&mut self, body: Body<'_>) {
        self.0.bodies.push(telemetry::Body {
            name: body.name.to_owned(),
            x: Some(follower(body.x)),
            y: Some(follower(body.y)),
            angle: Some(follower(body.angle)),
            outlines: Vec::new(),
            modes: numbers(body.modes),
        });
    }

    fn outline(&mut self, material: Material, points: &[[f64; 2]], ends: Ends) {
        let Some(body) = self.0.bodies.last_mut() else { return };
        let kind = match material {
            Material::Wood => outline::Kind::Wood,
            Material::Felt => outline::Kind::Felt,
            Material::Metal => outline::Kind::Metal,
            Material::String => outline::Kind::String,
            Material::Ground => outline::Kind::Ground,
            Material::Finger => outline::Kind::Finger,
        };
        body.outlines.push(Outline {
            kind: kind.into(),
            x: points.iter().map(|point| point[0]).collect(),
            y: points.iter().map(|point| point[1]).collect(),
            closed: ends == Ends::Closed,
        });
    }

    fn coil(&mut self, coil: Coil<'_>) {
        let ((from, [from_x, from_y]), (to, [to_x, to_y])) = (coil.from, coil.to);
        self.0.coils.push(telemetry::Coil {
            name: coil.name.to_owned(),
            from,
            from_x,
            from_y,
            to,
            to_x,
            to_y,
            modes: numbers(coil.modes),
        });
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn every_model_gives_as_many_signals_as_it_names() {
        for name in mechanism::model_names() {
            let model = scene::Library::default().find(name, Path::new("")).expect("a model");
            let (entry, probe): (&ModelEntry, _) = (&model, probe(&model, &[]));
            let mut signals = Vec::new();
            for mode in 0..modes(entry).len() {
                let mode = mode as u64;
                probe.see(&ModelSnapshot { mode, ..ModelSnapshot::default() }, &mut signals);
                probe.see(&ModelSnapshot { mode: 255, ..ModelSnapshot::default() }, &mut signals);
            }
            let names = super::signals(entry).len();
            assert_eq!(signals.len(), 2 * names * modes(entry).len(), "{}", entry.name);
        }
    }

    #[test]
    fn a_guard_is_seen_where_it_is_watched() {
        let model = scene::Library::default().find("key-hammer-springs", Path::new(""));
        let model = model.expect("a model");
        let (probe, signals) = (probe(&model, &[]), signals(&model));
        for mode in 0..2_u32 {
            let mut seen = Vec::new();
            probe.see(&ModelSnapshot { mode: mode.into(), ..ModelSnapshot::default() }, &mut seen);
            for (signal, value) in signals.iter().zip(seen) {
                let is_watched = signal.modes.is_empty() || signal.modes.contains(&mode);
                assert_eq!(value.is_finite(), is_watched, "{} in mode {mode}", signal.name);
            }
        }
    }
}
