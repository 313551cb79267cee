//! Compares impedances with closed forms that share no code with the product.

use std::path::Path;

use std::f64::consts::TAU;

use crate::stability::{LoopQuantity, LoopValues, VoiceOrder, wall};
use haptics::{EstimatorName, RigParameters};
use nalgebra_of_lm::Complex;

use super::*;

type Z = Complex<f64>;

fn j_omega(frequency: f64) -> Z {
    Complex::new(0.0, TAU * frequency)
}

fn values(model: &instruments::ModelEntry, changed: &[(&str, f64)]) -> Vec<f64> {
    model.values(|name| changed.iter().find(|it| it.0 == name).map(|it| it.1))
}

/// Asserts that a mode's impedance is `expected`, from 1 Hz to 1 kHz.
///
/// Slopes are central differences over a millionth of usual sizes: rounding leaves 1e-9 of forces
/// of newtons, the third derivative less. 1e-6 of |Z| is a hundred times that.
#[track_caller]
fn check_mode(
    name: &str,
    changed: &[(&str, f64)],
    mode: &str,
    depth: f64,
    expected: &dyn Fn(f64) -> Z,
) {
    let model = mechanism::Library::default().find(name, Path::new("")).unwrap();
    let values = values(&model, changed);
    let held = HeldMode { model: &model, values: &values, mode: Some(mode), depth };
    let linear = linearise(&held).unwrap();
    assert_eq!(linear.mode, mode);
    for frequency in frequencies((1.0, 1e3), 25) {
        let (found, expected) = (linear.at(frequency).unwrap(), expected(frequency));
        let error = (found - expected).norm() / expected.norm();
        assert!(error < 1e-6, "{name} {mode} at {frequency} Hz: {found}, expected {expected}");
    }
}

#[test]
fn a_spring_and_a_damper_have_k_over_j_omega_plus_b() {
    for (k, b) in [(1e3, 0.5), (4e4, 0.0), (10.0, 20.0)] {
        let changed = [("K", k), ("B", b), ("wall", 2e-3)];
        check_mode("spring-wall", &changed, "contact", 6e-3, &|f| b + k / j_omega(f));
    }
}

/// Returns the hammer's turn per key's where the paper's key holds its hammer at the angle `s`,
/// and the lever from the slider to the hammer's pivot (m).
fn lever(s: f64, l1: f64, l3: f64, l4: f64) -> (f64, f64) {
    let (x, y) = (l1 * s.cos() - l3, l1 * s.sin() - l4);
    // θh = atan2(y, x).
    let turn = (x * l1 * s.cos() + y * l1 * s.sin()) / (x * x + y * y);
    (turn, x.hypot(y))
}

const L1: f64 = 0.4;
const L3: f64 = 0.1;
const L4: f64 = 0.05;

#[test]
fn model_a_is_a_mass_with_its_hammer_and_a_smaller_one_without() {
    let (jk, jh, r) = (0.016_25, 0.01, 0.0762 / std::f64::consts::FRAC_PI_4);
    let depth = 6e-3;
    let (turn, _) = lever(depth / r, L1, L3, L4);
    let weightless = [("g", 0.0)];
    let mass = |inertia: f64| move |f| j_omega(f) * (inertia / (r * r));
    check_mode("key-hammer-rigid", &weightless, "A1", depth, &mass(jk + jh * turn * turn));
    check_mode("key-hammer-rigid", &weightless, "A2", depth, &mass(jk));
}

#[test]
fn model_b_is_two_springs_and_two_masses_and_in_flight_one_of_each() {
    let (jk, jh, r) = (0.016_25, 0.01, 0.0762 / std::f64::consts::FRAC_PI_4);
    let depth = 6e-3;
    // Without gravity k2 is not pressed, and the slider lies on the key's line: q4 changes by
    // −q3/cos δ per hammer's angle and L1 per key's.
    let (_, q3) = lever(depth / r, L1, L3, L4);
    let s = depth / r;
    let hammer_angle = (L1 * s.sin() - L4).atan2(L1 * s.cos() - L3);
    let arm = q3 / (s - hammer_angle).cos();
    for (k1, k2, b1) in [(6.2, 15.0, 0.0), (300.0, 24e3, 0.12)] {
        let changed = [("g", 0.0), ("k1", k1), ("k2", k2), ("b1", b1)];
        let expected = |contact: f64| {
            move |f| {
                let p = j_omega(f);
                let coupling = k1 + b1 * p;
                let hammer = contact * arm * arm + jh * p * p;
                let across = contact * arm * L1;
                let key = coupling + contact * L1 * L1 + jk * p * p - across * across / hammer;
                (coupling - coupling * coupling / key) / (r * r) / p
            }
        };
        check_mode("key-hammer-springs", &changed, "B1", depth, &expected(k2));
        check_mode("key-hammer-springs", &changed, "B2", depth, &expected(0.0));
    }
}

/// Returns the impedance of a sampled, held and late wall: the backward difference has
/// (1 − exp(−jωT))/T for jω, and the hold sinc(ωT/2) exp(−jωT/2).
fn sampled_wall((k, b): (f64, f64), (period, delay): (f64, f64), frequency: f64) -> Z {
    let p = j_omega(frequency);
    let turned = |time: f64| (-p * time).exp();
    let lost = Complex::new(1.0, 0.0) - turned(period);
    let hold = lost / (p * period);
    (k + b * lost / period) * hold * turned(delay) / p
}

fn wall_values((k, b): (f64, f64), (period, delay): (f64, f64)) -> LoopValues {
    let mut values = LoopValues::ideal(&RigParameters::default(), period, 1e5);
    let all =
        [(LoopQuantity::Stiffness, k), (LoopQuantity::Damping, b), (LoopQuantity::Delay, delay)];
    for (quantity, value) in all {
        values.set(quantity, value);
    }
    values
}

#[test]
fn a_held_and_late_spring_is_not_passive_and_has_its_closed_form() {
    for (kb, times) in [
        ((1e3, 0.0), (1e-3, 0.0)),
        ((1e3, 0.0), (1e-3, 2e-3)),
        ((2e3, 4.0), (0.5e-3, 0.5e-3)),
        ((100.0, 1.0), (7e-3, 0.0)),
    ] {
        let values = wall_values(kb, times);
        let estimator = EstimatorName::BackwardDifference;
        let order = VoiceOrder { values: &values, estimator, parameters: &[] };
        let maker = &|order: &VoiceOrder<'_>| Ok(wall(order));
        let voice = ShakenVoice { maker, order, depth: 5e-3, amplitude: 20e-6 };
        let highest = ForceHold { period: times.0, delay: times.1 }.highest();
        let curve = voice.curve(&frequencies((1.0, highest), 40), &|| ()).unwrap();
        for point in &curve.points {
            let expected = sampled_wall(kb, times, point.frequency);
            let error = (Complex::new(point.real, point.imaginary) - expected).norm();
            // A force of newtons is rounded to 1e-15 N, a motion of nanometres to 1e-18 m: 1e-6
            // of a force that 20 nm make, with a hundredth of that left by averaging.
            assert!(error < 1e-6 * expected.norm(), "{kb:?} {times:?}: {point:?} {expected}");
            assert!(point.coherence > 1.0 - 1e-9, "{point:?}");
            assert_eq!(
                point.is_active(),
                expected.re < -1e-4 * expected.norm(),
                "{point:?} {expected}"
            );
        }
        if kb.1 == 0.0 {
            // The force lags by half a period and the delay: it drives for half a cycle of that.
            // Z is straight between points to the square of their distance, 0.16² / 2.
            let end = (0.5 / (0.5 * times.0 + times.1)).min(highest);
            let band = curve.active_bands()[0];
            assert!((band.from - 1.0).abs() < 1e-12, "{band:?}");
            assert!((band.to / end - 1.0).abs() < 0.015, "{band:?}, expected to end at {end}");
        }
    }
}

fn shaky_positions(count: usize) -> Vec<f64> {
    let (mut seed, mut smooth) = (12_345_u64, [0.0; 2]);
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let mut position = || {
        smooth[0] += 0.2 * (next() - smooth[0]);
        smooth[1] += 0.2 * (smooth[0] - smooth[1]);
        5e-3 + 4e-3 * smooth[1]
    };
    (0..count).map(|_| position()).collect()
}

fn wall_forces(positions: &[f64], (k, b): (f64, f64), period: f64) -> Vec<f64> {
    let rate = |at: usize| at.checked_sub(1).map_or(0.0, |it| positions[at] - positions[it]);
    (0..positions.len()).map(|at| k * positions[at] + b * rate(at) / period).collect()
}

#[test]
fn a_recorded_stroke_on_a_wall_has_that_walls_impedance_and_is_coherent() {
    let (kb, times) = ((800.0, 2.0), (1e-3, 1e-3));
    let position = shaky_positions(8000);
    let force = wall_forces(&position, kb, times.0);
    let held = ForceHold { period: times.0, delay: times.1 };
    let stroke = RecordedStroke { name: "a wall".to_owned(), held, position, force };
    let curve = stroke.curve(&frequencies((10.0, 200.0), 20), &|| ()).unwrap();
    assert_eq!(curve.points.len(), 20);
    for point in &curve.points {
        let expected = sampled_wall(kb, times, point.frequency);
        let error = (Complex::new(point.real, point.imaginary) - expected).norm();
        // The window (0.4 s) changes by π/400 in the period that the damper remembers.
        assert!(error < 0.01 * expected.norm(), "{point:?}, expected {expected}");
        assert!(point.coherence > 0.99, "{point:?}");
    }
}

#[test]
fn noise_in_the_force_lowers_the_coherence_and_points_are_not_judged() {
    let position = shaky_positions(8000);
    let mut force = wall_forces(&position, (100.0, 0.0), 1e-3);
    let noise = shaky_positions(9000);
    // Later noise of the same kind has the same spectrum: with 100 times its power 1 % is coherent,
    // and 39 segments leave 1/39 by chance.
    for (force, noise) in force.iter_mut().zip(&noise[1000..]) {
        *force += 1e3 * noise;
    }
    let held = ForceHold { period: 1e-3, delay: 0.0 };
    let stroke = RecordedStroke { name: "noise".to_owned(), held, position, force };
    let curve = stroke.curve(&frequencies((10.0, 200.0), 20), &|| ()).unwrap();
    let mean = curve.points.iter().map(|it| it.coherence).sum::<f64>() / 20.0;
    assert!(mean < 0.15, "{mean}");
    assert_eq!(curve.active_bands(), []);
}

#[test]
fn a_recording_that_is_too_short_or_lies_still_is_refused() {
    let held = ForceHold { period: 1e-3, delay: 0.0 };
    let stroke = |position: Vec<f64>| {
        let force = vec![0.0; position.len()];
        RecordedStroke { name: "C4".to_owned(), held, position, force }
    };
    let said = stroke(shaky_positions(900)).curve(&[10.0], &|| ()).unwrap_err();
    assert!(said.contains("10 Hz takes 1 s") && said.contains("begin at 11.23 Hz"), "{said}");
    let said = stroke(shaky_positions(20)).curve(&[10.0], &|| ()).unwrap_err();
    assert!(said.ends_with("10 Hz takes 1 s; record more"), "{said}");
    let said = stroke(vec![1e-3; 2000]).curve(&[10.0], &|| ()).unwrap_err();
    assert!(said.contains("lies still"), "{said}");
}

#[test]
fn bands_begin_and_end_where_the_real_part_is_zero() {
    let point =
        |(frequency, real): (f64, f64)| ImpedancePoint::exact(frequency, Complex::new(real, 1.0));
    let points = [(1.0, 1.0), (2.0, -1.0), (3.0, -2.0), (4.0, 2.0), (5.0, -1.0)].map(point);
    let [name, remark] = ["K".to_owned(), String::new()];
    let curve = ImpedanceCurve { name, remark, points: points.to_vec() };
    let band = |from, to, lowest, at| ActiveBand { from, to, lowest, at };
    let expected = [band(1.5, 3.5, -2.0, 3.0), band(4.0 + 2.0 / 3.0, 5.0, -1.0, 5.0)];
    assert_eq!(curve.active_bands(), expected);
    assert!(curve.verdict().contains("from 1.5 to 3.5 Hz (lowest -2 N·s/m at 3 Hz), and from"));
    let svg = picture::picture("K".to_owned(), std::slice::from_ref(&curve)).svg();
    // Two bands in each of three panels, and their row in the legend, in a thin blue.
    assert_eq!(svg.matches("#CCE3F0").count(), 7, "{svg}");
}
