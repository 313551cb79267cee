//! Instruments under a stroke, against trajectories of independent programs.

use instruments::{NamedModes as _, SmallModel};
use pode::Motion;

use super::file::{BadFile, ReferenceCase, ReferenceFile, file};
use super::input::{Bells, Presses, TermInput};
use super::{ForceKind, MS, ModeOf, Plan, Reference, Scenario, StateOf};

#[derive(Debug)]
pub(super) struct StrokeScenario<I> {
    model: SmallModel,
    input: I,
    until: f64,
    pace: StrokeTicks,
    reference: Reference<SmallModel>,
}

#[derive(Clone, Copy, Debug)]
struct StrokeTicks {
    ticks: &'static [f64],
    /// For methods that choose their steps (s).
    offline_tick: f64,
}

impl StrokeTicks {
    const USUAL: Self = Self { ticks: super::TICKS, offline_tick: 100.0 * MS };
}

impl<I: TermInput> StrokeScenario<I> {
    /// Reads the case of the model `name` in `file`; `column` of its trajectory is the readout.
    #[expect(clippy::large_stack_frames, reason = "once for a scenario")]
    fn read(
        (name, column): (&str, &str),
        file: &ReferenceFile,
        pace: StrokeTicks,
    ) -> Result<Self, BadFile> {
        let case = ReferenceCase::read(file)?;
        let known = super::small(name);
        let model = case.model(&known.ok_or_else(|| file.wrong(format_args!("no model {name}")))?);
        let input = I::of(&case.input_terms(file)?);
        let reference = Reference {
            events: case.events(&model, file)?,
            is_whole: true,
            rest: None,
            names: model.modes().collect(),
            samples: case.samples(&model, file, column)?,
        };
        Ok(Self {
            model,
            input: input.ok_or_else(|| file.wrong("another number of terms"))?,
            until: case.until(file)?,
            pace,
            reference,
        })
    }
}

impl<I: TermInput> Scenario for StrokeScenario<I> {
    type Model = SmallModel;

    fn plan(&self) -> Plan {
        let Self { until, pace: StrokeTicks { ticks, offline_tick }, .. } = *self;
        Plan { until, ticks, offline_tick, felt: ForceKind::Readout, ..Plan::EXACT }
    }

    /// Starts at rest under s = 0; the first tick sets the values that a mode slaves to the input.
    fn start(&self) -> (SmallModel, ModeOf<Self>, StateOf<Self>) {
        let (mode, state) = self.model.at_rest(&Motion::default());
        (self.model.clone(), mode, state)
    }

    #[inline]
    fn input(&self, t: f64) -> Motion {
        self.input.at(t)
    }

    fn reference(&self) -> &Reference<SmallModel> {
        &self.reference
    }
}

pub(super) type RigidStroke = StrokeScenario<Bells<2>>;
pub(super) type SpringsStroke = StrokeScenario<Bells<3>>;
pub(super) type GrandStroke = StrokeScenario<Presses<2>>;

const TORQUE: &str = "T_KU";

pub(super) fn two_throws() -> Result<RigidStroke, BadFile> {
    let file = file!("../../../instruments/tests/reference/", "model-a-two-throws");
    StrokeScenario::read(("key-hammer-rigid", TORQUE), &file, StrokeTicks::USUAL)
}

pub(super) fn figure_6() -> Result<SpringsStroke, BadFile> {
    springs(&file!("../../../instruments/tests/reference/", "model-b-figure6"), StrokeTicks::USUAL)
}

pub(super) fn stiff_10() -> Result<SpringsStroke, BadFile> {
    springs(&file!("../../../instruments/tests/reference/", "model-b-stiff-10"), StrokeTicks::USUAL)
}

pub(super) fn stiff_100() -> Result<SpringsStroke, BadFile> {
    springs(&file!("../../references/", "model-b-stiff-100"), StrokeTicks::USUAL)
}

/// Returns model B, 1e4 times stiffer: 2600 rad/s.
pub(super) fn stiff_10000() -> Result<SpringsStroke, BadFile> {
    const TICKS: &[f64] =
        &[5.0 * MS, MS, 0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS, 0.02 * MS, 0.01 * MS];
    let pace = StrokeTicks { ticks: TICKS, offline_tick: 120.0 * MS };
    springs(&file!("../../references/", "model-b-stiff-10000"), pace)
}

/// Returns model C: a forte, held and released.
pub(super) fn forte() -> Result<GrandStroke, BadFile> {
    const TICKS: &[f64] =
        &[5.0 * MS, MS, 0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS, 0.025 * MS, 0.01 * MS];
    let file = file!("../../../instruments/tests/reference/", "model-c-forte");
    let pace = StrokeTicks { ticks: TICKS, offline_tick: 50.0 * MS };
    StrokeScenario::read(("reduced-grand", "F_KU"), &file, pace)
}

fn springs(file: &ReferenceFile, pace: StrokeTicks) -> Result<SpringsStroke, BadFile> {
    StrokeScenario::read(("key-hammer-springs", TORQUE), file, pace)
}
