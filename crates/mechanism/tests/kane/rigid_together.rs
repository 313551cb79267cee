//! Rigid contacts that close together, open by themselves, or rub, against closed forms.

use pode::contacts::WithContacts;
use pode::stepper::Any;
use pode::{Advance, Fault, Limits, Motion, Resets, RunRecorder, Simulator};

use crate::kane::runnable::{Run, described, model};

const LAWS: [&str; 3] = ["newton", "poisson", "sequential"];
const G: f64 = 9.81;
const HEAD: &str = "name = \"it\"\nsummary = \"it\"\n";
/// A body in the plane, on a slope, with its three points, and CONTACTS.
const PLANE: &str = r#"gravity = ["9.81*sin(SLOPE)*1 m/s^2", "-9.81*cos(SLOPE)*1 m/s^2"]
coordinates.x = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-9 m/s", "9 m/s"] }
coordinates.y = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-9 m/s", "9 m/s"] }
coordinates.a = { unit = "rad", range = ["-2 rad", "2 rad"], speed_range = ["-9 rad/s", "9 rad/s"] }
frames.body = { origin = ["x", "y"], turn = "a" }
points.left = { in = "body", at = ["-0.5 m", "LOW"] }
points.right = { in = "body", at = ["0.5 m", "LOW"] }
points.top = { in = "body", at = ["0 m", "0.2 m"] }
bodies.body = { frame = "body", mass = "1 kg", inertia = "0.1 kg*m^2" }
rest = { mode = "MODE", start = true, x = "0 m" }
[contacts]
"#;
/// A ball on a rope in the coordinates x and y, and in r and phi.
const ROPES: [&str; 2] = [
    r#"gravity = ["0", "-9.81 m/s^2"]
coordinates.x = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-9 m/s", "9 m/s"] }
coordinates.y = { unit = "m", range = ["-2 m", "2 m"], speed_range = ["-9 m/s", "9 m/s"] }
frames.bob = { origin = ["x", "y"] }
bodies.bob = { frame = "bob", mass = "1 kg" }
rest = { start = true, x = "0.3 m" }
contacts.rope = { gap = "1 m - hypot(x, y)", rigid = true }"#,
    r#"gravity = ["0", "-9.81 m/s^2"]
coordinates.r = { unit = "m", range = ["0 m", "2 m"], speed_range = ["-9 m/s", "9 m/s"] }
coordinates.phi = { unit = "rad", range = ["-4 rad", "4 rad"], speed_range = ["-9 rad/s", "9 rad/s"] }
frames.arm = { turn = "phi" }
frames.bob = { in = "arm", origin = ["r"] }
bodies.bob = { frame = "bob", mass = "1 kg" }
rest = { start = true, r = "0.5 m" }
contacts.rope = { gap = "1 m - r", rigid = true }"#,
];

/// Three balls on a line; the first strikes the other two.
const BALLS: &str = r#"impacts = "LAW"
coordinates.x1 = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-2 m/s", "2 m/s"] }
coordinates.x2 = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-2 m/s", "2 m/s"] }
coordinates.x3 = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-2 m/s", "2 m/s"] }
frames = { b1 = { origin = ["x1"] }, b2 = { origin = ["x2"] }, b3 = { origin = ["x3"] } }
bodies.b1 = { frame = "b1", mass = "1 kg" }
bodies.b2 = { frame = "b2", mass = "1 kg" }
bodies.b3 = { frame = "b3", mass = "1 kg" }
rest = { start = true, x1 = "-0.1 m" }
contacts.one = { gap = "A-B", rigid = true, restitution = 1 }
contacts.two = { gap = "C-D", rigid = true, restitution = 1 }"#;

#[derive(Debug)]
struct Ran {
    advance: Advance,
    x: [f64; 6],
    events: Vec<(&'static str, f64)>,
    mode: &'static str,
}

/// Runs a description for `until` (s), from its start with other entries of the state.
fn run(text: &str, until: f64, (method, h): (&str, f64), start: &[(usize, f64)]) -> Ran {
    let it: Run<6> = model(described(&format!("{HEAD}{text}")), (0, 0));
    let names: Vec<_> = it.table().modes.iter().map(|mode| mode.name).collect();
    let (mode, mut x) = it.at_rest(&Motion::default());
    for (entry, value) in start {
        x[*entry] = *value;
    }
    if it.table().contacts.is_empty() {
        return followed(it, (mode, x), until, (method, h), |mode| names[usize::from(mode.0)]);
    }
    let it = WithContacts::new(it).unwrap();
    let start = it.start(mode, &x, &Motion::default());
    followed(it, start, until, (method, h), |mode| names[usize::from(mode.structure.0)])
}

fn followed<M: Resets<State = [f64; 6], Input = Motion>>(
    it: M,
    (mode, x): (M::Mode, [f64; 6]),
    until: f64,
    (method, h): (&str, f64),
    name: impl Fn(M::Mode) -> &'static str,
) -> Ran {
    let mut simulator = Simulator::new(it, Any::named(method).unwrap(), Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(h);
    let advance = simulator.run(until, h, |_| Motion::default(), &mut recorder).advance;
    let events = recorder.events().iter().map(|it| (it.name, it.t)).collect();
    Ran { advance, x: *simulator.state(), events, mode: name(simulator.mode()) }
}

#[track_caller]
fn near(found: f64, wanted: f64, error: f64) {
    assert!((found - wanted).abs() <= error, "{found}, not {wanted}");
}

/// Returns a description of the body in the plane with contacts of these names, gaps and laws.
fn plane(slope: &str, mode: &str, low: &str, contacts: &[(&str, &str, String)]) -> String {
    let one = |(name, gap, law): &(&str, &str, String)| {
        format!("{name} = {{ gap = \"{gap}\", rigid = true, {law} }}\n")
    };
    let text = PLANE.replace("SLOPE", slope).replace("MODE", mode).replace("LOW", low);
    text + &contacts.iter().map(one).collect::<String>()
}

#[test]
fn a_rope_that_goes_slack_does_so_once() {
    let ([x, y], [u, v]) = ([0.3_f64, -0.2_f64], [2.0, 3.0]);
    let r = x.hypot(y);
    let polar =
        [(0, r), (1, y.atan2(x)), (2, (x * u + y * v) / r), (3, (x * v - y * u) / r.powi(2))];
    let wanted = run(ROPES[1], 2.2, ("dop853", 1e-4), &polar);
    let names = ["rope", "rope_opens", "rope", "rope_opens", "rope"];
    assert!(wanted.events.iter().map(|it| it.0).eq(names), "{wanted:?}");
    for method in ["rk4", "heun", "dop853", "tsitouras5", "by-need"] {
        for h in [2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5] {
            let found = run(ROPES[0], 2.2, (method, h), &[(0, x), (1, y), (2, u), (3, v)]);
            assert_eq!(found.advance, Advance::Completed, "{method} {h}");
            assert!(found.events.iter().map(|it| it.0).eq(names), "{method} {h} {found:?}");
            if (method, h <= 2e-4) == ("dop853", true) {
                let times = found.events.iter().zip(&wanted.events);
                times.for_each(|(found, wanted)| near(found.1, wanted.1, 1e-6));
            }
        }
    }
}

#[test]
fn contacts_that_close_together_part_whatever_their_order_is() {
    let fall = (2.0 / G).sqrt();
    for law in LAWS {
        let box_in = |slope: &str, order: &[usize], until: f64| {
            let right = if order.len() == 2 { 0.5 } else { 0.3 };
            let all = [("left", "y(left)", 0.5), ("right", "y(right)", right)];
            let all = [all[0], all[1], ("wall", "1 m - x(top)", 0.4)];
            let contacts = order.iter().map(|it| all[*it]);
            let contacts = contacts.map(|it| (it.0, it.1, format!("restitution = {}", it.2)));
            let text = plane(slope, "motion", "0 m", &contacts.collect::<Vec<_>>());
            run(&format!("impacts = \"{law}\"\n{text}"), until, ("rk4", 1e-3), &[(1, 1.0)])
        };
        for order in [[0, 1], [1, 0]] {
            let first = box_in("0", &order, 0.46);
            near(first.events[0].1, fall, 1e-12);
            near(first.x[4], 0.5 * G * fall - G * (0.46 - fall), 1e-12);
            near(first.x[5], 0.0, 1e-12);
            let rest = box_in("0", &order, 1.4);
            assert_eq!(rest.mode.len(), "motion+left+right".len(), "{rest:?}");
            near(rest.events.last().unwrap().1, 3.0 * fall, 1e-9);
        }
        // Down the slope of 45 degrees it reaches floor and wall at one time.
        let wanted = box_in("pi/4", &[0, 1, 2], 0.6);
        assert!(wanted.x[5].abs() > 0.1 && wanted.events.len() == 1, "{wanted:?}");
        for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let found = box_in("pi/4", &order, 0.6).x;
            found.iter().zip(wanted.x).for_each(|(found, wanted)| near(*found, wanted, 1e-12));
        }
    }
}

#[test]
fn three_balls_part_by_the_law_that_is_named() {
    for (law, wanted) in LAWS.iter().zip([[-1.0, 2.0, 2.0], [-1.0, 2.0, 2.0], [0.0, 0.0, 3.0]]) {
        for order in [["x2 - x1", "x3 - x2"], ["x3 - x2", "x2 - x1"]] {
            let text = BALLS.replace("LAW", law).replace("A-B", order[0]).replace("C-D", order[1]);
            let found = run(&text, 0.2, ("rk4", 1e-3), &[(3, 1.0)]);
            let speeds = found.x[3..].iter().zip(wanted);
            speeds.for_each(|(found, wanted)| near(*found, wanted / 3.0, 1e-14));
        }
    }
}

#[test]
fn friction_brakes_by_the_reaction_that_it_changes() {
    let rubs =
        |slip: &str, mu: f64| format!("friction = {{ slip = \"{slip}\", coefficient = {mu} }}");
    let block = |slope: &str, mode: &str, until: f64, start: &[(usize, f64)]| {
        let text = plane(slope, mode, "0 m", &[("floor", "y", rubs("x'", 0.3))]);
        run(&text, until, ("rk4", 1e-2), start).x[0]
    };
    // Down a slope, and held on it below atan(mu); thrown, it lands and slides to rest.
    let slides = 0.125 * G * (0.5_f64.sin() - 0.3 * 0.5_f64.cos());
    near(block("0.5", "motion+floor", 0.5, &[]), slides, 1e-12);
    near(block("0.2914", "motion+floor", 0.5, &[]), 0.0, 1e-12);
    assert!(block("0.2916", "motion+floor", 0.5, &[]) > 1e-6, "atan(0.3) is 0.29146");
    let far = 1.5 * (0.4 / G).sqrt() + 1.5 * 1.5 / (0.6 * G);
    near(block("0", "motion", 2.0, &[(1, 0.2), (3, 1.5)]), far, 1e-12);
    // On two corners, below its centre by 0.2 m, or by 1.2 m: it tips over the one in front.
    for (low, mode) in [(0.2, "motion+left+right"), (1.2, "motion+right")] {
        let corner = |name, gap, at| (name, gap, rubs(&format!("rate(x({at}))"), 0.5));
        let corners = [corner("left", "y(left)", "left"), corner("right", "y(right)", "right")];
        let text = plane("0", "motion+left+right", &format!("-{low} m"), &corners);
        let start = [(1, low), (3, 1.5)];
        assert_eq!(run(&text, 0.1, ("rk4", 1e-3), &start).mode, mode);
        let stops = (run(&text, 1.0, ("rk4", 1e-3), &start).x[0] - 1.5 * 1.5 / G).abs() < 1e-12;
        assert_eq!(stops, low < 1.0, "v^2/(2 mu g)");
    }
    // A rod on its lower tip, by Newton and Euler; the other way no force exists (Painlevé).
    let (sin, cos) = 1.1_f64.sin_cos();
    let text =
        plane("0", "motion+floor", "0 m", &[("floor", "y(left)", rubs("rate(x(left))", 2.0))]);
    let slide =
        |speed: f64| run(&text, 1e-6, ("rk4", 1e-6), &[(1, 0.5 * sin), (2, 1.1), (3, speed)]);
    let normal = G / (1.0 + 2.5 * cos * (cos + 2.0 * sin));
    near((slide(3.0).x[3] - 3.0) / 1e-6, -2.0 * normal, 1e-4);
    assert_eq!(slide(-3.0).advance, Advance::Faulty(Fault::Guard));
}
