//! Accumulating impacts without a mode to rest in: the floor holds nevertheless, in bounded work,
//! and the ticks report that they stopped.

use pode::stepper::Rk4;
use pode::{Advance, Cap, GuardValue, Silent, Simulator};

use crate::common::{G, ONE, OneMode, STEPS, no_input};

/// A ball over a floor whose model names no mode of rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub restitution: f64,
    /// `true` if an impact puts it on the floor, instead of leaving it in place.
    pub puts: bool,
}

impl Ball {
    pub fn dropped(self, height: f64) -> Simulator<OneMode<Self, 2>, Rk4> {
        let ball = OneMode {
            guards: &ONE,
            guard: |_, _, x| GuardValue::new(x[0], x[1]),
            reset: |it: &Self, _, x| [if it.puts { 0.0 } else { x[0] }, -it.restitution * x[1]],
            ..OneMode::new(self, |_, x| [x[1], -G])
        };
        ball.start(Rk4, [height, 0.0])
    }
}

#[track_caller]
fn check(ball: Ball, height: f64, h: f64) {
    let mut it = ball.dropped(height);
    let fall = (2.0 * height / G).sqrt();
    let rest = fall * (1.0 + ball.restitution) / (1.0 - ball.restitution);
    let mut last = Advance::Completed;
    while it.tick() as f64 * h < rest + 200.0 * h {
        let tick = it.advance(h, &no_input, &mut Silent);
        last = tick.advance;
        let is_known =
            matches!(last, Advance::Completed | Advance::Capped(Cap::Events | Cap::Cascade));
        assert!(is_known, "{ball:?} from {height}, h {h}: {tick:?}");
        // Each impact may find it 16 ε below; without a lift that adds up.
        let y = it.state()[0];
        assert!(y > -1e-12, "{ball:?} from {height}, h {h}: it has sunk to {y:e}");
    }
    assert!(matches!(last, Advance::Capped(_)), "{ball:?} from {height}, h {h}: nobody was told");
}

#[test]
fn a_ball_without_a_mode_to_rest_in_never_sinks() {
    for restitution in [0.0, 0.1, 0.5, 0.8, 0.95] {
        let both = |height: f64| [(height, true), (height, false)];
        for (height, puts) in [1.0, 1e-3, 1e-9].into_iter().flat_map(both) {
            for h in STEPS {
                check(Ball { restitution, puts }, height, h);
            }
        }
    }
}
