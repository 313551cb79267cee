use mechanism::kane::derive_model;
use mechanism::kane::description::read;
use pode::stepper::Rk4;
use pode::{Limits, Motion, RunRecorder, Simulator};

use crate::kane::runnable::{Run, described, model, shipped};

/// Events of a run, by name, mode and time, and its state every millisecond.
type Story<const N: usize> = (Vec<(String, u8, f64)>, Vec<[f64; N]>);

fn story<const N: usize>(text: &str, until: f64, input: impl Fn(f64) -> Motion) -> Story<N> {
    let it: Run<N> = model(described(text), (0, 0));
    let (mode, x) = it.at_rest(&input(0.0));
    let mut simulator = Simulator::new(it, Rk4, Limits::default(), mode, x);
    let mut recorder = RunRecorder::new(1e-4).sampled(1e-3);
    let outcome = simulator.run(until, 1e-4, input, &mut recorder);
    assert!(outcome.is_completed(), "{outcome:?}");
    let events = recorder.events().iter().map(|it| (it.name.to_owned(), it.to.0, it.t)).collect();
    (events, recorder.samples().iter().map(|it| it.state).collect())
}

#[track_caller]
fn same<const N: usize>(one: &Story<N>, other: &Story<N>, error: f64) {
    assert_eq!(one.0.len(), other.0.len(), "{:?}\n{:?}", one.0, other.0);
    for (a, b) in one.0.iter().zip(&other.0) {
        assert!(a.1 == b.1 && (a.2 - b.2).abs() < error, "{a:?}, not {b:?}");
    }
    for (a, b) in one.1.iter().zip(&other.1) {
        for (a, b) in a.iter().zip(b) {
            assert!((a - b).abs() < error * b.abs().max(1.0), "{a}, not {b}");
        }
    }
}

fn to_and_fro(t: f64) -> Motion {
    let (sin, cos) = (2.0 * t).sin_cos();
    Motion { position: 0.12 * sin, rate: 0.24 * cos, acceleration: -0.48 * sin, jerk: -0.96 * cos }
}

#[test]
fn a_cart_between_rigid_walls_is_the_one_with_its_modes_written() {
    let written = shipped("cart-pendulum");
    let start = written.find("[constraints]").unwrap();
    let end = written.find("[outputs]").unwrap();
    let rigid = format!(
        "{}{}{}",
        &written[..start],
        r#"
[contacts]
left = { gap = "x - left", rigid = true, scale = "1 m", restitution = "restitution", sounds = "abs(x_dot)" }
right = { gap = "right - x", rigid = true, scale = "1 m", restitution = "restitution", sounds = "abs(x_dot)" }

[modes.free]
doc = "the cart is between the walls"

"#,
        written[end..].replace(
            "{ left = \"reaction(at_left)\", right = \"-reaction(at_right)\" }",
            "{ \"free+left\" = \"reaction(left)\", \"free+right\" = \"reaction(right)\" }",
        ),
    );
    let derived = described(&rigid);
    let names: Vec<_> = derived.program.table.modes.iter().map(|it| it.name).collect();
    assert_eq!(names, ["free", "free+left", "free+right"]);
    assert_eq!(
        derived.system.mechanism.instrument.left_out,
        ["free+left+right"],
        "one wall at a time"
    );
    let (one, other) = (story::<4>(&rigid, 4.0, to_and_fro), story::<4>(&written, 4.0, to_and_fro));
    let rests = other.0.iter().filter(|it| it.1 > 0).count();
    assert!(other.0.len() > 20 && rests >= 2, "it rebounds and is held: {:?}", other.0);
    // The law of several contacts rounds otherwise than the reset map of one.
    same(&one, &other, 1e-11);
}

#[test]
fn a_double_pendulum_at_a_rigid_wall_is_the_one_with_its_modes_written() {
    let rigid = shipped("double-pendulum");
    let begin = rigid.find("[contacts]").unwrap();
    let end = rigid.find("[outputs]").unwrap();
    let written = format!(
        "{}{}{}",
        &rigid[..begin],
        r#"
[constraints]
held = { zero = "wall - x(end)" }

[modes.swing]
constraints = []
[[modes.swing.guards]]
name = "wall"
positive = "wall - x(end)"
to = "swing"
impact = { along = "wall - x(end)", restitution = "restitution", settles = "leaning" }

[modes.leaning]
constraints = ["held"]
[[modes.leaning.guards]]
name = "off"
positive = "reaction(held)"
to = "swing"

"#,
        &rigid[end..].replace("reaction(wall)", "reaction(held)"),
    );
    // Pressed against the wall, where it comes to rest, and drawn off again.
    let input = |t: f64| {
        let (sin, cos) = (4.0 * t).sin_cos();
        Motion {
            position: 0.9 * (1.0 - cos),
            rate: 3.6 * sin,
            acceleration: 14.4 * cos,
            jerk: -57.6 * sin,
        }
    };
    let (one, other) = (story::<4>(&rigid, 2.0, input), story::<4>(&written, 2.0, input));
    assert!(other.0.iter().filter(|it| it.1 == 1).count() >= 1, "it leans: {:?}", other.0);
    assert!(other.0.len() > 8, "{:?}", other.0);
    same(&one, &other, 1e-12);
}

fn stops(count: usize, extra: &str) -> String {
    let text = r#"
name = "stops"
summary = "a mass among stops"
[coordinates]
x = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-1 m/s", "1 m/s"] }
y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-1 m/s", "1 m/s"] }
[frames]
B = { origin = ["x", "y"] }
[bodies]
mass = { frame = "B", mass = "2 kg" }
[contacts]
"#
    .to_owned();
    let stop = |number: usize| {
        let angle = f64::from(u32::try_from(number).unwrap());
        let gap = format!("1 m - x*cos({angle} rad) - y*sin({angle} rad)");
        format!("s{number} = {{ gap = \"{gap}\", rigid = true }}\n")
    };
    let text = text + &(0..count).map(stop).collect::<String>();
    text + extra
}

#[test]
fn as_many_contacts_close_as_there_are_degrees_of_freedom() {
    let derived = described(&stops(3, ""));
    let names: Vec<_> = derived.program.table.modes.iter().map(|it| it.name).collect();
    let wanted = ["motion", "motion+s0", "motion+s1", "motion+s2", "motion+s0+s1", "motion+s0+s2"];
    assert_eq!(names[..6], wanted);
    assert_eq!(names[6..], ["motion+s1+s2"], "not three at a time, in a plane");
}

#[test]
fn too_many_configurations_are_counted_and_refused() {
    // 1 + 8 + 28.
    let modes = "[modes.free]\n[modes.less]\nwithout = [\"s0\"]\n\
                 guards = [{ name = \"go\", positive = \"0.5 m - x\", to = \"free\" }]\n\
                 [outputs.push]\nunit = \"N\"\nvalue = \"reaction(s0)\"\n";
    for (extra, count) in [("", "37"), (modes, "66")] {
        let said = read("stops.toml", &stops(8, extra), &()).unwrap_err().to_string();
        for part in
            [&format!("the rigid contacts would make {count} modes"), "32 at most", "stops.toml:12"]
        {
            assert!(said.contains(part), "{said} lacks {part}");
        }
        assert_eq!(said.lines().count(), 1, "consequences are no mistakes: {said}");
    }
}

#[test]
fn a_mode_may_do_without_a_rigid_contact() {
    let modes = r#"
[modes.in]
guards = [{ name = "go", positive = "0.5 m - x", to = "out" }]
[modes.out]
without = ["s0"]
guards = [{ name = "come", positive = "x - 0.4 m", to = "in" }]
"#;
    let derived = described(&stops(2, modes));
    let names: Vec<_> = derived.program.table.modes.iter().map(|it| it.name).collect();
    assert_eq!(names, ["in", "out", "in+s0", "in+s1", "in+s0+s1", "out+s1"]);
    let to = |mode: usize| {
        let guards = &derived.program.table.modes[mode].guards;
        guards.iter().find(|it| it.name == "go").unwrap().ways[0].to
    };
    assert_eq!([to(0), to(2), to(3)], [1, 1, 5], "what is closed stays closed if it can");
}

#[test]
fn an_impact_of_a_rigid_contact_keeps_the_momentum_along_it() {
    let text = stops(1, "[rest]\nstart = true\nx = \"0.5 m\"\n")
        .replace("rigid = true", "rigid = true, restitution = 0.25");
    let it: Run<4> = model(described(&text), (0, 0));
    let mut simulator = Simulator::new(
        it,
        Rk4,
        Limits::default(),
        instruments::equations::ModeNumber(0),
        [0.5, 0.0, 1.0, 0.3],
    );
    let mut recorder = RunRecorder::new(1e-3);
    assert!(simulator.run(1.0, 1e-3, |_| Motion::default(), &mut recorder).is_completed());
    // It meets the stop at 0.5 s, and returns at a quarter of its speed.
    let [x, y, u, v] = *simulator.state();
    assert!((x - 0.875).abs() < 1e-12 && (y - 0.3).abs() < 1e-12, "{x} {y}");
    assert!((u + 0.25).abs() < 1e-12 && (v - 0.3).abs() < 1e-12, "{u} {v}");
}

#[test]
fn what_a_rigid_contact_says_wrong_is_named() {
    let says = |from: &str, to: &str, part: &str| {
        let text = stops(1, "").replace(from, to);
        let said = derive_model("it.toml", &text, &()).unwrap_err().to_string();
        assert!(said.contains(part), "{said} lacks {part}");
        assert!(!said.contains("no stiffness"), "a consequence: {said}");
    };
    says("rigid = true", "rigid = 1", "rigid is true or false");
    says("rigid = true", "rigid = true, stiffness = \"1 N/m\"", "stiffness");
    says("gap = ", "gab = ", "has no gap");
    says("1 m - x", "1 s - x", "is in");
    says("rigid = true", "rigid = true, restitution = \"1 kg\"", "restitution");
}
