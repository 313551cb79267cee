//! Runs a fit, and writes its remarks.

use instruments::Parameter;
use serde::Serialize;

use super::certainty::{FitCertainty, RemainingSpread};
use super::data::StrokeRow;
use super::sensitivity::{jacobian, steps};
use super::solve::{scan, solve};
use super::task::{Differences, FitSubject, FitTask};

/// Maximum searches; each computes steps at its start and scans around its end.
const ROUNDS: usize = 6;
/// A search that reduces the sum of squares by less than this fraction is the last.
const WORTH: f64 = 1e-3;
/// Change of a force, over its noise, below which a parameter has no effect.
const UNFELT: f64 = 1e-2;
/// Relative difference of two derivative estimates that triggers a warning.
const UNSURE: f64 = 0.3;
/// Remaining differences, over the noise, that trigger a warning.
const POOR: f64 = 2.0;
/// Correlation that triggers a warning.
const CORRELATED: f64 = 0.95;

/// Result for one parameter.
#[derive(Clone, Debug, Serialize)]
pub struct FittedParameter {
    pub name: &'static str,
    pub title: Box<str>,
    /// SI unit; `"1"` for a ratio.
    pub unit: &'static str,
    /// Value before (its unit).
    pub before: f64,
    /// Value after; unchanged if the data do not determine it.
    pub value: f64,
    /// 95 % interval within the parameter's range; `None` if the data do not determine it.
    pub interval: Option<(f64, f64)>,
    /// Relative difference of the derivatives over a step and over half of it.
    pub derivative_error: Option<f64>,
}

/// Result for one stroke.
#[derive(Clone, Debug, Serialize)]
pub struct FittedStroke {
    pub name: String,
    pub rows: usize,
    /// Median noise of the force (N).
    pub noise: f64,
    /// Root mean square of the difference before, and after (N).
    pub before: f64,
    pub after: f64,
    #[serde(skip)]
    pub(super) measured: Vec<StrokeRow>,
    /// Forces with the fitted values (N).
    #[serde(skip)]
    pub(super) forces: Vec<f64>,
}

/// Result of a fit.
#[derive(Clone, Debug, Serialize)]
pub struct FitOutcome {
    pub instrument: String,
    pub parameters: Vec<FittedParameter>,
    /// Correlation of each determined parameter with each, in their order.
    pub correlations: Vec<Vec<f64>>,
    /// Warnings and notes, a sentence each.
    pub remarks: Vec<String>,
    pub strokes: Vec<FittedStroke>,
}

/// Fits `subject`; `progress` is called after each simulated stroke.
///
/// # Errors
/// If the model fails with the values from which the search begins.
pub fn fit(subject: &FitSubject<'_>, progress: &(dyn Fn() + Sync)) -> Result<FitOutcome, String> {
    let task = FitTask::new(subject, progress);
    let start = subject.values.to_vec();
    let first = task.forces(std::slice::from_ref(&start)).pop().flatten().ok_or_else(|| {
        format!(
            "{} cannot follow these strokes: the model fails with the values that it has",
            subject.name
        )
    })?;
    let mut fitting = Fitting::new(&task, subject)?;
    fitting.weed((RemainingSpread { deviation: 1.0, rows: task.rows() as f64 }, &[]));
    let known = loop {
        fitting.search();
        let shaken = task.shaken(&fitting.values, &fitting.now);
        if !fitting.weed((fitting.spread(), &shaken)) {
            break fitting.known(&shaken);
        }
    };
    let last = task.forces(std::slice::from_ref(&fitting.values)).pop().flatten();
    let last = last.unwrap_or_else(|| first.clone());
    Ok(FitOutcome {
        instrument: subject.name.to_owned(),
        parameters: fitting.parameters(subject, known.as_ref()),
        correlations: known.as_ref().map(|it| rows(&it.certainty)).unwrap_or_default(),
        remarks: fitting.remarks(known.as_ref()),
        strokes: strokes(subject, &task, [first, last]),
    })
}

struct Fitting<'a> {
    task: &'a FitTask<'a>,
    start: Vec<f64>,
    values: Vec<f64>,
    now: Differences,
    fitted: Vec<usize>,
    left: Vec<String>,
}

struct Known {
    certainty: FitCertainty,
    errors: Vec<f64>,
}

impl<'a> Fitting<'a> {
    fn new(task: &'a FitTask<'a>, subject: &FitSubject<'_>) -> Result<Self, String> {
        let values = subject.values.to_vec();
        let now = task.differences_of(&values).ok_or("the model fails at its start")?;
        let (start, fitted) = (values.clone(), subject.fitted.to_vec());
        Ok(Self { task, start, values, now, fitted, left: Vec::new() })
    }

    fn parameter(&self, place: usize) -> &'a Parameter {
        &self.task.model.parameters[place]
    }

    fn called(&self, place: usize) -> String {
        let Parameter { name, title, .. } = self.parameter(place);
        if *name == &**title { (*name).to_owned() } else { format!("{title} ({name})") }
    }

    /// Returns the scale of an interval: the value, or the range if the value is zero.
    fn size(&self, place: usize) -> f64 {
        let (low, high) = self.task.range(place);
        let value = self.values[place].abs();
        if value > 0.0 { value.min(0.5 * (high - low)) } else { 0.5 * (high - low) }
    }

    fn sizes(&self) -> Vec<f64> {
        self.fitted.iter().map(|place| self.size(*place)).collect()
    }

    fn steps(&self) -> Vec<f64> {
        steps(self.task, &self.fitted, &self.values, &self.now)
    }

    fn spread(&self) -> RemainingSpread {
        let mut rest = self.now.as_slice();
        let strokes = self.task.strokes.iter().map(|stroke| {
            let (head, tail) = rest.split_at(stroke.rows());
            rest = tail;
            head
        });
        let strokes = strokes.collect::<Vec<_>>();
        RemainingSpread::new(&strokes, self.fitted.len())
    }

    fn search(&mut self) {
        for _ in 0..ROUNDS {
            if self.fitted.is_empty() {
                return;
            }
            let (before, steps) = (self.now.norm_squared(), self.steps());
            let from = (self.values.clone(), self.now.clone());
            let found = solve(self.task, &self.fitted, &steps, from);
            (self.values, self.now) = scan(self.task, &self.fitted, &steps, found);
            if self.now.norm_squared() > (1.0 - WORTH) * before {
                return;
            }
        }
    }

    /// Restores the parameters that the data do not determine; returns `true` if there were any.
    fn weed(&mut self, spread: (RemainingSpread, &[Differences])) -> bool {
        let steps = self.steps();
        let mut found = jacobian(self.task, &self.fitted, &self.values, (&steps, 1.0));
        let count = self.fitted.len();
        while !self.fitted.is_empty() {
            let sizes = self.sizes();
            let certainty = FitCertainty::new(&found, &sizes, spread);
            let Some((worst, with)) = certainty.undetermined(&sizes) else { break };
            let (place, half) = (self.fitted[worst], certainty.halves[worst]);
            let is_felt = found.column(worst).amax() * sizes[worst] > UNFELT;
            self.left.push(self.sentence(worst, &with, is_felt.then_some(half)));
            self.fitted.remove(worst);
            self.values[place] = self.start[place];
            found = found.remove_column(worst);
        }
        if self.fitted.len() < count {
            let now = self.task.differences_of(&self.values);
            self.now = now.unwrap_or_else(|| self.now.clone());
        }
        self.fitted.len() < count
    }

    fn sentence(&self, at: usize, with: &[usize], half: Option<f64>) -> String {
        let place = self.fitted[at];
        let Parameter { unit, .. } = self.parameter(place);
        let (name, kept) = (self.called(place), with_unit(self.start[place], unit));
        let others: Vec<_> = with.iter().map(|at| self.called(self.fitted[*at])).collect();
        match half {
            None => {
                format!("{name} has no influence on these strokes; it keeps its value, {kept}.")
            }
            Some(_) if !others.is_empty() => format!(
                "These strokes do not tell {name} from {}; it keeps its value, {kept}.",
                others.join(" and ")
            ),
            Some(half) => format!(
                "These strokes do not determine {name}, its 95 % interval would be ± {}; it keeps \
                 its value, {kept}.",
                with_unit(half, unit)
            ),
        }
    }

    fn known(&self, shaken: &[Differences]) -> Option<Known> {
        if self.fitted.is_empty() {
            return None;
        }
        let steps = self.steps();
        let of = |part| jacobian(self.task, &self.fitted, &self.values, (&steps, part));
        let (whole, half) = (of(1.0), of(0.5));
        let columns = whole.column_iter().zip(half.column_iter());
        let errors = columns.map(|(a, b)| (a - b).norm() / b.norm().max(f64::MIN_POSITIVE));
        let errors = errors.collect();
        Some(Known {
            certainty: FitCertainty::new(&whole, &self.sizes(), (self.spread(), shaken)),
            errors,
        })
    }

    fn parameters(&self, subject: &FitSubject<'_>, known: Option<&Known>) -> Vec<FittedParameter> {
        let one = |place: &usize| {
            let Parameter { name, title, unit, range, .. } = self.parameter(*place).clone();
            let at = self.fitted.iter().position(|it| it == place);
            let known = at.and_then(|at| Some((at, known?)));
            let value = self.values[*place];
            FittedParameter {
                name,
                title,
                unit,
                before: self.start[*place],
                value,
                interval: known.map(|(at, it)| {
                    let half = it.certainty.halves[at];
                    ((value - half).max(range.0), (value + half).min(range.1))
                }),
                derivative_error: known.map(|(at, it)| it.errors[at]),
            }
        };
        subject.fitted.iter().map(one).collect()
    }

    fn remarks(&self, known: Option<&Known>) -> Vec<String> {
        let mut remarks = self.left.clone();
        let Some(Known { certainty, errors }) = known else {
            remarks.push("Nothing was fitted.".to_owned());
            return remarks;
        };
        let pairs = (0..errors.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
        let alike = pairs.map(|(a, b)| (a, b, certainty.correlations[(a, b)]));
        remarks.extend(alike.filter(|it| it.2.abs() > CORRELATED).map(|(a, b, correlation)| {
            let [a, b] = [a, b].map(|at| self.called(self.fitted[at]));
            format!(
                "{a} and {b} have a correlation of {correlation:.3}: one can stand for the other."
            )
        }));
        let unsure = self.fitted.iter().zip(errors).filter(|it| *it.1 > UNSURE);
        remarks.extend(unsure.map(|(place, error)| {
            format!(
                "The force changes in jumps with {}: two derivatives are {:.0} % apart, and so \
                 unsure is its interval.",
                self.called(*place),
                100.0 * error
            )
        }));
        let deviation = self.spread().deviation;
        if deviation > POOR {
            remarks.push(format!(
                "The differences that remain are {deviation:.1} times the noise: the model cannot \
                 follow all of the data, and the intervals are those of its best values."
            ));
        }
        remarks
    }
}

pub(super) fn with_unit(value: f64, unit: &str) -> String {
    let digits = four_digits(value);
    if unit == "1" { digits } else { format!("{digits} {unit}") }
}

pub(super) fn four_digits(value: f64) -> String {
    let rounded = format!("{value:.3e}").parse::<f64>().unwrap_or(value);
    let is_short = rounded == 0.0 || (1e-3..1e6).contains(&rounded.abs());
    if is_short { format!("{rounded}") } else { format!("{rounded:e}") }
}

fn rows(certainty: &FitCertainty) -> Vec<Vec<f64>> {
    certainty.correlations.row_iter().map(|row| row.iter().copied().collect()).collect()
}

fn strokes(
    subject: &FitSubject<'_>,
    task: &FitTask<'_>,
    [first, last]: [Vec<Vec<f64>>; 2],
) -> Vec<FittedStroke> {
    let all = subject.strokes.iter().zip(&task.strokes).zip(first.into_iter().zip(last));
    all.map(|((stroke, driven), (before, after))| {
        let rms = |forces: &[f64]| {
            let squares = stroke.rows.iter().zip(forces).map(|(row, it)| (row.force - it).powi(2));
            (squares.sum::<f64>() / forces.len() as f64).sqrt()
        };
        FittedStroke {
            name: stroke.name.clone(),
            rows: stroke.rows.len(),
            noise: super::data::median(driven.noises.clone()),
            before: rms(&before),
            after: rms(&after),
            measured: stroke.rows.clone(),
            forces: after,
        }
    })
    .collect()
}
