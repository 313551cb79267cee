//! Change of the forces with a parameter.

use nalgebra_of_lm::DMatrix;

use super::task::{Differences, FitTask};

/// Wanted RMS change of the forces by a step, over the present differences or the noise.
const WANTED: f64 = 0.5;
/// Shortest and longest step of a parameter, as fractions of its value.
const PARTS: (f64, f64) = (1e-5, 0.05);
/// Longest step of a parameter that is zero, as a fraction of its range.
const LONGEST: f64 = 0.05;

fn apart(a: &Differences, b: &Differences) -> f64 {
    (a - b).norm() / (a.len() as f64).sqrt()
}

/// Returns a step of each parameter in `fitted` (its unit) that moves the forces by about half of
/// the differences `now` or of the noise: far above rounding, and wide enough for jumps over a row.
pub(super) fn steps(
    task: &FitTask<'_>,
    fitted: &[usize],
    values: &[f64],
    now: &Differences,
) -> Vec<f64> {
    fitted.iter().map(|place| step(task, *place, values, now)).collect()
}

fn step(task: &FitTask<'_>, place: usize, values: &[f64], now: &Differences) -> f64 {
    let (low, high) = task.range(place);
    let value = values[place];
    let wanted = WANTED * (now.norm() / (now.len() as f64).sqrt()).max(1.0);
    let change = |h: f64| {
        let mut values = values.to_vec();
        values[place] = if value + h <= high { value + h } else { value - h };
        task.differences_of(&values).map_or(f64::INFINITY, |it| apart(&it, now))
    };
    let (least, most, mut h) = if value == 0.0 {
        // Its size is unknown: start with 1e-13 of the range.
        let mut h = 1e-13 * (high - low);
        while h < LONGEST * (high - low) && change(h) < 0.3 * wanted {
            h *= 10.0;
        }
        (0.1 * h, h, h)
    } else {
        (PARTS.0 * value.abs(), PARTS.1 * value.abs(), 1e-3 * value.abs())
    };
    for _ in 0..3 {
        let change = change(h);
        // Approach a failing model slowly.
        let factor = if change.is_finite() { wanted / change.max(1e-9) } else { 0.1 };
        h = (h * factor).clamp(least, most);
        if (0.5..=2.0).contains(&factor) {
            break;
        }
    }
    h.min(0.25 * (high - low))
}

/// Returns central differences of the forces over their noise by the parameters in `fitted`, with
/// steps of `part` of `steps`; one-sided or zero at an end of a range and where the model fails.
pub(super) fn jacobian(
    task: &FitTask<'_>,
    fitted: &[usize],
    values: &[f64],
    (steps, part): (&[f64], f64),
) -> DMatrix<f64> {
    let mut sets = vec![values.to_vec()];
    for (place, step) in fitted.iter().zip(steps) {
        let (low, high) = task.range(*place);
        for side in [-part, part] {
            let mut set = values.to_vec();
            set[*place] = (values[*place] + side * step).clamp(low, high);
            sets.push(set);
        }
    }
    let found = task.differences(&sets);
    let mut jacobian = DMatrix::zeros(task.rows(), fitted.len());
    for (column, place) in fitted.iter().enumerate() {
        let sides = [2 * column + 1, 2 * column + 2];
        let [below, above] = sides.map(|side| if found[side].is_some() { side } else { 0 });
        let width = sets[above][*place] - sets[below][*place];
        if let (Some(a), Some(b), true) = (&found[below], &found[above], width > 0.0) {
            jacobian.set_column(column, &((b - a) / width));
        }
    }
    jacobian
}
