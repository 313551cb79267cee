//! `[render]`: how a voice is computed, and what the finger may feel at most.

use haptics::Kalman;
use pode::input::Reconstruction as Samples;
use pode::{Limits, Stepper as _, stepper};

use super::quantity::Quantity;
use super::read::TableReader;
use super::report::{Location, MistakeList};

const LONGEST_STEP: Quantity = Quantity { unit: "s", range: (1e-6, 0.1) };

/// Below 1e-9 no key's motion is known, above 0.1 none is rendered.
const ERROR_BUDGET: Quantity = Quantity { unit: "1", range: (1e-9, 0.1) };

/// A bracket of half a tick locates nothing; below 1e-15 the fraction has no digits left.
const EVENT_TOLERANCE: Quantity = Quantity { unit: "1", range: (1e-15, 0.1) };

/// From a key that hardly moves to one that is hammered.
pub(super) const JERK_DENSITY: Quantity = Quantity { unit: "m²/s⁵", range: (1e-3, 1e12) };

/// A finger holds about 100 N for a moment, and no keyboard needs it to.
const FORCE_LIMIT: Quantity = Quantity { unit: "N", range: (0.1, 100.0) };

const SLEW_LIMIT: Quantity = Quantity { unit: "N/s", range: (1.0, 1e7) };

/// How a voice is computed, and what the finger may feel at most.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Render {
    pub stepper: StepperName,
    /// Relative error per radian of a mode's fastest motion that `by-need` may make.
    pub error_budget: f64,
    /// Longest step (s); the model's own limit holds too.
    pub longest_step: f64,
    /// Width to which an event is located, as a fraction of the tick.
    pub event_tolerance: f64,
    /// What makes a motion of encoder counts.
    pub estimator: EstimatorName,
    /// Power density of the jerk that the Kalman filter reckons with [m²/s⁵]: the smaller,
    /// the smoother and slower. Rigid models need it small, see key_hammer_rigid's README.
    pub jerk_density: f64,
    /// How that motion goes on over the tick.
    pub reconstruction: InputReconstruction,
    /// Largest force (N).
    pub force_limit: f64,
    /// Fastest change of force (N/s).
    pub slew_limit: f64,
}

impl Default for Render {
    fn default() -> Self {
        Self {
            stepper: StepperName::Rk4,
            error_budget: stepper::ByNeed::BUDGET,
            longest_step: 1e-3,
            event_tolerance: Limits::default().event_tolerance,
            estimator: EstimatorName::Kalman,
            jerk_density: Kalman::KEY_JERK_DENSITY,
            reconstruction: InputReconstruction::Estimate,
            force_limit: 25.0,
            slew_limit: 2e4,
        }
    }
}

macro_rules! steppers {
    ($($(#[$doc:meta])+ $name:ident,)+) => {
        /// A method of `pode::stepper` that makes sense in a tick.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum StepperName {
            $($(#[$doc])+ $name,)+
        }

        impl StepperName {
            /// Every method, the explicit ones first, by order.
            pub const ALL: &[Self] = &[$(Self::$name),+];

            /// Its name in scenes and on the command line.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$name => <stepper::$name>::NAME,)+
                }
            }
        }
    };
}

steppers! {
    /// First order, two evaluations; keeps energy bounded.
    SemiImplicitEuler,
    /// Second order, two evaluations.
    Heun,
    /// Second order, two evaluations; keeps energy bounded.
    VelocityVerlet,
    /// Second order, one evaluation; starts anew after events.
    AdamsBashforth2,
    /// Third order, one evaluation; starts anew after events.
    AdamsBashforth3,
    /// Third order, three evaluations.
    BogackiShampine,
    /// Fourth order, four evaluations.
    Rk4,
    /// Fifth order, six evaluations.
    Tsitouras5,
    /// Second order, linearly implicit; makes no energy at any stiffness.
    LinearImplicitMidpoint,
    /// Second order, linearly implicit; stiff motion dies out.
    Ros2,
    /// Third order, linearly implicit; stiff motion dies out.
    Rodas3,
    /// The exact flow of linear modes, `Rk4` in the others.
    Exact,
    /// For each mode the cheapest that meets the error budget.
    ByNeed,
}

/// An estimator of `haptics`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EstimatorName {
    /// A Kalman filter of position, velocity and acceleration.
    Kalman,
    /// Differences of the newest positions.
    BackwardDifference,
}

impl EstimatorName {
    /// Every estimator, the default first.
    pub const ALL: [Self; 2] = [Self::Kalman, Self::BackwardDifference];

    /// Its name in scenes.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kalman => "kalman",
            Self::BackwardDifference => "backward-difference",
        }
    }
}

/// How the key's motion goes on between two samples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InputReconstruction {
    /// Ballistic, from what the estimator says.
    Estimate,
    /// From the samples alone.
    Samples(Samples),
}

impl InputReconstruction {
    /// Every reconstruction, the default first.
    pub const ALL: [Self; 5] = [
        Self::Estimate,
        Self::Samples(Samples::Hold),
        Self::Samples(Samples::Linear),
        Self::Samples(Samples::Quadratic),
        Self::Samples(Samples::LateHermite),
    ];

    /// Its name in scenes.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Estimate => "estimate",
            Self::Samples(Samples::Hold) => "hold",
            Self::Samples(Samples::Linear) => "linear",
            Self::Samples(Samples::Quadratic) => "quadratic",
            Self::Samples(Samples::LateHermite) => "late-hermite",
        }
    }
}

/// Reads the table `render` for ticks at `tick_hz`; the default for what is not there.
pub(super) fn read(
    report: &mut MistakeList<'_>,
    scene: &mut TableReader<'_>,
    tick_hz: u32,
) -> Render {
    let mut render = Render::default();
    let Some(mut reader) = scene.table(report, "render") else { return render };
    let steppers: Vec<_> = StepperName::ALL.iter().map(|all| (all.name(), *all)).collect();
    let estimators = EstimatorName::ALL.map(|all| (all.name(), all));
    let reconstructions = InputReconstruction::ALL.map(|all| (all.name(), all));

    keep(&mut render.stepper, reader.choice(report, "stepper", "there is no stepper", &steppers));
    keep(&mut render.error_budget, reader.number(report, "error_budget", ERROR_BUDGET));
    let longest_step = reader.take("longest_step").map(|entry| entry.node.place);
    keep(&mut render.longest_step, reader.number(report, "longest_step", LONGEST_STEP));
    keep(&mut render.event_tolerance, reader.number(report, "event_tolerance", EVENT_TOLERANCE));
    keep(
        &mut render.estimator,
        reader.choice(report, "estimator", "there is no estimator", &estimators),
    );
    keep(&mut render.jerk_density, reader.number(report, "jerk_density", JERK_DENSITY));
    let reconstruction =
        reader.choice(report, "reconstruction", "there is no reconstruction", &reconstructions);
    keep(&mut render.reconstruction, reconstruction);
    keep(&mut render.force_limit, reader.number(report, "force_limit", FORCE_LIMIT));
    keep(&mut render.slew_limit, reader.number(report, "slew_limit", SLEW_LIMIT));
    if let Some(place) = longest_step {
        refuse_too_short(report, place, render.longest_step, tick_hz);
    }
    reader.finish(report);
    render
}

/// Keeps what was read, if anything was.
fn keep<T>(kept: &mut T, read: Option<T>) {
    if let Some(read) = read {
        *kept = read;
    }
}

/// Reports a step of which more are needed than a tick may take.
fn refuse_too_short(
    report: &mut MistakeList<'_>,
    place: Location,
    longest_step: f64,
    tick_hz: u32,
) {
    let limits = Limits::default();
    // An event may cut a step in two.
    let most = f64::from(limits.pieces.saturating_sub(limits.events).max(1));
    let shortest = 1.0 / (f64::from(tick_hz) * most);
    if longest_step < shortest {
        // Rounded up, or what is told would be refused again.
        let microseconds = (shortest * 1e7).ceil() / 10.0;
        let message = format!(
            "\"longest_step\" is {}, but a tick at {tick_hz} Hz may take {most} steps at most",
            LONGEST_STEP.show(longest_step)
        );
        report.say(place, message, format!("give at least {microseconds:.1} us, or a faster tick"));
    }
}
