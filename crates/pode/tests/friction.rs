//! Sticking as a sliding mode: a mass on a spring, held by the friction of a belt.
//!
//! Error model, with r = ω h the radians per step: RK4 keeps a phase to r⁴/120, and its third-order
//! dense output takes r⁴/69 of the amplitude at an event. A speed errs like the amplitude times ω,
//! and the time of a landing by that over the slope of the slip speed.

use pode::filippov::{Branch, Filippov, Mode, Sided, Surface, SurfaceSide};
use pode::input::{Reconstruction, Reconstructor};
use pode::stepper::{Exact, Rk4};
use pode::{
    Advance, EquationKind, Limits, Motion, Nature, RecordedEvent, Silent, Simulator, Stepper,
};

use crate::common::{all_completed, close, each_step_and_phase};
use crate::driven::run_driven;

const RADIANS: f64 = 0.02;

/// Relative error of an amplitude after one event.
const LANDING: f64 = RADIANS * RADIANS * RADIANS * RADIANS / 69.0;

/// A mass on a spring on a belt: place (m) and speed (m/s) over a fixed ground.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Block {
    mass: f64,
    /// Stiffness of the spring (N/m).
    k: f64,
    /// Friction of a fast slip (N).
    kinetic: f64,
    /// Friction of a slow slip (N).
    slow: f64,
    /// Slip speed at which friction has fallen half way (m/s).
    half: f64,
    /// Static friction (N).
    limit: f64,
}

impl Block {
    fn coulomb(mass: f64, k: f64, friction: f64) -> Self {
        Self { mass, k, kinetic: friction, slow: friction, half: 1.0, limit: friction }
    }

    fn omega(&self) -> f64 {
        (self.k / self.mass).sqrt()
    }

    /// Returns the friction on the mass (N) at a slip speed `slip` over the belt (m/s).
    fn friction(&self, branch: Branch, slip: f64) -> f64 {
        let sign = branch.side.sign();
        let free = self.kinetic + (self.slow - self.kinetic) / (1.0 + sign * slip / self.half);
        -sign * if branch.holds { self.limit } else { free }
    }
}

impl Sided for Block {
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;
    const SIZE: f64 = 1.0;
    const RATE: f64 = 10.0;

    fn derivative(&self, branch: Branch, x: &[f64; 2], belt: &Motion) -> [f64; 2] {
        [x[1], (self.readout(branch, x, belt) - self.k * x[0]) / self.mass]
    }

    fn readout(&self, branch: Branch, x: &[f64; 2], belt: &Motion) -> f64 {
        self.friction(branch, x[1] - belt.rate)
    }

    fn surface(&self, x: &[f64; 2], belt: &Motion) -> Surface<[f64; 2]> {
        let drift = -belt.acceleration;
        Surface { value: x[1] - belt.rate, gradient: [0.0, 1.0], drift }
    }

    fn nature(&self, _: SurfaceSide) -> Nature {
        let is_coulomb = self.slow.to_bits() == self.kinetic.to_bits();
        Nature::new(
            if is_coulomb { EquationKind::Affine } else { EquationKind::Smooth },
            self.omega(),
        )
        .with_longest_step(RADIANS / self.omega())
    }
}

fn start(block: Block, x: [f64; 2], belt: &Motion) -> Simulator<Filippov<Block>, Rk4> {
    start_with(Rk4, block, x, belt)
}

fn start_with<T: Stepper>(
    stepper: T,
    block: Block,
    x: [f64; 2],
    belt: &Motion,
) -> Simulator<Filippov<Block>, T> {
    let model = Filippov(block);
    let (mode, state) = model.start(&x, belt);
    Simulator::new(model, stepper, Limits::default(), mode, state)
}

fn steady(speed: f64) -> impl Fn(f64) -> Motion {
    move |t| Motion { position: speed * t, rate: speed, ..Motion::default() }
}

fn ground(_: f64) -> Motion {
    Motion::default()
}

fn modes(seen: &[RecordedEvent<Filippov<Block>>]) -> Vec<Mode> {
    seen.iter().map(|it| it.to).collect()
}

/// Friction that falls as 1 + 0.5/(1 + s/0.05) (N): 1 kg, 100 N/m, a belt at 0.1 m/s.
/// Slip and stick times from Taylor series of 30 digits.
#[test]
fn stribeck_friction_has_its_limit_cycle() {
    const SLIP: f64 = 0.525_926_117_973_594_4;
    const STICK: f64 = 0.131_090_871_294_373_75;
    const CAPTURE: f64 = 0.001_890_912_870_562_624_6;
    let block = Block { slow: 1.5, half: 0.05, limit: 1.5, ..Block::coulomb(1.0, 100.0, 1.0) };
    each_step_and_phase(|h, phase| {
        let mut it = start(block, [0.0, 0.1], &steady(0.1)(0.0));
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 4.0, steady(0.1));
        all_completed(&ticks);
        let seen = recorder.events();
        assert!(seen.len() >= 12, "h {h}: {:?}", modes(seen));
        for (n, pair) in seen.chunks_exact(2).enumerate() {
            assert_eq!(modes(pair), [Mode::Below, Mode::Sliding], "h {h}, phase {phase}");
            let release = 0.15 + n as f64 * (SLIP + STICK);
            // The falling friction destabilises the slow slip: errors grow by e^(10 × 0.5).
            let tolerance = (n as f64 + 1.0) * 150.0 * LANDING / 10.0;
            close(format_args!("h {h}, release {n}"), pair[0].t, release, tolerance);
            close(format_args!("h {h}, capture {n}"), pair[1].t, release + SLIP, tolerance);
            close("place", pair[1].after[0], CAPTURE, 150.0 * LANDING * 0.02);
        }
    });
}

#[track_caller]
fn check_rest(block: Block, x0: f64, (h, phase): (f64, f64)) {
    let dead = block.kinetic / block.k;
    let swings = ((x0.abs() / dead - 1.0) / 2.0).ceil().max(0.0);
    let until = (swings + 1.0) * std::f64::consts::PI / block.omega();
    let mut it = start(block, [x0, 0.0], &ground(0.0));
    let (recorder, ticks) = run_driven(&mut it, (h, phase), until, ground);
    all_completed(&ticks);
    let found = recorder.events().len() as f64;
    assert!((found - swings).abs() < 0.5, "{found} turns, not {swings}: x0 {x0}, {block:?}");
    let mut x = x0;
    for (n, seen) in (1_u32..).zip(recorder.events()) {
        // Each swing goes about ±d, and ends 2d nearer.
        x = 2.0 * dead.copysign(x) - x;
        let error = f64::from(n) * x0.abs() * (LANDING + 3.2 * RADIANS.powi(4) / 120.0) + 1e-13;
        let turn = f64::from(n) * std::f64::consts::PI / block.omega();
        let slope = block.omega() * (x.abs() - dead).abs().max(dead);
        close(format_args!("turn {n} of {x0}, {block:?}"), seen.t, turn, error / slope + 1e-12);
        close(format_args!("place {n} of {x0}, {block:?}"), seen.after[0], x, error);
    }
    assert_eq!(it.mode(), Mode::Sliding, "x0 {x0}, {block:?}");
    close("it lies still", it.state()[1], 0.0, 1e-30);
    let held = ticks[ticks.len() - 1].end_readout;
    close("friction", held, block.k * it.state()[0], 1e-12 * block.kinetic);
}

#[test]
fn a_block_on_dry_ground_loses_twice_its_dead_band_per_swing_and_stops() {
    let block = Block::coulomb(0.2, 50.0, 0.3 * 0.2 * crate::common::G);
    let dead = block.kinetic / block.k;
    for swings in [0.5, 0.999, 1.5, 4.0, 7.7, 12.2, 30.1] {
        for sign in [1.0, -1.0] {
            each_step_and_phase(|h, phase| check_rest(block, sign * swings * dead, (h, phase)));
        }
    }
}

#[test]
fn a_block_at_the_very_end_of_its_dead_band_stays_there() {
    // 0.5 N on 50 N/m, in bits that round either way.
    for x in [0.01_f64, 0.01_f64.next_up(), 0.01_f64.next_down()] {
        let block = Block::coulomb(0.2, 50.0, 0.5);
        let mut it = start(block, [x, 0.0], &ground(0.0));
        let (recorder, ticks) = run_driven(&mut it, (1e-3, 0.0), 1.0, ground);
        all_completed(&ticks);
        assert!(recorder.events().len() <= 1, "{:?}", recorder.events());
        // One rounding of the force moves it by 1e-16 N/k.
        close("x", it.state()[0], x, 1e-15);
    }
}

#[test]
fn on_the_exact_flow_sticks_and_slips_are_known_to_rounding() {
    let exact = Exact;
    let block = Block { limit: 2.0, ..Block::coulomb(0.5, 80.0, 1.2) };
    let (speed, omega) = (0.15, block.omega());
    let a = (block.limit - block.kinetic) / block.k;
    let slip = (std::f64::consts::TAU - 2.0 * (a * omega / speed).atan()) / omega;
    let period = slip + 2.0 * a / speed;
    each_step_and_phase(|h, phase| {
        let mut it = start_with(exact, block, [0.0, speed], &steady(speed)(0.0));
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 4.0, steady(speed));
        all_completed(&ticks);
        assert!(recorder.events().len() >= 12, "h {h}");
        for (n, pair) in recorder.events().chunks_exact(2).enumerate() {
            let release = block.limit / (block.k * speed) + n as f64 * period;
            close(format_args!("h {h}, release {n}"), pair[0].t, release, 1e-12);
            close(format_args!("h {h}, capture {n}"), pair[1].t, release + slip, 1e-12);
        }
    });
}

#[test]
fn a_sampled_belt_carries_without_chatter() {
    // 1 kHz samples of s = 0.02 sin 9t: at each tick the belt's speed jumps a little.
    let block = Block::coulomb(1.0, 100.0, 2.5);
    let place = |t: f64| 0.02 * (9.0 * t).sin();
    for kind in [Reconstruction::Linear, Reconstruction::Quadratic, Reconstruction::LateHermite] {
        let mut reconstructor = Reconstructor::new(kind, place(-4e-3), 1e-3);
        for n in -3..0 {
            let _ = reconstructor.push(place(f64::from(n) * 1e-3));
        }
        let mut it = start(block, [0.0, 0.18], &Motion { rate: 0.18, ..Motion::default() });
        let mut events = 0;
        for n in 0..2000 {
            let belt = reconstructor.push(place(f64::from(n) * 1e-3));
            let tick = it.advance(1e-3, &belt, &mut Silent);
            assert_eq!(tick.advance, Advance::Completed);
            events += tick.work.events;
        }
        // |k x + m s''| ≤ 2 + 1.62 N in opposite phase: 0.38 N, so it never slips.
        assert_eq!((events, it.mode()), (0, Mode::Sliding), "{kind:?}");
        let lag = if kind == Reconstruction::LateHermite { 1e-3 } else { 0.0 };
        // The mass adds up the belt's reconstructed motion: jumps of s''' h² each tick.
        close(format_args!("{kind:?}"), it.state()[0], place(2.0 - lag), 2.0 * 0.02 * 729.0 * 1e-3);
    }
}

#[test]
fn a_belt_that_starts_with_a_jerk_tears_the_mass_off() {
    let block = Block::coulomb(1.0, 100.0, 1.0);
    for (jump, mode) in [(0.5, Mode::Below), (-0.5, Mode::Above), (1e-4, Mode::Sliding)] {
        let mut it = start(block, [0.0, 0.0], &ground(0.0));
        let _ = it.advance(1e-3, &ground, &mut Silent);
        assert_eq!(it.mode(), Mode::Sliding);
        let tick = it.advance(1e-3, &steady(jump), &mut Silent);
        assert_eq!((tick.advance, it.mode()), (Advance::Completed, mode), "a jump of {jump}");
    }
}
