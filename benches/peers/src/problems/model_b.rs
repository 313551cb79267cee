//! Model B, the paper's key and hammer with springs in the contacts, under a stroke.
//!
//! Written by hand from crates/instruments/src/key_hammer_springs/README.md, as the user of
//! another library would; a test compares it with `pode` at random states.

use std::fmt::Write as _;

use crate::problem::Problem;

/// Parameters, all SI, and the input s(t) = Σ A exp(−((t − tc)/w)²).
#[derive(Clone, Copy, Debug)]
pub(crate) struct ModelB {
    /// Distances of the geometry L1, L2, L3, L4 (m).
    pub(crate) l: [f64; 4],
    /// M1 g cK (N·m), M2 g L2 (N·m).
    pub(crate) weights: [f64; 2],
    /// Torsion spring k1 (N·m/rad) and contact spring k2 (N/m).
    pub(crate) k: [f64; 2],
    /// Inertias JK, JH (kg·m²).
    pub(crate) j: [f64; 2],
    /// Angle of the string (rad) and the impact's restitution.
    pub(crate) string: [f64; 2],
    /// (A (rad), tc (s), 1/w (1/s)) of each bell.
    pub(crate) bells: [[f64; 3]; 3],
    /// State at rest: θh, θk (rad), and their rates, which are 0.
    pub(crate) rest: [f64; 4],
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Mode {
    Coupled,
    Apart,
}

impl ModelB {
    pub(crate) fn lines(&self, t_end: f64) -> String {
        let names = "L1 L2 L3 L4 weight_key weight_hammer k1 k2 JK JH string restitution";
        let bells = self.bells.as_flattened();
        let values = [&self.l[..], &self.weights, &self.k, &self.j, &self.string];
        let values: Vec<f64> = values.concat();
        let mut lines = format!("problem model-b\nt_end {t_end:?}\n");
        let names = names.split(' ').map(str::to_owned);
        let bells = bells.iter().enumerate().map(|(i, value)| (format!("bell{i}"), *value));
        let rest = self.rest.iter().enumerate().map(|(i, value)| (format!("rest{i}"), *value));
        for (name, value) in names.zip(values).chain(bells).chain(rest) {
            let _ = writeln!(lines, "{name} {value:?}");
        }
        lines
    }

    #[inline]
    pub(crate) fn input(&self, t: f64) -> f64 {
        self.bells.iter().fold(0.0, |sum, [a, tc, per_w]| {
            let z = (t - tc) * per_w;
            sum + a * (-z * z).exp()
        })
    }

    /// Returns the gap −q4 cos δ (m), positive apart.
    #[inline]
    fn gap(&self, x: &[f64; 4]) -> f64 {
        let [l1, _, l3, l4] = self.l;
        let (sin, cos) = x[0].sin_cos();
        l4 * cos - l3 * sin - l1 * (x[1] - x[0]).sin()
    }

    #[inline]
    fn gap_rate(&self, x: &[f64; 4]) -> f64 {
        let [l1, _, l3, l4] = self.l;
        let (sin, cos) = x[0].sin_cos();
        -(l4 * sin + l3 * cos) * x[2] - l1 * (x[1] - x[0]).cos() * (x[3] - x[2])
    }

    /// Returns θh'' JH and θk'' JK of the contact spring, and cos θh, cos θk.
    #[inline]
    fn contact(&self, x: &[f64; 4]) -> ([f64; 2], [f64; 2]) {
        let [l1, _, l3, l4] = self.l;
        let ((sin_h, cos_h), (sin_k, cos_k)) = (x[0].sin_cos(), x[1].sin_cos());
        let sin_d = sin_k * cos_h - cos_k * sin_h;
        let secant = 1.0 / (cos_k * cos_h + sin_k * sin_h);
        let q4 = (l1 * sin_d - l4 * cos_h + l3 * sin_h) * secant;
        let q3 = (l1 - l3 * cos_k - l4 * sin_k) * secant;
        let force = self.k[1] * q4;
        ([force * q3 * secant, -force * (l1 + q4 * sin_d * secant)], [cos_h, cos_k])
    }
}

impl Problem<4, 2> for ModelB {
    type Mode = Mode;

    fn names(mode: Mode) -> [&'static str; 2] {
        match mode {
            Mode::Coupled => ["release", "string"],
            Mode::Apart => ["land", "string"],
        }
    }

    fn start(&self) -> (Mode, [f64; 4]) {
        (Mode::Coupled, self.rest)
    }

    #[inline]
    fn derivative(&self, mode: Mode, t: f64, x: &[f64; 4]) -> [f64; 4] {
        let ([hammer, key], [cos_h, cos_k]) = match mode {
            Mode::Coupled => self.contact(x),
            Mode::Apart => ([0.0; 2], [x[0].cos(), x[1].cos()]),
        };
        let drive = self.k[0] * (self.input(t) - x[1]);
        [
            x[2],
            x[3],
            (hammer - self.weights[1] * cos_h) / self.j[1],
            (drive + key - self.weights[0] * cos_k) / self.j[0],
        ]
    }

    #[inline]
    fn guards(&self, mode: Mode, x: &[f64; 4]) -> [f64; 2] {
        let gap = self.gap(x);
        let contact = if mode == Mode::Coupled { -gap } else { gap };
        [contact, self.string[0] - x[0]]
    }

    #[inline]
    fn guard_rates(&self, mode: Mode, x: &[f64; 4]) -> [f64; 2] {
        let rate = self.gap_rate(x);
        let contact = if mode == Mode::Coupled { -rate } else { rate };
        [contact, -x[2]]
    }

    #[inline]
    fn fire(&self, mode: Mode, guard: usize, x: &[f64; 4]) -> (Mode, [f64; 4]) {
        match (guard, mode) {
            (0, Mode::Coupled) => (Mode::Apart, *x),
            (0, Mode::Apart) => (Mode::Coupled, *x),
            _ => (mode, [self.string[0], x[1], -self.string[1] * x[2], x[3]]),
        }
    }

    /// One width of the narrowest bell, 0.06 s; a bell is four wide.
    fn longest_step(&self) -> f64 {
        let narrowest = self.bells.iter().fold(0.0, |most: f64, bell| most.max(bell[2]));
        2.0 / narrowest
    }
}
