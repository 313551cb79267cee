//! The paper's step: input sampled once and held, RK4, guards checked once, at the step's end.
//! `[GC93]` §3.1, §6

use instruments::SmallModel;
use pode::stepper::{Given, Rk4};
use pode::{Dense as _, Energetic as _, Fires, GuardSpec, Guarded as _, Model as _};
use pode::{Resets as _, Stepper as _};

use super::model_run::{Mode, ModelRun, ModelState, RunEvent, mode_name, row, still};

/// A model that is stepped as in the paper.
#[derive(Clone, Debug)]
pub(super) struct SampledModel<'a> {
    model: &'a SmallModel,
    /// Length of a step (s).
    step: f64,
    mode: Mode,
    state: ModelState,
    /// Energy that no input supplied (J).
    made: f64,
    run: ModelRun,
}

impl<'a> SampledModel<'a> {
    /// Returns the model at rest under s = 0, for steps of `step` (s).
    pub(super) fn new(model: &'a SmallModel, step: f64) -> Self {
        let (mode, state) = model.at_rest(&still(0.0));
        let run = ModelRun::new(model, (mode, state), 0.0);
        Self { model, step, mode, state, made: 0.0, run }
    }

    /// Advances by a step under the sampled angle `s` (rad); returns the force at its end (N), up.
    pub(super) fn advance(&mut self, s: f64) -> f64 {
        let (input, before) = (still(s), (self.mode, self.state));
        // The input's jump is work of the hand; everything else conserves the energy.
        let energy = self.model.energy(self.mode, &self.state, &input);
        let mut field = Given {
            coords: self.model.coordinates(),
            nature: self.model.nature(self.mode),
            f: |_tau, x: &ModelState| self.model.derivative(before.0, x, &input),
        };
        self.state = *Rk4.step(&mut field, &before.1, &mut (), self.step).dense.end();
        let t = self.run.rows.len() as f64 * self.step;
        if let Some(guard) = self.broken(&before.1, s) {
            self.switch(guard, t, s);
        }
        self.made += self.model.energy(self.mode, &self.state, &input) - energy;
        self.run.made = self.run.made.max(self.made.abs());
        let row = row(self.model, t, (self.mode, &self.state), s);
        self.run.rows.push(row);
        self.force()
    }

    /// Returns the present force on the hand (N), up positive.
    pub(super) fn force(&self) -> f64 {
        self.run.rows.last().map_or(0.0, |row| row.f_ku)
    }

    pub(super) fn finish(self) -> ModelRun {
        self.run
    }

    fn broken(&self, before: &ModelState, s: f64) -> Option<GuardSpec> {
        let value = |spec: &GuardSpec, x| self.model.guard(self.mode, spec.id, x, &still(s)).value;
        let is_broken = |spec: &&GuardSpec| {
            let crossed = spec.fires == Fires::WhileNegative || value(spec, before) > 0.0;
            crossed && value(spec, &self.state) < 0.0
        };
        let guards = self.model.guards(self.mode).iter();
        guards.filter(is_broken).min_by_key(|spec| spec.priority).copied()
    }

    /// Continues in the mode and with the speeds of the reset map of `guard`, from `t` (s) on. The
    /// angles do not change: at the string the paper reversed only the sign of a speed, though the
    /// hammer was already beyond it. `[GC93]` §5.1
    fn switch(&mut self, guard: GuardSpec, t: f64, s: f64) {
        let reset = self.model.reset(self.mode, guard.id, &self.state, &still(s));
        let [from, to] = [self.mode, reset.mode].map(|mode| mode_name(self.model, mode));
        self.run.events.push(RunEvent { t, guard: guard.name, from, to });
        let ([hammer, key, ..], [.., u_hammer, u_key]) = (self.state, reset.state);
        (self.mode, self.state) = (reset.mode, [hammer, key, u_hammer, u_key]);
    }
}
