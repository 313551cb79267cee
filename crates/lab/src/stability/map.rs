//! A map: a loop at every point of a grid, and the boundary of stability.

use std::fmt;

use haptics::{EstimatorName, RigParameters};
use serde::Serialize;

use super::axis::{LoopPoint, MapAxis};
use super::contour::{MapPlace, zero_lines};
use super::judge::LoopVerdict;
use super::theory::{StabilityTheory, theories};
use super::trial::{KeyTravel, LoopKnock, run};
use super::voice::{TrialVoice, VoiceOrder, wall};
use figures::parallel::in_parallel;

/// Bisections between a stable point and its unstable neighbour.
const HALVINGS: u32 = 10;

/// Bisections for a theory, which are cheap.
const THEORY_HALVINGS: u32 = 40;

/// Points of a column at which a theory's boundary is searched.
const LOOKS: u32 = 400;

/// Makes the ordered voice, or returns a sentence of failure.
pub type VoiceMaker<'a> =
    &'a (dyn Fn(&VoiceOrder<'_>) -> Result<Box<dyn TrialVoice>, String> + Sync);

/// Subject on the key.
#[derive(Clone, Copy)]
pub enum StabilitySubject<'a> {
    /// A spring and damper that pushes and pulls, on a key that moves freely.
    Wall,
    /// The voice of an instrument, on a key between its felts.
    Voice(VoiceMaker<'a>),
}

impl fmt::Debug for StabilitySubject<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wall => "Wall",
            Self::Voice(_) => "Voice",
        })
    }
}

/// A subject, its key, and the variables of a map.
#[derive(Clone, Debug)]
pub struct StabilityStudy<'a> {
    pub name: String,
    pub subject: StabilitySubject<'a>,
    /// Rig of the loop, for all that is no quantity: felts, return spring, largest force.
    pub rig: RigParameters,
    /// Values of all that is no axis.
    pub base: LoopPoint,
    pub chosen: Vec<String>,
    pub axes: [MapAxis; 2],
    pub cells: usize,
}

/// Map of one estimator: cells, and the boundary between them.
#[derive(Clone, Debug)]
pub struct StabilityMap {
    pub estimator: EstimatorName,
    /// Verdict of each cell, column by column, from the lowest values.
    pub columns: Vec<Vec<LoopVerdict>>,
    pub crossings: Vec<Vec<f64>>,
    pub theories: Vec<TheoryLine>,
}

/// Boundary of a theory in a map.
#[derive(Clone, Debug)]
pub struct TheoryLine {
    pub theory: StabilityTheory,
    pub lines: Vec<Vec<MapPlace>>,
    pub crossings: Vec<Vec<f64>>,
}

/// Number of cells per verdict.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
pub struct VerdictCounts {
    pub rests: usize,
    pub rings: usize,
    pub makes_energy: usize,
    pub fails: usize,
}

impl StabilityMap {
    pub fn counts(&self) -> VerdictCounts {
        let count = |verdict| self.columns.iter().flatten().filter(|it| **it == verdict).count();
        VerdictCounts {
            rests: count(LoopVerdict::Rests),
            rings: count(LoopVerdict::Rings),
            makes_energy: count(LoopVerdict::MakesEnergy),
            fails: count(LoopVerdict::Fails),
        }
    }
}

impl StabilityStudy<'_> {
    /// Returns the minimum number of loops of one map, for a progress bar.
    pub fn runs(&self) -> usize {
        self.axes.iter().map(|it| it.cells(self.cells)).product()
    }

    pub fn point(&self, (x, y): MapPlace) -> LoopPoint {
        let [along, up] = &self.axes;
        self.base.clone().with(along, along.value(x)).with(up, up.value(y))
    }

    /// Returns the middle of a cell along the axis of that number, as a fraction of it.
    pub fn middle(&self, axis: usize, cell: usize) -> f64 {
        (cell as f64 + 0.5) / self.axes[axis].cells(self.cells) as f64
    }

    /// Describes invalid values, in a sentence each.
    pub fn mistakes(&self) -> Vec<String> {
        let mut mistakes: Vec<_> = self.axes.iter().filter_map(MapAxis::mistake).collect();
        if !mistakes.is_empty() {
            return mistakes;
        }
        // Values are bounded by ranges and by ratios of two of them: corners are worst.
        let corners = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0)];
        mistakes = corners.iter().flat_map(|it| self.point(*it).values.mistakes()).collect();
        mistakes.sort();
        mistakes.dedup();
        if let StabilitySubject::Voice(make) = self.subject
            && mistakes.is_empty()
        {
            let point = self.point((0.5, 0.5));
            let estimator = EstimatorName::Kalman;
            let order =
                VoiceOrder { values: &point.values, estimator, parameters: &point.parameters };
            mistakes.extend(make(&order).err());
        }
        mistakes
    }

    /// Runs the loop at a point; a voice that cannot be made counts as a failure.
    pub fn verdict(&self, estimator: EstimatorName, point: &LoopPoint) -> LoopVerdict {
        let LoopPoint { values, parameters } = point;
        let order = VoiceOrder { values, estimator, parameters };
        let (voice, travel, knock) = match self.subject {
            StabilitySubject::Wall => (Ok(wall(&order)), KeyTravel::Free, LoopKnock::TAP),
            StabilitySubject::Voice(make) => (make(&order), KeyTravel::Felts, LoopKnock::STROKE),
        };
        match voice {
            Ok(mut voice) => run((&self.rig, travel), values, &knock, voice.as_mut()),
            Err(_no_voice) => LoopVerdict::Fails,
        }
    }

    /// Runs the loop at every point, and locates boundaries; calls `done` after each cell.
    pub fn measure(&self, estimator: EstimatorName, done: &(dyn Fn() + Sync)) -> StabilityMap {
        let [across, up] = [0, 1].map(|axis| self.axes[axis].cells(self.cells));
        let cells: Vec<_> = (0..across).flat_map(|x| (0..up).map(move |y| (x, y))).collect();
        let verdicts = in_parallel(&cells, &|(x, y)| {
            let place = (self.middle(0, *x), self.middle(1, *y));
            let verdict = self.verdict(estimator, &self.point(place));
            done();
            verdict
        });
        let columns: Vec<_> = verdicts.chunks(up).map(<[_]>::to_vec).collect();
        let places: Vec<_> = (0..across).collect();
        let crossings = in_parallel(&places, &|x| self.crossings(estimator, *x, &columns[*x]));
        let theories = match self.subject {
            StabilitySubject::Wall => self.theories(estimator),
            StabilitySubject::Voice(_) => Vec::new(),
        };
        let theories = in_parallel(&theories, &|theory| self.line(*theory));
        StabilityMap { estimator, columns, crossings, theories }
    }

    fn theories(&self, estimator: EstimatorName) -> Vec<StabilityTheory> {
        let most = self.point((1.0, 1.0)).values;
        let mut theories = theories(estimator);
        theories.retain(|it| it.needs.is_none_or(|needs| most.get(needs) > 0.0));
        theories
    }

    fn crossings(&self, estimator: EstimatorName, x: usize, column: &[LoopVerdict]) -> Vec<f64> {
        let is_stable = |it: LoopVerdict| it == LoopVerdict::Rests;
        let [x_part, up] = [self.middle(0, x), self.axes[1].cells(self.cells) as f64];
        let mut found = Vec::new();
        for (y, pair) in column.windows(2).enumerate() {
            if is_stable(pair[0]) == is_stable(pair[1]) {
                continue;
            }
            let halvings = if self.axes[1].names().is_some() { 0 } else { HALVINGS };
            let is_low = |part: f64| {
                let verdict = self.verdict(estimator, &self.point((x_part, part)));
                is_stable(verdict) == is_stable(pair[0])
            };
            let ends = ((y as f64 + 0.5) / up, (y as f64 + 1.5) / up);
            found.push(self.axes[1].value(between(ends, halvings, &is_low)));
        }
        found
    }

    fn line(&self, theory: StabilityTheory) -> TheoryLine {
        let margin = |place: MapPlace| theory.margin(&self.point(place));
        let across = self.axes[0].cells(self.cells);
        let crossings = (0..across).map(|x| self.theory_crossings(&margin, self.middle(0, x)));
        let crossings = crossings.collect();
        TheoryLine { theory, lines: zero_lines(&margin), crossings }
    }

    /// Returns the crossings of a theory's boundary and the column at a fraction of the first axis.
    fn theory_crossings(&self, margin: &dyn Fn(MapPlace) -> f64, x: f64) -> Vec<f64> {
        if self.axes[1].names().is_some() {
            return Vec::new();
        }
        let part = |look: u32| f64::from(look) / f64::from(LOOKS);
        let is_inside = |y: f64| margin((x, y)) > 0.0;
        let inside: Vec<_> = (0..=LOOKS).map(|look| is_inside(part(look))).collect();
        let mut found = Vec::new();
        for (look, pair) in (0..LOOKS).zip(inside.windows(2)) {
            if pair[0] == pair[1] {
                continue;
            }
            let is_low = |y: f64| is_inside(y) == pair[0];
            let crossing = between((part(look), part(look + 1)), THEORY_HALVINGS, &is_low);
            found.push(self.axes[1].value(crossing));
        }
        found
    }
}

/// Bisects between two ends for the first value that is unlike the low end.
fn between((mut low, mut high): (f64, f64), halvings: u32, is_low: &dyn Fn(f64) -> bool) -> f64 {
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        *(if is_low(middle) { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}
