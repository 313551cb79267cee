//! What the guards can do over one step.

use core::f64::consts::LN_2;

use pode::{Enclosure, GuardBound, GuardId, Motion};

use super::forces::SoftFelt;
use super::guards::{CHECK, JACK_IN, LAND, LIFT_OFF, REP_OFF, REP_ON, STRING_OFF, STRING_ON};
use super::parameters::ReducedGrandValues;
use super::{Mode, ReducedGrand};
use crate::bounds::TermBound;
use equations::FAR_SOFTPLUS as FAR;

type Over = Enclosure<[f64; 4], Motion>;

/// 1/w of what sets in softly (1/m), and 1/vc (s/m): a product takes a third of a division's
/// time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct PerWidth {
    felt: f64,
    jack: f64,
    drop: f64,
    friction_speed: f64,
}

impl PerWidth {
    pub(super) fn new(p: &ReducedGrandValues) -> Self {
        Self {
            felt: 1.0 / p.felt_width,
            jack: 1.0 / p.jack_width,
            drop: 1.0 / p.drop_width,
            friction_speed: 1.0 / p.friction_speed,
        }
    }
}

/// An upper bound of e^−x without an exponential, 1 below 0: 1/(1 + x/8)⁸.
#[inline]
fn decayed(x: f64) -> f64 {
    let root = 1.0 + 0.125 * x.max(0.0);
    let fourth = (root * root) * (root * root);
    1.0 / (fourth * fourth)
}

/// Bound of a softplus up to `high`, where its slope is at most `slope`.
#[inline]
fn softplus_up_to(high: f64, slope: f64) -> f64 {
    if high > 0.0 { high + LN_2 } else { slope.min(LN_2) }
}

impl SoftFelt {
    /// Bound of the felt's force over a step that begins `depth` (m) deep at `rate` (m/s), with
    /// the bounds of both. The slope σ and the softplus are at most e^x, and
    /// ½ d²(sp²)/dx² = σ² + sp σ' is nowhere above 1.046.
    #[inline]
    fn bound(
        &self,
        per_width: f64,
        (depth, deep): (f64, &TermBound),
        (rate, fast): (f64, &TermBound),
    ) -> TermBound {
        let high = (depth + deep.moves) * per_width;
        if high < -FAR {
            return TermBound::constant(0.0);
        }
        let slope = decayed(-high);
        let (height, k) = (self.width * softplus_up_to(high, slope), self.stiffness);
        let bend = 2.0 * k * 1.05_f64.min(2.0 * slope * slope);
        let spring = deep.through(k * height * height, 2.0 * k * height * slope, bend);
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
        let felt = self.per_width.felt;
        let bed = self.bed().bound(felt, (y - p.bed, &place), (u, &speed));
        let rail = self.rail().bound(felt, (-y, &place), (-u, &speed));
        let own = speed.times(p.key_damping) + TermBound::constant(p.key_weight);
        finger + own + self.rubbing_bound(u, &speed) + self.jack_bound(y, &place) + bed + rail
    }

    /// Bound of the key's dry friction: the slope of tanh x is at most 4 e^−2|x|.
    #[inline]
    fn rubbing_bound(&self, u: f64, speed: &TermBound) -> TermBound {
        /// Largest second derivative of tanh, 4/(3√3).
        const BEND: f64 = 0.77;
        let (most, per_speed) = (self.values.friction, self.per_width.friction_speed);
        if most <= 0.0 {
            return TermBound::constant(0.0);
        }
        let slowest = (u.abs() - speed.moves) * per_speed;
        let slope = (4.0 * decayed(2.0 * slowest)).min(1.0);
        let friction = most * per_speed;
        speed.through(most, friction * slope, friction * per_speed * BEND.min(2.0 * slope))
    }

    /// Bound of the force of jack and button on the key.
    #[inline]
    fn jack_bound(&self, y: f64, place: &TermBound) -> TermBound {
        let (p, per_width) = (&self.values, self.per_width.jack);
        let from = |y: f64| (y - p.button) * per_width;
        let (low, high) = (from(y - place.moves), from(y + place.moves));
        if high < -FAR {
            return TermBound::constant(0.0);
        }
        let slope = decayed(-high);
        let most = p.jack_stiffness * p.jack_width * softplus_up_to(high, slope);
        let bend = p.jack_stiffness * per_width * slope.min(decayed(low)).min(0.25);
        place.through(most, p.jack_stiffness * slope, bend)
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
        let push = self.push_bound(over).times(p.hammer_mass / p.key_mass);
        if mode != Mode::Lo {
            return (push + speed.times(p.hammer_damping)).times(p.ratio).as_guard();
        }
        let ratio = self.at_button_bound(over).1;
        let own = speed.square().times(p.hammer_mass * self.let_off.bend);
        (ratio * (push + speed.times(p.hammer_damping)) + own).as_guard()
    }

    /// Bound of the height of the repetition lever, whose slope R (1 − σ) is at most R e^−x.
    #[inline]
    fn lever_bound(&self, over: &Over) -> GuardBound {
        let (p, per_width) = (&self.values, self.per_width.drop);
        let place = TermBound::entry::<0, 4, _>(over);
        let from = |y: f64| (y - p.drop) * per_width;
        let (y, moves) = (over.start[0], place.moves);
        let slope = decayed(from(y - moves));
        let bend = slope.min(decayed(-from(y + moves))).min(0.25);
        place.through(0.0, p.ratio * slope, p.ratio * per_width * bend).as_guard()
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
