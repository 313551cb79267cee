//! The paper's experiment: hand, encoder, model, motor, key, and the hand again.

use haptics::{KeyRig, MuscleCommand};
use instruments::SmallModel;
use pode::Motion;

use super::hand::{HandPath, LEAD_IN, RIG};
use super::model_run::{ModelRun, still};
use super::{located::located, sampled::SampledModel};

/// A step of the model (s). `[GC93]` §6
pub const STEP: f64 = 2e-3;

/// The paper's servo cycle (s of the hand). `[GC93]` §6
pub const SERVO: f64 = 7e-3;

/// Allowed model seconds per second of the hand: a rig takes cycles of up to 20 ms.
pub const TIME_SCALES: (f64, f64) = (0.1, 1.0);

/// Speed of model time relative to the hand's time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Pace {
    time_scale: f64,
}

impl Pace {
    /// The paper's pace: a step of 2 ms each 7 ms.
    pub const PAPER: Self = Self { time_scale: STEP / SERVO };
    /// Equal times: a step of 2 ms each 2 ms.
    pub const SAME: Self = Self { time_scale: 1.0 };

    /// Returns the pace of `time_scale`, if it is within [`TIME_SCALES`].
    pub fn of(time_scale: f64) -> Option<Self> {
        let (low, high) = TIME_SCALES;
        (low..=high).contains(&time_scale).then_some(Self { time_scale })
    }

    pub const fn time_scale(self) -> f64 {
        self.time_scale
    }

    /// Returns the time between samples (s of the hand).
    pub fn servo(self) -> f64 {
        STEP / self.time_scale
    }
}

/// State of the rig at the end of a servo cycle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RigRow {
    /// True angle of the manipulandum (rad), from the zero of the encoder.
    pub angle: f64,
    /// Its rate per model second (rad/s).
    pub rate: f64,
    /// Force of the motor (N), up positive.
    pub motor: f64,
    /// Force of the handle on the hand (N), up positive.
    pub hand: f64,
}

/// A run of the closed loop, and its gesture stepped in two better ways.
#[derive(Clone, PartialEq, Debug)]
pub struct ClosedLoop {
    pub pace: Pace,
    pub paper: ModelRun,
    /// Same samples, held, with located events.
    pub located: ModelRun,
    /// True motion of the handle between the samples, with located events.
    pub exact: ModelRun,
    pub rig: Vec<RigRow>,
}

struct Servo<'a, S> {
    rig: KeyRig,
    path: HandPath<S>,
    pace: Pace,
    model: SampledModel<'a>,
    /// Commanded force (N).
    force: f64,
    /// Position of the encoder's zero (m).
    zero: f64,
}

impl<'a, S: Fn(f64) -> Motion + Copy> Servo<'a, S> {
    /// Returns the loop before the lead-in, with the model at rest.
    fn new(model: &'a SmallModel, pace: Pace, cycles: usize, stroke: S) -> Self {
        let expected =
            located(model, (STEP, cycles), |tick, theta| stroke((tick as f64 + theta) * STEP));
        let path = HandPath {
            stroke,
            expected: expected.rows.iter().map(|row| row.f_ku).collect(),
            step: STEP,
            lever: 1.0 / model.input_per_metre(),
            time_scale: pace.time_scale,
        };
        let sampled = SampledModel::new(model, STEP);
        let force = sampled.force();
        Self { rig: KeyRig::new(RIG), path, pace, model: sampled, force, zero: 0.0 }
    }

    /// Brings the handle to its level under the force of the model at rest, and zeroes the encoder.
    fn lead_in(&mut self) {
        let cycles = (LEAD_IN / self.pace.servo()).ceil();
        let mut cycle = -cycles;
        while cycle < 0.0 {
            self.advance_rig(cycle * self.pace.servo());
            cycle += 1.0;
        }
        self.zero = self.encoder();
    }

    /// Runs one cycle: poll the sensor, integrate a step, check the guards, send the force.
    fn cycle(&mut self, number: usize) -> (f64, RigRow) {
        let s = self.angle(self.encoder());
        self.force = self.model.advance(s);
        self.advance_rig(number as f64 * self.pace.servo());
        (s, self.row())
    }

    fn advance_rig(&mut self, t: f64) {
        let path = &self.path;
        let command = |t: f64| -> MuscleCommand { path.command(t) };
        self.rig.follow(t, self.pace.servo(), self.force, command);
    }

    /// Returns the reading of the encoder (m).
    fn encoder(&self) -> f64 {
        f64::from(self.rig.counts()) * self.rig.quantum()
    }

    /// Returns the angle at a position (m), in rad.
    fn angle(&self, position: f64) -> f64 {
        (position - self.zero) / self.path.lever
    }

    fn row(&self) -> RigRow {
        RigRow {
            angle: self.angle(self.rig.position()),
            rate: self.rig.velocity() / (self.path.lever * self.pace.time_scale),
            motor: self.rig.motor_force(),
            hand: self.rig.finger_force(),
        }
    }
}

/// Runs the closed loop until the model's time `until` (s), under a hand that plays `stroke`.
pub(super) fn closed_loop(
    model: &SmallModel,
    pace: Pace,
    until: f64,
    stroke: impl Fn(f64) -> Motion + Copy,
) -> ClosedLoop {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few thousand")]
    let cycles = (until / STEP).round() as usize;
    let mut servo = Servo::new(model, pace, cycles, stroke);
    servo.lead_in();
    let mut rows = vec![servo.row()];
    let mut samples = Vec::new();
    for number in 0..cycles {
        let (s, row) = servo.cycle(number);
        samples.push(s);
        rows.push(row);
    }
    let span = (STEP, cycles);
    ClosedLoop {
        pace,
        paper: servo.model.finish(),
        located: located(model, span, |tick, _theta| still(samples[tick])),
        exact: located(model, span, |tick, theta| between([rows[tick], rows[tick + 1]], theta)),
        rig: rows,
    }
}

/// Returns angle and rate between the ends of a cycle, by the cubic through both of theirs.
fn between([from, to]: [RigRow; 2], theta: f64) -> Motion {
    let (x, rest) = (theta, 1.0 - theta);
    let angles = from.angle * rest * rest * (1.0 + 2.0 * x) + to.angle * x * x * (3.0 - 2.0 * x);
    let rates = STEP * (from.rate * x * rest * rest - to.rate * x * x * rest);
    let slope = 6.0 * x * rest * (to.angle - from.angle) / STEP;
    let rate = slope + from.rate * rest * (rest - 2.0 * x) + to.rate * x * (x - 2.0 * rest);
    Motion { rate, ..still(angles + rates) }
}
