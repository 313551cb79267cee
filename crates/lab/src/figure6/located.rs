use instruments::SmallModel;
use pode::{EnergyAudit, Limits, Motion, RunRecorder, Simulator, stepper::Rk4};

use super::model_run::{ModelRun, RunEvent, mode_name, row};

/// Runs the model from rest over `ticks` of `step` (s) with RK4; `input` returns the angle's
/// motion at a fraction of a tick, 0 ..= 1.
pub(super) fn located(
    model: &SmallModel,
    (step, ticks): (f64, usize),
    input: impl Fn(usize, f64) -> Motion,
) -> ModelRun {
    let (mode, state) = model.at_rest(&Motion::default());
    let mut simulator = Simulator::new(model.clone(), Rk4, Limits::default(), mode, state);
    let mut watch = (RunRecorder::new(step), EnergyAudit::default());
    let mut run = ModelRun::new(model, (mode, state), input(0, 0.0).position);
    for tick in 0..ticks {
        let _tick = simulator.advance(step, &|theta: f64| input(tick, theta), &mut watch);
        let (t, s) = ((tick + 1) as f64 * step, input(tick, 1.0).position);
        run.rows.push(row(model, t, (simulator.mode(), simulator.state()), s));
        // Contacts and string are elastic: no input supplies an event's change of energy.
        run.made = run.made.max((watch.1.residual() + watch.1.jumps).abs());
    }
    let name = |mode| mode_name(model, mode);
    let events = watch.0.events().iter();
    run.events = events
        .map(|it| RunEvent { t: it.t, guard: it.name, from: name(it.from), to: name(it.to) })
        .collect();
    run
}
