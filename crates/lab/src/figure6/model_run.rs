//! Record of a model's run: a row at the end of each step, and its events.

use instruments::{NamedModes as _, SmallModel};
use pode::{Energetic as _, Model, Motion};

pub(super) type Mode = <SmallModel as Model>::Mode;
/// State of the model: θh, θk (rad), θh', θk' (rad/s).
pub(super) type ModelState = <SmallModel as Model>::State;

/// State of the model at the end of a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RunRow {
    /// Model time (s).
    pub t: f64,
    pub mode: &'static str,
    /// Input angle of the manipulandum (rad).
    pub s: f64,
    /// Angle of the key (rad).
    pub key: f64,
    /// Angle of the hammer (rad).
    pub hammer: f64,
    /// Force of the key on the hand, at the finger's lever, up positive (N).
    pub f_ku: f64,
    /// Force of the key on the hammer (N); 0 if apart.
    pub f_kh: f64,
    /// Gap between hammer and key (m); below 0 in contact.
    pub gap: f64,
    /// Stored energy (J).
    pub energy: f64,
}

/// An event of a run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RunEvent {
    /// Model time at which the step acted on it (s).
    pub t: f64,
    pub guard: &'static str,
    pub from: &'static str,
    pub to: &'static str,
}

/// A run of the model, from rest.
#[derive(Clone, PartialEq, Debug)]
pub struct ModelRun {
    pub rows: Vec<RunRow>,
    pub events: Vec<RunEvent>,
    /// Largest energy generated or lost without work of the hand, up to the end of any step (J).
    pub made: f64,
}

impl ModelRun {
    pub(super) fn new(model: &SmallModel, (mode, state): (Mode, ModelState), s: f64) -> Self {
        let rows = vec![row(model, 0.0, (mode, &state), s)];
        Self { rows, events: Vec::new(), made: 0.0 }
    }

    /// Returns the model time of the end (s).
    pub fn end(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row.t)
    }
}

/// Returns the row at `t` (s) under the angle `s` (rad).
pub(super) fn row(
    model: &SmallModel,
    t: f64,
    (mode, state): (Mode, &ModelState),
    s: f64,
) -> RunRow {
    let input = still(s);
    let mut outputs = [0.0; OUTPUTS];
    model.outputs(mode, state, &input, &mut outputs);
    let [f_kh, torque, gap, ..] = outputs;
    let [hammer, key, ..] = *state;
    RunRow {
        t,
        mode: mode_name(model, mode),
        s,
        key,
        hammer,
        f_ku: torque * model.input_per_metre(),
        f_kh,
        gap,
        energy: model.energy(mode, state, &input),
    }
}

/// Number of outputs: `F_KH`, `T_KU`, gap, q4, q3.
const OUTPUTS: usize = 5;

/// Returns the constant angle `s` (rad).
pub(super) fn still(s: f64) -> Motion {
    Motion { position: s, ..Motion::default() }
}

pub(super) fn mode_name(model: &SmallModel, mode: Mode) -> &'static str {
    model.modes().find(|(known, _)| *known == mode).map_or("", |(_, name)| name)
}
