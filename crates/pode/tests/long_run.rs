//! Case C9 and its family: accuracy after hours.
//!
//! Error model of RK4, with r = ω h the radians per step in contact: an amplitude loses r⁶/144 per
//! step and r⁴/69 at each of a contact's two events, the dense output's own. The exact flow has
//! neither: each step rounds by ε/2 of its largest term, which adds up like a random walk, or at
//! worst in one direction.

use pode::contacts::{ContactState, Surface};
use pode::stepper::{Exact, Rk4};
use pode::{Advance, Event, Limits, Model, Motion, Resets, Silent, Simulator, Stepper, Watch};

use crate::common::block::Block;
use crate::common::head::{CONTACTS, Head, Mode, RADIANS};
use crate::common::two_sided::{self, TwoSided, side};
use crate::common::{G, STEPS, close, no_input};

#[derive(Debug)]
struct Count {
    guard: &'static str,
    h: f64,
    number: u32,
    last: f64,
}

impl Count {
    fn of(guard: &'static str, h: f64) -> Self {
        Self { guard, h, number: 0, last: 0.0 }
    }
}

impl<M: Model> Watch<M> for Count {
    fn event(&mut self, _: &M, event: &Event<'_, M>) {
        if event.cause.name() == self.guard {
            self.number += 1;
            self.last = (event.tick as f64 + event.theta) * self.h;
        }
    }
}

#[track_caller]
fn run_for<M: Resets, T: Stepper>(
    it: &mut Simulator<M, T>,
    (count, input): (&mut Count, impl Fn(f64) -> M::Input),
    seconds: f64,
    ready: impl Fn(M::Mode) -> bool,
) {
    let ticks = (seconds / count.h).ceil() as u64;
    while it.tick() < ticks || !ready(it.mode()) {
        assert_eq!(it.advance(count.h, &input, count).advance, Advance::Completed);
    }
}

fn drift([x, v]: [f64; 2]) -> f64 {
    v * v + 2.0 * G * x - 1.0
}

#[test]
fn c9_the_exact_flow_keeps_energy_and_time_for_hours_at_every_step() {
    let [k, _, _, period] = CONTACTS[1];
    // A step adds g h to the speed: half an ulp of 0.5 m/s at worst, in one direction.
    let most = |h: f64| 1e-10_f64.max(2.0 * 0.25 * f64::EPSILON * 1e3 / h);
    let long = (7e-3, 1e4, 1e-9);
    for (h, seconds, most) in STEPS.map(|h| (h, 1e3, most(h))).into_iter().chain([long]) {
        let mut head = Head { k }.dropped(Exact);
        let mut count = Count::of("touch", h);
        run_for(&mut head, (&mut count, no_input), seconds, |mode| mode == Mode::Flight);
        close(format_args!("h {h}: energy"), drift(*head.state()), 0.0, most);
        let expected = (head.tick() as f64 * h / period).floor() as u32 + 1;
        assert_eq!(count.number, expected, "h {h}: contacts");
        // An error δ of the speed moves each landing by 2δ/g.
        let n = f64::from(count.number - 1);
        close(format_args!("h {h}: time"), count.last, n * period, most * n * period);
    }
}

#[test]
fn rk4_loses_in_a_hundred_seconds_what_its_order_says() {
    for [k, _, _, period] in CONTACTS {
        for h in STEPS {
            let mut head = Head { k }.dropped(Rk4);
            run_for(&mut head, (&mut Count::of("touch", h), no_input), 100.0, |mode| {
                mode == Mode::Flight
            });
            let steps = std::f64::consts::PI / RADIANS;
            let once = 2.0 * RADIANS.powi(4) / 69.0 + steps * RADIANS.powi(6) / 144.0;
            let most = 2.0 * once * 100.0 / period;
            close(format_args!("k {k}, h {h}: energy"), drift(*head.state()), 0.0, most);
        }
    }
}

#[test]
fn an_hour_of_stick_and_slip_keeps_its_period() {
    // Slip about 0.01 from 0.015 m, then carried twice 0.005 m at 0.1 m/s.
    let slip = (std::f64::consts::TAU - 2.0 * 0.5_f64.atan()) / 10.0;
    let period = slip + 0.1;
    for h in [1e-3, 7e-3] {
        let belt = Motion { rate: 0.1, ..Motion::default() };
        let mut it = Block::new(1.0, 100.0, [1.5, 1.0]).start(Exact, [0.0, 0.1], &belt);
        let mut count = Count::of("belt", h);
        let sticks = |mode| side(mode) == ContactState::Stick;
        run_for(&mut it, (&mut count, |_| belt), 3600.0, sticks);
        // Each cycle has a release and a capture.
        let n = f64::from(count.number / 2 - 1);
        // Each release restarts the cycle, so only roundings of its times add up.
        let capture = 0.15 + slip + n * period;
        close(format_args!("h {h}: last capture"), count.last, capture, 1e-12 * n);
        assert!(it.tick() as f64 * h < capture + period, "h {h}: {count:?}");
    }
}

#[test]
fn a_slide_of_an_hour_stays_on_its_surface() {
    let limits = Limits { longest_step: 0.02, ..Limits::default() };
    let mut it = two_sided::start(Circle, [1.0, 0.0], &(), limits);
    for _ in 0..180_000 {
        assert_eq!(it.advance(0.02, &no_input, &mut Silent).advance, Advance::Completed);
        let [x, y] = *it.state();
        assert!((x * x + y * y - 1.0).abs() < 1e-15, "it has left the circle: {x}, {y}");
    }
    // RK4's phase error: (ω h)⁴/120 of 3600 rad, on the circle where x and y are exact.
    let [x, y] = *it.state();
    let angle = (y * 3600.0_f64.cos() - x * 3600.0_f64.sin()).asin();
    close("angle", angle, 0.0, 3600.0 * 0.02_f64.powi(4) / 100.0);
    assert_eq!(side(it.mode()), ContactState::Stick);
}

/// Turns about the origin at 1 rad/s, drawn onto the circle of radius 1 from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Circle;

impl TwoSided for Circle {
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 2;

    fn flow(&self, side: f64, x: &[f64; 2], (): &()) -> [f64; 2] {
        [-x[1] - side * x[0], x[0] - side * x[1]]
    }

    fn condition(&self, x: &[f64; 2], (): &()) -> Surface<[f64; 2]> {
        Surface {
            value: x[0] * x[0] + x[1] * x[1] - 1.0,
            gradient: [2.0 * x[0], 2.0 * x[1]],
            drift: 0.0,
        }
    }
}
