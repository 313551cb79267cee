//! Taylor's method: its order, its tolerance, its events (case C3), and models without a series.

use pode::series::Expansion;
use pode::stepper::{Memory as _, Taylor, TaylorMemory, Tolerance};
use pode::{
    Dense as _, Field, GuardSpec, GuardValue, Limits, Nature, RunRecorder, Silent, Simulator,
    Stepper as _,
};

use crate::common::{G, OneMode};
use crate::pendulum::{IMPACTS, Pendulum};

const EXPANDED: Pendulum = Pendulum { has_wall: true, has_series: true };

/// Expands θ'' = −9.81 sin θ by hand: sine and cosine drive each other. The guard is the angle.
pub fn expand(out: &mut Expansion<[f64; 2]>) {
    let (sine, cosine) = out.terms[0][0].sin_cos();
    let (mut sines, mut cosines) = (vec![sine], vec![cosine]);
    for k in 0..out.order {
        if k > 0 {
            // k sₖ = Σ j θⱼ cₖ₋ⱼ, and the same of the cosine.
            let of = |other: &[f64]| -> f64 {
                let terms = (1..=k).map(|j| j as f64 * out.terms[j][0] * other[k - j]);
                terms.sum::<f64>() / k as f64
            };
            let (sine, cosine) = (of(&cosines), -of(&sines));
            sines.push(sine);
            cosines.push(cosine);
        }
        let by = out.scale / (k + 1) as f64;
        out.terms[k + 1] = [by * out.terms[k][1], -by * G * sines[k]];
    }
    for k in 0..=out.order {
        out.guards[0][k] = out.terms[k][0];
    }
    out.known_guards = 1;
}

#[expect(clippy::large_stack_frames, reason = "a simulator on the stack of a test")]
fn impacts(pendulum: Pendulum, tolerance: f64, h: f64) -> (f64, pode::Work) {
    let method = Taylor::to(Tolerance::both(tolerance));
    let limits = Limits { events: 64, ..Limits::default() };
    let mut pendulum = Simulator::new(pendulum, method, limits, (), [1.2, 0.0]);
    let mut recorder = RunRecorder::new(h);
    let report = pendulum.run(10.0, h, |_| (), &mut recorder);
    assert!(report.is_completed());
    let times = recorder.times_of("wall");
    assert_eq!(times.len(), 10);
    let error = IMPACTS.iter().map(|(n, time)| (times[n - 1] - time).abs()).fold(0.0, f64::max);
    (error, report.work)
}

#[test]
fn a_pendulum_meets_its_wall_within_the_tolerance() {
    let mut last = f64::INFINITY;
    for tolerance in [1e-6, 1e-9, 1e-12, 1e-15] {
        let (error, work) = impacts(EXPANDED, tolerance, 10.0);
        assert!(error < 10.0 * tolerance + 2e-14, "{tolerance:e}: {error:e}");
        assert!(error <= last, "{tolerance:e} is no better: {error:e}");
        assert_eq!((work.unknown, work.events), (0, 10), "every step is certain");
        assert!(work.pieces < 120, "{} steps", work.pieces);
        last = error;
    }
}

#[test]
fn ticks_do_not_matter_to_it() {
    for h in [10.0, 0.25, 1e-2] {
        let (error, _) = impacts(EXPANDED, 1e-14, h);
        assert!(error < 1e-13, "{h}: {error:e}");
    }
}

#[test]
fn a_model_without_a_series_is_stepped_within_the_tolerance_too() {
    let (error, work) = impacts(Pendulum { has_series: false, ..EXPANDED }, 1e-10, 10.0);
    assert!(error < 1e-8, "{error:e}");
    assert!(work.pieces > 200, "steps of order 5: {}", work.pieces);
}

struct Swing;

impl Field<[f64; 2]> for Swing {
    fn coords(&self) -> usize {
        1
    }

    fn nature(&self) -> Nature {
        Nature::default()
    }

    fn derivative(&mut self, _: f64, x: &[f64; 2]) -> [f64; 2] {
        [x[1], -G * x[0].sin()]
    }

    fn expand(&mut self, out: &mut Expansion<[f64; 2]>) -> bool {
        expand(out);
        true
    }
}

fn after(order: usize, h: f64) -> [f64; 2] {
    let method = Taylor { order, tolerance: Tolerance::default() };
    let mut memory = TaylorMemory::default();
    memory.restart();
    *method.step(&mut Swing, &[0.7, 0.4], &mut memory, h).dense.end()
}

#[test]
fn a_step_of_order_p_errs_by_the_power_p_plus_one() {
    for order in [4_u8, 5, 7] {
        let error = |h: f64| (after(order.into(), h)[0] - after(24, h)[0]).abs();
        let observed = (error(0.06) / error(0.03)).log2();
        let expected = f64::from(order) + 1.0;
        assert!((observed - expected).abs() < 0.6, "{order}: {observed}");
    }
}

#[test]
fn the_dense_output_solves_the_equation_inside_the_step() {
    let method = Taylor { order: 20, tolerance: Tolerance::default() };
    let h = 0.1;
    let step = method.step(&mut Swing, &[0.7, 0.4], &mut TaylorMemory::default(), h);
    for n in 1..10 {
        let tau = 0.1 * f64::from(n);
        let there = method.step(&mut Swing, &[0.7, 0.4], &mut TaylorMemory::default(), tau * h);
        let (dense, exact) = (step.dense.at(tau), there.dense.end());
        assert!((dense[0] - exact[0]).abs() < 4e-16 && (dense[1] - exact[1]).abs() < 4e-15);
    }
}

#[test]
fn a_pendulum_keeps_its_energy_for_a_thousand_swings() {
    let energy = |x: &[f64; 2]| 0.5 * x[1] * x[1] - G * x[0].cos();
    let limits = Limits { pieces: u32::MAX, guards: u32::MAX, ..Limits::default() };
    let free = Pendulum { has_wall: false, has_series: true };
    let method = Taylor::to(Tolerance::both(1e-15));
    let mut pendulum = Simulator::new(free, method, limits, (), [1.2, 0.0]);
    let before = energy(pendulum.state());
    assert!(pendulum.run(2000.0, 2000.0, |_| (), &mut Silent).is_completed());
    let drift = (energy(pendulum.state()) - before).abs();
    assert!(drift < 1e-12, "{drift:e}");
}

const LOWEST: f64 = 0.123_456_789;

/// Returns a gap that is a parabola in time: it dips to −`depth` at [`LOWEST`].
fn graze(depth: f64) -> OneMode<f64, 1> {
    OneMode {
        guards: const { &[GuardSpec::new(0, "gap").on_crossing()] },
        guard: |depth, _, x| {
            let from = x[0] - LOWEST;
            GuardValue::new(10.0 * (from * from - depth), 20.0 * from)
        },
        series: Some(|depth, out| {
            let from = out.terms[0][0] - LOWEST;
            for k in 1..=out.order {
                out.terms[k] = [if k == 1 { out.scale } else { 0.0 }];
                out.guards[0][k] = 0.0;
            }
            out.guards[0][0] = 10.0 * (from * from - depth);
            out.guards[0][1] = 20.0 * from * out.scale;
            out.guards[0][2] = 10.0 * out.scale * out.scale;
            out.known_guards = 1;
        }),
        ..OneMode::new(depth, |_, _| [1.0])
    }
}

#[test]
fn a_graze_is_seen_in_a_step_that_is_a_million_times_longer() {
    for depth in [1e-4, 1e-6, 1e-8, 1e-10, -1e-4, -1e-8] {
        let mut graze = graze(depth).start(Taylor::default(), [0.0]);
        let mut recorder = RunRecorder::new(1.0);
        assert!(graze.run(1.0, 1.0, |_| (), &mut recorder).is_completed());
        let times = recorder.times_of("gap");
        if depth < 0.0 {
            assert_eq!(times.len(), 0, "{depth:e}: {times:?}");
            continue;
        }
        assert_eq!(times.len(), 1, "{depth:e}");
        let error = (times[0] - (LOWEST - depth.sqrt())).abs();
        assert!(error < 1e-15 / depth.sqrt() + 2e-12, "{depth:e}: {error:e}");
    }
}

/// Returns x' = `way` (1 + max(x, 0)): a straight line below zero, an exponential above it.
fn bent(way: f64) -> OneMode<f64, 1> {
    OneMode {
        series: Some(|way, out| {
            let is_above = out.terms[0][0] > 0.0;
            for k in 0..out.order {
                let above = if is_above { out.terms[k][0] } else { 0.0 };
                let one = if k == 0 { 1.0 } else { 0.0 };
                let rate = way * (one + above);
                out.terms[k + 1] = [out.scale * rate / (k + 1) as f64];
            }
            for k in 0..=out.order {
                out.conditions[0][k] = out.terms[k][0];
            }
            out.known_conditions = 1;
        }),
        ..OneMode::new(way, |way, x| [way * (1.0 + x[0].max(0.0))])
    }
}

#[test]
fn a_step_ends_where_the_equations_change_their_form() {
    let e = 1.0_f64.exp();
    // Both reach zero after 1 s, from −1 or from e − 1.
    for (way, from) in [(1.0, -1.0), (-1.0, e - 1.0)] {
        for h in [3.0, 0.7, 0.1, 1.0] {
            let method = Taylor::to(Tolerance::both(1e-14));
            let mut bent = bent(way).start(method, [from]);
            let ticks = (3.0_f64 / h).floor();
            let report = bent.run(ticks * h, h, |_| (), &mut Silent);
            assert!(report.is_completed());
            let after = ticks * h - 1.0;
            let expected = match (way > 0.0, after > 0.0) {
                (true, true) => after.exp_m1(),
                (true, false) => after,
                (false, true) => -after,
                (false, false) => (-after).exp_m1(),
            };
            let error = (bent.state()[0] - expected).abs() / (1.0 + expected.abs());
            assert!(error < 1e-13, "{way}, ticks of {h} s: {error:e}");
            assert!(
                report.work.pieces <= 12 + u32::try_from(report.ticks).expect("few ticks"),
                "{:?}",
                report.work
            );
        }
    }
}
