//! Thirteen compliant contacts on one body, two of them with friction that sticks, against an
//! independent program: `reference/thirteen_contacts.py`.

mod body;

use pode::contacts::{ContactMode, ContactState, WithContacts};
use pode::stepper::{Controlled, Dop853, Rk4, Tolerance};
use pode::{Event, Limits, Simulator, Stepper, Tick, Watch};

use crate::common::{all_completed, close};
use crate::driven::Clock;
use body::{Body, BodyState, lines};

const FILE: &str = include_str!("../../reference/thirteen_contacts.csv");

/// An event: time (s), contact, its next state, and the body's state.
#[derive(Clone, Debug)]
struct Change {
    t: f64,
    contact: &'static str,
    state: ContactState,
    x: BodyState,
}

fn numbers(fields: &[&str]) -> BodyState {
    std::array::from_fn(|i| fields[i].parse().unwrap())
}

fn expected() -> Vec<Change> {
    let read = |it: Vec<&'static str>| Change {
        t: it[0].parse().unwrap(),
        contact: it[1],
        state: match it[2] {
            "open" => ContactState::Open,
            "closed" => ContactState::Closed,
            "stick" => ContactState::Stick,
            "up" => ContactState::SlideUp,
            "down" => ContactState::SlideDown,
            other => panic!("{other}"),
        },
        x: numbers(&it[3..]),
    };
    lines(FILE, "event").into_iter().map(read).collect()
}

struct Changes {
    h: f64,
    seen: Vec<Change>,
}

impl Watch<WithContacts<Body>> for Changes {
    fn event(&mut self, model: &WithContacts<Body>, event: &Event<'_, WithContacts<Body>>) {
        let [before, after] = [event.before.0, event.after.0].map(|mode| mode.contacts);
        let specs = model.system().specs.iter().enumerate();
        for (contact, spec) in specs.filter(|(it, _)| before.state(*it) != after.state(*it)) {
            self.seen.push(Change {
                t: (event.tick as f64 + event.theta) * self.h,
                contact: spec.name,
                state: after.state(contact),
                x: event.after.1,
            });
        }
    }
}

fn start<T: Stepper>(scene: &'static str, stepper: T) -> Simulator<WithContacts<Body>, T> {
    let model = WithContacts::new(Body::read(scene)).unwrap();
    let (mode, x) = model.start((), &numbers(&lines(scene, "start")[0]), &Clock(0.0));
    Simulator::new(model, stepper, Limits::default(), mode, x).without_readout()
}

fn run<T: Stepper>(
    it: &mut Simulator<WithContacts<Body>, T>,
    (h, until): (f64, f64),
    mut each: impl FnMut(&Simulator<WithContacts<Body>, T>, ContactMode<()>, &Tick),
) -> Vec<Change> {
    let mut changes = Changes { h, seen: vec![] };
    let mut ticks = vec![];
    while (it.tick() as f64 + 0.5) * h < until {
        let (before, t) = (it.mode(), it.tick() as f64 * h);
        ticks.push(it.advance(h, &|theta: f64| Clock(t + theta * h), &mut changes));
        each(it, before, &ticks[ticks.len() - 1]);
    }
    all_completed(&ticks);
    changes.seen
}

fn until() -> f64 {
    lines(FILE, "end")[0][0].parse().unwrap()
}

#[track_caller]
fn check<T: Stepper>(stepper: T, h: f64, tolerance: f64) {
    let mut it = start(FILE, stepper);
    let x0 = *it.state();
    let seen = run(&mut it, (h, until()), |_, _, _| {});
    let expected = expected();
    for (n, (found, expected)) in seen.iter().zip(&expected).enumerate() {
        let what = format!("event {n}, {} {:?} at {}", expected.contact, expected.state, found.t);
        assert_eq!((found.contact, found.state), (expected.contact, expected.state), "{what}");
        close(&what, found.t, expected.t, tolerance);
        for (found, expected) in found.x.iter().zip(expected.x) {
            close(&what, *found, expected, tolerance);
        }
    }
    assert_eq!(seen.len(), expected.len());
    let (body, x) = (it.model().system(), it.state());
    for (found, expected) in x.iter().zip(numbers(&lines(FILE, "end")[0][1..])) {
        close("end", *found, expected, tolerance);
    }
    let residual = body.energy(x) - body.energy(&x0) + x[6] - x[7];
    close("stored + taken - put in", residual, 0.0, tolerance);
}

#[test]
fn thirteen_contacts_open_close_stick_and_slip_as_in_the_reference() {
    let tolerance = Tolerance { absolute: 1e-15, relative: 1e-13 };
    check(Controlled { method: Dop853, tolerance }, 1e-3, 1e-9);
}

#[test]
fn so_they_do_with_rk4_in_short_ticks() {
    // A felt's force begins as t^1.5: the first step errs by h^2.5, with any fixed-step method.
    check(Rk4, 2e-5, 1e-6);
}

#[test]
fn a_tick_costs_the_contacts_that_are_closed() {
    let mut it = start(FILE, Rk4);
    let mut last = it.model().system().calls.now();
    let mut ticks = [0_u32; 3];
    let _ = run(&mut it, (2e-4, until()), |it, before, tick| {
        let now = it.model().system().calls.now();
        let [derivatives, normals, gaps] = std::array::from_fn(|i| now[i] - last[i]);
        last = now;
        if tick.work.events > 0 {
            return;
        }
        let contacts = before.contacts;
        let (stuck, slides) = (contacts.sticking().len(), contacts.sliding().len());
        let closed = contacts.closed().len();
        assert_eq!(normals, derivatives * closed);
        // RK4's four, and those of the guards of frictions; a gap for each contact.
        assert_eq!(tick.work.derivatives, 4);
        let frictions = tick.work.guards as usize - gaps;
        assert!(frictions == 0 || stuck + slides > 0);
        if stuck == 0 || slides == 0 {
            let each = if stuck > 0 { 3 } else { 1 };
            assert_eq!(derivatives, 4 + each * frictions, "{contacts:?}");
        }
        ticks[if stuck + slides > 0 { 2 } else { usize::from(closed > 0) }] += 1;
    });
    assert!(ticks.iter().all(|n| *n > 100), "{ticks:?}");
}

/// Returns both skids under the body: on a flat floor they hold nearly the same motion.
fn feet() -> &'static str {
    let wall = "skid-wall,0.1,0.004,-1.0,0.0,-0.1005,1500.0,1.0,0.6,0.8,0.6";
    assert!(FILE.contains(wall));
    let foot = "skid-right,0.08,-0.02,0.0,1.0,0.0,2000.0,1.0,0.6,0.6,0.6";
    FILE.replace(wall, foot).leak()
}

#[test]
fn two_feet_that_hold_nearly_the_same_motion_keep_the_books() {
    let scene = feet();
    // Each time that the body turns through the horizontal, one foot's slip passes zero while the
    // other one holds, and no force can hold both: the slip continues.
    for (h, tolerance) in [(1e-3, 5e-5), (1e-4, 5e-8), (2e-5, 1e-9)] {
        let mut it = start(scene, Rk4);
        let x0 = *it.state();
        let seen = run(&mut it, (h, until()), |_, _, _| {});
        let sticks = seen.iter().filter(|it| it.state == ContactState::Stick).count();
        assert!(sticks > 40, "{sticks} of {}", seen.len());
        let (body, x) = (it.model().system(), it.state());
        let residual = body.energy(x) - body.energy(&x0) + x[6] - x[7];
        close(format_args!("stored + taken - put in, h {h}"), residual, 0.0, tolerance);
    }
}
