//! Observed orders: slopes of the errors over the steps.

use serde::Serialize;

use super::{MeasuredScenario, MethodKind, StudyRow};

/// Order of a method on a scenario, beside the order that its authors state.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct ObservedOrder {
    pub method: &'static str,
    pub nominal: u32,
    /// Highest order that the smoothness of the scenario allows.
    pub bound: Option<f64>,
    /// Slope of the error of event times; `None` with fewer than three runs to fit.
    pub events: Option<f64>,
    /// Slope of the error of states.
    pub states: Option<f64>,
}

/// Returns the orders of the methods whose step is the tick.
pub fn observed_orders(measured: &MeasuredScenario) -> Vec<ObservedOrder> {
    /// Largest error of states, over their size, in the range where orders hold.
    const MAX_STATE_ERROR: f64 = 0.1;
    let rows = &measured.rows;
    // An event is not located where it is off by more than a step.
    let event = |row: &StudyRow| row.verdict.event_error.filter(|it| *it < row.setting.tick);
    let state = |row: &StudyRow| row.verdict.state_error.filter(|it| *it < MAX_STATE_ERROR);
    let order = |runs: &[StudyRow]| {
        let method = runs.first().filter(|it| it.method.kind == MethodKind::Fixed)?.method;
        let [events, states] = [fit(runs, rows, &event), fit(runs, rows, &state)];
        let (nominal, bound) = (method.order, measured.plan.order_bound);
        Some(ObservedOrder { method: method.name, nominal, bound, events, states })
    };
    rows.chunk_by(|a, b| a.method == b.method).filter_map(order).collect()
}

/// Returns the slope of the logarithm of the errors of `runs` over that of the tick; errors near the
/// smallest of `all` are rounding.
fn fit(
    runs: &[StudyRow],
    all: &[StudyRow],
    error: &dyn Fn(&StudyRow) -> Option<f64>,
) -> Option<f64> {
    const ABOVE_ROUNDING: f64 = 30.0;
    const FEWEST: usize = 3;
    let floor = ABOVE_ROUNDING * all.iter().filter_map(error).fold(f64::INFINITY, f64::min);
    let point = |run: &StudyRow| Some((run.setting.tick.ln(), error(run)?));
    let points = runs.iter().filter_map(point).filter(|(_, error)| *error > floor);
    let points: Vec<_> = points.map(|(tick, error)| (tick, error.ln())).collect();
    (points.len() >= FEWEST).then(|| slope(&points))
}

/// Returns the slope of the line of least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), it| (x + it.0 / n, y + it.1 / n));
    let sum = |of: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>();
    sum(&|it| (it.0 - x) * (it.1 - y)) / sum(&|it| (it.0 - x).powi(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let points = [1e-3_f64, 5e-4, 1e-4].map(|h| (h.ln(), (7.0 * h.powf(2.5)).ln()));
        assert!((slope(&points) - 2.5).abs() < 1e-12);
    }
}
