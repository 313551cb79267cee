//! Stick and slip: a mass on a spring, held by the friction of a belt.
//!
//! Error model, with r = ω h the radians per step: RK4 keeps a phase to r⁴/120, and its third-order
//! dense output takes r⁴/69 of the amplitude at an event. A speed errs like the amplitude times ω,
//! and the time of a landing by that over the slope of the slip speed.

use pode::contacts::ContactState::{SlideDown, SlideUp, Stick};
use pode::input::{Reconstruction, Reconstructor};
use pode::stepper::{Exact, Rk4};
use pode::{Advance, EquationKind, Motion, Nature, Silent};

use crate::common::block::Block;
use crate::common::two_sided::{side, states};
use crate::common::{all_completed, close, each_step_and_phase};
use crate::driven::run_driven;

const RADIANS: f64 = 0.02;

/// Relative error of an amplitude after one event.
const LANDING: f64 = RADIANS * RADIANS * RADIANS * RADIANS / 69.0;

fn block(mass: f64, k: f64, limits: [f64; 2]) -> Block {
    let block = Block::new(mass, k, limits);
    let nature = block.nature.with_longest_step(RADIANS / block.omega());
    Block { nature, ..block }
}

fn coulomb(mass: f64, k: f64, friction: f64) -> Block {
    block(mass, k, [friction; 2])
}

fn steady(speed: f64) -> impl Fn(f64) -> Motion {
    move |t| Motion { position: speed * t, rate: speed, ..Motion::default() }
}

fn ground(_: f64) -> Motion {
    Motion::default()
}

/// Friction that falls as 1 + 0.5/(1 + (s/0.05)²) (N): 1 kg, 100 N/m, a belt at 0.1 m/s.
/// Slip and stick times from Taylor series of 30 digits.
#[test]
fn stribeck_friction_has_its_limit_cycle() {
    const SLIP: f64 = 0.517_950_581_622_033_8;
    const STICK: f64 = 0.154_190_792_093_540_78;
    const CAPTURE: f64 = -0.000_419_079_209_354_077_14;
    let block = block(1.0, 100.0, [1.5, 1.0]);
    let nature = Nature { kind: EquationKind::Smooth, ..block.nature };
    let block = Block { slow: [0.5, 0.05], nature, ..block };
    each_step_and_phase(|h, phase| {
        let mut it = block.clone().start(Rk4, [0.0, 0.1], &steady(0.1)(0.0));
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 4.5, steady(0.1));
        all_completed(&ticks);
        let seen = recorder.events();
        assert!(seen.len() >= 12, "h {h}: {:?}", states(seen));
        for (n, pair) in seen.chunks_exact(2).enumerate() {
            assert_eq!(states(pair), [SlideDown, Stick], "h {h}, phase {phase}");
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
fn check_rest(block: &Block, x0: f64, (h, phase): (f64, f64)) {
    let dead = block.kinetic / block.k;
    let swings = ((x0.abs() / dead - 1.0) / 2.0).ceil().max(0.0);
    let until = (swings + 1.0) * std::f64::consts::PI / block.omega();
    let mut it = block.clone().start(Rk4, [x0, 0.0], &ground(0.0));
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
    assert_eq!(side(it.mode()), Stick, "x0 {x0}, {block:?}");
    // A slip within the rounding of its size, 1 m/s, is left.
    close("it lies still", it.state()[1], 0.0, f64::EPSILON);
    let held = ticks[ticks.len() - 1].end_readout;
    close("friction", held, block.k * it.state()[0], 1e-12 * block.kinetic);
}

#[test]
fn a_block_on_dry_ground_loses_twice_its_dead_band_per_swing_and_stops() {
    let block = coulomb(0.2, 50.0, 0.3 * 0.2 * crate::common::G);
    let dead = block.kinetic / block.k;
    for swings in [0.5, 0.999, 1.5, 4.0, 7.7, 12.2, 30.1] {
        for sign in [1.0, -1.0] {
            each_step_and_phase(|h, phase| check_rest(&block, sign * swings * dead, (h, phase)));
        }
    }
}

#[test]
fn a_block_at_the_very_end_of_its_dead_band_stays_there() {
    // 0.5 N on 50 N/m, in bits that round either way.
    for x in [0.01_f64, 0.01_f64.next_up(), 0.01_f64.next_down()] {
        let mut it = coulomb(0.2, 50.0, 0.5).start(Rk4, [x, 0.0], &ground(0.0));
        let (recorder, ticks) = run_driven(&mut it, (1e-3, 0.0), 1.0, ground);
        all_completed(&ticks);
        assert!(recorder.events().len() <= 1, "{:?}", recorder.events());
        // One rounding of the force moves it by 1e-16 N/k.
        close("x", it.state()[0], x, 1e-15);
    }
}

#[test]
fn on_the_exact_flow_sticks_and_slips_are_known_to_rounding() {
    let block = Block::new(0.5, 80.0, [2.0, 1.2]);
    let (speed, omega) = (0.15, block.omega());
    let a = (block.stiction - block.kinetic) / block.k;
    let slip = (std::f64::consts::TAU - 2.0 * (a * omega / speed).atan()) / omega;
    let period = slip + 2.0 * a / speed;
    each_step_and_phase(|h, phase| {
        let mut it = block.clone().start(Exact, [0.0, speed], &steady(speed)(0.0));
        let (recorder, ticks) = run_driven(&mut it, (h, phase), 4.0, steady(speed));
        all_completed(&ticks);
        assert!(recorder.events().len() >= 12, "h {h}");
        for (n, pair) in recorder.events().chunks_exact(2).enumerate() {
            let release = block.stiction / (block.k * speed) + n as f64 * period;
            close(format_args!("h {h}, release {n}"), pair[0].t, release, 1e-12);
            close(format_args!("h {h}, capture {n}"), pair[1].t, release + slip, 1e-12);
        }
    });
}

#[test]
fn a_sampled_belt_carries_without_chatter() {
    // 1 kHz samples of s = 0.02 sin 9t: at each tick the belt's speed jumps a little.
    let place = |t: f64| 0.02 * (9.0 * t).sin();
    for kind in [Reconstruction::Linear, Reconstruction::Quadratic, Reconstruction::LateHermite] {
        let mut reconstructor = Reconstructor::new(kind, place(-4e-3), 1e-3);
        for n in -3..0 {
            let _ = reconstructor.push(place(f64::from(n) * 1e-3));
        }
        let belt = Motion { rate: 0.18, ..Motion::default() };
        let mut it = coulomb(1.0, 100.0, 2.5).start(Rk4, [0.0, 0.18], &belt);
        let mut events = 0;
        for n in 0..2000 {
            let belt = reconstructor.push(place(f64::from(n) * 1e-3));
            let tick = it.advance(1e-3, &belt, &mut Silent);
            assert_eq!(tick.advance, Advance::Completed);
            events += tick.work.events;
        }
        // |k x + m s''| ≤ 2 + 1.62 N in opposite phase: 0.38 N, so it never slips.
        assert_eq!((events, side(it.mode())), (0, Stick), "{kind:?}");
        let lag = if kind == Reconstruction::LateHermite { 1e-3 } else { 0.0 };
        // The mass adds up the belt's reconstructed motion: jumps of s''' h² each tick.
        close(format_args!("{kind:?}"), it.state()[0], place(2.0 - lag), 2.0 * 0.02 * 729.0 * 1e-3);
    }
}

#[test]
fn a_belt_that_starts_with_a_jerk_tears_the_mass_off() {
    for (jump, mode) in [(0.5, SlideDown), (-0.5, SlideUp), (1e-4, Stick)] {
        let mut it = coulomb(1.0, 100.0, 1.0).start(Rk4, [0.0, 0.0], &ground(0.0));
        let _ = it.advance(1e-3, &ground, &mut Silent);
        assert_eq!(side(it.mode()), Stick);
        let tick = it.advance(1e-3, &steady(jump), &mut Silent);
        assert_eq!((tick.advance, side(it.mode())), (Advance::Completed, mode), "a jump of {jump}");
    }
}
