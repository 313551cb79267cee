use instruments::equations::ModeNumber;
use pode::series::{INPUT_TERMS, add_bell};
use pode::stepper::{Controlled, Dop853, Stepper, Taylor, Tolerance};
use pode::{Advance, Energetic as _, Limits, Motion, RunRecorder, Signal, Simulator, Work};

use super::{model, named};
use crate::kane::runnable::{Runnable, runnable};
use crate::kane::stroke::{FIGURE_6, bells};

/// Strokes of figure 6 over one tick of `h` (s), with their series.
struct Strokes {
    from: f64,
    h: f64,
    scale: f64,
}

impl Signal<Motion> for Strokes {
    fn at(&self, theta: f64) -> Motion {
        let at = FIGURE_6.map(|[height, tc, w]| [self.scale * height, tc, w]);
        bells(&at, self.from + theta * self.h)
    }

    fn series(&self, theta: f64, span: f64, out: &mut [Motion]) -> bool {
        let (t, dt) = (self.from + theta * self.h, span * self.h);
        let mut terms = [0.0; INPUT_TERMS];
        for [height, tc, w] in FIGURE_6 {
            add_bell(&mut terms, self.scale * height, (t - tc) / w, dt / w);
        }
        for (out, position) in out.iter_mut().zip(terms) {
            *out = Motion { position, ..Motion::default() };
        }
        true
    }
}

/// Times (s), names and modes of a run's events, its end, and its work.
struct Outcome<const N: usize> {
    events: Vec<(f64, &'static str, u8)>,
    end: [f64; N],
    energies: Vec<f64>,
    work: Work,
}

fn run<const N: usize, T: Stepper>(
    model: Runnable<N>,
    method: T,
    (mode, start): (ModeNumber, [f64; N]),
    (h, ticks, scale): (f64, u32, f64),
) -> Outcome<N> {
    let mut simulator = Simulator::new(model, method, Limits::default(), mode, start);
    let mut recorder = RunRecorder::new(h);
    let (mut energies, mut work) = (Vec::new(), Work::default());
    for tick in 0..ticks {
        let strokes = Strokes { from: f64::from(tick) * h, h, scale };
        let done = simulator.advance(h, &strokes, &mut recorder);
        assert_eq!(done.advance, Advance::Completed, "tick {tick}");
        let input = strokes.at(1.0);
        energies.push(model.energy(simulator.mode(), simulator.state(), &input));
        work = done.work;
    }
    let events = recorder.events().iter().map(|it| (it.t, it.name, it.to.0)).collect();
    Outcome { events, end: *simulator.state(), energies, work }
}

fn exact() -> Controlled<Dop853> {
    Controlled { method: Dop853, tolerance: Tolerance::both(1e-13) }
}

fn same<const N: usize>(name: &str, one: &Outcome<N>, other: &Outcome<N>, within: f64) {
    let story = |it: &Outcome<N>| -> Vec<_> {
        it.events.iter().map(|(_, name, to)| (*name, *to)).collect()
    };
    assert_eq!(story(one), story(other), "{name}");
    for ((a, guard, _), (b, _, _)) in one.events.iter().zip(&other.events) {
        assert!((a - b).abs() < within, "{name}: {guard} at {a}, not at {b}: {:e}", a - b);
    }
    for (a, b) in one.end.iter().zip(&other.end) {
        assert!((a - b).abs() < 100.0 * within * (1.0 + b.abs()), "{name}: {a}, not {b}");
    }
}

#[test]
fn a_described_double_pendulum_meets_its_wall_when_another_method_says_so() {
    let program = named("double-pendulum");
    let model = model::<4>(&program, 0);
    let start = (ModeNumber(0), [-0.6, 0.3, 0.0, 0.0]);
    let span = (0.02, 50, 0.0);
    let taylor = run(model, Taylor::to(Tolerance::both(1e-14)), start, span);
    let other = run(model, exact(), start, span);
    assert!(taylor.events.len() >= 2, "{:?}", taylor.events);
    same("double pendulum", &taylor, &other, 1e-10);
}

#[test]
fn its_energy_stays() {
    let program = named("double-pendulum");
    let mut model = model::<4>(&program, 0);
    let mut values = model.parameters().to_vec();
    let wall = program.table.parameters.iter().position(|it| it.name == "wall").expect("a wall");
    values[wall] = 0.5;
    model = runnable(program.clone(), &values);
    let start = (ModeNumber(0), [-0.6, 0.3, 0.0, 4.0]);
    let taylor = run(model, Taylor::to(Tolerance::both(1e-15)), start, (0.1, 100, 0.0));
    let first = model.energy(start.0, &start.1, &Motion::default());
    let worst = taylor.energies.iter().fold(0.0, |most: f64, it| most.max((it - first).abs()));
    println!("{worst:e} of {first:e} J, {:?}", taylor.work);
    assert!(worst < 1e-12, "{worst:e} J");
}

#[test]
fn the_described_model_b_throws_and_catches_when_another_method_says_so() {
    let program = named("key-hammer-springs");
    let model = model::<4>(&program, 0);
    let rest = model.rest_pose(&Motion::default());
    let start = (rest.mode, rest.state);
    let taylor = run(model, Taylor::to(Tolerance::both(1e-14)), start, (2.5, 1, 1.0));
    let other = run(model, exact(), start, (1e-3, 2500, 1.0));
    assert!(taylor.events.len() >= 4, "{:?}", taylor.events);
    same("model B", &taylor, &other, 1e-11);
    println!("{:?}", taylor.work);
}

/// The third preset has a felt with a non-negative force: the step ends where it would be negative.
#[test]
fn a_step_ends_where_a_felt_is_left() {
    let program = named("key-hammer-springs");
    let playable = program.table.presets.iter().position(|it| it.name == "playable");
    let model = model::<4>(&program, playable.expect("a preset"));
    let rest = model.rest_pose(&Motion::default());
    let start = (rest.mode, rest.state);
    let taylor = run(model, Taylor::to(Tolerance::both(1e-14)), start, (1e-2, 250, 0.2));
    let other = run(model, exact(), start, (1e-4, 25000, 0.2));
    assert!(taylor.events.len() >= 2, "{:?}", taylor.events);
    same("model B with a felt", &taylor, &other, 1e-9);
}
