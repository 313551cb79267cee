//! Model B as a model of `pode`, as a user writes it: equations, natures, bounds of guards.

use pode::math::{cos, sin_cos_of_two, sqrt};
use pode::series::{Expansion, INPUT_TERMS};
use pode::{
    Enclosure, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model, Motion,
    Nature, Part, Reset, Resets,
};

use super::series;
use crate::problems::{ModelB, ModelBMode as Mode};

const STRING: GuardId = GuardId(2);
const STRING_SPEC: GuardSpec = GuardSpec::new(2, "string").on_crossing().of_state();
const COUPLED: [GuardSpec; 2] = [GuardSpec::new(0, "release").of_state(), STRING_SPEC];
const APART: [GuardSpec; 2] = [GuardSpec::new(1, "land").of_state(), STRING_SPEC];

/// A step of the fastest oscillation (rad).
const RADIANS: f64 = 0.75;

/// Key and hammer, coupled by springs or apart. State: θh, θk (rad), θh', θk' (rad/s). Input:
/// the manipulandum's angle (rad).
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeyHammer {
    /// L1, L3, L4 (m), the angular accelerations of the weights of hammer and key (rad/s²),
    /// k2/JH, k2/JK, k1/JK, 0 for a damper, and the string's angle (rad), in the series' order.
    constants: [f64; 10],
    restitution: f64,
    /// Entries of hammer and key, which move apart in B2.
    apart: [Part; 2],
    /// Fastest rates in B1 and in B2 (rad/s).
    rates: [f64; 2],
}

impl KeyHammer {
    pub(crate) fn new(problem: &ModelB) -> Self {
        let ModelB { l: [l1, _, l3, l4], weights, k: [k1, k2], j: [jk, jh], string, .. } = *problem;
        let contact = k2 * (l1 * l1 / jk + (l1 - l3) * (l1 - l3) / jh);
        let rates = [contact, 0.0].map(|contact| sqrt(k1 / jk + contact));
        let nature = |rate| Nature::new(EquationKind::Conservative, rate);
        let swing = sqrt(weights[1] / jh);
        let hammer = Part::of(&[0, 2]).of_state().with_nature(nature(swing));
        let falling = [weights[1] / jh, weights[0] / jk];
        let [hammer_falls, key_falls] = falling;
        Self {
            constants: [
                l1,
                l3,
                l4,
                hammer_falls,
                key_falls,
                k2 / jh,
                k2 / jk,
                k1 / jk,
                0.0,
                string[0],
            ],
            restitution: string[1],
            apart: [
                hammer.with_longest_step(RADIANS / swing),
                Part::of(&[1, 3]).with_nature(nature(rates[1])),
            ],
            rates,
        }
    }

    /// Returns θh'' and θk'' without the contact (rad/s²).
    #[inline]
    fn free(&self, x: &[f64; 4], s: &Motion, [cos_h, cos_k]: [f64; 2]) -> [f64; 2] {
        let [_, _, _, hammer, key, _, _, coupling, ..] = self.constants;
        [-hammer * cos_h, coupling * (s.position - x[1]) - key * cos_k]
    }

    /// Returns the gap −q4 cos δ and its rate.
    #[inline]
    fn gap(&self, x: &[f64; 4]) -> GuardValue {
        let [l1, l3, l4, ..] = self.constants;
        let ([sin_h, sin_d], [cos_h, cos_d]) = sin_cos_of_two([x[0], x[1] - x[0]]);
        let rate = -(l4 * sin_h + l3 * cos_h) * x[2] - l1 * cos_d * (x[3] - x[2]);
        GuardValue::new(l4 * cos_h - l3 * sin_h - l1 * sin_d, rate)
    }
}

impl Model for KeyHammer {
    type Mode = Mode;
    type State = [f64; 4];
    type Input = Motion;
    const COORDS: usize = 2;

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn derivative(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let ([sin_h, sin_k], [cos_h, cos_k]) = sin_cos_of_two([x[0], x[1]]);
        let [hammer, key] = self.free(x, s, [cos_h, cos_k]);
        if mode == Mode::Apart {
            return [x[2], x[3], hammer, key];
        }
        let [l1, l3, l4, _, _, by_hammer, by_key, ..] = self.constants;
        let sin_d = sin_k * cos_h - cos_k * sin_h;
        let secant = 1.0 / (cos_k * cos_h + sin_k * sin_h);
        let q4 = (l1 * sin_d - l4 * cos_h + l3 * sin_h) * secant;
        let q3 = (l1 - l3 * cos_k - l4 * sin_k) * secant;
        let per_key = l1 + q4 * (sin_d * secant);
        [x[2], x[3], hammer + by_hammer * q4 * q3 * secant, key - by_key * q4 * per_key]
    }

    #[inline]
    fn parts(&self, mode: Mode) -> &[Part] {
        match mode {
            Mode::Coupled => &[Part::WHOLE],
            Mode::Apart => &self.apart,
        }
    }

    #[inline]
    fn derivative_of(&self, _mode: Mode, index: usize, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let [_, _, _, hammer, key, _, _, coupling, ..] = self.constants;
        if index == 0 {
            [x[2], 0.0, -hammer * cos(x[0]), 0.0]
        } else {
            [0.0, x[3], 0.0, coupling * (s.position - x[1]) - key * cos(x[1])]
        }
    }

    fn readout(&self, _mode: Mode, _x: &[f64; 4], _s: &Motion) -> f64 {
        0.0
    }

    fn nature(&self, mode: Mode) -> Nature {
        let rate = self.rates[mode as usize];
        Nature::new(EquationKind::Conservative, rate).with_longest_step(RADIANS / rate)
    }
}

impl Guarded for KeyHammer {
    fn series(
        &self,
        mode: Mode,
        input: &[Motion; INPUT_TERMS],
        out: &mut Expansion<[f64; 4]>,
    ) -> bool {
        match mode {
            Mode::Coupled => series::coupled(&self.constants, input, out),
            Mode::Apart => series::apart(&self.constants, input, out),
        }
        true
    }

    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Coupled => &COUPLED,
            Mode::Apart => &APART,
        }
    }

    /// Hammer and key move together, and the gap's slopes are small where they do:
    /// ∂/∂θh = (L1 − L3) cos θh − L4 sin θh + L1 (cos δ − cos θh); the last term is at most
    /// L1 |θk| (|θh| + |θk|/2). ∂²/∂θh² contains L1 sin δ + L3 sin θh, and sin δ + sin θh is at
    /// most |θk|. All other slopes are L1 sin δ.
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
        let [l1, l3, l4, ..] = self.constants;
        let size = |entry: usize| over.start[entry].abs() + over.moves[entry];
        let (hammer, key) = (size(0), size(1));
        let [fast_h, fast_k, ..] = over.speeds;
        let (apart, rise) = ((l1 - l3).abs(), l4.abs());
        let slope = apart + l1 * key * (hammer + 0.5 * key) + rise * hammer;
        let own = l1 * key + rise + apart * hammer;
        let mixed = l1 * (hammer + key).min(1.0);
        GuardBound::new(
            slope * over.moves[0] + l1 * over.moves[1],
            slope * over.bends[0]
                + l1 * over.bends[1]
                + own * fast_h * fast_h
                + mixed * fast_k * (fast_k + 2.0 * fast_h),
        )
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn guard(&self, mode: Mode, guard: GuardId, x: &[f64; 4], _s: &Motion) -> GuardValue {
        if guard == STRING {
            return GuardValue::new(self.constants[9] - x[0], -x[2]);
        }
        let gap = self.gap(x);
        match mode {
            Mode::Coupled => GuardValue::new(-gap.value, -gap.rate),
            Mode::Apart => gap,
        }
    }
}

impl Resets for KeyHammer {
    fn reset(&self, mode: Mode, guard: GuardId, x: &[f64; 4], _s: &Motion) -> Reset<Self> {
        if guard == STRING {
            let state = [self.constants[9], x[1], -self.restitution * x[2], x[3]];
            return Reset::to(mode, state);
        }
        match mode {
            Mode::Coupled => Reset::to(Mode::Apart, *x),
            Mode::Apart => Reset::to(Mode::Coupled, *x),
        }
    }
}
