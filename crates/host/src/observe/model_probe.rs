//! What a model gives to look at: its names, and its signals at any moment.
//!
//! Off the tick: a snapshot has mode, state and input; guards and outputs follow from them.

use models::Playable;
use models::catalogue::{self, Visitor};
use models::draw::{Body, Coil, Ends, Follow, Material, Sketch};
use pode::Motion;
use scheduler::observation::{MAX_STATES, ModelSnapshot};
use telemetry::{Drawing, Follower, Outline, Signal, outline, signal};

use super::short;

/// A model with values, seen from outside.
pub trait ModelProbe: Send {
    /// Appends the signals in the order of [`signals`]: states, guards, outputs. A guard that is
    /// not watched in the present mode is not a number.
    fn see(&self, look: &ModelSnapshot, signals: &mut Vec<f32>);

    /// The name of a guard that fired in `mode`; none if it is not watched there.
    fn guard(&self, mode: u8, guard: u8) -> Option<&'static str>;

    /// How it is drawn.
    fn drawing(&self) -> Drawing;
}

/// An probe for the model called `name` with one value per parameter.
pub fn probe(name: &str, values: &[f64]) -> Option<Box<dyn ModelProbe>> {
    catalogue::visit(name, Opened(values))
}

/// Names of what an probe for the model called `name` sees, in its order.
pub fn signals(name: &str) -> Vec<Signal> {
    catalogue::visit(name, Named).unwrap_or_default()
}

/// Names of the modes of the model called `name`.
pub fn modes(name: &str) -> Vec<String> {
    catalogue::visit(name, Modes).unwrap_or_default()
}

struct Opened<'a>(&'a [f64]);

impl Visitor for Opened<'_> {
    type Output = Box<dyn ModelProbe>;

    fn visit<M: Playable>(self) -> Self::Output {
        const {
            assert!(M::STATES.len() <= MAX_STATES, "raise MAX_STATES of scheduler");
            assert!(M::OUTPUTS.len() <= MOST_OUTPUTS, "raise MOST_OUTPUTS");
        }
        let model = M::with_values(self.0);
        // Only its shape counts; to find a rest may cost more than all signals of a row.
        let (_mode, shape) = model.at_rest(&Motion::default());
        Box::new(ProbedModel { model, shape, guards: guards::<M>() })
    }
}

struct Named;

impl Visitor for Named {
    type Output = Vec<Signal>;

    fn visit<M: Playable>(self) -> Self::Output {
        let of = |name: &str, unit: &str, kind: signal::Kind| Signal {
            name: name.to_owned(),
            unit: unit.to_owned(),
            kind: kind.into(),
            modes: Vec::new(),
        };
        let states = M::STATES.iter().zip(M::STATE_UNITS);
        let states = states.map(|(name, unit)| of(name, unit, signal::Kind::State));
        let watched = guards::<M>();
        let guards = watched.iter().map(|guard| Signal {
            modes: guard.modes.iter().map(|mode| u32::from(*mode)).collect(),
            ..of(guard.name, "", signal::Kind::Guard)
        });
        let outputs = M::OUTPUTS.iter().zip(M::OUTPUT_UNITS);
        let outputs = outputs.map(|(name, unit)| of(name, unit, signal::Kind::Output));
        states.chain(guards).chain(outputs).collect()
    }
}

struct Modes;

impl Visitor for Modes {
    type Output = Vec<String>;

    fn visit<M: Playable>(self) -> Self::Output {
        M::MODES.iter().map(|(_mode, name)| (*name).to_owned()).collect()
    }
}

/// A guard, and the modes in which it is watched.
struct WatchedGuard {
    id: pode::GuardId,
    name: &'static str,
    modes: Vec<u8>,
}

/// Every guard of a model, in the order in which its modes name them.
fn guards<M: Playable>() -> Vec<WatchedGuard> {
    let model = M::with_values(&[]);
    let mut all: Vec<WatchedGuard> = Vec::new();
    for (number, (mode, _name)) in (0..).zip(M::MODES) {
        for spec in model.guards(*mode) {
            match all.iter_mut().find(|guard| guard.id == spec.id) {
                Some(guard) => guard.modes.push(number),
                None => {
                    all.push(WatchedGuard { id: spec.id, name: spec.name, modes: vec![number] });
                }
            }
        }
    }
    all
}

struct ProbedModel<M: Playable> {
    model: M,
    /// A state to write others into.
    shape: M::State,
    guards: Vec<WatchedGuard>,
}

impl<M: Playable> ProbedModel<M> {
    fn mode(look: &ModelSnapshot) -> Option<M::Mode> {
        M::MODES.get(usize::from(look.mode)).map(|(mode, _name)| *mode)
    }
}

/// Most outputs that a model has.
const MOST_OUTPUTS: usize = 16;

impl<M: Playable> ModelProbe for ProbedModel<M> {
    fn see(&self, look: &ModelSnapshot, signals: &mut Vec<f32>) {
        let wanted = signals.len() + M::STATES.len() + self.guards.len() + M::OUTPUTS.len();
        signals.extend(look.state.iter().take(M::STATES.len()).map(|value| short(*value)));
        let Some(mode) = Self::mode(look) else {
            return signals.resize(wanted, f32::NAN);
        };
        let [position, rate, acceleration, jerk] = look.input;
        let input = Motion { position, rate, acceleration, jerk };
        let mut state = self.shape;
        for (entry, shown) in state.as_mut().iter_mut().zip(look.state) {
            *entry = shown;
        }
        for guard in &self.guards {
            let is_watched = guard.modes.contains(&look.mode);
            let value = || self.model.guard(mode, guard.id, &state, &input).value;
            signals.push(if is_watched { short(value()) } else { f32::NAN });
        }
        let mut outputs = [0.0; MOST_OUTPUTS];
        self.model.outputs(mode, &state, &input, &mut outputs);
        signals.extend(outputs.iter().take(M::OUTPUTS.len()).map(|value| short(*value)));
        signals.resize(wanted, f32::NAN);
    }

    fn guard(&self, mode: u8, guard: u8) -> Option<&'static str> {
        let is_it = |it: &&WatchedGuard| it.id.0 == guard && it.modes.contains(&mode);
        self.guards.iter().find(is_it).map(|it| it.name)
    }

    fn drawing(&self) -> Drawing {
        let mut drawn = Drawn::default();
        self.model.draw(&mut drawn);
        drawn.0
    }
}

/// A drawing as a message.
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
    use super::*;

    #[test]
    fn every_model_gives_as_many_signals_as_it_names() {
        for entry in catalogue::ENTRIES {
            let probe = probe(entry.name, &[]).expect("an probe");
            let mut signals = Vec::new();
            for mode in 0..modes(entry.name).len() {
                let mode = u8::try_from(mode).expect("few modes");
                probe.see(&ModelSnapshot { mode, ..ModelSnapshot::default() }, &mut signals);
                probe.see(&ModelSnapshot { mode: 255, ..ModelSnapshot::default() }, &mut signals);
            }
            let names = super::signals(entry.name).len();
            assert_eq!(signals.len(), 2 * names * modes(entry.name).len(), "{}", entry.name);
        }
    }

    #[test]
    fn a_guard_is_seen_where_it_is_watched() {
        let name = "key-hammer-springs";
        let probe = probe(name, &[]).expect("an probe");
        let signals = signals(name);
        for mode in 0..2_u8 {
            let mut seen = Vec::new();
            probe.see(&ModelSnapshot { mode, ..ModelSnapshot::default() }, &mut seen);
            for (signal, value) in signals.iter().zip(seen) {
                let is_watched = signal.modes.is_empty() || signal.modes.contains(&mode.into());
                assert_eq!(value.is_finite(), is_watched, "{} in mode {mode}", signal.name);
            }
        }
    }
}
