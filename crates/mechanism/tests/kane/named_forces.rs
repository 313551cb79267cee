//! Forces by name are those that move the model: their powers are what is stored and lost.

use std::fmt::Write as _;

use documents::toml::{FindingList, TextPlace, TomlSource, parse};
use pode::contacts::{ContactMode, MAX_CONTACTS, WithContacts};
use pode::stepper::Dop853;
use pode::{
    Energetic as _, EnergyAudit, Limits, Model as _, Motion, Piece, Signal, Simulator, Watch,
};

use instruments::equations::ModeNumber;

use crate::kane::runnable::{Runnable, ShippedModel, described};
use crate::kane::shipped::files;
use crate::kane::stroke::bells;

type Built = WithContacts<Runnable<16, 512>>;

/// Force of each spring, felt, force, contact and its friction, and the rate of its stretch.
fn elements(text: &str) -> Vec<(String, String)> {
    let mut report = FindingList::default();
    let source = TomlSource { name: String::new(), text: text.to_owned() };
    let source = report.source(source);
    let tree = parse(&mut report, source, TextPlace::FirstCharacter).expect("TOML");
    let mut all = Vec::new();
    for (table, key) in [
        ("springs", "stretch"),
        ("felts", "compression"),
        ("forces", "stretch"),
        ("contacts", "gap"),
    ] {
        for entry in tree.get(table).and_then(|it| it.node.entries()).unwrap_or_default() {
            let text = |key| Some(entry.node.get(key)?.node.text()?.to_owned());
            let is_rigid = entry.node.get("rigid").is_some();
            let sign = if table == "contacts" { "-" } else { "" };
            let stretch = text(key).filter(|_| !is_rigid);
            all.extend(
                stretch.map(|it| (format!("force({})", entry.name), format!("{sign}rate({it})"))),
            );
            let slip = entry.node.get("friction").and_then(|it| it.node.get("slip")?.node.text());
            all.extend(slip.map(|it| (format!("friction({})", entry.name), format!("-({it})"))));
        }
    }
    for entry in tree.get("frictions").and_then(|it| it.node.entries()).unwrap_or_default() {
        let slip = entry.node.get("slip").and_then(|it| it.node.text()).expect("a slip");
        all.push((format!("force({})", entry.name), format!("-({slip})")));
    }
    all
}

/// Largest power of the elements of a run (W), and by how much it is not what is stored and lost.
struct PowerBalance {
    still: Built,
    /// Outputs of the force and the rate of each element.
    pairs: Vec<[usize; 2]>,
    largest: f64,
    off: f64,
}

impl PowerBalance {
    fn outputs(&self, mode: ContactMode<ModeNumber>, x: &[f64; 16], input: &Motion) -> [f64; 128] {
        let (mut frictions, mut out) = ([0.0; MAX_CONTACTS], [0.0; 128]);
        for (contact, force) in self.still.friction_forces(mode, x, input).iter() {
            frictions[contact] = force;
        }
        self.still.system().outputs_with(mode.structure, (x, input), &frictions, &mut out);
        out
    }

    /// Energy of what is stored in the elements alone: without motion, and without gravity.
    fn stored(&self, mode: ContactMode<ModeNumber>, x: &[f64; 16], input: &Motion) -> f64 {
        let mut still = *x;
        still[self.still.coordinates()..].fill(0.0);
        self.still.energy(mode, &still, &Motion { rate: 0.0, ..*input })
    }
}

impl Watch<Built> for PowerBalance {
    fn piece<S: Signal<Motion>>(&mut self, _model: &Built, piece: &Piece<'_, Built, S>) {
        const MOMENT: f64 = 1e-9;
        let (mode, x, input) = (piece.mode, piece.end, piece.inputs[1]);
        let flow = self.still.derivative(mode, &x, &input);
        let [late, early] = [MOMENT, -MOMENT].map(|dt| {
            let position = input.position + dt * input.rate;
            let x = std::array::from_fn(|i| x[i] + dt * flow[i]);
            self.stored(mode, &x, &Motion { position, ..input })
        });
        let out = self.outputs(mode, &x, &input);
        let powers = self.pairs.iter().map(|[force, rate]| out[*force] * out[*rate]);
        let taken: f64 = powers.clone().sum();
        let expected = (late - early) / (2.0 * MOMENT) + self.still.dissipated(mode, &x, &input);
        self.largest = powers.map(f64::abs).fold(self.largest, f64::max);
        self.off = self.off.max((taken - expected).abs());
    }
}

fn balance(name: &str, elements: &[(String, String)]) -> PowerBalance {
    let mut text = format!("name = \"powers\"\nbase = \"{name}\"\n[outputs]\n");
    for (i, (element, rate)) in elements.iter().enumerate() {
        writeln!(text, "f{i} = {{ value = \"{element}\" }}").expect("text grows");
        writeln!(text, "r{i} = {{ value = \"{rate}\" }}").expect("text grows");
    }
    let it = ShippedModel::of(described(&text).program);
    let values = it.values(0, 39);
    let g = it.table.parameters.iter().position(|it| it.name == "g");
    let mut without = values.clone();
    if let Some(g) = g {
        without[g] = 0.0;
    }
    let [model, still] =
        [&values, &without].map(|values| WithContacts::new(it.valued(values)).expect("few"));
    let travel = 0.009 * model.system().input_per_metre();
    let input = |t: f64| bells(&[[travel, 0.12, 0.04]], t);
    let (structure, x) = model.system().at_rest(&input(0.0));
    let (mode, x) = model.start(structure, &x, &input(0.0));
    let output = |name: String| it.table.outputs.iter().position(|it| it.name == name);
    let pair = |i: usize| [format!("f{i}"), format!("r{i}")].map(|it| output(it).expect("it"));
    let pairs = (0..elements.len()).map(pair).collect();
    let mut balance = PowerBalance { still, pairs, largest: 0.0, off: 0.0 };
    let mut simulator = Simulator::new(model, Dop853, Limits::default(), mode, x);
    assert!(simulator.run(0.3, 2e-4, input, &mut balance).is_completed(), "{name}");
    balance
}

#[test]
fn the_powers_of_all_elements_are_what_is_stored_and_lost() {
    let mut checked = 0;
    for file in files() {
        let text = std::fs::read_to_string(&file).expect("a file");
        let (all, name) = (elements(&text), file.file_stem().expect("a name").to_string_lossy());
        // Of a description by plain equations, and of one that another is made of, there are none.
        if !file.ends_with("model.toml") && !all.is_empty() {
            let PowerBalance { largest, off, .. } = balance(&name, &all);
            println!("{name}: {} elements, up to {largest:.2e} W, off by {off:.1e} W", all.len());
            assert!(largest > 0.0 && off <= 1e-6 * largest, "{name}: {off:e} of {largest:e} W");
            checked += 1;
        }
    }
    assert!(checked >= 14, "{checked}");
}

/// A pendulum and a block on a table that shakes, two belts, and a crank that pushes.
const SHAKEN: &str = r#"
name = "shaken"
gravity = ["0", "-9.81 m/s^2"]
parameters.omega = { value = "7 rad/s", range = ["0 rad/s", "100 rad/s"], doc = "of the table" }
parameters.vb = { value = "0.3 m/s", range = ["0 m/s", "1 m/s"], doc = "of the belt" }
definitions.a = "0.1 m*sin(omega*t)"
[coordinates]
th = { unit = "rad", range = ["-10 rad", "10 rad"], speed_range = ["-50 rad/s", "50 rad/s"] }
x = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
z = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-10 m/s", "10 m/s"] }
[frames]
t = { origin = ["a"] }
p = { in = "t", turn = "th" }
b = { in = "t", origin = ["x"] }
c = { origin = ["y", "z"] }
[bodies]
p = { frame = "p", mass = "1 kg", centre = ["0 m", "-0.5 m"], inertia = "0.02 kg*m^2" }
b = { frame = "b", mass = "2 kg" }
c = { frame = "c", mass = "0.5 kg" }
[springs]
s = { stretch = "x - a", stiffness = "100 N/m", damping = "1 N*s/m" }
tie = { stretch = "z - x", stiffness = "80 N/m", damping = "1 N*s/m" }
[forces]
push = { stretch = "th", force = "0.1 N*m*sin(omega*t)", energy = "0 J" }
[frictions]
belt = { slip = "x' - vb", stiction = "5 N", kinetic = "3 N", scales = ["1 N", "0.1 m/s"] }
side = { slip = "z' + a'", stiction = "2 N", kinetic = "1.5 N", scales = ["1 N", "0.1 m/s"] }
[constraints]
crank = { zero = "y - a - 0.5*z" }
[outputs]
F = { value = "force(belt)" }
G = { value = "friction(side)" }
slip = { value = "x' - vb" }
push = { value = "2 kg*(x'' + a'') + force(s) - force(tie)" }
[rest]
start = true
th = "0.3 rad"
"x'" = "0.1 m/s"
"#;

#[test]
fn surfaces_and_clocks_that_move_by_themselves_supply() {
    let it = ShippedModel::of(described(SHAKEN).program);
    let model: Built = WithContacts::new(it.valued(&it.values(0, 0))).expect("two contacts");
    let still = Motion::default();
    let (structure, x) = model.system().at_rest(&still);
    assert_eq!(x[it.table.coordinates + 1], 0.1, "x' at the start");
    let (mode, x) = model.start(structure, &x, &still);
    let powers = PowerBalance { still: model, pairs: Vec::new(), largest: 0.0, off: 0.0 };
    let mut audit = EnergyAudit::default();
    let mut simulator = Simulator::new(model, Dop853, Limits::default(), mode, x);
    let mut stuck = 0;
    for _ in 0..3000 {
        simulator.advance(1e-3, &|_: f64| still, &mut audit);
        let (mode, x) = (simulator.mode(), *simulator.state());
        let [belt, side, slip, push, ..] = powers.outputs(mode, &x, &still);
        let is_stuck = mode.contacts.sticking().contains(0);
        stuck += usize::from(is_stuck);
        let kinetic = if slip > 0.0 { -3.0 } else { 3.0 };
        assert!(if is_stuck { belt.abs() <= 5.0 } else { belt == kinetic }, "{belt} N at {slip}");
        assert!(side.abs() <= 2.0, "{side}");
        // Newton's law of the block: the friction is what is left of its acceleration.
        assert!((push - belt).abs() < 1e-9, "{push} N, {belt} N");
    }
    let EnergyAudit { supplied, dissipated, integration, .. } = audit;
    assert!(supplied > 10.0 && dissipated > 10.0 && stuck > 20, "{supplied} J, {stuck} stuck");
    assert!(integration.abs() < 1e-8 * supplied, "{integration:e} J of {supplied} J");
}
