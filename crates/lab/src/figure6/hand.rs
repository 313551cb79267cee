//! The hand of the experiment and its rig.
//!
//! The rig is [`RigParameters::PAPER`]. The motion of the hand is an estimate (E) for figure 6.

use core::f64::consts::TAU;

use haptics::{FingerParameters, KeyParameters, MotorParameters, MuscleCommand, RigParameters};
use pode::Motion;

pub(super) const RIG: RigParameters = RigParameters::PAPER;

/// Displacement of one line of the encoder (m).
pub(super) const LINE: f64 = RIG.quantum;

/// Travel of the handle (m).
pub(super) const TRAVEL: f64 = RIG.key.bottom_stop.position;

const HANDLE: KeyParameters = RIG.key;
const MOTOR: MotorParameters = RIG.motor;
const HAND: FingerParameters = RIG.finger;

/// Level of the manipulandum (m), from the upper stop (E).
const LEVEL: f64 = 25.4e-3;

/// Times of the hand's way there, and of its rest after it (s of the hand).
const APPROACH: f64 = 0.7;
const WAIT: f64 = 0.8;

/// Time of the hand before the model's time 0 (s of the hand).
pub(super) const LEAD_IN: f64 = APPROACH + WAIT;

#[derive(Clone, Copy, Debug)]
pub(super) struct RigValue {
    pub(super) title: &'static str,
    pub(super) value: f64,
    pub(super) unit: &'static str,
    pub(super) source: &'static str,
}

pub(super) fn values() -> Vec<RigValue> {
    const PAPER: &str = "the paper, section 6";
    const ESTIMATE: &str = "estimate";
    let value = |title, value, unit, source| RigValue { title, value, unit, source };
    vec![
        value("line of the encoder", 1e3 * LINE, "mm", PAPER),
        value("travel of the handle, for 45°", 1e3 * TRAVEL, "mm", PAPER),
        value("moving mass of the handle", HANDLE.mass, "kg", ESTIMATE),
        value("damping of the handle", HANDLE.damping, "N·s/m", ESTIMATE),
        value("friction of the handle, moving", HANDLE.coulomb, "N", ESTIMATE),
        value("friction of the handle, at rest", HANDLE.stiction, "N", ESTIMATE),
        value("largest force of the motor", MOTOR.limit, "N", ESTIMATE),
        value("bandwidth of the motor's current", MOTOR.bandwidth / TAU, "Hz", ESTIMATE),
        value("mass of the hand", HAND.mass, "kg", ESTIMATE),
        value("stiffness of the muscle", HAND.stiffness, "N/m", ESTIMATE),
        value("damping of the muscle", HAND.damping, "N·s/m", ESTIMATE),
        value("stiffness of the grip", HAND.pulp_stiffness, "N/m", ESTIMATE),
        value("damping of the grip", HAND.pulp_damping, "N·s/m", ESTIMATE),
    ]
}

/// Command of a practised hand: the way to the level, then the stroke, each advanced by the
/// deflection of its own spring under the expected force.
#[derive(Clone, Debug)]
pub(super) struct HandPath<S> {
    /// Stroke in model time: an angle with its rates (rad).
    pub(super) stroke: S,
    /// Force expected from the model (N), at multiples of `step` from 0 on.
    pub(super) expected: Vec<f64>,
    /// Model time between them (s).
    pub(super) step: f64,
    /// Lever of the finger (m).
    pub(super) lever: f64,
    pub(super) time_scale: f64,
}

impl<S: Fn(f64) -> Motion> HandPath<S> {
    /// Returns the command at `t` (s of the hand), with 0 at the model's 0.
    pub(super) fn command(&self, t: f64) -> MuscleCommand {
        let (way, rate) = approach((t + LEAD_IN) / APPROACH);
        let stroke = (self.stroke)(t * self.time_scale);
        let velocity = self.lever * self.time_scale * stroke.rate;
        let acceleration = self.lever * self.time_scale * self.time_scale * stroke.acceleration;
        let (force, slope) = self.expected(t * self.time_scale);
        let grip = force + HANDLE.mass * acceleration + HANDLE.damping * velocity;
        let muscle = grip + HAND.mass * acceleration;
        let place = self.lever * stroke.position;
        let gives = grip / HAND.pulp_stiffness + muscle / HAND.stiffness;
        let gives_rate =
            slope * self.time_scale * (1.0 / HAND.pulp_stiffness + 1.0 / HAND.stiffness);
        MuscleCommand {
            position: LEVEL * way + place + gives,
            velocity: LEVEL * rate / APPROACH + velocity + gives_rate,
        }
    }

    /// Returns the expected force (N) and its slope (N/s) at model time `t` (s); constant before 0.
    fn expected(&self, t: f64) -> (f64, f64) {
        let place = (t / self.step).max(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
        let index = place as usize;
        match self.expected.get(index..) {
            Some([from, to, ..]) if t >= 0.0 => {
                (from + (place - index as f64) * (to - from), (to - from) / self.step)
            }
            Some([force, ..]) => (*force, 0.0),
            _ => (self.expected.last().copied().unwrap_or(0.0), 0.0),
        }
    }
}

fn approach(x: f64) -> (f64, f64) {
    let x = x.clamp(0.0, 1.0);
    (x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x))
}
