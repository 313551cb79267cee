//! Mechanisms derived by Kane's method and assembled, run beside models written by hand.
#![expect(clippy::unwrap_used, reason = "a test fails aloud")]

use equations::{EquationModel, ModeNumber};
use hand_written::{BouncingBall, CartPendulum, KeyHammerRigid, KeyHammerSprings};
use kane::assemble::TapeFunctions;
use models::Described;
use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{Limits, Motion, Resets, RunRecorder, Silent, Simulator, Work};

use crate::beside_hand_written::{figure_6, run};
use crate::builder::MechanismBuilder;
use crate::evaluation::Derived;
use crate::models_ab::{model_a, model_b};
use crate::small_models::{ball, cart};

type Assembled<const N: usize> = EquationModel<&'static TapeFunctions, N, 256>;

/// The assembled model beside the one by hand, with the same values.
fn both<M, const N: usize>(builder: MechanismBuilder) -> (Assembled<N>, M)
where
    M: Described<State = [f64; N]> + Default,
{
    let derived = Derived::from(builder);
    let program = derived.system.clone().assemble().unwrap();
    let functions: &'static TapeFunctions = Box::leak(Box::new(program.functions));
    let assembled = EquationModel::new(program.table, functions, &derived.values).unwrap();
    (assembled, M::default().with_values(&derived.values))
}

/// Events of guards, each with the mode that it led to, up to the first that is no guard's.
fn story<M: pode::Model>(
    recorder: &RunRecorder<M>,
    number: impl Fn(M::Mode) -> usize,
) -> Vec<(&'static str, usize, f64)> {
    let events = recorder.events().iter();
    let guards = events.take_while(|event| !["impacts", "settled"].contains(&event.name));
    guards.map(|event| (event.name, number(event.to), event.t)).collect()
}

/// What both did: their work, and the number of events that were compared.
struct Compared {
    described: Work,
    written: Work,
    events: usize,
}

/// Runs both from where the one by hand rests, and compares events and readouts.
fn check<M, const N: usize>(
    (assembled, written): (Assembled<N>, M),
    (h, until): (f64, f64),
    input: impl Fn(f64) -> Motion + Copy,
) -> Compared
where
    M: Described<State = [f64; N]>,
{
    let number = |mode: M::Mode| usize::from(written.mode_code(mode).structure());
    let (mode, x) = written.at_rest(&input(0.0));
    let own = ModeNumber(u8::try_from(number(mode)).unwrap());
    let (one, described, _) = run(assembled, (own, x), (h, until), input);
    let (other, work, _) = run(written, (mode, x), (h, until), input);
    let (seen, wanted) = (story(&one, |mode| mode.0.into()), story(&other, number));
    let end = seen.len().min(wanted.len());
    for (seen, wanted) in seen.iter().zip(&wanted) {
        assert_eq!((seen.0, seen.1), (wanted.0, wanted.1), "{seen:?}, {wanted:?}");
        assert!((seen.2 - wanted.2).abs() < 1e-9, "{seen:?}, {wanted:?}");
    }
    let is_same = one.events().len() == end && other.events().len() == end;
    let last =
        if is_same { until } else { wanted.get(end).or(wanted.last()).map_or(0.0, |it| it.2) };
    let pairs = one.samples().iter().zip(other.samples());
    for (a, b) in pairs.take_while(|(a, _)| a.t < last - 1e-3) {
        let error = (a.readout - b.readout).abs();
        let size = 1.0 + b.readout.abs();
        assert!(error < 1e-9 * size, "at {}: {} is not {}", a.t, a.readout, b.readout);
    }
    Compared { described, written: work, events: end }
}

#[test]
fn model_a_throws_and_catches_as_the_one_by_hand() {
    let compared = check(both::<KeyHammerRigid, 2>(model_a(0)), (1e-3, 3.0), figure_6(1.0));
    assert!(compared.events >= 4, "{} events", compared.events);
    let (described, written) = (compared.described, compared.written);
    assert!(described.derivatives <= written.derivatives, "{described:?}, {written:?}");
}

/// Work over ticks of 1 ms under cubics through the input at both ends of each, as a board's
/// samples are: their magnitudes are known.
fn measured<M>(model: M, (mode, x): (M::Mode, M::State)) -> Work
where
    M: pode::Model<Input = Motion> + Resets,
{
    const H: f64 = 1e-3;
    let input = figure_6(1.0);
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut work = Work::default();
    for tick in 0..3000 {
        let [a, b] = [tick, tick + 1].map(|line| input(f64::from(line) * H));
        let (rise, rates) = (b.position - a.position, [a.rate * H, b.rate * H]);
        let c = [3.0 * rise - 2.0 * rates[0] - rates[1], rates[0] + rates[1] - 2.0 * rise];
        let signal = Cubic::new([a.position, rates[0], c[0], c[1]], H);
        let tick = simulator.advance(H, &signal, &mut Silent);
        assert_eq!(tick.advance, pode::Advance::Completed);
        work = work.plus(tick.work);
    }
    work
}

#[test]
fn its_steps_are_as_certain_as_those_by_hand() {
    let (assembled, written) = both::<KeyHammerRigid, 2>(model_a(0));
    let (mode, x) = written.at_rest(&Motion::default());
    let (described, least) =
        (measured(assembled, (ModeNumber(0), x)), measured(written, (mode, x)));
    assert_eq!(described.events, least.events);
    assert!(described.derivatives <= least.derivatives, "{described:?}, {least:?}");
    // A bound over the input knows its largest magnitude, and not where it is.
    assert!(described.guards <= least.guards + least.guards / 100, "{described:?}, {least:?}");
    assert!(described.unknown <= least.unknown, "{described:?}, {least:?}");
}

#[test]
fn model_b_plays_as_the_one_by_hand() {
    let compared = check(both::<KeyHammerSprings, 4>(model_b(0)), (1e-3, 3.0), figure_6(1.0));
    assert!(compared.events >= 8, "{} events", compared.events);
    let (described, written) = (compared.described, compared.written);
    assert!(described.derivatives <= written.derivatives, "{described:?}, {written:?}");
    assert!(described.guards <= written.guards, "{described:?}, {written:?}");
    assert!(described.unknown <= written.unknown, "{described:?}, {written:?}");
}

/// s(t) = A sin ωt.
fn sine(amplitude: f64, omega: f64) -> impl Fn(f64) -> Motion + Copy {
    move |t| {
        let (sin, cos) = (omega * t).sin_cos();
        let rates = [1.0, omega, omega * omega, omega * omega * omega].map(|it| amplitude * it);
        Motion {
            position: rates[0] * sin,
            rate: rates[1] * cos,
            acceleration: -rates[2] * sin,
            jerk: -rates[3] * cos,
        }
    }
}

#[test]
fn a_cart_meets_its_walls_as_the_one_by_hand() {
    let compared = check(both::<CartPendulum, 4>(cart()), (2.5e-4, 3.0), sine(0.1, 9.0));
    assert!(compared.events >= 3, "{} events", compared.events);
}

#[test]
fn a_ball_on_a_moving_floor_bounces_as_the_one_by_hand() {
    let compared = check(both::<BouncingBall, 2>(ball()), (1e-3, 3.0), sine(0.05, 20.0));
    assert!(compared.events >= 5, "{} events", compared.events);
}

#[test]
fn impacts_come_to_rest_in_the_mode_that_holds_what_meets() {
    let rests = |builder: MechanismBuilder| {
        let program = Derived::from(builder).system.clone().assemble().unwrap();
        let guards = program.table.modes[0].guards.iter();
        guards.map(|guard| guard.ways[0].resting.map(|it| it.to)).collect::<Vec<_>>()
    };
    assert_eq!(rests(ball()), [Some(1)], "on the floor");
    assert_eq!(rests(cart()), [Some(1), Some(2)], "at either wall");
}

#[test]
fn a_ball_comes_to_rest_on_the_floor_when_the_one_by_hand_does() {
    let (assembled, written) = both::<BouncingBall, 2>(ball());
    let still = |_| Motion::default();
    let start = [1.0, 0.0];
    let (one, _, _) = run(assembled, (ModeNumber(0), start), (1e-3, 6.0), still);
    let flight = hand_written::bouncing_ball::Mode::Flight;
    let (other, _, _) = run(written, (flight, start), (1e-3, 6.0), still);
    let (rest, expected) = (one.events().last().unwrap(), other.events().last().unwrap());
    assert_eq!((rest.to, expected.to), (ModeNumber(1), hand_written::bouncing_ball::Mode::Rest));
    assert!((rest.t - expected.t).abs() < 1e-9, "{} is not {}", rest.t, expected.t);
    assert!((one.impulse() - other.impulse()).abs() < 1e-9, "the impulse until then");
}
