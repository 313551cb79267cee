//! Accumulating impacts without a mode to rest in: the floor holds nevertheless, in bounded work,
//! and the ticks report that they stopped.

use pode::stepper::Rk4;
use pode::{
    Advance, Cap, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Reset, Resets, Silent,
    Simulator,
};

use crate::common::{G, STEPS, no_input};

/// A ball over a floor whose model names no mode of rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub restitution: f64,
    /// `true` if an impact puts it on the floor, instead of leaving it in place.
    pub puts: bool,
}

impl Model for Ball {
    type Mode = ();
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, (): (), x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], -G]
    }
}

impl Guarded for Ball {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        const FLOOR: [GuardSpec; 1] = [GuardSpec::new(0, "floor")];
        &FLOOR
    }

    fn guard(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }
}

impl Resets for Ball {
    fn reset(&self, (): (), _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let place = if self.puts { 0.0 } else { x[0] };
        Reset::to((), [place, -self.restitution * x[1]])
    }
}

#[track_caller]
fn check(ball: Ball, height: f64, h: f64) {
    let mut it = Simulator::new(ball, Rk4, Limits::default(), (), [height, 0.0]);
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
