//! Case C2's family: a ball on a table, thrown by it, and landing.
//!
//! The table's motion is the input, a sine. Lift-off is where its acceleration reaches −g, with
//! gap, speed and acceleration all zero: the gap opens like t³. Flight is a parabola, which RK4
//! follows exactly, so that all times are known to rounding.

use pode::stepper::Rk4;
use pode::{
    Advance, GuardId, GuardSpec, GuardValue, Guarded, Limits, Model, Motion, Reset, Resets,
    Simulator,
};
use proptest::prelude::*;

use crate::common::{G, all_completed, close, each_step_and_phase};
use crate::driven::{root, run_driven};

/// A ball of 1 kg that does not bounce: height (m) and speed (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Ball;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Mode {
    OnTable,
    Flight,
}

impl Model for Ball {
    type Mode = Mode;
    type State = [f64; 2];
    type Input = Motion;
    const COORDS: usize = 1;

    fn derivative(&self, mode: Mode, x: &[f64; 2], table: &Motion) -> [f64; 2] {
        match mode {
            Mode::OnTable => [table.rate, table.acceleration],
            Mode::Flight => [x[1], -G],
        }
    }

    fn readout(&self, mode: Mode, _: &[f64; 2], table: &Motion) -> f64 {
        match mode {
            Mode::OnTable => G + table.acceleration,
            Mode::Flight => 0.0,
        }
    }
}

impl Guarded for Ball {
    fn constrain(&self, mode: Mode, x: &[f64; 2], table: &Motion) -> [f64; 2] {
        match mode {
            Mode::OnTable => [table.position, table.rate],
            Mode::Flight => *x,
        }
    }

    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        const LIFT: [GuardSpec; 1] = [GuardSpec::new(0, "lift-off").scaled(G)];
        const GAP: [GuardSpec; 1] = [GuardSpec::new(1, "landing").scaled(0.2)];
        match mode {
            Mode::OnTable => &LIFT,
            Mode::Flight => &GAP,
        }
    }

    fn guard(&self, mode: Mode, _: GuardId, x: &[f64; 2], table: &Motion) -> GuardValue {
        match mode {
            Mode::OnTable => GuardValue::new(G + table.acceleration, table.jerk),
            Mode::Flight => GuardValue::new(x[0] - table.position, x[1] - table.rate),
        }
    }
}

impl Resets for Ball {
    fn reset(&self, mode: Mode, _: GuardId, x: &[f64; 2], table: &Motion) -> Reset<Self> {
        match mode {
            Mode::OnTable => Reset::to(Mode::Flight, *x),
            Mode::Flight => {
                let after = [table.position, table.rate];
                Reset::to(Mode::OnTable, after).with_impulse(table.rate - x[1])
            }
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct Table {
    amplitude: f64,
    omega: f64,
}

impl Table {
    fn of(g_forces: f64, omega: f64) -> Self {
        Self { amplitude: g_forces * G / omega.powi(2), omega }
    }

    fn at(&self, t: f64) -> Motion {
        let (sin, cos) = (self.omega * t).sin_cos();
        let [a, w] = [self.amplitude, self.omega];
        Motion {
            position: a * sin,
            rate: a * w * cos,
            acceleration: -a * w * w * sin,
            jerk: -a * w * w * w * cos,
        }
    }

    fn lift_off(&self, t: f64) -> f64 {
        let phase = (G / (self.amplitude * self.omega * self.omega)).asin();
        let turn = std::f64::consts::TAU;
        (phase + ((self.omega * t - phase) / turn).ceil() * turn) / self.omega
    }

    fn landing(&self, t: f64) -> f64 {
        let leave = self.at(t);
        let gap = |s: f64| {
            let flown = s - t;
            leave.position + flown * (leave.rate - 0.5 * G * flown) - self.at(s).position
        };
        let step = 1e-3 / self.omega;
        // The gap opens like t³: from 0.05 rad on it is far above rounding.
        let mut s = t + 0.05 / self.omega;
        while gap(s) > 0.0 {
            s += step;
        }
        root(s - step, s, gap)
    }

    /// Returns the error (s) of a landing: rounding of `steps` sums of heights and speeds, and the
    /// error of the lift-off, over the landing speed, which is small for a near miss.
    fn off(&self, [leave, land]: [f64; 2], steps: f64, leave_off: f64) -> f64 {
        let flown = land - leave;
        let speed = (self.at(leave).rate - G * flown - self.at(land).rate).abs();
        let size = self.amplitude * (1.0 + self.omega * flown);
        let turn = (self.at(leave).acceleration + G).abs() * flown;
        1e-12 + (steps * f64::EPSILON * size + turn * leave_off) / speed
    }

    fn flights(&self, until: f64) -> Vec<[f64; 2]> {
        let mut flights = vec![];
        let mut t = self.lift_off(0.0);
        while t < until {
            let landing = self.landing(t);
            flights.push([t, landing]);
            let is_thrown_again = self.at(landing).acceleration < -G;
            t = if is_thrown_again { landing } else { self.lift_off(landing) };
        }
        flights
    }
}

fn events(table: Table, at: (f64, f64), until: f64) -> (Vec<(&'static str, f64)>, Vec<pode::Tick>) {
    let start = table.at(0.0);
    let state = [start.position, start.rate];
    let mut it = Simulator::new(Ball, Rk4, Limits::default(), Mode::OnTable, state);
    let (recorder, ticks) = run_driven(&mut it, at, until, |t| table.at(t));
    (recorder.events().iter().map(|seen| (seen.name, seen.t)).collect(), ticks)
}

#[test]
fn c2_the_shaker_throws_and_catches() {
    let table = Table { amplitude: 2e-3, omega: 40.0 * std::f64::consts::PI };
    each_step_and_phase(|h, phase| {
        let (events, ticks) = events(table, (h, phase), 0.055);
        all_completed(&ticks);
        let names: Vec<_> = events.iter().map(|it| it.0).take(2).collect();
        assert_eq!(names, ["lift-off", "landing"], "h {h}, phase {phase}");
        close(format_args!("h {h}: lift-off"), events[0].1, 0.002_513_355_797_052_246, 1e-16);
        close(format_args!("h {h}: landing"), events[1].1, 0.051_865_286_988_733_95, 1e-15);
        // Impulse from the table: the relative speed, and before, weight and its own motion.
        let impulse: f64 = ticks.iter().map(|tick| tick.impulse).sum();
        close(format_args!("h {h}: landing speed"), impulse, 0.489_701_201_981_647_3, 1e-13);
    });
}

#[test]
fn a_table_below_one_g_never_lets_go() {
    let omega = 100.0;
    for part in [0.5, 0.999, 1.0 - 1e-9, 1.0] {
        let table = Table::of(part, omega);
        each_step_and_phase(|h, phase| {
            let (events, ticks) = events(table, (h, phase), 0.5);
            all_completed(&ticks);
            // At one g the guard touches zero, to rounding, in each turn.
            assert!(events.is_empty(), "{part} g, h {h}, phase {phase}: {events:?}");
        });
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_shaker_throws_and_catches_at_the_times_of_its_closed_form(
        g_forces in 1.05..8.0,
        omega in 20.0..400.0,
        h in prop_oneof![Just(1e-4), Just(1e-3), Just(7e-3), 1e-4..7e-3],
        phase in prop_oneof![Just(0.0), Just(1.0 / 3.0), Just(0.999)],
    ) {
        let table = Table::of(g_forces, omega);
        let until = 40.0 / omega;
        let flights = table.flights(until);
        let mut expected = vec![];
        let mut off = 1e-12;
        for &[leave, land] in &flights {
            let is_thrown_again = table.at(leave).acceleration < -(1.0 + 1e-9) * G;
            off = if is_thrown_again { off } else { 1e-12 };
            expected.push(("lift-off", leave, off));
            off = table.off([leave, land], (land - leave) / h, off);
            expected.push(("landing", land, off));
        }
        expected.retain(|it| it.1 < until);
        // Thrown again very near −g: rounding may decide.
        let is_sharp = |[_, t]: &[f64; 2]| (table.at(*t).acceleration + G).abs() > 1e-6 * G;
        prop_assume!(flights.iter().all(is_sharp));
        prop_assume!(expected.iter().all(|it| (it.1 - until).abs() > 1e-9));
        let (found, ticks) = events(table, (h, phase), until);
        prop_assert!(ticks.iter().all(|tick| tick.advance == Advance::Completed));
        prop_assert_eq!(found.len(), expected.len(), "{:?} {:?}", &found, &expected);
        for (found, expected) in found.iter().zip(&expected) {
            prop_assert_eq!(found.0, expected.0);
            prop_assert!((found.1 - expected.1).abs() < expected.2, "{:?} {:?}", found, expected);
        }
    }
}
