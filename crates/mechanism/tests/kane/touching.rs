use instruments::equations::ModeNumber;
use pode::contacts::{ContactState, WithContacts};
use pode::stepper::Rk4;
use pode::{Auditor, Energetic as _, Guarded as _, Limits, Motion, RunRecorder, Simulator};

use crate::kane::runnable::{Run, mass};

fn falling() -> Run<2> {
    mass(
        r#"
gravity = ["0", "-9.81 m/s^2"]
coordinates.y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
frames.mass = { in = "ground", origin = ["0 m", "y"] }
bodies.mass = { frame = "mass", mass = "2 kg" }
contacts.spring = { gap = "y", stiffness = "5 kN/m" }
"#,
    )
}

fn drawn() -> Run<2> {
    mass(
        r#"
coordinates.x = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
frames.mass = { in = "ground", origin = ["x", "0 m"] }
bodies.mass = { frame = "mass", mass = "0.5 kg" }
springs.spring = { stretch = "s - x", stiffness = "80 N/m" }
frictions.bearing = { slip = "x'", stiction = "2 N", kinetic = "1.5 N" }
"#,
    )
}

#[test]
fn a_mass_stays_on_its_spring_for_the_time_of_the_closed_form() {
    let model = WithContacts::new(falling()).unwrap();
    let still = Motion::default();
    let (mode, x) = model.start(ModeNumber(0), &[0.1, 0.0], &still);
    assert!(!mode.contacts.is_closed(0));
    let start = model.energy(mode, &x, &still);
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(1e-3);
    assert!(simulator.run(0.4, 1e-3, |_| still, &mut recorder).is_completed());
    let (g, omega) = (9.81_f64, 2500.0_f64.sqrt());
    let fall = (0.2 / g).sqrt();
    // x'' = g − ω² x from v: x = 0 again where tan(ωt/2) = −v ω/g.
    let contact = 2.0 / omega * (std::f64::consts::PI - (g * fall * omega / g).atan());
    let times = recorder.times_of("spring");
    assert!((times[0] - fall).abs() < 1e-12, "touches at {}, not {fall}", times[0]);
    // RK4 in steps of 0.05 rad is late by 0.05⁴/120 of the phase.
    let error = times[1] - fall - contact;
    let expected = 0.05_f64.powi(4) / 120.0 * contact;
    assert!((error / expected - 1.0).abs() < 0.1, "leaves {error:e} s late, not {expected:e}");
    let closed = mode.with(0, ContactState::Closed);
    let energy = model.energy(closed, &[-0.01, 0.0], &still);
    assert!((energy - (0.5 * 5e3 * 1e-4 - 2.0 * g * 0.01)).abs() < 1e-12, "{energy}");
    let left = model.energy(simulator.mode(), simulator.state(), &still);
    assert!((left - start).abs() < 1e-6, "{left} J of {start} J");
}

#[test]
fn the_step_on_a_contact_is_that_of_its_stiffness() {
    let model = WithContacts::new(falling()).unwrap();
    let still = Motion::default();
    let (open, x) = model.start(ModeNumber(0), &[0.1, 0.0], &still);
    let closed = open.with(0, ContactState::Closed);
    assert!(model.longest_step_at(open, &x, &still) > 1.0);
    let step = model.longest_step_at(closed, &[-0.01, 0.0], &still);
    assert!((step - 0.75 / 2500.0_f64.sqrt()).abs() < 1e-9, "{step}");
    let settled = model.system().at_rest(&still).1;
    assert!((settled[0] + 2.0 * 9.81 / 5e3).abs() < 1e-12, "it lies {settled:?} deep");
    assert_eq!(model.guards(open).len(), 1);
}

#[test]
fn a_bearing_sticks_and_slips_as_the_closed_form_does() {
    let model = WithContacts::new(drawn()).unwrap();
    let speed = 0.05;
    let input = |t: f64| Motion { position: speed * t, rate: speed, ..Motion::default() };
    let (mode, x) = model.start(ModeNumber(0), &[0.0, 0.0], &input(0.0));
    assert_eq!(mode.contacts.state(0), ContactState::Stick);
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(1e-3);
    let mut audit: Auditor<_> = Auditor::default();
    assert!(simulator.run(1.5, 1e-3, input, &mut recorder).is_completed());
    let omega = (80.0_f64 / 0.5).sqrt();
    // It tears off where k v t = stiction; then x' = 0 where tan(ωτ/2) = −ω (Fs − Fk)/(k v).
    let off = 2.0 / (80.0 * speed);
    let slide = 2.0 / omega * (std::f64::consts::PI - (omega * 0.5 / (80.0 * speed)).atan());
    let times = recorder.times_of("bearing");
    assert!((times[0] - off).abs() < 1e-9, "slips at {}, not {off}", times[0]);
    assert!((times[1] - off - slide).abs() < 1e-8, "sticks at {}, not {}", times[1], off + slide);
    let mut again = Simulator::new(model, Rk4, Limits::default(), mode, x);
    assert!(again.run(1.5, 1e-3, input, &mut audit).is_completed());
    assert!(audit.sums.dissipated > 0.0, "a slide takes energy");
    assert!(audit.sums.integration.abs() < 1e-9, "{:e}", audit.sums.integration);
}

/// Energy and powers computed together equal those computed one by one: with a closed contact, and
/// with a bearing that holds, and slips each way.
#[test]
fn a_balance_is_its_three_numbers() {
    let input = Motion { position: 0.02, rate: 0.3, ..Motion::default() };
    let frictions = [ContactState::Stick, ContactState::SlideUp, ContactState::SlideDown];
    let cases = [(falling(), &[ContactState::Closed][..]), (drawn(), &frictions[..])];
    for (described, states) in cases {
        let model = WithContacts::new(described).unwrap();
        let (open, _) = model.start(ModeNumber(0), &[0.1, 0.0], &input);
        for state in states {
            let (mode, x) = (open.with(0, *state), [-0.01, 0.2]);
            let balance = model.balance_of_input(mode, &x, &input);
            let found = [balance.energy, balance.supplied, balance.dissipated];
            let one_by_one = [
                model.energy(mode, &x, &input),
                model.supplied(mode, &x, &input),
                model.dissipated(mode, &x, &input),
            ];
            assert_eq!(found.map(f64::to_bits), one_by_one.map(f64::to_bits), "{state:?}");
            assert!(balance.energy.abs() > 1e-3, "{state:?} stores something");
            // A slipping bearing takes 1.5 N times 0.2 m/s, or gives it where it slips backwards.
            let taken = match state {
                ContactState::SlideUp => 0.3,
                ContactState::SlideDown => -0.3,
                ContactState::Open | ContactState::Closed | ContactState::Stick => continue,
            };
            assert!((balance.dissipated - taken).abs() < 1e-12, "{state:?}: {balance:?}");
            // ½ · 0.5 kg · 0.2² + ½ · 80 N/m · 0.03², and 80 N/m · 0.03 m · 0.3 m/s.
            let [energy, supplied] = [balance.energy - 0.046, balance.supplied - 0.72];
            assert!(energy.abs() < 1e-12 && supplied.abs() < 1e-12, "{state:?}: {balance:?}");
        }
    }
}
