//! Model B's equations, by hand, in the form that generated ones will take.

use pode::math::{cos, sin_cos_of_two, sqrt};
use pode::series::{Expansion, INPUT_TERMS};
use pode::{
    Enclosure, Energetic, EnergyBalance, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue,
    Guarded, Model, Motion, Nature, Part, ReadoutSlopes, Reset, Resets, Sloped,
};

use super::{KeyHammerSprings, Mode, series};
use crate::bounds::TermBound;
use crate::key_hammer::{Coupled, KeyHammerValues, below_string, gap, gap_bound};

const RELEASE: GuardId = GuardId(0);
const LAND: GuardId = GuardId(1);
/// The hammer meets the string.
pub(super) const STRING: GuardId = GuardId(2);
/// On the crossing only: a hammer that the key has pushed through the string stays there.
/// Putting it back when the mode changes would squeeze it into the key.
const STRING_SPEC: GuardSpec = GuardSpec::new(2, "string").on_crossing().of_state();

const B1: [GuardSpec; 2] = [GuardSpec::new(0, "release").of_state(), STRING_SPEC];
const B2: [GuardSpec; 2] = [GuardSpec::new(1, "land").of_state(), STRING_SPEC];

/// The place of the hammer among the parts of B2; the other is the key.
const HAMMER: usize = 0;

/// Hammer and key as the parts of B2, where the key's equations have this nature.
pub(super) fn apart(p: &KeyHammerValues, key: Nature) -> [Part; 2] {
    let rate = sqrt((p.m2 * p.g * p.l2).abs() / p.jh);
    let hammer = Part::of(&[0, 2])
        .of_state()
        .with_nature(Nature::new(EquationKind::Conservative, rate))
        .with_longest_step(RADIANS / rate);
    [hammer, Part::of(&[1, 3]).with_nature(key)]
}

/// The spring k2 and the slider.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    /// Compression of k2 (m).
    pub(super) q4: f64,
    /// Its rate (m/s).
    pub(super) q4_rate: f64,
    /// Position of the slider along H (m).
    pub(super) q3: f64,
    /// k2 q4 (N).
    spring: f64,
    /// The felt's factor on it, 1 + c2 q4': never below 0, so that it never pulls.
    felt: f64,
    /// cos δ, δ = θk − θh.
    pub(super) cos_delta: f64,
    /// ∂q4/∂θh = −q3 / cos δ (m/rad).
    pub(super) per_hammer: f64,
    /// ∂q4/∂θk = L1 + q4 tan δ (m/rad).
    pub(super) per_key: f64,
    /// Sines and cosines of θh and θk.
    sin_h: f64,
    sin_k: f64,
    cos_h: f64,
    cos_k: f64,
}

impl Contact {
    /// What the felt stores and takes.
    #[inline]
    fn balance(&self) -> EnergyBalance {
        EnergyBalance {
            energy: 0.5 * self.spring * self.q4,
            supplied: 0.0,
            dissipated: (self.force() - self.spring) * self.q4_rate,
        }
    }

    /// `F_KH` (N).
    pub(super) fn force(&self) -> f64 {
        self.spring * self.felt
    }
}

impl KeyHammerSprings {
    /// q4 = (L1 sin δ − L4 cos θh + L3 sin θh)/cos δ, q3 = (L1 − L3 cos θk − L4 sin θk)/cos δ.
    #[expect(clippy::inline_always, reason = "a call hands over nine numbers through memory")]
    #[inline(always)]
    pub(super) fn contact(&self, x: &[f64; 4]) -> Contact {
        let p = &self.values;
        let ([sin_h, sin_k], [cos_h, cos_k]) = sin_cos_of_two([x[0], x[1]]);
        let sin_d = sin_k * cos_h - cos_k * sin_h;
        let cos_delta = cos_k * cos_h + sin_k * sin_h;
        let secant = 1.0 / cos_delta;
        let q4 = (p.l1 * sin_d - p.l4 * cos_h + p.l3 * sin_h) * secant;
        let q3 = (p.l1 - p.l3 * cos_k - p.l4 * sin_k) * secant;
        let per_hammer = -q3 * secant;
        let per_key = p.l1 + q4 * (sin_d * secant);
        let q4_rate = per_hammer * x[2] + per_key * x[3];
        let (spring, stiffer) = (p.k2 * q4, 1.0 + p.c2 * q4_rate);
        let felt = if stiffer > 0.0 { stiffer } else { 0.0 };
        Contact {
            q4,
            q4_rate,
            q3,
            spring,
            felt,
            cos_delta,
            per_hammer,
            per_key,
            sin_h,
            sin_k,
            cos_h,
            cos_k,
        }
    }

    /// F_KU as a torque: k1 (s − θk) + b1 (s' − θk') (N·m).
    #[inline]
    pub(super) fn coupling(&self, x: &[f64; 4], s: &Motion) -> f64 {
        self.values.k1 * (s.position - x[1]) + self.values.b1 * (s.rate - x[3])
    }

    /// θh'' and θk'' without the contact's force (rad/s²).
    #[inline]
    fn free(&self, x: &[f64; 4], s: &Motion, (cos_h, cos_k): (f64, f64)) -> [f64; 2] {
        let [hammer, key] = self.weights;
        [-hammer * cos_h, self.coupling(x, s) * self.per_inertia[1] - key * cos_k]
    }

    /// What the contact's force adds to them.
    #[inline]
    fn pushed(&self, contact: &Contact) -> [f64; 2] {
        // The felt's factor is known last: the depth of the formula is the time that it takes.
        let by = |per_angle: f64, per_inertia: f64| {
            -(contact.spring * per_angle * per_inertia) * contact.felt
        };
        let [hammer, key] = self.per_inertia;
        [by(contact.per_hammer, hammer), by(contact.per_key, key)]
    }

    /// At rest in B1 with the manipulandum at `s`: Newton on both balances.
    pub(super) fn equilibrium(&self, s: f64) -> [f64; 4] {
        /// From the rigid geometry Newton needs 4–6 rounds; 40 leave room for soft springs.
        const ROUNDS: usize = 40;
        let input = Motion { position: s, ..Motion::default() };
        let mut x = [Coupled::on_key(&self.values, &input).angle, s, 0.0, 0.0];
        for _ in 0..ROUNDS {
            let f = self.imbalance(x, &input);
            let [[a, c], [b, d]] = [0, 1].map(|j| self.imbalance_per(j, x, &input));
            let determinant = a * d - b * c;
            let step = [(d * f[0] - b * f[1]) / determinant, (a * f[1] - c * f[0]) / determinant];
            x[0] -= step[0];
            x[1] -= step[1];
            if step[0].abs().max(step[1].abs()) < 1e-16 {
                break;
            }
        }
        x
    }

    /// θh'' and θk'' in B1 (rad/s²).
    fn imbalance(&self, x: [f64; 4], s: &Motion) -> [f64; 2] {
        let [_, _, hammer, key] = self.derivative(Mode::B1, &x, s);
        [hammer, key]
    }

    /// The same per radian of the angle `j`, by a central difference.
    fn imbalance_per(&self, j: usize, x: [f64; 4], s: &Motion) -> [f64; 2] {
        const STEP: f64 = 1e-7;
        let (mut up, mut down) = (x, x);
        up[j] += STEP;
        down[j] -= STEP;
        let (up, down) = (self.imbalance(up, s), self.imbalance(down, s));
        [0, 1].map(|i| (up[i] - down[i]) / (2.0 * STEP))
    }
}

impl Model for KeyHammerSprings {
    type Mode = Mode;
    type State = [f64; 4];
    type Input = Motion;
    const COORDS: usize = 2;

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn derivative(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let [hammer, key] = match mode {
            Mode::B1 => {
                let contact = self.contact(x);
                let free = self.free(x, s, (contact.cos_h, contact.cos_k));
                let pushed = self.pushed(&contact);
                [free[0] + pushed[0], free[1] + pushed[1]]
            }
            Mode::B2 => {
                let (_, [cos_h, cos_k]) = sin_cos_of_two([x[0], x[1]]);
                self.free(x, s, (cos_h, cos_k))
            }
        };
        [x[2], x[3], hammer, key]
    }

    /// Hammer and key apart are two systems of one degree of freedom (`[GC93]` table 1).
    #[inline]
    fn parts(&self, mode: Mode) -> &[Part] {
        match mode {
            Mode::B1 => &[Part::WHOLE],
            Mode::B2 => &self.apart,
        }
    }

    #[inline]
    fn derivative_of(&self, _mode: Mode, index: usize, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let [hammer, key] = self.weights;
        if index == HAMMER {
            [x[2], 0.0, -hammer * cos(x[0]), 0.0]
        } else {
            let pushed = self.coupling(x, s) * self.per_inertia[1];
            [0.0, x[3], 0.0, pushed - key * cos(x[1])]
        }
    }

    #[inline]
    fn readout(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.coupling(x, s)
    }

    /// A felt has no series here.
    fn series(
        &self,
        mode: Mode,
        input: &[Motion; INPUT_TERMS],
        out: &mut Expansion<[f64; 4]>,
    ) -> bool {
        match mode {
            Mode::B1 if self.values.c2 != 0.0 => return false,
            Mode::B1 => series::coupled(&self.series, input, out),
            Mode::B2 => series::apart(&self.series, input, out),
        }
        true
    }

    fn nature(&self, mode: Mode) -> Nature {
        self.natures[mode as usize]
    }

    fn longest_step(&self, mode: Mode) -> f64 {
        match mode {
            Mode::B1 => self.longest_steps[0],
            Mode::B2 => self.longest_steps[1],
        }
    }
}

/// A step of the fastest oscillation (rad).
const RADIANS: f64 = 0.75;

/// Three quarters of a radian of the fastest oscillation in B1 and in B2 (s).
pub(super) fn longest_steps(p: &KeyHammerValues) -> [f64; 2] {
    oscillations(p).map(|rate| RADIANS / rate)
}

/// The constants of the Taylor series, in its order: lengths L1, L3, L4 (m), the angular
/// accelerations of the weights (rad/s²), k2/JH, k2/JK, k1/JK, b1/JK, the string's angle (rad).
pub(super) fn series_constants(p: &KeyHammerValues) -> [f64; 10] {
    let [hammer, key] = [p.m2 * p.g * p.l2 / p.jh, p.m1 * p.g * p.ck / p.jk];
    let springs = [p.k2 / p.jh, p.k2 / p.jk, p.k1 / p.jk, p.b1 / p.jk];
    let [by_hammer, by_key, coupling, damping] = springs;
    [p.l1, p.l3, p.l4, hammer, key, by_hammer, by_key, coupling, damping, p.string_angle]
}

/// What the equations of B1 and of B2 are like; the fastest rate is an oscillation's, with its
/// damper's on top.
pub(super) fn natures(p: &KeyHammerValues) -> [Nature; 2] {
    let is_lossless = p.b1 == 0.0 && p.c2 == 0.0;
    let kind = if is_lossless { EquationKind::Conservative } else { EquationKind::Smooth };
    oscillations(p).map(|rate| Nature::new(kind, rate + p.b1 / p.jk))
}

/// The fastest oscillation in B1 and in B2 (rad/s).
fn oscillations(p: &KeyHammerValues) -> [f64; 2] {
    let reach = p.l1 - p.l3;
    let contact = p.k2 * (p.l1 * p.l1 / p.jk + reach * reach / p.jh);
    [contact, 0.0].map(|contact| sqrt(p.k1 / p.jk + contact))
}

impl Guarded for KeyHammerSprings {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::B1 => &B1,
            Mode::B2 => &B2,
        }
    }

    #[expect(clippy::inline_always, reason = "asked for in every step, of every guard")]
    #[inline(always)]
    fn guard_bound(
        &self,
        _mode: Mode,
        guard: GuardId,
        over: &Enclosure<[f64; 4], Motion>,
    ) -> GuardBound {
        if guard == STRING {
            return over.entry(0);
        }
        gap_bound(
            &self.values,
            TermBound::entry::<0, 4, _>(over),
            TermBound::entry::<1, 4, _>(over),
        )
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn guard(&self, _mode: Mode, guard: GuardId, x: &[f64; 4], _s: &Motion) -> GuardValue {
        let gap = || gap(&self.values, (x[0], x[2]), (x[1], x[3]));
        match guard {
            // q4 cos δ: zero where q4 is, without a division, and just what lands.
            RELEASE => -gap(),
            LAND => gap(),
            _ => below_string(&self.values, (x[0], x[2])),
        }
    }
}

impl Resets for KeyHammerSprings {
    /// Release and landing keep the state; the string turns the hammer round.
    fn reset(&self, mode: Mode, guard: GuardId, x: &[f64; 4], _s: &Motion) -> Reset<Self> {
        let p = &self.values;
        match guard {
            RELEASE => Reset::to(Mode::B2, *x),
            LAND => Reset::to(Mode::B1, *x),
            _ => Reset::to(mode, [p.string_angle, x[1], -p.restitution * x[2], x[3]]),
        }
    }
}

impl Energetic for KeyHammerSprings {
    fn energy(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.balance_of_state(mode, x).energy + self.balance_of_input(mode, x, s).energy
    }

    fn supplied(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.coupling(x, s) * s.rate
    }

    fn dissipated(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.balance_of_state(mode, x).dissipated + self.balance_of_input(mode, x, s).dissipated
    }

    /// Motion, weight and the felt between hammer and key.
    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn balance_of_state(&self, mode: Mode, x: &[f64; 4]) -> EnergyBalance {
        let p = &self.values;
        let ([sin_h, sin_k], felt) = match mode {
            Mode::B1 => {
                let contact = self.contact(x);
                ([contact.sin_h, contact.sin_k], contact.balance())
            }
            Mode::B2 => (sin_cos_of_two([x[0], x[1]]).0, EnergyBalance::default()),
        };
        let own = EnergyBalance {
            energy: 0.5 * (p.jh * x[2] * x[2] + p.jk * x[3] * x[3])
                + self.moments[0] * sin_h
                + self.moments[1] * sin_k,
            ..EnergyBalance::default()
        };
        own + felt
    }

    /// The coupling k1 and b1.
    #[inline]
    fn balance_of_input(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> EnergyBalance {
        let (twist, slip) = (s.position - x[1], s.rate - x[3]);
        EnergyBalance {
            energy: 0.5 * self.values.k1 * twist * twist,
            supplied: self.supplied(mode, x, s),
            dissipated: self.values.b1 * slip * slip,
        }
    }
}

impl Sloped for KeyHammerSprings {
    fn slopes(&self, _mode: Mode, _x: &[f64; 4], _s: &Motion) -> ReadoutSlopes {
        ReadoutSlopes { per_position: self.values.k1, per_rate: self.values.b1 }
    }
}
