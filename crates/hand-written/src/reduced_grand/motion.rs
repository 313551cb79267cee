//! The equations of motion: the model's derivative in each mode.

use pode::{EquationKind, GuardValue, Model, Motion, Nature, Part, ReadoutSlopes, Sloped};

use super::geometry::CarriedHead;
use super::{Mode, ReducedGrand};

/// The key, with what it carries.
const KEY: Part = Part::of(&[0, 2]);

/// Longest step of a head in the air (s): its damping takes seconds.
const FALL: f64 = 0.05;

impl ReducedGrand {
    /// ζ and ζ' of a head that the key carries in `mode`, if it does.
    #[inline]
    fn place(&self, mode: Mode, y: f64) -> Option<(f64, f64)> {
        let straight = |head: CarriedHead| Some((head.height, head.ratio));
        match mode {
            Mode::Acc => straight(self.on_jack(y)),
            Mode::Lo => Some(self.let_off.head(&self.values, y)),
            Mode::Chk => straight(self.in_check(y)),
            Mode::Fla
            | Mode::Fll
            | Mode::Flt
            | Mode::Stu
            | Mode::Stt
            | Mode::RepH
            | Mode::RepL
            | Mode::Rep0 => None,
        }
    }

    /// What the finger pushes beyond the key's own load: Fu − S (N).
    #[inline]
    fn push(&self, x: &[f64; 4], s: &Motion) -> f64 {
        self.finger(x[0], x[2], s) - self.key_load(x[0], x[2])
    }

    /// Force on a carried head but for its ζ' y'': mh (ζ'' u² + g) + ch ζ' u (N).
    #[inline]
    fn burden(&self, head: &CarriedHead, u: f64) -> f64 {
        let p = &self.values;
        p.hammer_mass * (head.bend * u * u + p.g) + p.hammer_damping * head.ratio * u
    }

    /// mk + mh t ζ': the mass that the finger moves (kg).
    #[inline]
    fn carried_mass(&self, head: &CarriedHead) -> f64 {
        let p = &self.values;
        p.key_mass + p.hammer_mass * head.transmission * head.ratio
    }

    /// y'' with the head carried, under a further `push` on the key (m/s²).
    #[inline]
    fn with_head(&self, head: &CarriedHead, u: f64, push: f64) -> f64 {
        (push - head.transmission * self.burden(head, u)) / self.carried_mass(head)
    }

    /// The head on the jack in ACC and LO.
    #[inline]
    fn head_on_jack(&self, mode: Mode, y: f64, u: f64) -> CarriedHead {
        if mode == Mode::Lo { self.at_button(y, u) } else { self.on_jack(y) }
    }

    /// λ, the jack's force on the head in ACC and LO (N).
    pub(super) fn jack_force(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        let [y, _, u, _] = *x;
        let head = self.head_on_jack(mode, y, u);
        let acceleration = self.with_head(&head, u, self.push(x, s));
        self.values.hammer_mass * head.ratio * acceleration + self.burden(&head, u)
    }

    /// The force that would make the head go with a key that does not feel it (N), and its rate:
    /// mh ζ' (Fu − S)/mk + mh (ζ'' u² + g) + ch ζ' u.
    ///
    /// It is λ times (mk + mh t ζ')/mk: it vanishes with λ, and the let-off's friction, which
    /// is a part of t, is not in it.
    pub(super) fn lift_off(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> GuardValue {
        let p = &self.values;
        let [y, _, u, _] = *x;
        let head = self.head_on_jack(mode, y, u);
        let CarriedHead { ratio, bend, .. } = head;
        let push = self.push(x, s);
        let acceleration = self.with_head(&head, u, push);
        let push_rate =
            self.finger_rate(u, acceleration, s) - self.key_load_rate(y, u, acceleration);
        let driven = p.hammer_mass / p.key_mass;
        let rate = driven * (bend * u * push + ratio * push_rate)
            + 2.0 * p.hammer_mass * bend * u * acceleration
            + p.hammer_damping * (bend * u * u + ratio * acceleration);
        GuardValue::new(driven * ratio * push + self.burden(&head, u), rate)
    }

    /// The derivative with the head carried under a further `push` on the key.
    #[inline]
    fn move_together(&self, head: &CarriedHead, u: f64, push: f64) -> [f64; 4] {
        let acceleration = self.with_head(head, u, push);
        [u, head.ratio * u, acceleration, head.ratio * acceleration + head.bend * u * u]
    }

    /// The derivative with the head apart: `push` on the key, `lift` on the head (N).
    #[inline]
    fn move_apart(&self, x: &[f64; 4], push: f64, lift: f64) -> [f64; 4] {
        let p = &self.values;
        [x[2], x[3], push / p.key_mass, self.fall(x[3]) + lift / p.hammer_mass]
    }

    /// z'' of a head in the air that rises at `w` (m/s²).
    #[inline]
    fn fall(&self, w: f64) -> f64 {
        let p = &self.values;
        -p.g - p.hammer_damping / p.hammer_mass * w
    }
}

impl Model for ReducedGrand {
    type Mode = Mode;
    type State = [f64; 4];
    type Input = Motion;
    const COORDS: usize = 2;

    /// A head that the key carries goes where the key puts it: the key alone moves by equations.
    /// A head in the air falls by itself, whatever the key does.
    #[inline]
    fn parts(&self, mode: Mode) -> &[Part] {
        match mode {
            Mode::Acc | Mode::Lo | Mode::Chk => &[KEY],
            Mode::Fla | Mode::Fll | Mode::Flt => {
                const { &[KEY, Part::of(&[1, 3]).of_state().with_longest_step(FALL)] }
            }
            Mode::Stu | Mode::Stt | Mode::RepH | Mode::RepL | Mode::Rep0 => &[Part::WHOLE],
        }
    }

    #[inline]
    fn derivative(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let [y, z, u, w] = *x;
        let push = self.push(x, s);
        match mode {
            Mode::Acc => self.move_together(&self.on_jack(y), u, push),
            Mode::Lo => self.move_together(&self.at_button(y, u), u, push),
            Mode::Fla | Mode::Fll | Mode::Flt => self.move_apart(x, push, 0.0),
            Mode::Stu | Mode::Stt => self.move_apart(x, push, -self.string_force(z, w)),
            Mode::RepH | Mode::RepL | Mode::Rep0 => {
                let lever = self.lever(y);
                let force = self.lever_force(&lever, x);
                self.move_apart(x, push - lever.ratio * force, force)
            }
            Mode::Chk => {
                let (head, lever) = (self.in_check(y), self.lever(y));
                let spring = self.lever_under_check(y);
                self.move_together(&head, u, push + spring * (head.ratio - lever.ratio))
            }
        }
    }

    #[inline]
    fn derivative_of(&self, mode: Mode, index: usize, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        match (mode, index) {
            (Mode::Fla | Mode::Fll | Mode::Flt, 0) => {
                [x[2], 0.0, self.push(x, s) / self.values.key_mass, 0.0]
            }
            (Mode::Fla | Mode::Fll | Mode::Flt, _) => [0.0, x[3], 0.0, self.fall(x[3])],
            _ => self.derivative(mode, x, s),
        }
    }

    #[inline]
    fn readout(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.finger(x[0], x[2], s)
    }

    fn nature(&self, mode: Mode) -> Nature {
        Nature::new(EquationKind::Smooth, self.longest_steps.rate(mode))
    }

    fn longest_step(&self, mode: Mode) -> f64 {
        self.longest_steps.of(mode)
    }

    #[inline]
    fn longest_step_at(&self, mode: Mode, x: &[f64; 4], _s: &Motion) -> f64 {
        self.longest_steps.from(&self.values, mode, x)
    }

    /// A carried head is where the key puts it.
    #[inline]
    fn constrain(&self, mode: Mode, x: &[f64; 4], _s: &Motion) -> [f64; 4] {
        let [y, _, u, _] = *x;
        self.place(mode, y).map_or(*x, |(height, ratio)| [y, height, u, ratio * u])
    }

    /// 1 µm: what catches the head stands where key and head are, whatever the input.
    fn longest_projection(&self, _mode: Mode) -> f64 {
        1e-6
    }
}

impl Sloped for ReducedGrand {
    fn slopes(&self, _mode: Mode, _x: &[f64; 4], _s: &Motion) -> ReadoutSlopes {
        let p = &self.values;
        ReadoutSlopes { per_position: p.coupling, per_rate: p.coupling_damping }
    }
}
