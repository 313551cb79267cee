use std::collections::HashMap;

use mechanism::formulas::{
    Dependence, Dimension, Form, Measured, NameError, NameScope, build, parse,
};
use mechanism::kane::graph::{Graph, Node, Place, Tangent};
use mechanism::kane::mechanism::{
    Constraint, ConstraintKind, Coordinate, Fires, Force, Guard, Mechanism, MechanismOutput,
    MechanismParameter, MechanismPreset, Mode, ReferenceFrame, RigidBody, Speed,
};

#[derive(Default)]
pub(crate) struct MechanismBuilder {
    pub(crate) it: Mechanism,
    pub(crate) names: HashMap<String, Node>,
    pub(crate) values: Vec<f64>,
}

impl MechanismBuilder {
    pub(crate) fn new(parameters: &[(&str, f64)], coordinates: &[&str]) -> Self {
        let mut new = Self::default();
        new.it.frames.push(ReferenceFrame {
            name: "ground".into(),
            parent: 0,
            origin: [None; 3],
            turn: None,
        });
        for k in 0..4_u8 {
            let node = new.it.graph.symbol(Place::Input(k));
            new.names.insert(format!("s{}", "'".repeat(k.into())), node);
        }
        for (i, (name, value)) in parameters.iter().enumerate() {
            let node = new.symbol(name, Place::Parameter(number(i)));
            let _ = node;
            let name = (*name).to_owned();
            new.it.parameters.push(MechanismParameter {
                title: name.clone(),
                name,
                unit: "1".into(),
                range: (-1e9, 1e9),
                doc: String::new(),
                reading: instruments::Reading::default(),
            });
            new.values.push(*value);
        }
        let values = new.values.iter().map(|value| new.it.graph.constant(*value)).collect();
        new.it.instrument.presets.push(MechanismPreset {
            name: "default".into(),
            doc: String::new(),
            values,
        });
        for name in coordinates {
            new.coordinate(name);
        }
        new
    }

    fn symbol(&mut self, name: &str, place: Place) -> Node {
        let node = self.it.graph.symbol(place);
        self.names.insert(name.to_owned(), node);
        node
    }

    pub(crate) fn coordinate(&mut self, name: &str) {
        let rate = self.speed(&format!("{name}'"));
        self.coordinate_with_rate(name, rate);
    }

    pub(crate) fn coordinate_with_rate(&mut self, name: &str, rate: Node) {
        let place = Place::Coordinate(number(self.it.coordinates.len()));
        self.symbol(name, place);
        let (name, unit) = (name.to_owned(), "1".to_owned());
        self.it.coordinates.push(Coordinate { name, unit, range: (-10.0, 10.0), rate });
        self.it.rest.coordinates.push(None);
    }

    pub(crate) fn speed(&mut self, name: &str) -> Node {
        let at = number(self.it.speeds.len());
        let (own, unit) = (name.to_owned(), "1".to_owned());
        self.it.speeds.push(Speed { name: own, unit, range: (-10.0, 10.0) });
        self.symbol(&format!("{name}'"), Place::Acceleration(at));
        self.symbol(name, Place::Speed(at))
    }

    pub(crate) fn e(&mut self, text: &str) -> Node {
        let parsed = parse(text, Form::Value).expect(text);
        build(&parsed, &mut self.it.graph, &mut Names(&self.names)).expect(text).node
    }

    pub(crate) fn define(&mut self, name: &str, text: &str) {
        let node = self.e(text);
        self.names.insert(name.to_owned(), node);
    }

    fn vector(&mut self, at: &[&str]) -> [Option<Node>; 3] {
        let mut nodes = [None; 3];
        for (node, text) in nodes.iter_mut().zip(at) {
            *node = Some(self.e(text));
        }
        nodes
    }

    pub(crate) fn frame(&mut self, parent: usize, origin: &[&str], turn: &str) -> usize {
        self.frame_about(parent, origin, Some((2, turn)))
    }

    pub(crate) fn frame_about(
        &mut self,
        parent: usize,
        origin: &[&str],
        turn: Option<(usize, &str)>,
    ) -> usize {
        let origin = self.vector(origin);
        let turn = turn.map(|(axis, angle)| (axis, self.e(angle)));
        let name = format!("frame{}", self.it.frames.len());
        self.it.frames.push(ReferenceFrame { name, parent, origin, turn });
        self.it.frames.len() - 1
    }

    pub(crate) fn body(&mut self, frame: usize, mass: &str, centre: &[&str], inertia: &str) {
        let inertia = self.e(inertia);
        self.body_with(frame, mass, centre, [None, None, Some(inertia), None, None, None]);
    }

    pub(crate) fn body_with(
        &mut self,
        frame: usize,
        mass: &str,
        centre: &[&str],
        inertia: [Option<Node>; 6],
    ) {
        let (mass, centre) = (self.e(mass), self.vector(centre));
        let name = format!("body{}", self.it.masses.bodies.len());
        self.it.masses.bodies.push(RigidBody { name, frame, mass, centre, inertia });
    }

    pub(crate) fn gravity(&mut self, at: &[&str]) {
        self.it.masses.gravity = self.vector(at);
    }

    pub(crate) fn rate(&mut self, node: Node) -> Node {
        let graph = &mut self.it.graph;
        let coordinates = self.it.coordinates.iter().enumerate();
        let mut seeds: Vec<_> =
            coordinates.map(|(i, it)| (Place::Coordinate(number(i)), it.rate)).collect();
        for k in 0..3 {
            seeds.push((Place::Input(k), graph.symbol(Place::Input(k + 1))));
        }
        Tangent::new(seeds).of(graph, node)
    }

    /// Adds a force along a deformation; its rate is called `rate` in the tension.
    pub(crate) fn force(
        &mut self,
        name: &str,
        stretch: &str,
        tension: &str,
        energy: &str,
    ) -> usize {
        let stretch = self.e(stretch);
        let stretch_rate = self.rate(stretch);
        self.names.insert("stretch".into(), stretch);
        self.names.insert("rate".into(), stretch_rate);
        let (tension, energy) = (self.e(tension), self.e(energy));
        let name = name.to_owned();
        self.it.forces.push(Force { name, stretch, stretch_rate, tension, energy, law: None });
        self.it.forces.len() - 1
    }

    pub(crate) fn constraint(&mut self, name: &str, zero: &str) -> usize {
        let zero = self.e(zero);
        let rate = self.rate(zero);
        self.enter_constraint(name, ConstraintKind::Holonomic, zero, rate)
    }

    pub(crate) fn nonholonomic(&mut self, name: &str, zero: &str) -> usize {
        let zero = self.e(zero);
        self.enter_constraint(name, ConstraintKind::Nonholonomic, zero, zero)
    }

    fn enter_constraint(
        &mut self,
        name: &str,
        kind: ConstraintKind,
        zero: Node,
        rate: Node,
    ) -> usize {
        let at = self.it.constraints.len();
        self.symbol(&format!("reaction_{name}"), Place::Reaction(number(at)));
        self.it.constraints.push(Constraint { name: name.to_owned(), kind, zero, rate });
        at
    }

    pub(crate) fn mode(&mut self, name: &str, constraints: &[usize]) -> usize {
        self.it.modes.push(Mode {
            name: name.to_owned(),
            constraints: constraints.to_vec(),
            forces: (0..self.it.forces.len()).collect(),
            contacts: (0..self.it.contacts.len()).collect(),
            ..Mode::default()
        });
        self.it.modes.len() - 1
    }

    pub(crate) fn solved(&mut self, mode: usize, coordinate: usize, text: &str) {
        let node = self.e(text);
        self.it.modes[mode].solved.push((coordinate, node));
    }

    pub(crate) fn guard(&mut self, mode: usize, name: &str, value: &str, to: usize) -> &mut Guard {
        let value = self.e(value);
        self.it.modes[mode].guards.push(Guard {
            unit: String::new(),
            name: name.to_owned(),
            value,
            scale: Some(1.0),
            priority: 0,
            fires: Fires::WhileNegative,
            closes: None,
            branches: vec![branch(to)],
            sounds: None,
        });
        self.it.modes[mode].guards.last_mut().expect("just pushed")
    }

    pub(crate) fn output(&mut self, name: &str, text: &str) {
        let value = self.e(text);
        let values = vec![value; self.it.modes.len()];
        self.it.outputs.push(MechanismOutput { name: name.to_owned(), unit: "1".into(), values });
    }

    pub(crate) fn rest(&mut self, coordinate: usize, text: &str) {
        self.it.rest.coordinates[coordinate] = Some(self.e(text));
    }

    pub(crate) fn graph(&mut self) -> &mut Graph {
        &mut self.it.graph
    }
}

pub(crate) fn branch(to: usize) -> mechanism::kane::mechanism::GuardBranch {
    mechanism::kane::mechanism::GuardBranch { when: None, to, set: Vec::new(), impact: None }
}

pub(crate) fn number(index: usize) -> u16 {
    u16::try_from(index).expect("few")
}

struct Names<'a>(&'a HashMap<String, Node>);

impl NameScope for Names<'_> {
    fn value(
        &mut self,
        _graph: &mut Graph,
        name: &str,
        primes: u8,
    ) -> Result<Measured, Option<NameError>> {
        let node = self.0.get(&format!("{name}{}", "'".repeat(primes.into()))).ok_or(None)?;
        Ok(Measured { node: *node, dimension: Dimension::NONE, reach: Dependence::NOTHING })
    }

    fn named(
        &mut self,
        _graph: &mut Graph,
        _function: &str,
        _names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)> {
        Err((0, None))
    }

    fn rate(&mut self, _graph: &mut Graph, _value: Measured) -> Result<Measured, NameError> {
        Err(NameError { message: "rates are names with primes".into(), help: String::new() })
    }

    fn allowed(&self) -> Dependence {
        Dependence::NOTHING
    }
}
