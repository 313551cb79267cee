//! Moments of a stroke: the mode and all signals that a drawing may follow.

use instruments::draw::Follow;
use instruments::{Described, Playable};
use pode::stepper::Rk4;
use pode::{Event, Limits, Motion, Simulator, Watch};

use crate::stroke::{presses, still};

#[derive(Clone, Debug)]
pub struct Moment {
    pub mode: usize,
    pub signals: Vec<(&'static str, f64)>,
}

impl Moment {
    pub fn of<M: Playable>(model: &M, (mode, state): (M::Mode, M::State), input: &Motion) -> Self {
        let entry = model.entry();
        let mut outputs = vec![0.0; entry.outputs.len()];
        model.outputs(mode, &state, input, &mut outputs);
        let mut state = state;
        let states = entry.states.iter().copied().zip(state.as_mut().iter().copied());
        let outputs = entry.outputs.iter().copied().zip(outputs);
        let position = input.position / model.input_per_metre();
        Self {
            mode: model.modes().position(|it| it.0 == mode).expect("a listed mode"),
            signals: states.chain(outputs).chain([("position", position)]).collect(),
        }
    }

    /// Returns the moment at rest with the key's front `down` (m).
    pub fn at_rest<M: Playable>(model: &M, down: f64) -> Self {
        let input = still(down * model.input_per_metre());
        Self::of(model, model.at_rest(&input), &input)
    }

    /// Like [`Self::at_rest`], but in a given mode and with given entries of the state.
    #[track_caller]
    pub fn posed<M: Playable>(model: &M, mode: usize, down: f64, entries: &[(&str, f64)]) -> Self {
        let input = still(down * model.input_per_metre());
        let (_, mut state) = model.at_rest(&input);
        for (name, value) in entries {
            let index = model.entry().states.iter().position(|it| it == name);
            state.as_mut()[index.expect("an entry of the state")] = *value;
        }
        let mode = model.modes().nth(mode).expect("a listed mode").0;
        Self::of(model, (mode, state), &input)
    }

    #[track_caller]
    pub fn signal(&self, name: &str) -> f64 {
        self.signals.iter().find(|it| it.0 == name).expect("a signal").1
    }

    #[track_caller]
    pub fn follow(&self, follow: &Follow) -> f64 {
        follow.offset + follow.signal.map_or(0.0, |name| follow.scale * self.signal(name))
    }
}

/// Returns the key's front at `t` (s), in the unit of the model's input: down by 10 mm in some
/// 60 ms from 0.1 s, up again from 0.3 s.
pub fn stroke<M: Playable>(model: &M, t: f64) -> Motion {
    let down = presses(&[[0.01, 0.1, 0.015], [-0.01, 0.35, 0.02]], t);
    let k = model.input_per_metre();
    Motion {
        position: k * down.position,
        rate: k * down.rate,
        acceleration: k * down.acceleration,
        jerk: k * down.jerk,
    }
}

struct Film<M: Described> {
    model: M,
    moments: Vec<(String, Moment)>,
}

impl<M: Playable> Watch<M> for Film<M> {
    fn event(&mut self, _model: &M, event: &Event<'_, M>) {
        let moment = Moment::of(&self.model, event.before, &event.input);
        self.moments.push((event.cause.name().to_owned(), moment));
    }
}

/// Returns the stroke's moments with the names of their events; ends of ticks have none.
pub fn film<M: Playable>(model: &M) -> Vec<(String, Moment)> {
    const H: f64 = 1e-3;
    let (mode, state) = model.at_rest(&stroke(model, 0.0));
    let mut simulator = Simulator::new(model.clone(), Rk4, Limits::default(), mode, state);
    let mut film = Film { model: model.clone(), moments: vec![] };
    for tick in (0_u32..700).map(f64::from) {
        simulator.advance(H, &|theta: f64| stroke(model, (tick + theta) * H), &mut film);
        let end = stroke(model, (tick + 1.0) * H);
        let moment = Moment::of(model, (simulator.mode(), *simulator.state()), &end);
        film.moments.push((String::new(), moment));
    }
    film.moments
}
