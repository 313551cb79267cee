use std::fmt::Write as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use mechanism::kane::graph::MAX_WORK;
use mechanism::kane::{derive_model, derive_unless_cancelled};

use crate::kane::shipped::{Folder, files};

/// Factor by which the limit exceeds the work on the largest shipped model, at least.
const ROOM: u64 = 10;

/// Rods that hang from each other: a short text with equations that grow with their number.
pub(crate) fn pendulum(links: usize) -> String {
    let mut tables = [String::new(), String::new(), String::new()];
    for link in 1..=links {
        let [coordinates, frames, bodies] = &mut tables;
        let motion = "range = [\"-3 rad\", \"3 rad\"], speed_range = [\"-60 rad/s\", \"60 rad/s\"]";
        writeln!(coordinates, "phi{link} = {{ unit = \"rad\", {motion} }}").expect("a string");
        let parent = match link - 1 {
            0 => "in = \"ground\"".to_owned(),
            parent => format!("in = \"f{parent}\", origin = [\"0 m\", \"-l\"]"),
        };
        writeln!(frames, "f{link} = {{ {parent}, turn = \"phi{link}\" }}").expect("a string");
        let mass = "mass = \"m\", centre = [\"0 m\", \"-l/2\"], inertia = \"m*l^2/12\"";
        writeln!(bodies, "b{link} = {{ frame = \"f{link}\", {mass} }}").expect("a string");
    }
    let [coordinates, frames, bodies] = tables;
    format!(
        r#"name = "pendulum"
gravity = ["0 m/s^2", "-9.81 m/s^2"]
[input]
name = "s"
unit = "rad"
per_metre = "4 rad/m"
[parameters]
l = {{ value = "0.1 m", range = ["1 mm", "10 m"], doc = "length of a rod" }}
m = {{ value = "50 g", range = ["1 mg", "10 kg"], doc = "mass of a rod" }}
[coordinates]
{coordinates}
[frames]
{frames}
[bodies]
{bodies}
[springs]
drive = {{ stretch = "s - phi1", stiffness = "0.6 N*m/rad" }}
[modes.swing]
doc = "all rods swing"
[outputs]
T = {{ unit = "N*m", value = "force(drive)" }}
[rest]
mode = "swing"
phi1 = "s"
"#
    )
}

#[test]
fn a_description_of_too_much_work_is_refused_in_a_sentence() {
    let said = derive_model("pendulum.toml", &pendulum(64), &()).unwrap_err();
    let [mistake] = said.as_slice() else { panic!("{said}") };
    assert!(mistake.message.contains("too much work"), "{said}");
    assert!(mistake.help.starts_with("describe a smaller model"), "{said}");
}

#[test]
fn work_grows_with_the_third_power_of_a_chains_length() {
    let work = |links| {
        let model = derive_model("pendulum.toml", &pendulum(links), &()).expect("a model");
        model.program.work as f64
    };
    let [twelve, long] = [12, 24].map(work);
    println!("12 rods: {twelve} operands; 24 rods: {long}");
    assert!(long < 16.0 * twelve && long < MAX_WORK as f64 / 3.0, "{twelve}, {long}");
}

#[test]
fn presets_that_take_too_long_to_come_to_rest_are_refused_in_a_sentence() {
    let mut definitions = String::new();
    for n in 0..32 {
        writeln!(definitions, "[presets.p{n}]\ndoc = \"one\"").expect("a string");
    }
    definitions += "[definitions]\nd0 = \"phi1\"\n";
    for n in 1..=12 {
        let terms: Vec<_> = (100..250).map(|it| format!("sin(0.01*{it}*d{})", n - 1)).collect();
        writeln!(definitions, "d{n} = \"{}\"", terms.join(" + ")).expect("a string");
    }
    let text = pendulum(2).replace("[coordinates]", &format!("{definitions}[coordinates]"));
    let text = text.replace("s - phi1\"", "s - phi1 + 1e-9*d12\"");
    let text = text.replace("phi1 = \"s\"\n", "phi1 = \"3 rad\"\nphi2 = \"3 rad\"\n");
    let said = derive_model("pendulum.toml", &text, &()).unwrap_err().to_string();
    assert!(said.contains("too much work"), "{said}");
}

#[test]
fn the_work_on_a_description_is_always_the_same() {
    let work = || {
        let model = derive_model("pendulum.toml", &pendulum(4), &()).expect("a model");
        model.program.work
    };
    assert_eq!(work(), work());
}

#[test]
fn the_limit_of_work_lies_far_above_every_model_of_the_program() {
    for file in files() {
        let text = std::fs::read_to_string(&file).unwrap();
        let name = file.display().to_string();
        let model = derive_model(&name, &text, &Folder).expect("a model");
        let work = model.program.work;
        println!("{name}: {work} operands, 1/{} of the limit", MAX_WORK / work);
        assert!(work < MAX_WORK / ROOM, "{name}: {work} operands");
    }
}

/// What a run of the default scene waits for.
#[test]
fn the_grand_takes_little_work_and_few_functions() {
    let program = mechanism::derive("grand").expect("a model").program;
    let instructions: usize = program.tapes().iter().map(|tape| tape.instructions.len()).sum();
    let (work, functions) = (program.work, program.tapes().len());
    println!("{work} operands, {functions} functions, {instructions} instructions");
    assert!(work < 750_000 && functions <= 29 && instructions < 8_500);
}

#[test]
fn a_derivation_ends_when_it_is_cancelled() {
    let is_cancelled = Arc::new(AtomicBool::new(false));
    let derive = || derive_unless_cancelled("it.toml", &pendulum(2), &(), &is_cancelled);
    assert!(derive().is_ok());
    is_cancelled.store(true, Ordering::Relaxed);
    let said = derive().unwrap_err().to_string();
    assert!(said.contains("cancelled"), "{said}");
}
