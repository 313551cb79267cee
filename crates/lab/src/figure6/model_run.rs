//! What a run of the model leaves behind: a row at the end of each step, and its events.

use instruments::Described as _;
use instruments::SmallModel;
use pode::{Energetic as _, Model, Motion};

/// The model's mode.
pub(super) type Mode = <SmallModel as Model>::Mode;
/// The model's state: θh, θk (rad), θh', θk' (rad/s).
pub(super) type ModelState = <SmallModel as Model>::State;

/// The model at the end of a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RunRow {
    /// Model time (s).
    pub t: f64,
    /// Name of the mode that holds from then on.
    pub mode: &'static str,
    /// Angle of the manipulandum, as the model was given it (rad).
    pub s: f64,
    /// Angle of the key (rad).
    pub key: f64,
    /// Angle of the hammer (rad).
    pub hammer: f64,
    /// Force of the key on the hand, at the finger's lever, up positive (N).
    pub f_ku: f64,
    /// Force of the key on the hammer (N); 0 apart.
    pub f_kh: f64,
    /// Gap between hammer and key (m); below 0 together.
    pub gap: f64,
    /// Stored energy (J).
    pub energy: f64,
}

/// An event of a run.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RunEvent {
    /// Model time at which it was acted upon (s).
    pub t: f64,
    /// Name of the guard.
    pub guard: &'static str,
    /// Names of the modes before and after.
    pub from: &'static str,
    pub to: &'static str,
}

/// A run of the model, from rest.
#[derive(Clone, PartialEq, Debug)]
pub struct ModelRun {
    /// The start, and the end of each step.
    pub rows: Vec<RunRow>,
    pub events: Vec<RunEvent>,
    /// Largest amount of energy that nobody had put in, or that was lost, up to the end of any
    /// step (J).
    pub made: f64,
}

impl ModelRun {
    /// A run that has only begun, in `mode` and `state` under `input`.
    pub(super) fn new(model: &SmallModel, (mode, state): (Mode, ModelState), s: f64) -> Self {
        let rows = vec![row(model, 0.0, (mode, &state), s)];
        Self { rows, events: Vec::new(), made: 0.0 }
    }

    /// Model time of its end (s).
    pub fn end(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row.t)
    }
}

/// The row at `t` (s) of a model in `mode` and `state` under the angle `s` (rad).
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

/// Outputs of the model: `F_KH`, `T_KU`, gap, q4, q3.
const OUTPUTS: usize = 5;

/// The angle `s` (rad), held.
pub(super) fn still(s: f64) -> Motion {
    Motion { position: s, ..Motion::default() }
}

/// What people call `mode`.
pub(super) fn mode_name(model: &SmallModel, mode: Mode) -> &'static str {
    model.modes().find(|(known, _)| *known == mode).map_or("", |(_, name)| name)
}
