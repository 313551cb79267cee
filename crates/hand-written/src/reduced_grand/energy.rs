//! Where the energy is and where it goes.

use pode::{Energetic, Motion};

use super::forces::Pressed;
use super::{Mode, ReducedGrand};

impl ReducedGrand {
    /// In the felt between hammer and string: Ks (z − zs)^(ps+1)/(ps + 1) (J).
    fn in_string(&self, z: f64) -> f64 {
        let p = &self.values;
        self.string_spring(z) * (z - p.string) / (p.string_exponent + 1.0)
    }

    /// In the repetition spring: kr d²/2 (J).
    fn in_lever(&self, y: f64, z: f64) -> f64 {
        let squeeze = self.lever(y).height - z;
        0.5 * self.values.lever_stiffness * squeeze * squeeze
    }

    /// In what only some modes load (J).
    fn in_mode(&self, mode: Mode, x: &[f64; 4]) -> f64 {
        match mode {
            Mode::Stu | Mode::Stt => self.in_string(x[1]),
            Mode::RepH | Mode::RepL | Mode::Rep0 | Mode::Chk => self.in_lever(x[0], x[1]),
            Mode::Acc | Mode::Lo | Mode::Fla | Mode::Fll | Mode::Flt => 0.0,
        }
    }

    /// In the springs and felts of the key (J).
    fn in_key(&self, y: f64) -> f64 {
        let p = &self.values;
        let jack = p.jack_stiffness * p.jack_width * p.jack_width;
        jack * self.button_spring(y).area() + self.bed().energy(y - p.bed) + self.rail().energy(-y)
    }

    /// Taken by damping, dry friction and felts of the key (W).
    fn lost_in_key(&self, y: f64, u: f64) -> f64 {
        let p = &self.values;
        let felt = |it: Pressed, rate: f64| it.spring * (it.factor - 1.0) * rate;
        (p.friction * pode::math::tanh(u / p.friction_speed) + p.key_damping * u) * u
            + felt(self.bed().pressed(y - p.bed, u), u)
            + felt(self.rail().pressed(-y, -u), -u)
    }

    /// Taken by what only some modes load (W).
    fn lost_in_mode(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        let [y, z, u, w] = *x;
        match mode {
            Mode::Lo => {
                let head = self.at_button(y, u);
                (head.transmission - head.ratio) * u * self.jack_force(mode, x, s)
            }
            Mode::Stu | Mode::Stt => (self.string_force(z, w) - self.string_spring(z)) * w,
            Mode::RepH | Mode::RepL | Mode::Rep0 => {
                let lever = self.lever(y);
                let spring = self.values.lever_stiffness * (lever.height - z);
                (self.lever_force(&lever, x) - spring) * (lever.ratio * u - w)
            }
            Mode::Acc | Mode::Fla | Mode::Fll | Mode::Flt | Mode::Chk => 0.0,
        }
    }
}

impl Energetic for ReducedGrand {
    fn energy(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        let p = &self.values;
        let [y, z, u, w] = *x;
        let bent = s.position - y;
        0.5 * (p.key_mass * u * u + p.hammer_mass * w * w + p.coupling * bent * bent)
            + p.key_weight * y
            + p.hammer_mass * p.g * z
            + self.in_key(y)
            + self.in_mode(mode, x)
    }

    fn supplied(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.finger(x[0], x[2], s) * s.rate
    }

    fn dissipated(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        let p = &self.values;
        let [y, _, u, w] = *x;
        let slip = s.rate - u;
        p.coupling_damping * slip * slip
            + p.hammer_damping * w * w
            + self.lost_in_key(y, u)
            + self.lost_in_mode(mode, x, s)
    }
}
