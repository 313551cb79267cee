//! One closed loop, knocked once and then left alone.
//!
//! Key, encoder, motor and finger are `haptics::plant`'s. A sample is read at the start of each
//! period; its force acts after the delay and is held until the next. The plant's step is a tenth
//! of m / b, or a four-thousandth of the period if that is longer: the key's damping is implicit.

use std::{collections::VecDeque, f64::consts::TAU};

use haptics::{Felt, FingerParameters, Gesture, KeyRig, RigParameters, plant::MAX_SUBSTEP};

use super::judge::{LoopVerdict, WindowSums, judge};
use super::quantity::{LoopQuantity, LoopValues};
use super::voice::{TrialAnswer, TrialVoice};

/// Maximum steps of the plant per period, and minimum for a key that moves freely: its steps are of
/// first order, and place a boundary half a step too high.
const MOST_STEPS: f64 = 4000.0;
const FREE_STEPS: f64 = 200.0;
/// Minimum steps of a key between its felts: the host's number at 1 kHz.
const FELT_STEPS: f64 = 20.0;

/// Displacement beyond which the loop counts as diverged (m).
const FAR: f64 = 1.0;

/// Depth of a pressing finger (m).
const PRESSED: f64 = 5e-3;

/// Ratio of stiction to kinetic friction.
const STICTION: f64 = 1.2;

/// A knock, with the waiting times.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct LoopKnock {
    /// Rest before the knock (s).
    settle: f64,
    /// Force (N) and duration (s) of a weight.
    weight: f64,
    duration: f64,
    /// Length of each of the four windows after it (s).
    window: f64,
}

impl LoopKnock {
    /// A tap on a wall: it moves a key by about a millimetre.
    pub(super) const TAP: Self = Self { settle: 0.1, weight: 1.0, duration: 10e-3, window: 0.1 };

    /// A stroke of an action: the key reaches its bed and is released, and its hammer strikes.
    pub(super) const STROKE: Self = Self { settle: 0.3, weight: 3.0, duration: 0.3, window: 0.4 };

    /// Returns the ticks of `period` (s) of rest, knock and window: at least 100, 10 and 100.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousands")]
    fn ticks(&self, period: f64) -> [u64; 3] {
        let ticks = |time: f64, least: f64| (time / period).ceil().max(least) as u64;
        [ticks(self.settle, 100.0), ticks(self.duration, 10.0), ticks(self.window, 100.0)]
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum KeyTravel {
    Free,
    /// Bounded by rest and bed.
    Felts,
}

struct TrialPlant {
    rig: KeyRig,
    finger: Option<Gesture>,
    /// Step (s), steps of a period, and of the delay.
    step: f64,
    steps: u64,
    delay: u64,
    has_steps: bool,
    /// Delayed forces, with the step at which they act.
    coming: VecDeque<(u64, f64)>,
    force: f64,
    now: u64,
}

impl TrialPlant {
    fn new(base: &RigParameters, travel: KeyTravel, values: &LoopValues) -> Self {
        let get = |quantity| values.get(quantity);
        let period = get(LoopQuantity::Period);
        let constant = get(LoopQuantity::Mass) / get(LoopQuantity::DeviceDamping).max(1e-9);
        let step = MAX_SUBSTEP.min(0.1 * constant);
        let fewest = if travel == KeyTravel::Free { FREE_STEPS } else { FELT_STEPS };
        let steps = (period / step).ceil().clamp(fewest, MOST_STEPS);
        let step = period / steps;
        let finger = finger(get(LoopQuantity::Finger));
        let rig = KeyRig::new(rig(base, travel, values));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "not negative")]
        let whole = |steps: f64| steps.round() as u64;
        Self {
            rig,
            finger: finger.map(|_corner| Gesture { hold: PRESSED, ..Gesture::USUAL }),
            step,
            steps: whole(steps),
            delay: whole(get(LoopQuantity::Delay) / step),
            has_steps: get(LoopQuantity::EncoderStep) > 0.0,
            coming: VecDeque::new(),
            force: 0.0,
            now: 0,
        }
    }

    /// Returns the reading of the encoder (m).
    fn reading(&self) -> f64 {
        if self.has_steps {
            f64::from(self.rig.counts()) * self.rig.quantum()
        } else {
            self.rig.position()
        }
    }

    /// Runs a period with `force` (N) sent at its start, and adds each step to `sums`.
    fn advance(&mut self, force: f64, sums: &mut WindowSums) {
        self.coming.push_back((self.now + self.delay, force));
        for _ in 0..self.steps {
            while let Some((_, force)) = self.coming.front().copied().filter(|it| it.0 <= self.now)
            {
                self.force = force;
                self.coming.pop_front();
            }
            let t = self.now as f64 * self.step;
            self.rig.advance(t, self.step, self.force, self.finger.as_ref());
            self.now += 1;
            sums.enter(self.rig.velocity(), self.force);
        }
    }

    fn is_gone(&self) -> bool {
        let position = self.rig.position();
        position.is_nan() || position.abs() > FAR
    }
}

fn finger(number: f64) -> Option<FingerParameters> {
    match number {
        ..0.5 => None,
        0.5..1.5 => Some(FingerParameters::LIMP),
        1.5..2.5 => Some(FingerParameters::ORDINARY),
        _ => Some(FingerParameters::STIFF),
    }
}

fn rig(base: &RigParameters, travel: KeyTravel, values: &LoopValues) -> RigParameters {
    let get = |quantity| values.get(quantity);
    let mut rig = *base;
    rig.key.mass = get(LoopQuantity::Mass);
    rig.key.damping = get(LoopQuantity::DeviceDamping);
    rig.key.coulomb = get(LoopQuantity::Friction);
    rig.key.stiction = STICTION * rig.key.coulomb;
    let bandwidth = get(LoopQuantity::Bandwidth);
    rig.motor.bandwidth = if bandwidth > 0.0 { TAU * bandwidth } else { f64::INFINITY };
    let step = get(LoopQuantity::EncoderStep);
    rig.quantum = if step > 0.0 { step } else { base.quantum };
    rig.finger = finger(get(LoopQuantity::Finger)).unwrap_or(base.finger);
    if travel == KeyTravel::Free {
        // A felt without stiffness leaves the key's position unbounded.
        let nothing = Felt { position: 0.0, stiffness: f64::MIN_POSITIVE, damping: 0.0 };
        (rig.key.rest_stop, rig.key.bottom_stop) = (nothing, nothing);
        rig.key.weight = 0.0;
        rig.motor.limit = f64::INFINITY;
        rig.motor.delay_steps = 0;
    }
    rig
}

/// Runs a loop with one knock and judges it.
pub(super) fn run(
    (base, travel): (&RigParameters, KeyTravel),
    values: &LoopValues,
    knock: &LoopKnock,
    voice: &mut dyn TrialVoice,
) -> LoopVerdict {
    let mut plant = TrialPlant::new(base, travel, values);
    let [settle, pressed, window] = knock.ticks(values.get(LoopQuantity::Period));
    let begin = settle + pressed;
    let mut before = WindowSums::default();
    let mut windows = [WindowSums::default(); 4];
    for tick in 0..begin + 4 * window {
        if tick == settle || tick == begin {
            plant.rig.lay(if tick == settle { knock.weight } else { 0.0 });
        }
        let force = match voice.answer(tick, plant.reading()) {
            TrialAnswer::Force(force) => force,
            TrialAnswer::Muted => return LoopVerdict::MakesEnergy,
            TrialAnswer::Failed => return LoopVerdict::Fails,
        };
        let place = tick.checked_sub(begin).and_then(|it| usize::try_from(it / window).ok());
        let sums = place.and_then(|it| windows.get_mut(it)).unwrap_or(&mut before);
        plant.advance(force, sums);
        if plant.is_gone() {
            return LoopVerdict::MakesEnergy;
        }
    }
    judge(&windows)
}
