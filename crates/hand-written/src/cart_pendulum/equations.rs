//! The cart's equations, by hand, in the form that generated ones will take.

use pode::math::{sin_cos, sqrt};
use pode::{
    Enclosure, Energetic, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model,
    Motion, Nature, Part, ReadoutSlopes, Reset, Resets, Settling, Sloped,
};

use super::{CartPendulum, Mode};
use crate::bounds::TermBound;
use crate::impact::{Meeting, Parting};

const LEFT: GuardId = GuardId(0);
const RIGHT: GuardId = GuardId(1);
const OFF: GuardId = GuardId(2);

const FREE: [GuardSpec; 2] =
    [GuardSpec::new(0, "left").of_state(), GuardSpec::new(1, "right").of_state()];
const HELD: [GuardSpec; 1] = [GuardSpec::new(2, "off")];

/// Whether `guard` is a meeting of cart and wall.
pub(super) fn is_wall(guard: GuardId) -> bool {
    matches!(guard, LEFT | RIGHT)
}

/// A wall: the mode in which it holds the cart, its place (m), and the way to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wall {
    mode: Mode,
    place: f64,
    /// +1 for the right wall, −1 for the left one.
    sign: f64,
}

/// The mass matrix [[a11, a12], [a12, a22]] and the forces that go with it.
#[derive(Clone, Copy, Debug)]
struct Dynamics {
    a11: f64,
    /// m l cos θ.
    a12: f64,
    /// J + m l².
    a22: f64,
    /// On the cart: spring, damper and the bob's centrifugal force (N).
    cart: f64,
    /// On the pendulum: its weight (N·m).
    bob: f64,
}

impl CartPendulum {
    const fn left_side(&self) -> Wall {
        Wall { mode: Mode::Left, place: self.left, sign: -1.0 }
    }

    const fn right_side(&self) -> Wall {
        Wall { mode: Mode::Right, place: self.right, sign: 1.0 }
    }

    /// The wall that holds the cart.
    pub(super) const fn side(&self, mode: Mode) -> Option<Wall> {
        match mode {
            Mode::Free => None,
            Mode::Left => Some(self.left_side()),
            Mode::Right => Some(self.right_side()),
        }
    }

    /// k (s − x) + b (s' − x') (N).
    pub(super) fn pull(&self, x: &[f64; 4], s: &Motion) -> f64 {
        self.k * (s.position - x[0]) + self.b * (s.rate - x[2])
    }

    /// The fastest oscillation, with the pendulum hanging (rad/s).
    fn oscillation(&self) -> f64 {
        let hanging = self.dynamics(&[0.0; 4], &Motion::default());
        let weight = self.g * hanging.a12 * hanging.a11 / hanging.a22;
        sqrt((self.k + weight) / hanging.felt_mass())
    }

    /// J + m l², inertia of the pendulum about its pivot (kg·m²).
    fn about_pivot(&self) -> f64 {
        self.inertia + self.bob_mass * self.length * self.length
    }

    fn dynamics(&self, x: &[f64; 4], s: &Motion) -> Dynamics {
        let (sin, cos) = sin_cos(x[1]);
        let arm = self.bob_mass * self.length;
        Dynamics {
            a11: self.cart_mass + self.bob_mass,
            a12: arm * cos,
            a22: self.about_pivot(),
            cart: self.pull(x, s) + arm * sin * x[3] * x[3],
            bob: -arm * self.g * sin,
        }
    }

    /// The wall's force on the cart that it holds, and its rate (N, N/s).
    pub(super) fn push(&self, side: Wall, x: &[f64; 4], s: &Motion) -> GuardValue {
        let held = self.dynamics(x, s);
        let (sin, cos) = sin_cos(x[1]);
        let arm = self.bob_mass * self.length;
        let acceleration = held.bob / held.a22;
        let jerk = -arm * self.g * cos * x[3] / held.a22;
        let force = held.cart - held.a12 * acceleration;
        let rate = self.k * s.rate
            + self.b * s.acceleration
            + arm * (cos * (x[3] * x[3] * x[3] - jerk) + 3.0 * sin * x[3] * acceleration);
        GuardValue::new(side.sign * force, side.sign * rate)
    }

    /// Bound of that force over a step: m l (sin θ θ'² + κ sin θ cos θ) and what pulls, with
    /// κ = m l g/a22.
    fn push_bound(&self, over: &Enclosure<[f64; 4], Motion>) -> GuardBound {
        let arm = self.bob_mass * self.length;
        let (angle, rate) = (TermBound::entry::<1, 4, _>(over), TermBound::entry::<3, 4, _>(over));
        let (sin, double) = (angle.size.min(1.0), (2.0 * angle.size).min(1.0));
        let weight = arm * self.g / self.about_pivot();
        let swung = angle.through(sin, 1.0, sin) * rate.square();
        let hung = angle.through(0.5 * weight * double, weight, 2.0 * weight * double);
        let bob = (swung + hung).times(arm).as_guard();
        bob.plus(over.position().times(self.k)).plus(over.rate().times(self.b))
    }

    /// x'⁺ = −e x'⁻ on the wall's place; θ's momentum a12 x' + a22 θ' is kept.
    fn meet(&self, side: Wall, x: &[f64; 4], s: &Motion) -> Reset<Self> {
        let Wall { mode, place, sign } = side;
        let at_wall = [place, x[1], x[2], x[3]];
        let stopped = self.with_cart_speed(&at_wall, 0.0);
        let meeting = Meeting {
            closing: sign * x[2],
            pressing: sign * self.dynamics(&stopped, s).accelerations()[0],
            restitution: self.restitution,
        };
        match meeting.part() {
            Parting::Already => Reset::to(Mode::Free, at_wall),
            Parting::Together => Reset::to(mode, stopped),
            Parting::Rebound { speed, settles } => {
                let reset = Reset::to(Mode::Free, self.with_cart_speed(&at_wall, -sign * speed));
                settles.map_or(reset, |after| reset.settling(self.settling(mode, &stopped, after)))
            }
        }
    }

    /// `x` after an impulse on the cart that makes its speed `speed` (m/s).
    fn with_cart_speed(&self, x: &[f64; 4], speed: f64) -> [f64; 4] {
        let (_, cos) = sin_cos(x[1]);
        let kept = self.bob_mass * self.length * cos / self.about_pivot();
        [x[0], x[1], speed, x[3] + kept * (x[2] - speed)]
    }

    /// Held in `mode` after `after` (s): the cart at the wall, the pendulum moved on.
    fn settling(&self, mode: Mode, stopped: &[f64; 4], after: f64) -> Settling<Self> {
        let (sin, _) = sin_cos(stopped[1]);
        let swing = -self.bob_mass * self.length * self.g * sin / self.about_pivot();
        let rate = stopped[3] + after * swing;
        Settling {
            after,
            ratio: self.restitution,
            mode,
            state: [stopped[0], stopped[1] + 0.5 * after * (stopped[3] + rate), 0.0, rate],
            impulse: 0.0,
        }
    }
}

impl Dynamics {
    /// Mass of the cart as the spring feels it, the pendulum swinging freely (kg).
    fn felt_mass(&self) -> f64 {
        self.a11 - self.a12 * self.a12 / self.a22
    }

    /// x'' and θ''.
    fn accelerations(&self) -> [f64; 2] {
        let cart = (self.cart - self.a12 / self.a22 * self.bob) / self.felt_mass();
        [cart, (self.bob - self.a12 * cart) / self.a22]
    }
}

impl Model for CartPendulum {
    type Mode = Mode;
    type State = [f64; 4];
    type Input = Motion;
    const COORDS: usize = 2;

    /// A wall that holds the cart leaves the pendulum.
    fn parts(&self, mode: Mode) -> &[Part] {
        match mode {
            Mode::Free => &[Part::WHOLE],
            Mode::Left | Mode::Right => const { &[Part::of(&[1, 3])] },
        }
    }

    fn derivative(&self, mode: Mode, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let dynamics = self.dynamics(x, s);
        match mode {
            Mode::Free => {
                let [cart, bob] = dynamics.accelerations();
                [x[2], x[3], cart, bob]
            }
            Mode::Left | Mode::Right => [0.0, x[3], 0.0, dynamics.bob / dynamics.a22],
        }
    }

    fn readout(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.pull(x, s)
    }

    /// A quarter of a radian of the fastest oscillation.
    fn longest_step(&self, _mode: Mode) -> f64 {
        const RADIANS: f64 = 0.25;
        RADIANS / self.oscillation()
    }

    /// The damper adds to the oscillation's rate where it is strong.
    fn nature(&self, _mode: Mode) -> Nature {
        let hanging = self.dynamics(&[0.0; 4], &Motion::default());
        Nature::new(EquationKind::Smooth, self.oscillation() + self.b / hanging.felt_mass())
    }

    fn constrain(&self, mode: Mode, x: &[f64; 4], _s: &Motion) -> [f64; 4] {
        self.side(mode).map_or(*x, |side| [side.place, x[1], 0.0, x[3]])
    }

    /// The walls stand still, so that no input moves a cart onto them.
    fn longest_projection(&self, mode: Mode) -> f64 {
        match mode {
            Mode::Free => f64::INFINITY,
            Mode::Left | Mode::Right => 1e-4,
        }
    }
}

impl Guarded for CartPendulum {
    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Free => &FREE,
            Mode::Left | Mode::Right => &HELD,
        }
    }

    #[inline]
    fn guard_bound(
        &self,
        _mode: Mode,
        guard: GuardId,
        over: &Enclosure<[f64; 4], Motion>,
    ) -> GuardBound {
        if guard == OFF { self.push_bound(over) } else { over.entry(0) }
    }

    fn guard(&self, mode: Mode, guard: GuardId, x: &[f64; 4], s: &Motion) -> GuardValue {
        match (guard, self.side(mode)) {
            (OFF, Some(side)) => self.push(side, x, s),
            (LEFT, _) => GuardValue::new(x[0] - self.left, x[2]),
            _ => GuardValue::new(self.right - x[0], -x[2]),
        }
    }
}

impl Resets for CartPendulum {
    /// A wall turns the cart round; coming off it keeps the state.
    fn reset(&self, _mode: Mode, guard: GuardId, x: &[f64; 4], s: &Motion) -> Reset<Self> {
        match guard {
            LEFT => self.meet(self.left_side(), x, s),
            RIGHT => self.meet(self.right_side(), x, s),
            _ => Reset::to(Mode::Free, *x),
        }
    }
}

impl Energetic for CartPendulum {
    fn energy(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        let (_, cos) = sin_cos(x[1]);
        let arm = self.bob_mass * self.length;
        let stretch = s.position - x[0];
        0.5 * ((self.cart_mass + self.bob_mass) * x[2] * x[2]
            + self.about_pivot() * x[3] * x[3]
            + self.k * stretch * stretch)
            + arm * cos * (x[2] * x[3] - self.g)
    }

    fn supplied(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        self.pull(x, s) * s.rate
    }

    fn dissipated(&self, _mode: Mode, x: &[f64; 4], s: &Motion) -> f64 {
        let slip = s.rate - x[2];
        self.b * slip * slip
    }
}

impl Sloped for CartPendulum {
    fn slopes(&self, _mode: Mode, _x: &[f64; 4], _s: &Motion) -> ReadoutSlopes {
        ReadoutSlopes { per_position: self.k, per_rate: self.b }
    }
}
