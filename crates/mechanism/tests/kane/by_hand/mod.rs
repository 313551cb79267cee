pub mod pendulum;

use mechanism::kane::assemble::Program;
use mechanism::kane::graph::{Graph, Node, Place};
use mechanism::kane::mechanism::{
    Coordinate, Fires, GuardBranch, InputSpec, InstrumentSpec, Mechanism, MechanismParameter,
    MechanismPreset, Mode, Rest, Speed,
};
use mechanism::kane::system::{EquationSystem, GuardEquations, ModeEquations, Way};

#[derive(Debug)]
pub struct Draft {
    pub mechanism: Mechanism,
    pub modes: Vec<ModeEquations>,
}

impl Draft {
    pub fn new(parameters: &[(&str, f64)], coordinates: &[&str]) -> Self {
        let mut graph = Graph::new();
        let values = parameters.iter().map(|(_, value)| graph.constant(*value)).collect();
        let preset = MechanismPreset { name: "default".to_owned(), doc: String::new(), values };
        let parameter = |(name, _): &(&str, f64)| MechanismParameter {
            name: (*name).to_owned(),
            title: (*name).to_owned(),
            unit: "1".to_owned(),
            range: (-1e9, 1e9),
            doc: String::new(),
            reading: instruments::Reading::default(),
        };
        let range = (-1e3, 1e3);
        let (mut places, mut speeds) = (Vec::new(), Vec::new());
        for (number, name) in (0..).zip(coordinates) {
            let rate = graph.symbol(Place::Speed(number));
            let (name, unit) = ((*name).to_owned(), "1".to_owned());
            speeds.push(Speed { name: format!("{name}_dot"), unit: unit.clone(), range });
            places.push(Coordinate { name, unit, range, rate });
        }
        let mechanism = Mechanism {
            parameters: parameters.iter().map(parameter).collect(),
            instrument: InstrumentSpec { presets: vec![preset], ..InstrumentSpec::default() },
            input: InputSpec { name: "s".to_owned(), ..InputSpec::default() },
            coordinates: places,
            speeds,
            rest: Rest { coordinates: vec![None; coordinates.len()], ..Rest::default() },
            graph,
            ..Mechanism::default()
        };
        Self { mechanism, modes: Vec::new() }
    }

    pub fn graph(&mut self) -> &mut Graph {
        &mut self.mechanism.graph
    }

    pub fn parameter(&mut self, name: &str) -> Node {
        let number = self.mechanism.parameters.iter().position(|it| it.name == name).unwrap();
        self.mechanism.graph.symbol(Place::Parameter(u16::try_from(number).unwrap()))
    }

    pub fn state(&mut self, number: u16) -> [Node; 2] {
        [Place::Coordinate(number), Place::Speed(number)].map(|it| self.mechanism.graph.symbol(it))
    }

    pub fn input(&mut self) -> [Node; 4] {
        [0, 1, 2, 3].map(|rate| self.mechanism.graph.symbol(Place::Input(rate)))
    }

    pub fn places(&self) -> Vec<Place> {
        let count = u16::try_from(self.mechanism.coordinates.len()).unwrap();
        (0..count).map(Place::Coordinate).chain((0..count).map(Place::Speed)).collect()
    }

    pub fn mode(&mut self, name: &str, derivative: &[Node]) -> &mut ModeEquations {
        self.mechanism.modes.push(Mode { name: name.to_owned(), ..Mode::default() });
        let slaved = self.places().iter().map(|it| self.mechanism.graph.symbol(*it)).collect();
        self.modes.push(ModeEquations {
            derivative: derivative.to_vec(),
            slaved,
            is_free: vec![true; derivative.len()],
            ..ModeEquations::default()
        });
        self.modes.last_mut().unwrap()
    }

    pub fn way(to: usize, state: &[Node], impulse: Node) -> Way {
        let branch = GuardBranch { when: None, to, set: Vec::new(), impact: None };
        Way { branch, state: state.to_vec(), impulse, releases: None }
    }

    pub fn same(&mut self) -> Vec<Node> {
        self.places().iter().map(|it| self.mechanism.graph.symbol(*it)).collect()
    }

    pub fn program(self) -> Program {
        let state = self.places();
        let coordinates = self.mechanism.coordinates.len();
        let system =
            EquationSystem { mechanism: self.mechanism, state, coordinates, modes: self.modes };
        system.assemble().unwrap()
    }
}

pub fn guard(name: &str, [value, rate]: [Node; 2], way: Way) -> GuardEquations {
    GuardEquations {
        unit: String::new(),
        name: name.to_owned(),
        value,
        rate,
        scale: 1.0,
        priority: 0,
        fires: Fires::WhileNegative,
        pressed: Vec::new(),
        closes: None,
        ways: vec![way],
        sounds: None,
    }
}
