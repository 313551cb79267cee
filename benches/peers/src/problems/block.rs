//! A block that rocks, slides and sticks: a rectangle on a level floor with Coulomb friction.
//!
//! In each mode one corner touches, and sticks or slides: six modes, with an impact at each
//! change of the corner. Forces and impulses are over the mass. The impact of a corner is
//! plastic (restitution 0), and Coulomb's law holds for its impulse.

use crate::problem::Problem;

/// State: the centre's position x (m), the angle θ (rad), and their rates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    /// Half width and half height (m).
    pub(crate) half: [f64; 2],
    /// Gravity (m/s²).
    pub(crate) g: f64,
    pub(crate) mu: f64,
    pub(crate) start: (Mode, [f64; 4]),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Mode {
    /// Touching corner: 1 right, −1 left.
    pub(crate) corner: i8,
    /// Direction of sliding: 1, −1, or 0 for sticking.
    pub(crate) slides: i8,
}

/// Accelerations and forces of a state, over the mass.
struct Motion {
    /// θ'' (rad/s²).
    turn: f64,
    /// Friction, which is x'', and the normal force (m/s²).
    along: f64,
    normal: f64,
    /// Vector of centre to corner (m).
    arm: [f64; 2],
}

impl Block {
    #[inline]
    fn inertia(&self) -> f64 {
        let [a, b] = self.half;
        (a * a + b * b) / 3.0
    }

    #[inline]
    fn arm(&self, corner: i8, angle: f64) -> [f64; 2] {
        let ([a, b], (sin, cos)) = (self.half, angle.sin_cos());
        let a = f64::from(corner) * a;
        [a * cos + b * sin, a * sin - b * cos]
    }

    #[inline]
    fn motion(&self, mode: Mode, x: &[f64; 4]) -> Motion {
        let [_, angle, _, rate] = *x;
        let arm @ [px, py] = self.arm(mode.corner, angle);
        let normal = |turn: f64| self.g - turn * px + rate * rate * py;
        if mode.slides == 0 {
            let turn = self.g * px / (4.0 * self.inertia());
            let along = turn * py + rate * rate * px;
            return Motion { turn, along, normal: normal(turn), arm };
        }
        let part = self.mu * f64::from(mode.slides);
        let lever = px + part * py;
        let turn = (self.g + rate * rate * py) * lever / (self.inertia() + px * lever);
        let normal = normal(turn);
        Motion { turn, along: -part * normal, normal, arm }
    }

    /// Returns the margin of the cone on one side, and its rate, where the corner sticks.
    #[inline]
    fn cone(&self, corner: i8, side: f64, x: &[f64; 4]) -> (f64, f64) {
        let Motion { turn, along, normal, arm: [px, py] } =
            self.motion(Mode { corner, slides: 0 }, x);
        let rate = x[3];
        let jerk = -self.g * rate * py / (4.0 * self.inertia());
        let along_rate = jerk * py + 3.0 * turn * rate * px - rate * rate * rate * py;
        let normal_rate = -jerk * px + 3.0 * turn * rate * py + rate * rate * rate * px;
        (self.mu * normal - side * along, self.mu * normal_rate - side * along_rate)
    }

    /// Returns the mode of a corner that has lost its speed: it sticks if the cone holds the force.
    fn stopped(&self, corner: i8, x: &[f64; 4]) -> Mode {
        let Motion { along, normal, .. } = self.motion(Mode { corner, slides: 0 }, x);
        let slides = match () {
            () if along.abs() <= self.mu * normal => 0,
            () if along > 0.0 => -1,
            () => 1,
        };
        Mode { corner, slides }
    }

    fn impact(&self, corner: i8, x: &[f64; 4]) -> (Mode, [f64; 4]) {
        let ([a, b], inertia) = (self.half, self.inertia());
        let a = f64::from(corner) * a;
        let [place, _, speed, rate] = *x;
        let (along, down) = (speed + rate * b, 2.0 * rate * a);
        let (tt, nn, tn) = (1.0 + b * b / inertia, 1.0 + a * a / inertia, a * b / inertia);
        let over = tt * nn - tn * tn;
        let stuck = [tn * down - nn * along, tn * along - tt * down].map(|it| it / over);
        let part = if stuck[0] > 0.0 { -self.mu } else { self.mu };
        let holds = stuck[0].abs() <= self.mu * stuck[1];
        let pn = if holds { stuck[1] } else { -down / (nn - part * tn) };
        let pt = if holds { stuck[0] } else { -part * pn };
        let after = [place, 0.0, speed + pt, rate + (a * pn + b * pt) / inertia];
        let slides = if part > 0.0 { 1 } else { -1 };
        (if holds { self.stopped(corner, &after) } else { Mode { corner, slides } }, after)
    }
}

impl Problem<4, 3> for Block {
    type Mode = Mode;

    fn names(mode: Mode) -> [&'static str; 3] {
        if mode.slides == 0 { ["impact", "slip", "slip"] } else { ["impact", "stick", "none"] }
    }

    fn start(&self) -> (Mode, [f64; 4]) {
        self.start
    }

    #[inline]
    fn derivative(&self, mode: Mode, _t: f64, x: &[f64; 4]) -> [f64; 4] {
        let motion = self.motion(mode, x);
        [x[2], x[3], motion.along, motion.turn]
    }

    fn guards(&self, mode: Mode, x: &[f64; 4]) -> [f64; 3] {
        std::array::from_fn(|i| self.guard(mode, i, x).0)
    }

    fn guard_rates(&self, mode: Mode, x: &[f64; 4]) -> [f64; 3] {
        std::array::from_fn(|i| self.guard(mode, i, x).1)
    }

    #[inline]
    fn guard(&self, mode: Mode, guard: usize, x: &[f64; 4]) -> (f64, f64) {
        let Mode { corner, slides } = mode;
        match (guard, slides) {
            (0, _) => (-f64::from(corner) * x[1], -f64::from(corner) * x[3]),
            (1, 0) => self.cone(corner, 1.0, x),
            (2, 0) => self.cone(corner, -1.0, x),
            (1, _) => {
                let (sign, rate) = (f64::from(slides), x[3]);
                let Motion { turn, along, arm: [px, py], .. } = self.motion(mode, x);
                let speeding = along - turn * py - rate * rate * px;
                (sign * (x[2] - rate * py), sign * speeding)
            }
            _ => (1.0, 0.0),
        }
    }

    fn fire(&self, mode: Mode, guard: usize, x: &[f64; 4]) -> (Mode, [f64; 4]) {
        let Mode { corner, slides } = mode;
        if guard == 0 {
            return self.impact(-corner, x);
        }
        // Stop the corner: earlier steps left some drift.
        let after = [x[0], x[1], x[3] * self.arm(corner, x[1])[1], x[3]];
        let mode = match (guard, slides) {
            (1, 0) => Mode { corner, slides: -1 },
            (_, 0) => Mode { corner, slides: 1 },
            _ => self.stopped(corner, &after),
        };
        (mode, after)
    }

    fn longest_step(&self) -> f64 {
        f64::INFINITY
    }
}
