//! What the guards can do over one step.

use core::f64::consts::LN_2;

use pode::{Enclosure, GuardBound, GuardId, Motion};

use super::forces::SoftFelt;
use super::guards::{CHECK, JACK_IN, LAND, LIFT_OFF, REP_OFF, REP_ON, STRING_OFF, STRING_ON};
use super::{Mode, ReducedGrand};
use crate::bounds::TermBound;

type Over = Enclosure<[f64; 4], Motion>;

/// Bounds of a softplus of x and of its derivatives, for x in `low` ..= `high`.
#[derive(Clone, Copy, Debug)]
struct SoftplusBound {
    value: f64,
    slope: f64,
    /// Of 1 − σ.
    slope_left: f64,
    bend: f64,
}

impl SoftplusBound {
    #[inline]
    fn over(low: f64, high: f64) -> Self {
        let (rising, falling) = (decayed(-high), decayed(low));
        let value = if high > 0.0 { high + LN_2 } else { rising.min(LN_2) };
        Self { value, slope: rising, slope_left: falling, bend: rising.min(falling).min(0.25) }
    }

    /// The bound of ½ d²(sp²)/dx² = σ² + sp σ', which is nowhere above 1.046.
    #[inline]
    const fn bend_of_square(&self) -> f64 {
        1.05_f64.min(2.0 * self.slope * self.slope)
    }
}

/// An upper bound of e^−x without an exponential, 1 below 0: 1/(1 + x/8)⁸.
#[inline]
fn decayed(x: f64) -> f64 {
    let root = 1.0 + 0.125 * x.max(0.0);
    let fourth = (root * root) * (root * root);
    1.0 / (fourth * fourth)
}

impl SoftFelt {
    /// Bound of the felt's force over a step that begins `depth` (m) deep at `rate` (m/s), with
    /// the bounds of both.
    #[inline]
    fn bound(
        &self,
        (depth, deep): (f64, &TermBound),
        (rate, fast): (f64, &TermBound),
    ) -> TermBound {
        let [low, high] = [depth - deep.moves, depth + deep.moves].map(|x| x / self.width);
        let soft = SoftplusBound::over(low, high);
        let (height, k) = (self.width * soft.value, self.stiffness);
        let slope = 2.0 * k * height * soft.slope;
        let spring = deep.through(k * height * height, slope, 2.0 * k * soft.bend_of_square());
        let factor = 1.0 + self.loss * rate;
        // Where the felt may let go its force has a corner.
        let corner = if factor < self.loss * fast.moves { f64::INFINITY } else { 0.0 };
        let most = (factor + self.loss * fast.moves).max(0.0);
        spring * fast.through(most, self.loss, corner)
    }
}

impl ReducedGrand {
    /// Bound of what the finger pushes beyond the key's own load (N).
    fn push_bound(&self, over: &Over) -> TermBound {
        let p = &self.values;
        let [y, _, u, _] = over.start;
        let (place, speed) = (TermBound::entry::<0, 4, _>(over), TermBound::entry::<2, 4, _>(over));
        let finger = (TermBound::position(over) + place).times(p.coupling)
            + (TermBound::rate(over) + speed).times(p.coupling_damping);
        let bed = self.bed().bound((y - p.bed, &place), (u, &speed));
        let rail = self.rail().bound((-y, &place), (-u, &speed));
        let own = speed.times(p.key_damping) + TermBound::constant(p.key_weight);
        finger + own + self.rubbing_bound(u, &speed) + self.jack_bound(y, &place) + bed + rail
    }

    /// Bound of the key's dry friction: the slope of tanh x is at most 4 e^−2|x|.
    fn rubbing_bound(&self, u: f64, speed: &TermBound) -> TermBound {
        /// Largest second derivative of tanh, 4/(3√3).
        const BEND: f64 = 0.77;
        let p = &self.values;
        let slowest = ((u.abs() - speed.moves) / p.friction_speed).max(0.0);
        let slope = (4.0 * decayed(2.0 * slowest)).min(1.0);
        let per_speed = 1.0 / p.friction_speed;
        let friction = p.friction * per_speed;
        speed.through(p.friction, friction * slope, friction * per_speed * BEND.min(2.0 * slope))
    }

    /// Bound of the force of jack and button on the key.
    fn jack_bound(&self, y: f64, place: &TermBound) -> TermBound {
        let p = &self.values;
        let from = |y: f64| (y - p.button) / p.jack_width;
        let soft = SoftplusBound::over(from(y - place.moves), from(y + place.moves));
        let bend = p.jack_stiffness / p.jack_width * soft.bend;
        let most = p.jack_stiffness * p.jack_width * soft.value;
        place.through(most, p.jack_stiffness * soft.slope, bend)
    }

    /// Bound of the head's height ζ at the button over a step, and of its slope ζ'.
    fn at_button_bound(&self, over: &Over) -> (TermBound, TermBound) {
        let place = TermBound::entry::<0, 4, _>(over);
        let (bend, (height, slope)) =
            (self.let_off.bend.abs(), self.let_off.head(&self.values, over.start[0]));
        let steepest = slope.abs() + bend * place.moves;
        let size = height.abs() + steepest * place.moves;
        (place.through(size, steepest, bend), place.through(steepest, bend, 0.0))
    }

    /// Bound of the guard [`Self::lift_off`].
    fn lift_off_bound(&self, mode: Mode, over: &Over) -> GuardBound {
        let p = &self.values;
        let speed = TermBound::entry::<2, 4, _>(over);
        let (ratio, bend) = if mode == Mode::Lo {
            (self.at_button_bound(over).1, self.let_off.bend)
        } else {
            (TermBound::constant(p.ratio), 0.0)
        };
        let driven = ratio * self.push_bound(over).times(p.hammer_mass / p.key_mass);
        let own = speed.square().times(p.hammer_mass * bend);
        (driven + own + (ratio * speed).times(p.hammer_damping)).as_guard()
    }

    /// Bound of the height of the repetition lever.
    fn lever_bound(&self, over: &Over) -> GuardBound {
        let p = &self.values;
        let place = TermBound::entry::<0, 4, _>(over);
        let from = |y: f64| (y - p.drop) / p.drop_width;
        let y = over.start[0];
        let soft = SoftplusBound::over(from(y - place.moves), from(y + place.moves));
        let bend = p.ratio / p.drop_width * soft.bend;
        place.through(0.0, p.ratio * soft.slope_left, bend).as_guard()
    }

    /// Bounds what a guard does over one step.
    #[inline]
    pub(super) fn bound_of(&self, mode: Mode, guard: GuardId, over: &Over) -> GuardBound {
        let (key, head) = (over.entry(0), over.entry(1));
        match guard {
            LIFT_OFF => self.lift_off_bound(mode, over),
            LAND if mode == Mode::Fll => head.plus(self.at_button_bound(over).0.as_guard()),
            LAND | JACK_IN => head.plus(key.times(self.values.ratio)),
            STRING_ON | STRING_OFF => head,
            REP_ON | REP_OFF => head.plus(self.lever_bound(over)),
            CHECK => head.plus(key.times(self.values.check_ratio)),
            _ => key,
        }
    }
}
