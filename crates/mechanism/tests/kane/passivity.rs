//! Contact never creates energy in a described model.
//!
//! The driver's work (readout and impulses), less the losses of dampers and impacts, is stored,
//! except for the integration error: RK4's, of order 4 in h ω per oscillation, with ω the fastest
//! one that the model resolves (`longest_step`).

use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{
    Advance, Auditor, Energetic as _, EnergyAudit, Limits, Model as _, Motion, Silent, Simulator,
};
use proptest::prelude::*;

use crate::kane::runnable::{BALL, CART, GRAND, RIGID, Runnable, SPRINGS, WALL, mode, value};
use crate::kane::stroke::{AuditedRun, bells, presses, run, sine, still};

/// Accumulated rounding over a run (J).
const ROUNDING: f64 = 1e-12;

#[track_caller]
fn check_audited<const N: usize>(audited: &AuditedRun<Runnable<N>>, bound: f64) {
    let audit = &audited.audit;
    let scale = audited.throughput + audited.energies.0.abs().max(audited.energies.1.abs());
    let residual = audit.integration.abs();
    assert!(residual <= bound * scale + ROUNDING, "{residual:e} J made of {scale:e} J");
    assert!(audit.dissipated >= -ROUNDING, "dampers gave {:e} J", audit.dissipated);
    assert!(audited.generated <= ROUNDING, "an event made {:e} J", audited.generated);
    // Only the integration error is stored beyond the supplied energy.
    let made = audit.stored - audit.supplied - audited.impulsive;
    assert!(made <= bound * scale + ROUNDING, "{made:e} J from nowhere");
}

/// Returns (h ω)⁴/120 per radian, for ω of the model's longest step and `radians` of motion.
fn rk4_bound(h: f64, omega: f64, radians: f64) -> f64 {
    (h * omega).powi(4) / 120.0 * radians
}

fn stroke_of(size: f64) -> impl Strategy<Value = Vec<[f64; 3]>> {
    let bell = (0.1 * size..size, 0.2..0.8_f64, 0.04..0.15_f64);
    prop::collection::vec(bell.prop_map(|(a, tc, w)| [a, tc, w]), 1..3)
}

fn gestures() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let gesture = (-0.011..0.011_f64, 0.05..1.0_f64, 0.002..0.06_f64);
    prop::collection::vec(gesture.prop_map(|(a, tc, w)| [a, tc, w]), 1..8)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn model_b_is_passive(
        stroke in stroke_of(0.15),
        k1 in 2.0..30.0_f64,
        k2 in 5.0..200.0_f64,
        losses in (0.0..1.0_f64, 0.0..0.1_f64, 0.0..2.0_f64),
    ) {
        let (e, b1, c2) = losses;
        let changes = [("k1", k1), ("k2", k2), ("restitution", e), ("b1", b1), ("c2", c2)];
        let model = SPRINGS.model::<4>("paper", 0, &changes);
        let h = 2e-4;
        let start = model.at_rest(&bells_at(&stroke, 0.0));
        let (audited, _) = run(&model, start, (h, 1.2), |t| bells(&stroke, t));
        let omega = model.nature(mode(&model, "B1")).rate;
        check_audited(&audited, rk4_bound(h, omega, omega * 1.2));
    }

    #[test]
    fn model_a_is_passive(stroke in stroke_of(0.12), e in 0.0..1.0_f64) {
        let model = RIGID.model::<2>("paper", 0, &[("restitution", e)]);
        let h = 1e-3;
        let start = model.at_rest(&bells_at(&stroke, 0.0));
        let (audited, _) = run(&model, start, (h, 1.2), |t| bells(&stroke, t));
        // The audit is Simpson's rule over ticks: the stroke's own rate counts.
        let omega = stroke.iter().map(|bell| 4.0 / bell[2]).fold(0.0, f64::max);
        check_audited(&audited, rk4_bound(h, omega, omega * 1.2));
    }

    #[test]
    fn the_ball_is_passive(e in 0.0..1.0_f64, amplitude in 0.0..5e-3_f64, omega in 1.0..150.0_f64) {
        let model = BALL.model::<2>("default", 0, &[("restitution", e)]);
        let h = 1e-3;
        let start = (mode(&model, "flight"), [0.05, 0.0]);
        let (audited, _) = run(&model, start, (h, 1.0), |t| sine(amplitude, omega, t));
        check_audited(&audited, rk4_bound(h, omega, omega));
        // Many impacts in one move put the ball on a floor that moves evenly: off by s'' h²/2 at
        // most, which is weight lifted. Their end is extrapolated from their intervals, with an
        // error of some 1e-4 of the energy of the drop.
        let off = 9.81 * 0.5 * amplitude * omega * omega * h * h + 4e-4 * 9.81 * 0.05;
        let generated = audited.generated_settling;
        assert!(generated <= off, "settling generated {generated:e} J");
    }

    #[test]
    fn the_cart_is_passive(
        stroke in stroke_of(0.15),
        e in 0.0..1.0_f64,
        b in 0.0..5.0_f64,
        angle in -2.0..2.0_f64,
    ) {
        let model = CART.model::<4>("default", 0, &[("restitution", e), ("b", b)]);
        let h = 5e-4;
        let start = (mode(&model, "free"), [0.0, angle, 0.0, 0.0]);
        let (audited, _) = run(&model, start, (h, 1.2), |t| bells(&stroke, t));
        let omega = model.nature(mode(&model, "free")).rate;
        // Many impacts in one move let the pendulum swing evenly for h at most: its speed is off by
        // (g/l) θ' h²/2, its energy by (g/l) h² of itself.
        let swing = value(&model, "g") / value(&model, "length") * h * h;
        check_audited(&audited, rk4_bound(h, omega, omega * 1.2) + 2.0 * swing);
        let most = audited.energies.0 + value(&model, "bob_mass") * value(&model, "g") * value(&model, "length");
        let off = swing * most + ROUNDING;
        assert!(audited.generated_settling < off, "settling made {:e} J", audited.generated_settling);
    }

    #[test]
    fn the_reduced_grand_is_passive(gestures in gestures(), preset_of in 0..2_usize, key in 0..88_u8) {
        let model = GRAND.model::<4>(["default", "playable"][preset_of], key, &[]);
        let h = 2e-4;
        let start = model.at_rest(&presses(&gestures, 0.0));
        let (audited, _) = run(&model, start, (h, 1.2), |t| presses(&gestures, t));
        // However short the tick, the string has steps of a quarter of a radian; from the blow to
        // the rebound it is half a turn. The key's motion is 4 times slower.
        check_audited(&audited, rk4_bound(1.0, 0.25, core::f64::consts::PI));
    }

    #[test]
    fn the_wall_is_passive(
        stroke in stroke_of(0.012),
        stiffness in 10.0..5000.0_f64,
        damping in 0.0..10.0_f64,
    ) {
        let model = WALL.model::<1>("default", 0, &[("K", stiffness), ("B", damping)]);
        let h = 1e-3;
        let (audited, _) = run(&model, (mode(&model, "free"), [0.0]), (h, 1.5), |t| bells(&stroke, t));
        // Simpson's rule over the kink where it would begin to pull: one tick of second order, (h
        // ω)² of the power's peak.
        let omega = stroke.iter().map(|bell| 4.0 / bell[2]).fold(0.0, f64::max);
        check_audited(&audited, rk4_bound(h, omega, omega * 1.5) + (h * omega).powi(2) * 0.1);
        assert!(audited.ticks.iter().all(|tick| tick.mean_readout >= 0.0), "the wall pulls");
    }
}

fn bells_at(stroke: &[[f64; 3]], t: f64) -> Motion {
    still(bells(stroke, t).position)
}

#[test]
fn the_energy_that_the_method_makes_shrinks_with_the_fourth_power_of_the_step() {
    let stroke = [[0.099, 0.514, 0.079], [0.181, 1.095, 0.109]];
    let residual = |h: f64| {
        let model = SPRINGS.model::<4>("paper", 0, &[("c2", 0.5), ("b1", 0.02)]);
        let start = model.at_rest(&still(0.0));
        let (audited, _) = run(&model, start, (h, 2.0), |t| bells(&stroke, t));
        assert!(audited.audit.dissipated > 1e-4, "dissipated {} J", audited.audit.dissipated);
        audited.audit.integration.abs()
    };
    // The positions of events in their ticks make each halving better or worse; five of them are
    // 2^20 in the mean, and a mean order of 3.5 counts as 4.
    let (coarse, fine) = (residual(4e-3), residual(1.25e-4));
    let order = (coarse / fine).log2() / 5.0;
    assert!(order > 3.5, "{coarse:e} J, then {fine:e} J: order {order}");
}

#[test]
fn a_ball_at_the_edge_of_lifting_off_neither_caps_nor_sinks() {
    // A ω² is slightly above g: hops of 1e-14 m, under the rounding of the guard. With a
    // restitution of 0.9 some hops last so long that a tick in a few hundred is capped; it does not
    // sink then.
    for part in [1.0 - 1e-6, 1.0 + 1e-9, 1.0 + 1e-7, 1.0 + 1e-6, 1.0 + 1e-5, 1.0 + 1e-4] {
        for (e, capped) in [(0.0, 0), (0.1, 0), (0.314, 0), (0.5, 0), (0.9, 15)] {
            let model = BALL.model::<2>("default", 0, &[("restitution", e)]);
            let omega = 48.824;
            let amplitude = part * 9.81 / (omega * omega);
            let start = (mode(&model, "rest"), [0.0, 0.0]);
            let mut ball = Simulator::new(model, Rk4, Limits::default(), start.0, start.1);
            let (mut caps, mut events) = (0, 0);
            for tick in 0..3000 {
                let signal = |theta: f64| sine(amplitude, omega, (f64::from(tick) + theta) * 1e-3);
                let done = ball.advance(1e-3, &signal, &mut Silent);
                caps += u32::from(done.advance != Advance::Completed);
                events += done.work.events;
                let gap = ball.state()[0] - signal(1.0).position;
                assert!(gap > -1e-12, "{part}, e = {e}: {gap:e} m");
            }
            assert!(caps <= capped, "{part}, e = {e}: {caps} ticks are capped");
            assert!(events < 2000, "{part}, e = {e}: {events} events");
        }
    }
}

#[test]
fn an_auditor_that_remembers_the_last_state_sums_the_same_bits() {
    const H: f64 = 1e-3;
    let model = SPRINGS.model::<4>("playable", 39, &[]);
    let (mode, state) = model.at_rest(&still(0.0));
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
    let (mut plain, mut auditor) = (EnergyAudit::default(), Auditor::default());
    let (mut events, scale) = (0, model.input_per_metre());
    for tick in 0..1000 {
        // As with an estimate, the input jumps at the start of a tick.
        let s =
            presses(&[[9e-3 * scale, 0.1, 0.02], [-9e-3 * scale, 0.5, 0.02]], f64::from(tick) * H);
        let signal = Cubic::ballistic(s.position, s.rate, 0.9 * s.acceleration, H);
        let done = simulator.advance(H, &signal, &mut (&mut plain, &mut auditor));
        events += done.work.events;
    }
    assert!(4 <= events, "{events} events");
    assert_eq!(auditor.sums, plain);
    assert!(plain.supplied > 1e-3 && plain.integration.abs() < 1e-3 * plain.supplied, "{plain:?}");
}

/// Runs model B over a press with an input that is `sampled` at each tick and held; returns the
/// audit, and the change of the stored energy in a run without one.
fn held(sampled: impl Fn(f64) -> f64) -> (EnergyAudit, f64) {
    const H: f64 = 1e-3;
    let model = SPRINGS.model::<4>("playable", 39, &[]);
    let scale = model.input_per_metre();
    let (mode, state) = model.at_rest(&still(0.0));
    let input_at = |tick: u32| {
        let s = presses(&[[9e-3, 0.1, 0.02], [-9e-3, 0.5, 0.02]], f64::from(tick) * H);
        still(scale * sampled(s.position))
    };
    let mut input = input_at(0);
    let start = model.energy(mode, &state, &input);
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
    let mut audit = EnergyAudit::default();
    for tick in 0..1000 {
        input = input_at(tick);
        let signal = Cubic::ballistic(input.position, 0.0, 0.0, H);
        simulator.advance(H, &signal, &mut audit);
    }
    (audit, simulator.model().energy(simulator.mode(), simulator.state(), &input) - start)
}

#[test]
fn what_a_held_or_quantised_input_puts_in_is_booked_as_sampling() {
    for quantum in [0.0, 0.5e-3] {
        let (audit, stored) =
            held(|x| if 0.0 < quantum { (x / quantum).round() * quantum } else { x });
        // Nothing moves within a tick, so all work is done between ticks.
        assert_eq!(audit.supplied.to_bits(), 0.0_f64.to_bits(), "{audit:?}");
        assert!(1e-3 < audit.sampling, "{audit:?}");
        let size = audit.sampling + audit.dissipated - audit.jumps;
        assert!(audit.residual().abs() < 1e-12 * size, "{audit:?}");
        assert!((audit.stored - stored).abs() < 1e-12 * size, "{audit:?}: {stored} J");
        assert!(audit.integration.abs() < 1e-3 * size, "{audit:?}");
    }
}
