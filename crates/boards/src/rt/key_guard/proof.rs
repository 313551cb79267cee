//! Proof that a motor moves its key in the correct direction, before any model may use it.
//!
//! ```text
//! Resting ─ still at its rest ─▶ Pushing down ─ moves down ─▶ Returning ─ is back ─▶ proven
//!    ▲                               │ nothing moves
//!    │                               ▼
//!    │                           Pushing up ─ moves down ─▶ Returning ─ is back ─▶ Reversed
//!    └── it did not return: a hand     │ nothing moves ─▶ Unmoved
//! ```
//!
//! Two motions must agree, and so must their pushes, so that a tapping finger proves nothing.
//!
//! A push grows by 0.1 N in 20 ms, so a free key starts gently and is released after 0.3 mm.
//! A key that is pressed or moves is not pushed: while it moves, it gets at most 1 N of its model's
//! force, held, until it has come to rest.

use super::super::key_fault::KeyFault;

/// Growth of a push (N/s), and its limit (N).
const GROWTH: f64 = 5.0;
const MOST: f64 = 1.5;

/// Path that counts as a motion (m).
const WAY: f64 = 0.3e-3;

/// Speed above which a hand has moved the key, not the push (m/s).
const SLOW: f64 = 0.08;

/// Distance from its start to which a key must return (m), and time limit (s).
const BACK: f64 = 0.15e-3;
const RETURN: f64 = 0.15;

/// Largest distance from rest (m), tremor (m), and duration before a push (s).
const REST: f64 = 1e-3;
const STILLNESS: f64 = 30e-6;
const STILL: f64 = 0.05;

/// Largest force without proof (N), and its duration on a key that stands still (s): a motor with
/// swapped wires would hold its key down.
const UNPROVEN: f64 = 1.0;
const HELD: f64 = 0.3;

/// Largest difference of the pushes of two agreeing motions (N).
const ALIKE: f64 = 0.2;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Push {
    Down,
    Up,
}

impl Push {
    /// Returns the force (N, up positive) of a push in this direction.
    const fn force(self, strength: f64) -> f64 {
        match self {
            Self::Down => -strength,
            Self::Up => strength,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum MotionSign {
    Right,
    Wrong,
}

/// A motion, and the push that began it (N).
#[derive(Clone, Copy, PartialEq, Debug)]
struct ProofMotion {
    shown: MotionSign,
    strength: f64,
}

impl ProofMotion {
    fn agrees_with(&self, other: &Self) -> bool {
        self.shown == other.shown && (self.strength - other.strength).abs() <= ALIKE
    }
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum ProofStage {
    /// It has been still at `place` (m) for so long (s).
    Resting {
        place: f64,
        still: f64,
    },
    /// It is pushed from `place` (m) with this force (N).
    Pushing {
        place: f64,
        push: Push,
        strength: f64,
    },
    /// It was released so long ago (s) and must return to `place` (m).
    Returning {
        place: f64,
        motion: ProofMotion,
        since: f64,
    },
    Proven,
    Failed(KeyFault),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct MotorProof {
    stage: ProofStage,
    /// Motion that the next one must agree with.
    before: Option<ProofMotion>,
    /// `true` if the key stood still under its force; it gets none until it has come to rest.
    is_limp: bool,
    /// Position at the last call (m).
    position: f64,
}

impl MotorProof {
    pub(super) const PROVEN: Self =
        Self { stage: ProofStage::Proven, before: None, is_limp: false, position: 0.0 };

    pub(super) const fn begin() -> Self {
        Self {
            stage: ProofStage::Resting { place: f64::INFINITY, still: 0.0 },
            before: None,
            is_limp: false,
            position: 0.0,
        }
    }

    pub(super) fn is_proven(&self) -> bool {
        self.stage == ProofStage::Proven
    }

    /// Returns `true` if the key was not pushed because it did not rest.
    pub(super) fn is_waiting(&self) -> bool {
        matches!(self.stage, ProofStage::Resting { .. })
    }

    pub(super) const fn fault(&self) -> Option<KeyFault> {
        match self.stage {
            ProofStage::Failed(fault) => Some(fault),
            ProofStage::Resting { .. }
            | ProofStage::Pushing { .. }
            | ProofStage::Returning { .. }
            | ProofStage::Proven => None,
        }
    }

    /// Continues with the key at `position` (m), `elapsed` (s) after the last call; returns the
    /// force to send (N, up positive) for the model's `wanted`.
    ///
    /// # Real-time
    /// Some ten operations.
    pub(super) fn step(&mut self, position: f64, elapsed: f64, wanted: f64) -> f64 {
        let force = self.advance(position, elapsed, wanted);
        self.position = position;
        force
    }

    fn advance(&mut self, position: f64, elapsed: f64, wanted: f64) -> f64 {
        match self.stage {
            ProofStage::Resting { place, still } => {
                let is_still = (position - place).abs() <= STILLNESS;
                let is_at_rest = position.abs() <= REST;
                let (place, still) =
                    if is_still { (place, still + elapsed) } else { (position, 0.0) };
                self.stage = if is_at_rest && STILL <= still {
                    ProofStage::Pushing { place: position, push: Push::Down, strength: 0.0 }
                } else {
                    ProofStage::Resting { place, still }
                };
                self.is_limp = !is_at_rest && (self.is_limp || HELD <= still);
                let is_free = is_at_rest || self.is_limp;
                if is_free { 0.0 } else { wanted.clamp(-UNPROVEN, UNPROVEN) }
            }
            ProofStage::Pushing { place, push, strength } => {
                let speed = (position - self.position).abs() / elapsed.max(1e-6);
                if SLOW < speed {
                    self.rest();
                    0.0
                } else {
                    self.push((place, position), push, strength + GROWTH * elapsed)
                }
            }
            ProofStage::Returning { place, motion, since } => {
                if (position - place).abs() <= BACK {
                    self.conclude(motion);
                } else if RETURN < since {
                    // A hand holds the key, and may have moved it.
                    self.rest();
                } else {
                    self.stage = ProofStage::Returning { place, motion, since: since + elapsed };
                }
                0.0
            }
            ProofStage::Proven => wanted,
            ProofStage::Failed(_) => 0.0,
        }
    }

    /// Pushes a key with `strength` (N), from `place` and now at `position` (m), until it moves.
    fn push(&mut self, (place, position): (f64, f64), push: Push, strength: f64) -> f64 {
        let shown = match (push, position - place) {
            (Push::Down, way) if WAY <= way => Some(MotionSign::Right),
            (Push::Down, way) if way <= -WAY => Some(MotionSign::Wrong),
            (Push::Up, way) if WAY <= way => Some(MotionSign::Wrong),
            (Push::Down | Push::Up, _) => None,
        };
        if let Some(shown) = shown {
            let motion = ProofMotion { shown, strength };
            self.stage = ProofStage::Returning { place, motion, since: 0.0 };
            return 0.0;
        }
        self.stage = match push {
            _ if strength < MOST => ProofStage::Pushing { place, push, strength },
            Push::Down => ProofStage::Pushing { place, push: Push::Up, strength: 0.0 },
            Push::Up => ProofStage::Failed(KeyFault::Unmoved),
        };
        push.force(strength.min(MOST))
    }

    fn conclude(&mut self, motion: ProofMotion) {
        let is_sure = self.before.replace(motion).is_some_and(|it| it.agrees_with(&motion));
        match motion.shown {
            _ if !is_sure => self.rest(),
            MotionSign::Right => self.stage = ProofStage::Proven,
            MotionSign::Wrong => self.stage = ProofStage::Failed(KeyFault::Reversed),
        }
    }

    const fn rest(&mut self) {
        self.stage = ProofStage::Resting { place: f64::INFINITY, still: 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use haptics::plant::{KeyRig, RigParameters};

    const H: f64 = 1e-3;

    /// Proves the motor of a simulated key that renders `gain` of its force, its sensor scaled by
    /// `scale`, while `hand` (N, down) presses; returns proof, duration (s), largest push (N).
    fn prove(gain: f64, scale: f64, hand: impl Fn(f64) -> f64) -> (MotorProof, f64, f64) {
        let mut rig = KeyRig::new(RigParameters::default());
        let (mut proof, mut force, mut most) = (MotorProof::begin(), 0.0, 0.0_f64);
        for n in 0..5_000_u32 {
            let t = f64::from(n) * H;
            rig.advance(t, H, gain * force - hand(t), None);
            force = proof.step(scale * rig.position(), H, 8.0);
            most = most.max(force.abs());
            if proof.is_proven() || proof.fault().is_some() {
                return (proof, t, most);
            }
        }
        (proof, 5.0, most)
    }

    #[test]
    fn a_motor_is_proven_in_half_a_second_with_less_than_a_newton() {
        let (proof, took, most) = prove(1.0, 1.0, |_| 0.0);
        assert!(proof.is_proven() && took < 0.6 && most <= 1.0, "{proof:?} {took} s {most} N");
    }

    #[test]
    fn exchanged_wires_a_turned_sensor_and_a_dead_motor_are_found() {
        for (gain, scale, fault) in [
            (-1.0, 1.0, KeyFault::Reversed),
            (1.0, -1.0, KeyFault::Reversed),
            (0.0, 1.0, KeyFault::Unmoved),
        ] {
            let (proof, took, most) = prove(gain, scale, |_| 0.0);
            assert_eq!(proof.fault(), Some(fault), "{gain} {scale}");
            assert!(took < 2.0 && most <= MOST, "{took} s {most} N");
        }
    }

    #[test]
    fn a_key_that_is_held_down_is_proven_once_it_is_let_go() {
        let (proof, took, most) = prove(1.0, 1.0, |t| if t < 1.0 { 3.0 } else { 0.0 });
        assert!(proof.is_proven() && 1.0 < took && took < 2.0 && most <= UNPROVEN, "{took} {most}");
        let (proof, _, most) = prove(-1.0, 1.0, |_| 3.0);
        assert!(proof.is_waiting() && most <= UNPROVEN, "{proof:?} {most}");
    }

    #[test]
    fn a_finger_that_presses_during_the_push_proves_nothing() {
        let taps = |t: f64| if t < 1.5 && (t * 8.0).fract() < 0.8 { 1.5 } else { 0.0 };
        let (proof, took, _) = prove(-1.0, 1.0, taps);
        assert_eq!(proof.fault(), Some(KeyFault::Reversed), "{took} s");
    }
}
