//! Contact never creates energy.
//!
//! What the driver puts in (readout and impulses), less what dampers and impacts take,
//! is what is stored, but for the integration error: RK4's, of order 4 in h ω per
//! oscillation, with ω the fastest one that the model resolves (`longest_step`).

use hand_written::bouncing_ball::Mode as Ball;
use hand_written::cart_pendulum::Mode as Cart;
use hand_written::key_hammer_rigid::Mode as Rigid;
use hand_written::key_hammer_springs::Mode as Springs;
use hand_written::spring_wall::Mode as Wall;
use hand_written::{
    BouncingBall, CartPendulum, KeyHammerRigid, KeyHammerSprings, ReducedGrand, SpringWall,
};
use models::Described;
use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{Auditor, Energetic as _, EnergyAudit, Limits, Model as _, Motion, Simulator};
use proptest::prelude::*;

use crate::stroke::{Books, bells, preset, presses, run, sine, still};

/// What rounding adds up to over a run (J).
const ROUNDING: f64 = 1e-12;

/// What the integration made, against `bound` of the energy that went through.
#[track_caller]
fn check_books<M: Described>(books: &Books<M>, bound: f64) {
    let label = std::any::type_name::<M>();
    let audit = &books.audit;
    let scale = books.throughput + books.energies.0.abs().max(books.energies.1.abs());
    let residual = audit.integration.abs();
    assert!(residual <= bound * scale + ROUNDING, "{label}: {residual:e} J made of {scale:e} J");
    assert!(audit.dissipated >= -ROUNDING, "{label}: dampers gave {:e} J", audit.dissipated);
    assert!(books.made <= ROUNDING, "{label}: an event made {:e} J", books.made);
    // Stored beyond what was put in: nothing but the integration error.
    let made = audit.stored - audit.supplied - books.impulsive;
    assert!(made <= bound * scale + ROUNDING, "{label}: {made:e} J from nowhere");
}

/// (h ω)⁴/120 per radian, for ω of the model's longest step and `radians` of motion.
fn rk4_bound(h: f64, omega: f64, radians: f64) -> f64 {
    (h * omega).powi(4) / 120.0 * radians
}

/// Bells of up to `size`, 40–150 ms wide, within the first second.
fn stroke_of(size: f64) -> impl Strategy<Value = Vec<[f64; 3]>> {
    let bell = (0.1 * size..size, 0.2..0.8_f64, 0.04..0.15_f64);
    prop::collection::vec(bell.prop_map(|(a, tc, w)| [a, tc, w]), 1..3)
}

/// Up to eight presses and releases of a key, 2–60 ms long, within the first second.
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
        let model: KeyHammerSprings = preset("paper", 0, &changes);
        let h = 2e-4;
        let start = model.at_rest(&bells_at(&stroke, 0.0));
        let (books, _) = run(model, start, (h, 1.2), |t| bells(&stroke, t));
        let omega = 0.75 / model.longest_step(Springs::B1);
        check_books(&books, rk4_bound(h, omega, omega * 1.2));
    }

    #[test]
    fn model_a_is_passive(stroke in stroke_of(0.12), e in 0.0..1.0_f64) {
        let model: KeyHammerRigid = preset("paper", 0, &[("restitution", e)]);
        let h = 1e-3;
        let start = model.at_rest(&bells_at(&stroke, 0.0));
        let (books, _) = run(model, start, (h, 1.2), |t| bells(&stroke, t));
        // The books are Simpson's rule over ticks: the stroke's own rate counts.
        let omega = stroke.iter().map(|bell| 4.0 / bell[2]).fold(0.0, f64::max);
        check_books(&books, rk4_bound(h, omega, omega * 1.2));
    }

    #[test]
    fn the_ball_is_passive(e in 0.0..1.0_f64, amplitude in 0.0..5e-3_f64, omega in 1.0..150.0_f64) {
        let model: BouncingBall = preset("default", 0, &[("restitution", e)]);
        let h = 1e-3;
        let start = (Ball::Flight, [0.05, 0.0]);
        let (books, _) = run(model, start, (h, 1.0), |t| sine(amplitude, omega, t));
        check_books(&books, rk4_bound(h, omega, omega));
        // Many impacts in one move put the ball on a floor that moves evenly: off by
        // s'' h²/2 at most, which is weight lifted.
        let off = 0.5 * amplitude * omega * omega * h * h;
        assert!(books.made_settling <= 9.81 * off + ROUNDING, "{:e} J", books.made_settling);
    }

    #[test]
    fn the_cart_is_passive(
        stroke in stroke_of(0.15),
        e in 0.0..1.0_f64,
        b in 0.0..5.0_f64,
        angle in -2.0..2.0_f64,
    ) {
        let model: CartPendulum = preset("default", 0, &[("restitution", e), ("b", b)]);
        let h = 5e-4;
        let start = (Cart::Free, [0.0, angle, 0.0, 0.0]);
        let (books, _) = run(model, start, (h, 1.2), |t| bells(&stroke, t));
        let omega = 0.25 / model.longest_step(Cart::Free);
        // Many impacts in one move let the pendulum swing evenly for h at most: its speed
        // is off by (g/l) θ' h²/2, its energy by (g/l) h² of itself.
        let swing = model.g / model.length * h * h;
        check_books(&books, rk4_bound(h, omega, omega * 1.2) + 2.0 * swing);
        let most = books.energies.0 + model.bob_mass * model.g * model.length;
        let off = swing * most + ROUNDING;
        assert!(books.made_settling < off, "settling made {:e} J", books.made_settling);
    }

    #[test]
    fn the_reduced_grand_is_passive(gestures in gestures(), preset_of in 0..2_usize, key in 0..88_u8) {
        let model: ReducedGrand = preset(["default", "playable"][preset_of], key, &[]);
        let h = 2e-4;
        let start = model.at_rest(&presses(&gestures, 0.0));
        let (books, _) = run(model, start, (h, 1.2), |t| presses(&gestures, t));
        // However short the tick, the string is taken in steps of a quarter of a radian; from
        // the blow to the rebound it is half a turn. The key's motion is 4 times slower.
        check_books(&books, rk4_bound(1.0, 0.25, core::f64::consts::PI));
    }

    #[test]
    fn the_wall_is_passive(
        stroke in stroke_of(0.012),
        stiffness in 10.0..5000.0_f64,
        damping in 0.0..10.0_f64,
    ) {
        let model: SpringWall = preset("default", 0, &[("K", stiffness), ("B", damping)]);
        let h = 1e-3;
        let (books, _) = run(model, (Wall::Free, []), (h, 1.5), |t| bells(&stroke, t));
        // Simpson's rule over the kink where it would begin to pull: one tick of
        // second order, (h ω)² of the power's peak.
        let omega = stroke.iter().map(|bell| 4.0 / bell[2]).fold(0.0, f64::max);
        check_books(&books, rk4_bound(h, omega, omega * 1.5) + (h * omega).powi(2) * 0.1);
        assert!(books.ticks.iter().all(|tick| tick.mean_readout >= 0.0), "the wall pulls");
    }
}

fn bells_at(stroke: &[[f64; 3]], t: f64) -> Motion {
    still(bells(stroke, t).position)
}

#[test]
fn the_energy_that_the_method_makes_shrinks_with_the_fourth_power_of_the_step() {
    let stroke = [[0.099, 0.514, 0.079], [0.181, 1.095, 0.109]];
    let residual = |h: f64| {
        let model: KeyHammerSprings = preset("paper", 0, &[("c2", 0.5), ("b1", 0.02)]);
        let start = model.at_rest(&still(0.0));
        let (books, _) = run(model, start, (h, 2.0), |t| bells(&stroke, t));
        assert!(books.audit.dissipated > 1e-4, "dissipated {} J", books.audit.dissipated);
        books.audit.integration.abs()
    };
    // Where events fall in their ticks makes each halving better or worse; five of them
    // are 2^20 in the mean, and a mean order of 3.5 is taken for 4.
    let (coarse, fine) = (residual(4e-3), residual(1.25e-4));
    let order = (coarse / fine).log2() / 5.0;
    assert!(order > 3.5, "{coarse:e} J, then {fine:e} J: order {order}");
}

#[test]
fn a_ball_at_the_edge_of_lifting_off_neither_caps_nor_sinks() {
    // A ω² is g and a little: hops of 1e-14 m, under the rounding of the guard.
    for part in [1.0 - 1e-6, 1.0 + 1e-9, 1.0 + 1e-7, 1.0 + 1e-6, 1.0 + 1e-5, 1.0 + 1e-4] {
        for e in [0.0, 0.1, 0.314, 0.5, 0.9] {
            let model: BouncingBall = preset("default", 0, &[("restitution", e)]);
            let omega = 48.824;
            let amplitude = part * 9.81 / (omega * omega);
            let start = (Ball::Rest, [0.0, 0.0]);
            let (books, ball) = run(model, start, (1e-3, 3.0), |t| sine(amplitude, omega, t));
            let gap = ball.state()[0] - sine(amplitude, omega, 3.0).position;
            assert!(gap > -1e-12, "{part}, e = {e}: {gap:e} m");
            assert!(books.events.len() < 2000, "{part}, e = {e}: {} events", books.events.len());
        }
    }
}

#[test]
fn model_b_keeps_its_energy_in_free_motion() {
    // From a stretched spring, with s constant: through releases and landings, no string.
    let model: KeyHammerSprings = preset("paper", 0, &[]);
    let s = still(0.05);
    let (_, mut x) = model.at_rest(&s);
    x[2] = 1.0;
    x[3] = -1.0;
    let (books, _) = run(model, (Springs::B1, x), (1e-4, 2.0), |_| s);
    assert!(books.events.len() > 3, "{:?}", books.names());
    assert!(!books.names().contains(&"string"));
    let energy = model.energy(Springs::B1, &x, &s).abs();
    let spread = books.spread();
    assert!(spread < 1e-9 * energy.max(0.01), "energy moves by {spread:e} J");
}

#[test]
fn the_hammer_of_model_a_keeps_its_energy_in_flight() {
    let model: KeyHammerRigid = preset("paper", 0, &[]);
    let s = still(0.0);
    let (_, x) = model.at_rest(&s);
    let start = (Rigid::A2, [x[0] + 1e-3, 4.0]);
    let (books, _) = run(model, start, (1e-4, 0.7), |_| s);
    assert_eq!(books.names(), ["string", "land"], "up, back from the string, and down");
    // The landing is plastic and takes what there was; until then nothing is lost.
    let in_flight = books.events[1].t;
    let (books, _) = run(model, start, (1e-4, in_flight - 1e-3), |_| s);
    let spread = books.spread();
    assert!(spread < 1e-9 * 0.08, "energy moves by {spread:e} J");
}

#[test]
fn an_elastic_cart_keeps_its_energy_over_many_walls() {
    let model: CartPendulum = preset("default", 0, &[("restitution", 1.0)]);
    let start = (Cart::Free, [0.0, 1.0, 1.0, 0.0]);
    let (books, _) = run(model, start, (1e-4, 10.0), |_| still(0.0));
    assert!(books.events.len() > 50, "{} events", books.events.len());
    let spread = books.spread();
    assert!(spread < 1e-8, "energy moves by {spread:e} J");
}

#[test]
fn an_auditor_that_remembers_the_last_state_sums_the_same_bits() {
    const H: f64 = 1e-3;
    let model: KeyHammerSprings = preset("playable", 39, &[]);
    let (mode, state) = model.at_rest(&still(0.0));
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
    let (mut plain, mut auditor) = (EnergyAudit::default(), Auditor::default());
    let (mut events, scale) = (0, models::Playable::input_per_metre(&model));
    for tick in 0..1000 {
        // As from an estimate, the input jumps where a tick begins.
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

/// Runs model B over a press whose input is `sampled` at each tick and held; returns the audit, and
/// the change of the stored energy as it is without one.
fn held(sampled: impl Fn(f64) -> f64) -> (EnergyAudit, f64) {
    const H: f64 = 1e-3;
    let model: KeyHammerSprings = preset("playable", 39, &[]);
    let scale = models::Playable::input_per_metre(&model);
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
