//! Model A's equations, by hand, in the form that generated ones will take.

use pode::math::{cos, sin, sqrt};
use pode::{
    Enclosure, Energetic, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model,
    Motion, Nature, Part, Reset, Resets, Sloped,
};

use super::{KeyHammerRigid, Mode};
use crate::bounds::TermBound;
use crate::key_hammer::{Coupled, ReachBounds, below_string, gap, gap_bound};

const RELEASE: GuardId = GuardId(0);
const LAND: GuardId = GuardId(1);
/// The hammer meets the string.
pub(super) const STRING: GuardId = GuardId(2);
/// On the crossing only: a hammer that the key has pushed through the string stays there.
/// Putting it back when the mode changes would squeeze it into the key.
const STRING_SPEC: GuardSpec = GuardSpec::new(2, "string").on_crossing();

const A1: [GuardSpec; 1] = [GuardSpec::new(0, "release")];
const A2: [GuardSpec; 2] = [GuardSpec::new(1, "land"), STRING_SPEC];

impl KeyHammerRigid {
    /// M2 g L2 cos θh: the hammer's weight about its pivot (N·m).
    fn weight(&self, angle: f64) -> f64 {
        let p = &self.values;
        p.m2 * p.g * p.l2 * cos(angle)
    }

    /// `F_KH` (N) and `T_KU` (N·m).
    pub(super) fn forces(&self, mode: Mode, s: &Motion) -> (f64, f64) {
        let p = &self.values;
        let key = p.jk * s.acceleration + p.m1 * p.g * p.ck * cos(s.position);
        match mode {
            Mode::A1 => {
                let hammer = Coupled::on_key(p, s);
                let contact = self.contact(&hammer).value;
                (contact, key + contact * p.l1 * hammer.cos_delta)
            }
            Mode::A2 => (0.0, key),
        }
    }

    /// F_KH = (JH θh'' + M2 g L2 cos θh) / σ and its rate.
    fn contact(&self, hammer: &Coupled) -> GuardValue {
        let p = &self.values;
        let force = (p.jh * hammer.acceleration + self.weight(hammer.angle)) / hammer.reach;
        let rate = (p.jh * hammer.jerk
            - p.m2 * p.g * p.l2 * sin(hammer.angle) * hammer.rate
            - force * hammer.reach_rate)
            / hammer.reach;
        GuardValue::new(force, rate)
    }

    /// Bound of that force over a step that starts with the hammer at `angle`; its bend would
    /// take the input's fourth derivative.
    ///
    /// F = a s'' + b s'² + c with a = JH p r, b = −JH q r (1 − 2p) and c = W r cos θh, in
    /// terms of [`ReachBounds`]: their slopes by s are JH q r (3p − 1),
    /// −JH r (1 − 2p)(4q² + p − p²) and W r (q cos θh − p sin θh).
    fn contact_bound(&self, angle: f64, over: &Enclosure<[f64; 2], Motion>) -> GuardBound {
        let Some(most) = over.input else { return GuardBound::UNKNOWN };
        let values = &self.values;
        let ReachBounds { along: p, across: q, inverse: r } =
            ReachBounds::over(values, most.position);
        let rotation = p * over.h * most.rate;
        let sin = (angle.abs() + rotation).min(1.0);
        let turned = 1.0 + 2.0 * p;
        let a = values.jh * p * r;
        let a_slope = values.jh * q * r * (3.0 * p + 1.0);
        let b = values.jh * q * r * turned;
        let b_slope = values.jh * r * turned * (4.0 * q * q + p + p * p);
        let c_slope = (values.m2 * values.g * values.l2).abs() * r * (q + p * sin);
        let by_rate = (a_slope + 2.0 * b) * most.acceleration + b_slope * most.rate * most.rate;
        let speed = a * most.jerk + (by_rate + c_slope) * most.rate;
        GuardBound::new(over.h * speed, f64::INFINITY)
    }
}

impl Model for KeyHammerRigid {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;

    /// On the key the hammer goes where the key goes: nothing moves by itself (`[GC93]` table 1).
    fn parts(&self, mode: Mode) -> &[Part] {
        match mode {
            Mode::A1 => &[],
            Mode::A2 => &[Part::WHOLE],
        }
    }

    /// The hammer apart from the key: a pendulum upside down.
    fn derivative(&self, _mode: Mode, x: &[f64; 2], _s: &Motion) -> [f64; 2] {
        [x[1], -self.weight(x[0]) / self.values.jh]
    }

    fn nature(&self, mode: Mode) -> Nature {
        let p = &self.values;
        match mode {
            Mode::A1 => Nature::new(EquationKind::Linear, 0.0),
            Mode::A2 => Nature::new(EquationKind::Conservative, sqrt(p.m2 * p.g * p.l2 / p.jh)),
        }
    }

    fn readout(&self, mode: Mode, _x: &[f64; 2], s: &Motion) -> f64 {
        self.forces(mode, s).1
    }

    fn constrain(&self, mode: Mode, x: &[f64; 2], s: &Motion) -> [f64; 2] {
        match mode {
            Mode::A1 => {
                let hammer = Coupled::on_key(&self.values, s);
                [hammer.angle, hammer.rate]
            }
            Mode::A2 => *x,
        }
    }

    /// A little more than half a turn (rad): a hammer that the key has pushed through the string
    /// may come round and land from behind. Noise of 0.1 mm moves a catch by 0.02 rad.
    fn longest_projection(&self, mode: Mode) -> f64 {
        match mode {
            Mode::A1 => 4.0,
            Mode::A2 => f64::INFINITY,
        }
    }
}

impl Guarded for KeyHammerRigid {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::A1 => &A1,
            Mode::A2 => &A2,
        }
    }

    #[inline]
    fn guard_bound(
        &self,
        _mode: Mode,
        guard: GuardId,
        over: &Enclosure<[f64; 2], Motion>,
    ) -> GuardBound {
        match guard {
            RELEASE => self.contact_bound(over.start[0], over),
            LAND => {
                let hammer = TermBound::entry::<0, 2, _>(over);
                gap_bound(&self.values, hammer, TermBound::position(over))
            }
            _ => over.entry(0),
        }
    }

    fn guard(&self, _mode: Mode, guard: GuardId, x: &[f64; 2], s: &Motion) -> GuardValue {
        match guard {
            RELEASE => self.contact(&Coupled::on_key(&self.values, s)),
            LAND => gap(&self.values, (x[0], x[1]), (s.position, s.rate)),
            _ => below_string(&self.values, (x[0], x[1])),
        }
    }
}

impl Resets for KeyHammerRigid {
    /// Release keeps the state; landing is a plastic catch with its impulse on the key;
    /// the string turns the hammer round.
    fn reset(&self, _mode: Mode, guard: GuardId, x: &[f64; 2], s: &Motion) -> Reset<Self> {
        let p = &self.values;
        match guard {
            RELEASE => Reset::to(Mode::A2, *x),
            LAND => {
                let hammer = Coupled::on_key(p, s);
                let impulse = p.jh * (hammer.rate - x[1]) / hammer.reach;
                Reset::to(Mode::A1, [hammer.angle, hammer.rate])
                    .with_impulse(impulse * p.l1 * hammer.cos_delta)
            }
            _ => Reset::to(Mode::A2, [p.string_angle, -p.restitution * x[1]]),
        }
    }
}

impl Energetic for KeyHammerRigid {
    fn energy(&self, _mode: Mode, x: &[f64; 2], s: &Motion) -> f64 {
        let p = &self.values;
        0.5 * (p.jh * x[1] * x[1] + p.jk * s.rate * s.rate)
            + p.g * (p.m2 * p.l2 * sin(x[0]) + p.m1 * p.ck * sin(s.position))
    }

    fn supplied(&self, mode: Mode, x: &[f64; 2], s: &Motion) -> f64 {
        self.readout(mode, x, s) * s.rate
    }
}

impl Sloped for KeyHammerRigid {}
