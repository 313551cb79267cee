//! A ball that was registered does what the ball of the program does.
#![expect(clippy::unwrap_used, reason = "visitors of tests, outside #[test], fail aloud")]

use descriptions::register_model;
use models::catalogue::{self, Visitor};
use models::{ModeName, Playable};
use pode::stepper::Rk4;
use pode::{Limits, Motion, Simulator};

use crate::ball::{Ball, TABLE};

/// Time after which the ball has met the floor once and is on its way down again (s).
const UNTIL: u32 = 900;

/// The floor at `t` (s): it goes up and down by 2 mm.
fn floor(t: f64) -> Motion {
    let w = 20.0;
    let (sin, cos) = (w * t).sin_cos();
    let a = 2e-3;
    Motion {
        position: a * sin,
        rate: a * w * cos,
        acceleration: -a * w * w * sin,
        jerk: -a * w * w * w * cos,
    }
}

/// Names of the events, and after each tick the mode, the state and the energy.
struct Flight;

impl Visitor for Flight {
    type Output = (usize, Vec<(String, Vec<f64>, f64)>);

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let (mode, state) = model.at_rest(&floor(0.0));
        let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
        let (mut events, mut rows) = (0, Vec::new());
        for tick in (0..UNTIL).map(f64::from) {
            let signal = |theta: f64| floor((tick + theta) * 1e-3);
            let done = simulator.advance(1e-3, &signal, &mut pode::Silent);
            events += usize::try_from(done.work.events).unwrap();
            let (mode, state) = (simulator.mode(), *simulator.state());
            let name = ModeName::new(&model, model.mode_code(mode)).to_string();
            let entries = model.entry().states.len();
            let energy = model.energy(mode, &state, &floor((tick + 1.0) * 1e-3));
            rows.push((name, pode::State::entries(&state)[..entries].to_vec(), energy));
        }
        (events, rows)
    }
}

#[test]
fn a_registered_ball_falls_and_bounces_as_the_one_of_the_program() {
    let described = register_model(&TABLE, &Ball, None).unwrap();
    let written = catalogue::built_in("bouncing-ball").unwrap();
    let [got, expected] =
        [described, written].map(|entry| catalogue::visit(entry, Flight).unwrap());
    assert_eq!((got.0, expected.0), (1, 1), "one impact");
    for ((mode, state, energy), (name, x, joules)) in got.1.iter().zip(&expected.1) {
        assert_eq!(mode, name);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12 * (1.0 + b.abs());
        assert!(state.iter().zip(x).all(|(a, b)| close(*a, *b)), "{state:?} is not {x:?}");
        assert!(close(*energy, *joules), "{energy} J is not {joules} J");
    }
}
