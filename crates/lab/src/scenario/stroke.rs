//! Instruments under a stroke, against trajectories of independent programs.

use models::Described;
use models::key_hammer_rigid::KeyHammerRigid;
use models::key_hammer_springs::KeyHammerSprings;
use models::reduced_grand::ReducedGrand;
use pode::Motion;

use super::file::{BadFile, ReferenceCase, ReferenceFile, file};
use super::input::{Bells, Presses, TermInput};
use super::{ForceKind, MS, ModeOf, Plan, Reference, Scenario, StateOf, Studied};

/// A model under a stroke.
#[derive(Debug)]
pub(super) struct StrokeScenario<M: Described, I> {
    model: M,
    input: I,
    until: f64,
    pace: StrokeTicks,
    reference: Reference<M>,
}

/// Over which ticks a stroke is studied.
#[derive(Clone, Copy, Debug)]
struct StrokeTicks {
    ticks: &'static [f64],
    /// For methods that choose their steps (s).
    offline_tick: f64,
}

impl StrokeTicks {
    const USUAL: Self = Self { ticks: super::TICKS, offline_tick: 100.0 * MS };
}

impl<M: Described + Default + Studied, I: TermInput> StrokeScenario<M, I> {
    /// Reads the case in `file`, whose trajectory has the readout in `column`.
    fn read(file: &ReferenceFile, column: &str, pace: StrokeTicks) -> Result<Self, BadFile> {
        let case = ReferenceCase::read(file)?;
        let input = I::of(&case.input_terms(file)?);
        let reference = Reference {
            events: case.events::<M>(file)?,
            is_whole: true,
            rest: None,
            samples: case.samples::<M>(file, column)?,
        };
        Ok(Self {
            model: case.model(),
            input: input.ok_or_else(|| file.wrong("another number of terms"))?,
            until: case.until(file)?,
            pace,
            reference,
        })
    }
}

impl<M: Described + Default + Studied, I: TermInput> Scenario for StrokeScenario<M, I> {
    type Model = M;

    fn plan(&self) -> Plan {
        let Self { until, pace: StrokeTicks { ticks, offline_tick }, .. } = *self;
        Plan { until, ticks, offline_tick, felt: ForceKind::Readout }
    }

    /// At rest under s = 0; what a mode slaves to the input, the first tick puts in place.
    fn start(&self) -> (M, ModeOf<Self>, StateOf<Self>) {
        let (mode, state) = self.model.at_rest(&Motion::default());
        (self.model, mode, state)
    }

    #[inline]
    fn input(&self, t: f64) -> Motion {
        self.input.at(t)
    }

    fn reference(&self) -> &Reference<M> {
        &self.reference
    }
}

/// Model A under two throws.
pub(super) type RigidStroke = StrokeScenario<KeyHammerRigid, Bells<2>>;
/// Model B under the paper's three throws.
pub(super) type SpringsStroke = StrokeScenario<KeyHammerSprings, Bells<3>>;
/// Model C under a press and its release.
pub(super) type GrandStroke = StrokeScenario<ReducedGrand, Presses<2>>;

/// The trajectories' column of the readout of models A and B.
const TORQUE: &str = "T_KU";

/// Returns model A under two throws.
pub(super) fn two_throws() -> Result<RigidStroke, BadFile> {
    let file = file!("../../../models/tests/reference/", "model-a-two-throws");
    StrokeScenario::read(&file, TORQUE, StrokeTicks::USUAL)
}

/// Model B, as the paper has it.
pub(super) fn figure_6() -> Result<SpringsStroke, BadFile> {
    springs(&file!("../../../models/tests/reference/", "model-b-figure6"), StrokeTicks::USUAL)
}

/// Model B, 10 times stiffer.
pub(super) fn stiff_10() -> Result<SpringsStroke, BadFile> {
    springs(&file!("../../../models/tests/reference/", "model-b-stiff-10"), StrokeTicks::USUAL)
}

/// Model B, 100 times stiffer.
pub(super) fn stiff_100() -> Result<SpringsStroke, BadFile> {
    springs(&file!("../../references/", "model-b-stiff-100"), StrokeTicks::USUAL)
}

/// Model B, 1e4 times stiffer: 2600 rad/s.
pub(super) fn stiff_10000() -> Result<SpringsStroke, BadFile> {
    const TICKS: &[f64] =
        &[5.0 * MS, MS, 0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS, 0.02 * MS, 0.01 * MS];
    let pace = StrokeTicks { ticks: TICKS, offline_tick: 120.0 * MS };
    springs(&file!("../../references/", "model-b-stiff-10000"), pace)
}

/// Model C: a forte, held and released.
pub(super) fn forte() -> Result<GrandStroke, BadFile> {
    const TICKS: &[f64] =
        &[5.0 * MS, MS, 0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS, 0.025 * MS, 0.01 * MS];
    let file = file!("../../../models/tests/reference/", "model-c-forte");
    let pace = StrokeTicks { ticks: TICKS, offline_tick: 50.0 * MS };
    StrokeScenario::read(&file, "F_KU", pace)
}

fn springs(file: &ReferenceFile, pace: StrokeTicks) -> Result<SpringsStroke, BadFile> {
    StrokeScenario::read(file, TORQUE, pace)
}
