//! `[render]`: the settings by which a voice is computed, and the limits of its force.

use haptics::{AnyEstimator, EstimatorName, EstimatorSettings, Kalman};
use pode::input::Reconstruction as Samples;
use pode::stepper::{self, Any};
use pode::{Limits, Stepper as _};

use super::quantity::Quantity;
use super::read::TableReader;
use super::setting::{NamedValues, settings};
use documents::toml::{FindingList, SourcePlace};

pub(super) const TICK_HZ: Quantity = Quantity { unit: "Hz", range: (100.0, 10_000.0) };

const LONGEST_STEP: Quantity = Quantity { unit: "s", range: (1e-6, 0.1) };

/// Below 1e-9 no motion is known, above 0.1 none is rendered.
const ERROR_BUDGET: Quantity = Quantity { unit: "1", range: (1e-9, 0.1) };

/// A bracket of half a tick locates nothing; below 1e-15 the fraction has no digits left.
const EVENT_TOLERANCE: Quantity = Quantity { unit: "1", range: (1e-15, 0.1) };

/// Range from a key that hardly moves to one that is hammered.
pub(super) const JERK_DENSITY: Quantity = Quantity { unit: "m²/s⁵", range: (1e-3, 1e12) };

/// Below a finger's slowest stroke the finger feels nothing.
const CUTOFF: Quantity = Quantity { unit: "Hz", range: (1.0, 1e4) };

const JERK_LIMIT: Quantity = Quantity { unit: "m/s³", range: (1.0, 1e9) };

pub(super) const COUPLING_STIFFNESS: Quantity = Quantity { unit: "N/m", range: (0.0, 1e6) };

pub(super) const COUPLING_DAMPING: Quantity = Quantity { unit: "N·s/m", range: (0.0, 1e3) };

/// A gain of the other sign would turn a spring into a push.
const GAIN: Quantity = Quantity { unit: "1", range: (1e-3, 1e3) };

/// More than a joule is a hammer's blow.
const ENERGY_TANK: Quantity = Quantity { unit: "J", range: (0.0, 1.0) };

/// The transport takes some milliseconds at most, and no estimate reaches farther.
const LEAD: Quantity = Quantity { unit: "s", range: (0.0, 8e-3) };

const COMPENSATION: Quantity = Quantity { unit: "1", range: (0.0, 1.0) };

const PASSIVITY_MODES: NamedValues<PassivityMode> = NamedValues {
    refusal: "there is no passivity",
    all: || PassivityMode::ALL.map(|all| (all.name(), all)).into(),
};

/// A finger holds about 100 N briefly, and no keyboard needs that.
const FORCE_LIMIT: Quantity = Quantity { unit: "N", range: (0.1, 100.0) };

const SLEW_LIMIT: Quantity = Quantity { unit: "N/s", range: (1.0, 1e7) };

/// Methods that are useful in a tick, the explicit ones first, by order.
const STEPPERS: NamedValues<Any> = NamedValues {
    refusal: "there is no stepper",
    all: || STEPPER_NAMES.iter().filter_map(|name| Some((*name, Any::named(name)?))).collect(),
};

const STEPPER_NAMES: [&str; 13] = [
    stepper::SemiImplicitEuler::NAME,
    stepper::Heun::NAME,
    stepper::VelocityVerlet::NAME,
    stepper::AdamsBashforth2::NAME,
    stepper::AdamsBashforth3::NAME,
    stepper::BogackiShampine::NAME,
    stepper::Rk4::NAME,
    stepper::Tsitouras5::NAME,
    stepper::LinearImplicitMidpoint::NAME,
    stepper::Rodas3::NAME,
    <stepper::Exact>::NAME,
    stepper::Newmark::NAME,
    stepper::ByNeed::NAME,
];

pub(super) const ESTIMATORS: NamedValues<EstimatorName> = NamedValues {
    refusal: "there is no estimator",
    all: || EstimatorName::ALL.map(|all| (all.name(), all)).into(),
};

pub(super) const RECONSTRUCTIONS: NamedValues<InputReconstruction> = NamedValues {
    refusal: "there is no reconstruction",
    all: || InputReconstruction::ALL.map(|all| (all.name(), all)).into(),
};

settings! {
    /// The settings by which a voice is computed, and the limits of its force.
    pub struct Render;
    /// Method of integration. `newmark` takes 2 to 4 evaluations a tick where felts press, and is RK4
    /// where the motion is slow.
    stepper: Any = Any::Newmark(stepper::Newmark::default()), STEPPERS;
    /// Relative error per radian of a mode's fastest motion allowed for `by-need`.
    error_budget: f64 = stepper::ByNeed::BUDGET, ERROR_BUDGET;
    /// Longest step (s); the model's own limit applies as well.
    longest_step: f64 = 1e-3, LONGEST_STEP;
    /// Width to which an event is located, as a fraction of the tick.
    event_tolerance: f64 = Limits::default().event_tolerance, EVENT_TOLERANCE;
    /// Estimator of motion from encoder counts.
    estimator: EstimatorName = EstimatorName::Kalman, ESTIMATORS;
    /// Power density of the jerk assumed by the Kalman filter (m²/s⁵): smaller is smoother and
    /// slower. Rigid models need it small, see key_hammer_rigid's README.
    jerk_density: f64 = Kalman::KEY_JERK_DENSITY, JERK_DENSITY;
    /// Cutoff of the low pass of `filtered-difference` (Hz).
    cutoff: f64 = EstimatorSettings::KEY_CUTOFF, CUTOFF;
    /// Largest jerk of a key assumed by `levant` (m/s³).
    jerk_limit: f64 = EstimatorSettings::KEY_JERK_LIMIT, JERK_LIMIT;
    /// Continuation of that motion over the tick.
    reconstruction: InputReconstruction = InputReconstruction::Estimate, RECONSTRUCTIONS;
    /// Stiffness between the player's key and the model's (N/m); 0 for none, the same key.
    coupling_stiffness: f64 = 0.0, COUPLING_STIFFNESS;
    /// Damping between the player's key and the model's (N s/m).
    coupling_damping: f64 = 0.0, COUPLING_DAMPING;
    /// Motion of the model's key per motion of the player's: 1 on a key as long as the model's.
    motion_gain: f64 = 1.0, GAIN;
    /// Motor force per force of the model.
    force_gain: f64 = 1.0, GAIN;
    /// Time after the tick, beyond the force's own hold, at which the force acts (s); estimated
    /// motion is extrapolated to it.
    lead: f64 = 0.0, LEAD;
    /// Fraction of the key's own mass that is removed from the felt force.
    inertia_compensation: f64 = 0.0, COMPENSATION;
    /// Fraction of the key's own friction, damping and weight that is removed.
    friction_compensation: f64 = 0.0, COMPENSATION;
    /// Response to energy that a key generates.
    passivity: PassivityMode = PassivityMode::Observe, PASSIVITY_MODES;
    /// Energy that a controlled key may give back in advance (J): smaller values make slow keys
    /// begin softer.
    energy_tank: f64 = 1e-3, ENERGY_TANK;
    /// Largest force (N).
    force_limit: f64 = 25.0, FORCE_LIMIT;
    /// Fastest change of force (N/s).
    slew_limit: f64 = 2e4, SLEW_LIMIT;
}

impl Render {
    /// Returns the estimator of a key with counts of `quantum` (m) each `period` (s).
    pub fn estimator(&self, period: f64, quantum: f64) -> AnyEstimator {
        let Self { jerk_density, cutoff, jerk_limit, .. } = *self;
        let settings = EstimatorSettings { period, quantum, jerk_density, cutoff, jerk_limit };
        AnyEstimator::new(self.estimator, &settings)
    }
}

/// Response to a key that gives back more energy than it received.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PassivityMode {
    /// The key is muted once it gave back more than any action stores.
    Observe,
    /// No force is sent that could give back too much.
    Control,
}

impl PassivityMode {
    /// Both modes, the usual one first.
    pub const ALL: [Self; 2] = [Self::Observe, Self::Control];

    pub const fn name(self) -> &'static str {
        match self {
            Self::Observe => "observe",
            Self::Control => "control",
        }
    }
}

/// Continuation of the key's motion between two samples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum InputReconstruction {
    /// Ballistic continuation of the estimate.
    Estimate,
    /// Interpolation of the samples alone.
    Samples(Samples),
}

impl InputReconstruction {
    pub const ALL: [Self; 5] = [
        Self::Estimate,
        Self::Samples(Samples::Hold),
        Self::Samples(Samples::Linear),
        Self::Samples(Samples::Quadratic),
        Self::Samples(Samples::LateHermite),
    ];

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

/// Reads the table `render` for ticks at `tick_hz`, with defaults for missing entries.
pub(super) fn read(report: &mut FindingList, scene: &mut TableReader<'_>, tick_hz: u32) -> Render {
    let mut render = Render::default();
    let Some(mut reader) = scene.table(report, "render") else { return render };
    render.read_all(report, &mut reader);
    let longest_step = reader.take("longest_step").map(|entry| entry.node.place);
    if let Some(place) = longest_step {
        refuse_too_short(report, place, render.longest_step, tick_hz);
    }
    reader.finish(report);
    render
}

/// Reports a longest step that needs more steps than a tick allows.
fn refuse_too_short(report: &mut FindingList, place: SourcePlace, longest_step: f64, tick_hz: u32) {
    let limits = Limits::default();
    let most = f64::from(limits.pieces.saturating_sub(limits.events).max(1));
    let shortest = 1.0 / (f64::from(tick_hz) * most);
    if longest_step < shortest {
        // Rounded up, or the reported value would be rejected again.
        let microseconds = (shortest * 1e7).ceil() / 10.0;
        let message = format!(
            "\"longest_step\" is {}, but a tick at {tick_hz} Hz may take {most} steps at most",
            LONGEST_STEP.show(longest_step)
        );
        report.say(place, message, format!("give at least {microseconds:.1} us, or a faster tick"));
    }
}
