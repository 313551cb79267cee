//! Rules that might surprise a modeller.

use pode::stepper::{Any, ByNeed, Exact, Rk4};
use pode::{
    Advance, EquationKind, Event, Fault, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model,
    Motion, Nature, Part, Reset, Resets, Settling, Silent, Simulator, Watch, Work,
};

use pode::Stepper as _;

use crate::common::{G, OneMode, all_completed, close, run};
use crate::undeclared::Ball;

#[derive(Clone, Copy, Debug)]
struct Rocking {
    restitution: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Edge {
    Right,
    Left,
    Both,
}

impl Edge {
    const fn sign(self) -> f64 {
        match self {
            Self::Right => 1.0,
            Self::Left | Self::Both => -1.0,
        }
    }
}

impl Model for Rocking {
    type Mode = Edge;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn parts(&self, edge: Edge) -> &[Part] {
        if edge == Edge::Both { &[] } else { &[Part::WHOLE] }
    }

    fn derivative(&self, edge: Edge, x: &[f64; 2], (): &()) -> [f64; 2] {
        [x[1], x[0] - edge.sign()]
    }

    fn nature(&self, _: Edge) -> Nature {
        Nature::default().with_longest_step(0.01)
    }
}

impl Guarded for Rocking {
    fn guards(&self, edge: Edge) -> &[GuardSpec] {
        match edge {
            Edge::Right => const { &[GuardSpec::new(0, "right")] },
            Edge::Left => const { &[GuardSpec::new(1, "left")] },
            Edge::Both => &[],
        }
    }

    fn guard(&self, edge: Edge, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(edge.sign() * x[0], edge.sign() * x[1])
    }
}

impl Resets for Rocking {
    fn reset(&self, edge: Edge, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let other = if edge == Edge::Right { Edge::Left } else { Edge::Right };
        Reset::to(other, [0.0, self.restitution * x[1]]).resting(Edge::Both, [0.0, 0.0])
    }
}

#[test]
fn impacts_of_two_guards_that_come_to_rest_in_one_mode_settle() {
    for restitution in [0.5, 0.8, 0.9] {
        // Quarter periods of Housner's block `[Hou63]`: from rest at φ, acosh(1/(1 − φ)).
        let quarter = |angle: f64| (1.0 / (1.0 - angle)).acosh();
        let (mut angle, mut t) = (0.3_f64, quarter(0.3));
        while angle > 1e-30 {
            let speed = restitution * restitution * (2.0 * angle - angle * angle);
            angle = speed / (1.0 + (1.0 - speed).sqrt());
            // A low hop takes √(2 φ), where acosh has lost its digits.
            t += 2.0 * if angle > 1e-8 { quarter(angle) } else { (2.0 * angle).sqrt() };
        }
        let block = Rocking { restitution };
        let mut block = Simulator::new(block, Rk4, Limits::default(), Edge::Right, [0.3, 0.0]);
        let (recorder, ticks) = run(&mut block, 1e-3, 0.0, t + 0.5);
        all_completed(&ticks);
        let last = recorder.events().last().expect("an event");
        assert_eq!((last.name, last.to), ("settled", Edge::Both), "r {restitution}");
        close(format_args!("time of rest, r {restitution}"), last.t, t, 2e-6);
        close("the angle", block.state()[0], 0.0, 0.0);
    }
}

#[test]
fn a_reset_that_leaves_its_guard_falling_is_counted() {
    // A negative restitution is a sign error.
    for (restitution, ineffective) in [(0.8, 0), (-0.8, 1)] {
        let mut ball = Ball { restitution, puts: true }.dropped(1.0);
        let (_, ticks) = run(&mut ball, 1e-3, 0.0, 0.6);
        all_completed(&ticks);
        let work = ticks.iter().fold(Work::default(), |sum, tick| sum.plus(tick.work));
        assert_eq!((work.events, work.ineffective), (1, ineffective), "e {restitution}");
    }
}

/// A ball on a floor that moves, with the end of its bounces in closed form as if the floor kept
/// its acceleration.
#[derive(Clone, Copy, Debug)]
struct OnFloor;

const RESTITUTION: f64 = 0.7;

impl Model for OnFloor {
    type Mode = bool;
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;

    fn parts(&self, flies: bool) -> &[Part] {
        if flies { &[Part::WHOLE] } else { &[] }
    }

    fn derivative(&self, _: bool, x: &[f64; 2], _: &Motion) -> [f64; 2] {
        [x[1], -G]
    }

    fn nature(&self, _: bool) -> Nature {
        Nature { longest_projection: 1e-3, ..Nature::default() }
    }
}

impl Guarded for OnFloor {
    fn constrain(&self, flies: bool, x: &[f64; 2], s: &Motion) -> [f64; 2] {
        if flies { *x } else { [s.position, s.rate] }
    }

    fn guards(&self, flies: bool) -> &[GuardSpec] {
        if flies { const { &[GuardSpec::new(0, "floor")] } } else { &[] }
    }

    fn guard(&self, _: bool, _: GuardId, x: &[f64; 2], s: &Motion) -> GuardValue {
        GuardValue::new(x[0] - s.position, x[1] - s.rate)
    }
}

impl Resets for OnFloor {
    fn reset(&self, _: bool, _: GuardId, x: &[f64; 2], s: &Motion) -> Reset<Self> {
        let up = -RESTITUTION * (x[1] - s.rate);
        if up <= 0.0 {
            return Reset::to(false, [s.position, s.rate]);
        }
        let after = 2.0 * up / ((G + s.acceleration) * (1.0 - RESTITUTION));
        let rate = s.rate + after * s.acceleration;
        Reset::to(true, [s.position, s.rate + up]).settling(Settling {
            after,
            ratio: RESTITUTION,
            mode: false,
            state: [s.position + 0.5 * after * (s.rate + rate), rate],
            impulse: 0.0,
        })
    }
}

struct Last {
    h: f64,
    at: (f64, f64),
}

impl Watch<OnFloor> for Last {
    fn event(&mut self, _: &OnFloor, event: &Event<'_, OnFloor>) {
        self.at = ((event.tick as f64 + event.theta) * self.h, event.error);
    }
}

/// Returns when the ball rests on a swinging floor (s), by its last event, and that one's error.
fn settles(h: f64) -> (f64, f64) {
    let start = [0.5, 0.0];
    let mut ball = Simulator::new(OnFloor, Rk4, Limits::default(), true, start);
    let mut last = Last { h, at: (0.0, 0.0) };
    while ball.mode() {
        let tick = ball.tick() as f64;
        let input = |theta: f64| {
            let (sin, cos) = (5.0 * (tick + theta) * h).sin_cos();
            Motion {
                position: 0.1 * sin,
                rate: 0.5 * cos,
                acceleration: -2.5 * sin,
                jerk: -12.5 * cos,
            }
        };
        let done = ball.advance(h, &input, &mut last);
        assert_eq!(done.advance, Advance::Completed);
    }
    last.at
}

#[test]
fn a_settle_time_states_its_error() {
    let (reference, left) = settles(1e-5);
    assert!(left <= 1e-9, "{left:e}");
    for h in [0.05, 0.02, 5e-3, 1e-3] {
        let (t, error) = settles(h);
        assert!(error <= h * 1e-6 || error <= 1e-6, "h {h}: {error:e}");
        close(format_args!("h {h}"), t, reference, 2.0 * (error + left));
    }
}

#[test]
fn how_far_an_event_moved_the_state_is_told_and_too_far_is_a_fault() {
    for (jump, is_fault) in [(5e-4, false), (2e-3, true)] {
        let mut ball = Simulator::new(OnFloor, Rk4, Limits::default(), true, [1e-6, -1.0]);
        let at = |position: f64| move |_: f64| Motion { position, ..Motion::default() };
        let _ = ball.advance(1e-9, &at(0.0), &mut Silent);
        ball.place(true, [0.0, 0.0]);
        let done = ball.advance(1e-3, &at(jump), &mut Silent);
        if is_fault {
            assert_eq!(done.advance, Advance::Faulty(Fault::Projection));
        } else {
            close("the way onto the floor", done.projection, jump, 1e-12);
        }
    }
}

#[test]
fn whether_a_step_aims_at_an_event_is_a_question_of_the_mode() {
    let [linear, smooth] =
        [EquationKind::Linear, EquationKind::Smooth].map(|kind| Nature::new(kind, 100.0));
    assert!(!Exact.aims(&linear) && Exact.aims(&smooth) && Rk4.aims(&linear));
    let by_need = ByNeed::new(1e-6, 1e-3);
    assert!(!by_need.aims(&linear) && by_need.aims(&smooth), "RK4 is what it takes");
    let exact = Any::Exact(Exact);
    assert_eq!([exact.name_in(&linear), exact.name_in(&smooth)], ["exact", "rk4"]);
    assert_eq!(Any::ByNeed(by_need).name_in(&smooth), "rk4");
    let heun = Any::named("heun").expect("a method");
    assert_eq!(heun.name_in(&smooth), "heun");
}

#[test]
fn by_need_gets_more_exact_with_a_shorter_step() {
    // x'' = −100 x, with nothing declared but the rate.
    let nature = Nature::new(EquationKind::Smooth, 10.0);
    let swing = OneMode { nature, ..OneMode::new((), |(), x| [x[1], -100.0 * x[0]]) };
    for budget in [1e-3, 1e-4, 1e-6, 1e-9] {
        let errors = [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4].map(|h| {
            let by_need = ByNeed::new(budget, 1e-3);
            let mut swing = swing.start(by_need, [1.0, 0.0]);
            assert!(swing.run(1.0, h, |_| (), &mut Silent).is_completed());
            (swing.state()[0] - 10.0_f64.cos()).abs()
        });
        let shrinks =
            errors.windows(2).all(|pair| pair[1] <= pair[0]) && errors[4] < 0.1 * errors[1];
        assert!(shrinks, "budget {budget}: {errors:?}");
    }
}
