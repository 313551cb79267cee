//! A mass on a belt whose speed swings, at random, against closed forms.
//!
//! While it slips, the mass swings harmonically about ±F/k, and while it sticks, it follows the
//! belt: the reference joins those pieces where slip speed or friction, both in closed form, reach
//! their ends. No equation is integrated.

use pode::contacts::ContactState::{self, SlideDown, SlideUp, Stick};
use pode::stepper::Rk4;
use pode::{Advance, Motion, Nature};
use proptest::prelude::*;

use crate::common::block::Block;
use crate::common::two_sided::states;
use crate::driven::{root, run_driven};

/// Mass 1 kg, ω = 10 rad/s; the belt moves at v + w sin Ωt.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Belt {
    /// Sliding and static friction (N).
    kinetic: f64,
    limit: f64,
    /// Mean and amplitude of the belt's speed (m/s), and its frequency (rad/s).
    mean: f64,
    swing: f64,
    frequency: f64,
}

const OMEGA: f64 = 10.0;
const K: f64 = OMEGA * OMEGA;

const RADIANS: f64 = 0.02;

impl Belt {
    fn motion(&self, t: f64) -> Motion {
        let (sin, cos) = (self.frequency * t).sin_cos();
        Motion {
            position: self.mean * t - self.swing / self.frequency * cos,
            rate: self.mean + self.swing * sin,
            acceleration: self.swing * self.frequency * cos,
            jerk: -self.swing * self.frequency * self.frequency * sin,
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Piece {
    from: f64,
    mode: ContactState,
    x: [f64; 2],
    /// Sharpness of its start: the smallest slope or distance in that decision.
    margin: f64,
}

impl Piece {
    fn at(&self, belt: &Belt, t: f64) -> [f64; 2] {
        if self.mode == Stick {
            let [from, to] = [self.from, t].map(|t| belt.motion(t));
            return [self.x[0] + to.position - from.position, to.rate];
        }
        let center = -self.mode.slip_sign() * belt.kinetic / K;
        let (sin, cos) = (OMEGA * (t - self.from)).sin_cos();
        let [a, b] = [self.x[0] - center, self.x[1] / OMEGA];
        [center + a * cos + b * sin, OMEGA * (b * cos - a * sin)]
    }

    fn guard(&self, belt: &Belt, t: f64) -> f64 {
        let (x, motion) = (self.at(belt, t), belt.motion(t));
        if self.mode == Stick {
            return belt.limit - (K * x[0] + motion.acceleration).abs();
        }
        self.mode.slip_sign() * (x[1] - motion.rate)
    }

    /// Returns the next piece, if one begins before `until`; by samples 1/500 of a radian apart.
    fn next(&self, belt: &Belt, until: f64) -> Option<Self> {
        let step = 0.002 / OMEGA.max(belt.frequency);
        let mut near = f64::INFINITY;
        let mut t = self.from + step;
        let mut before = self.guard(belt, t);
        while t < until {
            let now = self.guard(belt, t + step);
            if now <= 0.0 {
                let t = root(t, t + step, |t| self.guard(belt, t));
                return (t < until).then(|| self.follow(belt, t));
            }
            if before > now {
                near = now;
            } else if near < 1e-4 {
                return Some(Self { from: t, margin: 0.0, ..*self });
            } else {
                near = f64::INFINITY;
            }
            (t, before) = (t + step, now);
        }
        None
    }

    fn follow(&self, belt: &Belt, t: f64) -> Self {
        let (x, motion) = (self.at(belt, t), belt.motion(t));
        let held = K * x[0] + motion.acceleration;
        let free = (belt.limit - held.abs()).abs();
        let friction = -self.mode.slip_sign() * belt.kinetic;
        let slope = (friction - held).abs();
        let leaves = if held > 0.0 { SlideDown } else { SlideUp };
        if self.mode == Stick {
            let rate = (K * motion.rate + motion.jerk).abs();
            return Self { from: t, mode: leaves, x, margin: 0.01 * rate };
        }
        let mode = if held.abs() < belt.limit { Stick } else { leaves };
        Self { from: t, mode, x, margin: free.min(slope) }
    }
}

fn reference(belt: &Belt, until: f64) -> Vec<Piece> {
    let x = [0.0, belt.motion(0.0).rate];
    let mut pieces = vec![Piece { from: 0.0, mode: Stick, x, margin: 1.0 }];
    while let Some(next) = pieces[pieces.len() - 1].next(belt, until) {
        pieces.push(next);
        if next.margin < 0.01 {
            break;
        }
    }
    pieces
}

prop_compose! {
    fn belt()(
        kinetic in 0.2..2.0,
        above in prop_oneof![Just(1.0), 1.05..2.0],
        mean in -0.3..0.3,
        part in 0.0..0.98,
        frequency in 2.0..25.0,
    ) -> Belt {
        // At first the friction can hold it: the belt's acceleration is within the limit.
        let limit = above * kinetic;
        Belt { kinetic, limit, mean, swing: part * limit / frequency, frequency }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_swinging_belt_sticks_and_slips_as_in_closed_form(
        belt in belt(),
        h in prop_oneof![Just(1e-4), Just(1e-3), Just(7e-3)],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        const UNTIL: f64 = 4.0;
        let pieces = reference(&belt, UNTIL);
        let sure = pieces.iter().position(|it| it.margin < 0.01).unwrap_or(pieces.len());
        let until = pieces.get(sure).map_or(UNTIL, |it| it.from - 1e-3);
        let nature = Nature::default().with_longest_step(RADIANS / OMEGA.max(belt.frequency));
        let block = Block { nature, ..Block::new(1.0, K, [belt.limit, belt.kinetic]) };
        let mut it = block.start(Rk4, pieces[0].x, &belt.motion(0.0));
        let (recorder, ticks) = run_driven(&mut it, (h, phase), until, |t| belt.motion(t));
        prop_assert!(ticks.iter().all(|tick| tick.advance == Advance::Completed));
        let modes: Vec<_> = pieces[1..sure].iter().map(|it| it.mode).collect();
        prop_assert_eq!(states(recorder.events()), modes, "{:?}", recorder.times());
        // Each landing takes r⁴/69 of a speed of 1 m/s, over the slope with which it lands, and
        // passes it on: a stick resets the speed, and a slip passes the place on.
        let mut error = 1e-12;
        for (piece, t) in pieces[1..sure].iter().zip(recorder.times()) {
            error += 10.0 * RADIANS.powi(4) / 69.0 / piece.margin.min(1.0) + error / piece.margin.min(1.0);
            prop_assert!((t - piece.from).abs() < error, "{} is not {}, {:e}", t, piece.from, error);
        }
    }
}
