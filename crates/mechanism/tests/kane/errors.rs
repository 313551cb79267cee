use mechanism::kane::mechanism::Target;

use mechanism::kane::derive_model;

use crate::kane::builder::MechanismBuilder;

#[track_caller]
fn check(m: MechanismBuilder, expected: &str) {
    let Err(errors) = mechanism::kane::mechanics::derive(m.it) else {
        panic!("no error with {expected:?}")
    };
    let lines: Vec<_> = errors.iter().map(ToString::to_string).collect();
    assert!(lines.iter().any(|line| line.contains(expected)), "{lines:?} lacks {expected:?}");
}

fn pendulum(coordinates: &[&str]) -> MechanismBuilder {
    let mut m = MechanismBuilder::new(&[("l", 0.5)], coordinates);
    let frame = m.frame(0, &["0", "0"], "a");
    m.body(frame, "1", &["l"], "0");
    m
}

#[test]
fn a_coordinate_without_mass_is_named() {
    let mut m = pendulum(&["a", "z"]);
    m.mode("free", &[]);
    check(m, "mode free: at the rest pose nothing with mass moves with z'");
}

#[test]
fn constraints_that_say_the_same_are_named() {
    let mut m = pendulum(&["a", "b"]);
    let all = [m.constraint("one", "a - b"), m.constraint("two", "2*b - 2*a")];
    m.mode("tied", &all);
    check(m, "mode tied: at the rest pose the constraints one, two depend on one another");
}

#[test]
fn solutions_in_a_circle_are_named() {
    let mut m = pendulum(&["a", "b"]);
    m.mode("tied", &[]);
    m.solved(0, 0, "sin(b)");
    m.solved(0, 1, "cos(a)");
    check(m, "mode tied: the solved coordinates a, b are made of one another");
}

#[test]
fn a_solution_that_misses_its_constraint_is_named() {
    let mut m = pendulum(&["a", "b"]);
    let tie = m.constraint("tie", "sin(a) - 2*sin(b)");
    m.mode("tied", &[tie]);
    m.solved(0, 1, "3*a");
    check(m, "mode tied: what `solved` says does not meet the constraint tie");
}

#[test]
fn a_force_that_reads_accelerations_is_named() {
    let mut m = pendulum(&["a"]);
    m.force("drag", "a", "a''", "0");
    m.mode("free", &[]);
    check(m, "mode free: drag depends on accelerations or reactions");
}

#[test]
fn a_guard_of_a_stiffly_driven_mass_needs_too_many_rates() {
    let mut m = pendulum(&["a"]);
    let tie = m.constraint("tie", "a - s");
    m.mode("driven", &[tie]);
    m.guard(0, "jerk", "s'''", 0);
    check(m, "mode driven: the rate of jerk would need the fourth rate of the input");
}

#[test]
fn a_reset_of_what_is_solved_is_named() {
    let mut m = pendulum(&["a", "b"]);
    let tie = m.constraint("tie", "b - 2*a");
    m.mode("tied", &[tie]);
    let value = m.e("0");
    m.guard(0, "end", "1 - a", 0).branches[0].set = vec![(Target::Coordinate(1), value)];
    check(m, "mode tied: the reset map of end sets b, which is solved in every mode");
}

/// A mass in a plane, with what `more` says.
fn bob(more: &str) -> String {
    let range = "unit = \"m\", range = [\"-1 m\", \"1 m\"], speed_range = [\"-9 m/s\", \"9 m/s\"]";
    format!(
        "name = \"bob\"\n[coordinates]\nx = {{ {range} }}\ny = {{ {range} }}\n[frames]\n\
         b = {{ origin = [\"x\", \"y\"] }}\n[bodies]\nb = {{ frame = \"b\", mass = \"1 kg\" }}\n\
         {more}\n[rest]\nstart = true\nx = \"0.6 m\"\n"
    )
}

#[test]
fn constraints_have_their_line() {
    let of = |more: &str| derive_model("bob.toml", &bob(more), &());
    let said = |more| of(more).expect_err("a mistake").to_string();
    let point = said("[constraints]\npoint = { zero = \"x^2 + y^2\" }");
    assert!(point.contains("bob.toml:10:1") && point.contains("rate of point vanishes"), "{point}");
    let twice = said("[constraints]\na = { zero = \"x - y\" }\nb = { zero = \"2*y - 2*x\" }");
    assert!(twice.contains("bob.toml:11:1") && twice.contains("depend on one another"), "{twice}");
    of("[constraints]\nrod = { zero = \"x^2 + y^2 - 0.36 m^2\" }").expect("a rod holds everywhere");
}
