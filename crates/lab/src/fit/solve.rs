//! Search for the least sum of squares, by Levenberg and Marquardt's method.

use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra_of_lm::{DMatrix, DVector, Dyn, Owned};

use super::sensitivity::jacobian;
use super::task::{Differences, FitTask};

/// Relative change of the sum of squares, and of the parameters, that ends the search.
const TOLERANCE: f64 = 1e-6;
/// Maximum runs of all strokes per parameter.
const PATIENCE: usize = 15;
/// Distances in steps at which a parameter is tried, on both sides, after a search.
const AROUND: [f64; 6] = [1.0, 2.0, 3.0, 5.0, 8.0, 12.0];
/// Difference over its noise where the model fails: worse than any computed one.
const FAILED: f64 = 1e6;
/// Distance in steps from an end of its range at which a parameter starts, so that it can move.
const BESIDE: f64 = 0.1;

/// A parameter and its unbounded search variable: p = low + (high - low)/(1 + exp(-u)), u = u0 +
/// slope x. Near an end of the range it is a logarithm, so a positive value may change by orders.
#[derive(Clone, Copy, Debug)]
struct BoundedVariable {
    low: f64,
    high: f64,
    start: f64,
    /// Change of u per unit of x: x = 1 is a step of its derivative.
    slope: f64,
}

impl BoundedVariable {
    fn new((low, high): (f64, f64), value: f64, step: f64) -> Self {
        let (width, nudge) = (high - low, (BESIDE * step).min(0.25 * (high - low)));
        let value = value.clamp(low + nudge.max(1e-15 * width), high - nudge.max(1e-15 * width));
        let start = ((value - low) / (high - value)).ln();
        Self { low, high, start, slope: step * width / ((value - low) * (high - value)) }
    }

    fn at(self, x: f64) -> (f64, f64) {
        let u = (self.start + self.slope * x).clamp(-600.0, 600.0);
        let part = 1.0 / (1.0 + (-u).exp());
        let width = self.high - self.low;
        // 1 - part would lose digits.
        let other = 1.0 / (1.0 + u.exp());
        let value = (self.low + width * part).clamp(self.low, self.high);
        (value, self.slope * width * part * other)
    }
}

struct FitSearch<'a> {
    task: &'a FitTask<'a>,
    fitted: &'a [usize],
    steps: &'a [f64],
    variables: Vec<BoundedVariable>,
    x: DVector<f64>,
    values: Vec<f64>,
    now: Differences,
}

/// Returns the values of the least sum of squares near `values`, with their differences.
pub(super) fn solve(
    task: &FitTask<'_>,
    fitted: &[usize],
    steps: &[f64],
    (values, now): (Vec<f64>, Differences),
) -> (Vec<f64>, Differences) {
    let variables = fitted.iter().zip(steps);
    let variables =
        variables.map(|(at, step)| BoundedVariable::new(task.range(*at), values[*at], *step));
    let variables = variables.collect::<Vec<_>>();
    let start = (values.clone(), now.clone());
    let x = DVector::zeros(fitted.len());
    let mut search = FitSearch { task, fitted, steps, variables, x, values, now };
    search.set_params(&DVector::zeros(fitted.len()));
    let method = LevenbergMarquardt::new().with_tol(TOLERANCE).with_patience(PATIENCE);
    let (found, _why) = method.minimize(search);
    // Beside an end of a range the start may have been better.
    if found.now.norm_squared() < start.1.norm_squared() {
        (found.values, found.now)
    } else {
        start
    }
}

/// Returns the best values some steps from `values` in one parameter after the other. A let-off
/// that is 0.5 mm off has local minima on the way.
pub(super) fn scan(
    task: &FitTask<'_>,
    fitted: &[usize],
    steps: &[f64],
    (mut values, mut now): (Vec<f64>, Differences),
) -> (Vec<f64>, Differences) {
    for (place, step) in fitted.iter().zip(steps) {
        let (low, high) = task.range(*place);
        let beside = |part: &f64| {
            let mut set = values.clone();
            set[*place] = (values[*place] + part * step).clamp(low, high);
            set
        };
        let sets: Vec<_> = AROUND.iter().flat_map(|it| [beside(it), beside(&-it)]).collect();
        let found = sets.iter().zip(task.differences(&sets));
        let found = found.filter_map(|(set, found)| Some((set.clone(), found?)));
        let best = found.min_by(|a, b| a.1.norm().total_cmp(&b.1.norm()));
        if let Some(best) = best.filter(|best| best.1.norm() < now.norm()) {
            (values, now) = best;
        }
    }
    (values, now)
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for FitSearch<'_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, x: &DVector<f64>) {
        self.x.clone_from(x);
        for ((place, variable), x) in self.fitted.iter().zip(&self.variables).zip(x) {
            self.values[*place] = variable.at(*x).0;
        }
        let found = self.task.differences_of(&self.values);
        self.now = found.unwrap_or_else(|| DVector::repeat(self.task.rows(), FAILED));
    }

    fn params(&self) -> DVector<f64> {
        self.x.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        Some(self.now.clone())
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let mut found = jacobian(self.task, self.fitted, &self.values, (self.steps, 1.0));
        for (column, (variable, x)) in self.variables.iter().zip(&self.x).enumerate() {
            found.column_mut(column).scale_mut(variable.at(*x).1);
        }
        Some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_variable_starts_at_its_parameter_and_never_leaves_the_range() {
        for (range, value, step) in
            [((0.0, 1e9), 0.0112, 1e-4), ((-100.0, 100.0), 2e-3, 1e-4), ((0.0, 1.0), 1.0, 0.01)]
        {
            let variable = BoundedVariable::new(range, value, step);
            let (start, slope) = variable.at(0.0);
            assert!((start - value).abs() <= BESIDE * step * 1.001, "{start} for {value}");
            assert!((slope / step - 1.0).abs() < 1e-6, "{slope} for {step}");
            for x in [-1e9, -30.0, 30.0, 1e9] {
                let value = variable.at(x).0;
                assert!((range.0..=range.1).contains(&value), "{value} of {range:?}");
            }
        }
    }
}
