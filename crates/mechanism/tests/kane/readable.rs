use mechanism::kane::graph::{BinaryFunction, Graph, Node, Place, UnaryFunction};
use mechanism::kane::mechanism::{
    Coordinate, GuardBranch, Mechanism, MechanismParameter, Mode, Speed,
};
use mechanism::kane::readable::{Notation, SymbolNames, equations, expression, system_equations};
use mechanism::kane::system::{EquationSystem, GuardEquations, ModeEquations, Way};

use crate::kane::runnable::described;

fn names() -> SymbolNames {
    let mut names = SymbolNames::default();
    names.set(Place::Parameter(0), "k1");
    names.set(Place::Coordinate(0), "theta_k");
    names.set(Place::Speed(0), "theta_k'");
    names.set(Place::Coordinate(1), "omega");
    names
}

fn written(build: impl Fn(&mut Graph, [Node; 3]) -> Node) -> [String; 2] {
    let mut graph = Graph::new();
    let symbols = [Place::Parameter(0), Place::Coordinate(0), Place::Speed(0)];
    let symbols = symbols.map(|place| graph.symbol(place));
    let node = build(&mut graph, symbols);
    [Notation::Text, Notation::Latex].map(|it| expression(&graph, node, &names(), it))
}

#[test]
fn sums_fractions_and_powers() {
    let [text, latex] = written(|g, [k, q, u]| {
        let below = g.sum(&[(q, 1.0), (u, 2.0)]);
        let fraction = g.product(&[(k, 1), (q, 2), (below, -1)]);
        g.sum(&[(fraction, -0.5), (u, 1.0)])
    });
    assert_eq!(text, "theta_k' - 0.5*k1*theta_k^2/(theta_k + 2*theta_k')");
    assert_eq!(
        latex,
        "\\dot{\\theta}_{k} - 0.5 \\, \\frac{k_{1} \\, {\\theta_{k}}^{2}}{\\theta_{k} + 2 \\, \
         \\dot{\\theta}_{k}}"
    );
}

#[test]
fn functions_and_choices() {
    let [text, latex] = written(|g, [k, q, u]| {
        let sine = g.unary(UnaryFunction::Sin, q);
        let exponent = g.constant(2.5);
        let power = g.binary(BinaryFunction::Power, sine, exponent);
        let zero = g.constant(0.0);
        let root = g.sqrt(k);
        let larger = g.binary(BinaryFunction::Max, root, zero);
        g.select(u, power, larger)
    });
    assert_eq!(text, "if(theta_k' > 0, sin(theta_k)^2.5, max(sqrt(k1), 0))");
    assert_eq!(
        latex,
        "\\begin{cases} {\\sin\\left(\\theta_{k}\\right)}^{2.5} & \\dot{\\theta}_{k} > 0 \\\\ \
         \\max\\left(\\sqrt{k_{1}}, 0\\right) & \\text{otherwise} \\end{cases}"
    );
}

#[test]
fn a_sum_within_a_product_has_brackets() {
    let [text, _] = written(|g, [k, q, u]| {
        let difference = g.subtract(q, u);
        let one = g.constant(1.0);
        let square = g.power(difference, 2);
        let shifted = g.subtract(square, one);
        g.multiply(k, shifted)
    });
    assert_eq!(text, "k1*((theta_k - theta_k')^2 - 1)");
}

#[test]
fn large_parts_that_stand_twice_are_named_once() {
    let mut graph = Graph::new();
    let [k, q, w] = [Place::Parameter(0), Place::Coordinate(0), Place::Coordinate(1)]
        .map(|place| graph.symbol(place));
    let inner = graph.product(&[(k, 1), (q, 2), (w, -1)]);
    let inner = graph.sum(&[(inner, 1.0), (q, 2.0), (w, -1.0)]);
    let sine = graph.unary(UnaryFunction::Sin, inner);
    let (first, second) = (graph.multiply(sine, q), graph.multiply(sine, w));
    let wanted = [("a".to_owned(), first), ("b'".to_owned(), second)];
    let (definitions, lines) = equations(&graph, &wanted, &names(), Notation::Text);
    let said: Vec<String> =
        definitions.iter().chain(&lines).map(|it| format!("{} = {}", it.left, it.right)).collect();
    assert_eq!(
        said,
        ["z1 = sin(2*theta_k + k1*theta_k^2/omega - omega)", "a = theta_k*z1", "b' = omega*z1"]
            .map(str::to_owned)
    );
}

#[test]
fn an_expression_of_any_depth_is_written() {
    let mut graph = Graph::new();
    let mut node = graph.symbol(Place::Coordinate(0));
    for _ in 0..20_000 {
        node = graph.unary(UnaryFunction::Sin, node);
    }
    let (definitions, lines) =
        equations(&graph, &[("deep".to_owned(), node)], &names(), Notation::Text);
    assert!(definitions.len() > 300 && definitions.iter().all(|it| it.right.len() < 1000));
    assert_eq!(lines.len(), 1);
}

fn ball() -> EquationSystem {
    let mut graph = Graph::new();
    let [g, e] = [0, 1].map(|at| graph.symbol(Place::Parameter(at)));
    let (y, v) = (graph.symbol(Place::Coordinate(0)), graph.symbol(Place::Speed(0)));
    let (fall, bounced) = (graph.negate(g), graph.multiply(e, v));
    let bounced = graph.negate(bounced);
    let zero = graph.constant(0.0);
    let parameter = |name: &str| MechanismParameter {
        name: name.to_owned(),
        title: String::new(),
        unit: "1".to_owned(),
        range: (0.0, 1.0),
        doc: String::new(),
        reading: instruments::Reading::default(),
    };
    let name = |name: &str| (name.to_owned(), "m".to_owned(), (0.0, 1.0));
    let ((coordinate, unit, range), (speed, speed_unit, speed_range)) = (name("y"), name("y'"));
    let branch = GuardBranch { when: None, to: 0, set: vec![], impact: None };
    let mode = ModeEquations {
        derivative: vec![v, fall],
        slaved: vec![y, v],
        is_free: vec![true, true],
        readout: Some(zero),
        guards: vec![GuardEquations {
            unit: String::new(),
            name: "floor".to_owned(),
            value: y,
            rate: v,
            scale: 1.0,
            priority: 0,
            fires: mechanism::kane::mechanism::Fires::WhileNegative,
            pressed: Vec::new(),
            closes: None,
            ways: vec![Way { branch, state: vec![y, bounced], impulse: zero, releases: None }],
            sounds: None,
        }],
        ..ModeEquations::default()
    };
    EquationSystem {
        mechanism: Mechanism {
            graph,
            parameters: vec![parameter("g"), parameter("e")],
            coordinates: vec![Coordinate { name: coordinate, unit, range, rate: v }],
            speeds: vec![Speed { name: speed, unit: speed_unit, range: speed_range }],
            modes: vec![Mode { name: "flight".to_owned(), ..Mode::default() }],
            ..Mechanism::default()
        },
        state: vec![Place::Coordinate(0), Place::Speed(0)],
        coordinates: 1,
        modes: vec![mode],
    }
}

#[test]
fn a_system_is_written_mode_by_mode() {
    let expected = "\
mode flight
===========

motion:
    y'' = -g

readout, energy (J) and power (W):
    readout = 0

guard floor, positive while the mode is valid:
    floor = y
    floor' = y'

floor leads to flight; after it:
    y' = -e*y'

";
    assert_eq!(system_equations(&ball(), Notation::Text), expected);
    let latex = system_equations(&ball(), Notation::Latex);
    assert!(latex.contains("\\section*{mode flight}"), "{latex}");
    assert!(latex.contains("\\ddot{y} &= -g \\\\\n"), "{latex}");
    assert_eq!(latex.matches("\\begin").count(), latex.matches("\\end").count());
}

#[test]
fn frictions_act_slaved_speeds_stand_once_and_thirds_are_ratios() {
    let text = r#"
name = "belt"
[coordinates]
x = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-9 m/s", "9 m/s"] }
y = { unit = "m", range = ["-1 m", "1 m"], speed_range = ["-9 m/s", "9 m/s"] }
[frames]
b = { origin = ["x", "y"] }
[bodies]
b = { frame = "b", mass = "3 kg" }
[springs]
s = { stretch = "x", stiffness = "1 N/m" }
[frictions]
belt = { slip = "x' - 0.1 m/s", stiction = "5 N" }
[constraints]
rod = { zero = "x^2 + y^2 - 0.25 m^2" }
[outputs]
third = { value = "x/3" }
[rest]
start = true
x = "0.3 m"
y = "0.4 m"
"#;
    let printed = system_equations(&described(text).system, Notation::Text);
    assert!(printed.contains("*force(belt)") && printed.contains("1/3*x"), "{printed}");
    assert!(!printed.contains("drift_") && !printed.contains("0.333"), "{printed}");
    for speed in ["x'", "y'"] {
        assert!(printed.matches(&format!("\n    {speed} = ")).count() <= 1, "{printed}");
    }
}
