//! Problems with known answers: one file each.
//!
//! A scenario is a model, its start, its input as an exact function of time, and a [`Reference`]:
//! the right events and states, in closed form or from independent programs that agree. Models
//! that are not instruments are defined here. Copy `pendulum.rs` and list it in [`SCENARIOS`].

mod ball;
mod described;
mod elliptic;
mod felt;
mod file;
mod head;
mod input;
mod pendulum;
mod reference;
mod stroke;

pub use file::BadFile;
pub use reference::{ExpectedEvent, Reference, ReferenceSample};

use core::fmt::Debug;

use std::path::Path;
use std::sync::LazyLock;

use instruments::SmallModel;
use mechanism::Library;
use pode::{Energetic, Limits, Model, Resets};

use self::described::KeyStroke;
use self::stroke::{GrandStroke, RigidStroke, SpringsStroke};
use self::{
    ball::BallScenario, felt::FeltScenario, head::HeadScenario, pendulum::PendulumScenario,
};

/// Milliseconds (s).
pub(crate) const MS: f64 = 1e-3;

/// Steps of a key's stroke (s): all divide 5 ms.
const TICKS: &[f64] = &[5.0 * MS, 2.5 * MS, 1.0 * MS, 0.5 * MS, 0.25 * MS, 0.1 * MS, 0.05 * MS];

/// Limits of a tick without a deadline, for methods that choose their steps.
pub(crate) fn offline_limits() -> Limits {
    Limits { events: 1_000, guards: 1_000_000, pieces: 100_000, ..Limits::default() }
}

fn small(name: &str) -> Option<SmallModel> {
    Library::default().find(name, Path::new("")).ok()?.small()
}

pub(crate) fn figure_6() -> Result<impl Scenario<Model = SmallModel> + 'static, BadFile> {
    stroke::figure_6()
}

/// A model that can be studied.
pub trait Studied: Resets + Energetic + Clone + PartialEq {}

impl<M: Resets + Energetic + Clone + PartialEq> Studied for M {}

/// Input of a scenario's model.
pub type InputOf<S> = <<S as Scenario>::Model as Model>::Input;
/// Mode of a scenario's model.
pub type ModeOf<S> = <<S as Scenario>::Model as Model>::Mode;
/// State of a scenario's model.
pub type StateOf<S> = <<S as Scenario>::Model as Model>::State;

/// A problem with a known answer.
pub trait Scenario {
    type Model: Studied;

    fn plan(&self) -> Plan;

    /// Returns the model, with mode and state at t = 0.
    fn start(&self) -> (Self::Model, ModeOf<Self>, StateOf<Self>);

    /// Returns the exact input at `t` (s).
    fn input(&self, t: f64) -> InputOf<Self>;

    fn reference(&self) -> &Reference<Self::Model>;
}

/// Duration of a scenario, its steps, and the compared force.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Plan {
    /// End of the run (s).
    pub until: f64,
    /// Ticks (s), the longest first; each divides the time between samples.
    pub ticks: &'static [f64],
    /// Tick (s) for methods that choose their steps.
    pub offline_tick: f64,
    pub felt: ForceKind,
    /// Highest order of a method with located events, where a contact is not smooth as it closes:
    /// one more than the exponent of its force.
    pub order_bound: Option<f64>,
    /// `true` if the reference is of this project's methods, and no more exact than they are.
    pub is_computed: bool,
}

impl Plan {
    const EXACT: Self = Self {
        until: 0.0,
        ticks: &[],
        offline_tick: 0.0,
        felt: ForceKind::Readout,
        order_bound: None,
        is_computed: false,
    };
}

/// Kind of the force in samples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ForceKind {
    Readout,
    /// The readout's integral since the start with impulses, for contacts shorter than a tick.
    Impulse,
}

/// A scenario with its name.
#[derive(Clone, Copy, Debug)]
pub struct ScenarioEntry {
    pub name: &'static str,
    pub title: &'static str,
    pub source: &'static str,
    build: Build,
}

#[derive(Clone, Copy, Debug)]
enum Build {
    Ball(fn() -> Result<BallScenario, BadFile>),
    Pendulum(fn() -> PendulumScenario),
    Head(fn() -> HeadScenario),
    Felt(fn() -> FeltScenario),
    Rigid(fn() -> Result<RigidStroke, BadFile>),
    Springs(fn() -> Result<SpringsStroke, BadFile>),
    Grand(fn() -> Result<GrandStroke, BadFile>),
    Described(KeyStroke),
}

pub(crate) trait ScenarioVisitor {
    type Output;

    fn visit<S: Scenario + 'static>(self, scenario: S) -> Self::Output;
}

impl ScenarioEntry {
    #[expect(clippy::large_stack_frames, reason = "once for a scenario")]
    pub(crate) fn visit<V: ScenarioVisitor>(&self, visitor: V) -> Result<V::Output, BadFile> {
        Ok(match self.build {
            Build::Ball(build) => visitor.visit(build()?),
            Build::Pendulum(build) => visitor.visit(build()),
            Build::Head(build) => visitor.visit(build()),
            Build::Felt(build) => visitor.visit(build()),
            Build::Rigid(build) => visitor.visit(build()?),
            Build::Springs(build) => visitor.visit(build()?),
            Build::Grand(build) => visitor.visit(build()?),
            Build::Described(stroke) => stroke.visit(visitor)?,
        })
    }
}

const CLOSED: &str = "Reference: closed form.";
const GIVEN: &str = "Reference: three independent integrators, agreeing to 1e-19 s or better.";
const MADE: &str =
    "Reference: Taylor series in 240 bits and extrapolation in 113 bits, agreeing to 1e-23 s.";
const COMPUTED: &str = "Reference: DOP853 with a tolerance of 1e-13. Errors are shown down to 100 \
    times its difference from Tsitouras 5(4) with this tolerance.";

/// Exponent of the felt of a grand's hammer.
const FELT: Option<f64> = Some(2.4176);

macro_rules! small {
    ($($name:literal: $title:literal, $source:ident, $kind:ident($build:expr);)+) => {
        [$(ScenarioEntry { name: $name, title: $title, source: $source, build: Build::$kind($build) }),+]
    };
}

/// A soft stroke and a forte of each model, with the exponent of its least smooth contact.
macro_rules! strokes {
    ($($model:literal: $title:literal, $exponent:expr;)+) => {
        [$(
            ScenarioEntry {
                name: concat!($model, "-soft"),
                title: concat!($title, ", a soft stroke"),
                source: COMPUTED,
                build: Build::Described(KeyStroke::soft($model, $exponent)),
            },
            ScenarioEntry {
                name: concat!($model, "-forte"),
                title: concat!($title, ", a forte"),
                source: COMPUTED,
                build: Build::Described(KeyStroke::forte($model, $exponent)),
            },
        )+]
    };
}

static SMALL: [ScenarioEntry; 15] = small![
    "ball": "a ball with restitution 0.8, ten impacts", CLOSED, Ball(ball::ten_impacts);
    "ball-rest-0.8": "the same until it rests: a Zeno sequence", CLOSED, Ball(ball::rest_08);
    "ball-rest-0.5": "a ball with restitution 0.5 until it rests", CLOSED, Ball(ball::rest_05);
    "pendulum": "a pendulum against a wall at its lowest point: no Zeno sequence",
        CLOSED, Pendulum(pendulum::build);
    "head-1e3": "a hammer head on a lossless spring of 1e3 N/m", CLOSED, Head(head::build::<3>);
    "head-1e5": "a hammer head on a lossless spring of 1e5 N/m", CLOSED, Head(head::build::<5>);
    "head-1e7": "a hammer head on a lossless spring of 1e7 N/m: contacts of 0.1 ms",
        CLOSED, Head(head::build::<7>);
    "felt-1e5": "Hunt–Crossley felt of 1e5 N/m^1.5: one contact of 5.3 ms", CLOSED, Felt(felt::soft);
    "felt-1e7": "Hunt–Crossley felt of 1e7 N/m^1.5: one contact of 0.85 ms",
        CLOSED, Felt(felt::hard);
    "two-throws": "the paper's model A: rigid contact, two throws and catches",
        GIVEN, Rigid(stroke::two_throws);
    "figure-6": "the paper's model B: the stroke of figure 6", GIVEN, Springs(stroke::figure_6);
    "stiff-10": "figure 6 with springs ten times stiffer", GIVEN, Springs(stroke::stiff_10);
    "stiff-100": "figure 6 with springs a hundred times stiffer", MADE, Springs(stroke::stiff_100);
    "stiff-1e4": "figure 6 with springs 1e4 times stiffer: the first 11 events, before chaos",
        MADE, Springs(stroke::stiff_10000);
    "forte": "model C, a reduced grand action: a forte with let-off, check and repetition",
        GIVEN, Grand(stroke::forte);
];

static STROKES: [ScenarioEntry; 24] = strokes![
    "grand": "the default instrument", FELT;
    "grand-two-mass": "a grand of two masses", FELT;
    "grand-map": "a grand as a map of its forces", None;
    "upright": "an upright", None;
    "viennese": "a Viennese action", None;
    "harpsichord": "a harpsichord", None;
    "organ": "a tracker organ", None;
    "clavichord": "a clavichord", None;
    "celesta": "a celesta", None;
    "rhodes": "an electric piano with tines", None;
    "hammond": "a drawbar organ's key", None;
    "synth": "a synthesizer's key", Some(1.5);
];

pub static SCENARIOS: LazyLock<Vec<ScenarioEntry>> =
    LazyLock::new(|| SMALL.iter().chain(&STROKES).copied().collect());

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn names_are_different_and_fit_for_files() {
        let names: BTreeSet<_> = SCENARIOS.iter().map(|entry| entry.name).collect();
        assert_eq!(names.len(), SCENARIOS.len());
        let fits = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || "-.".contains(c);
        assert!(names.iter().all(|name| name.chars().all(fits)), "{names:?}");
    }

    struct Misfit;

    impl ScenarioVisitor for Misfit {
        type Output = Option<String>;

        fn visit<S: Scenario>(self, scenario: S) -> Option<String> {
            let Plan { until, ticks, offline_tick, .. } = scenario.plan();
            let is_whole = |parts: f64| (parts - parts.round()).abs() < 1e-6 && parts > 0.5;
            let odd = ticks.iter().chain([&offline_tick]).find(|tick| !is_whole(until / **tick));
            if let Some(odd) = odd {
                return Some(format!("{odd} s does not divide {until} s"));
            }
            let samples = &scenario.reference().samples;
            let odd = ticks.iter().find_map(|tick| {
                let sample = samples.iter().find(|sample| !is_whole(sample.t / tick))?;
                Some(format!("{tick} s does not divide {} s", sample.t))
            });
            let nothing = samples.is_empty().then(|| "there are no samples".to_owned());
            odd.or(nothing)
        }
    }

    #[test]
    fn every_scenario_can_be_built_and_its_ticks_meet_its_samples() {
        for entry in SCENARIOS.iter() {
            assert_eq!(entry.visit(Misfit), Ok(None), "{}", entry.name);
        }
    }
}
