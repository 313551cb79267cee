//! What every name of a description stands for.

use std::collections::{BTreeMap, BTreeSet};

use diagnostics::{choice, quoted};

use super::source::SourcePlace;
use crate::graph::{Graph, Node, Place, Tangent};
use crate::text::{Dimension, Measured, NameError, NameScope, Reach};

/// What a name in an expression is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum SymbolKind {
    Parameter(usize),
    Coordinate(usize),
    Speed(usize),
    Definition(usize),
    Input,
}

/// What a force, contact or friction is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LawPlace {
    Force(usize),
    Contact(usize),
}

/// Named things of one kind.
#[derive(Clone, Debug)]
pub(super) struct Catalogue<T> {
    pub(super) names: BTreeMap<String, (usize, SourcePlace)>,
    /// What each is; none until it is built, or if it is wrong.
    pub(super) values: Vec<Option<T>>,
}

impl<T> Default for Catalogue<T> {
    fn default() -> Self {
        Self { names: BTreeMap::new(), values: Vec::new() }
    }
}

impl<T: Clone> Catalogue<T> {
    pub(super) fn index(&self, name: &str) -> Option<usize> {
        self.names.get(name).map(|(index, _)| *index)
    }

    pub(super) fn value(&self, index: usize) -> Option<T> {
        self.values.get(index).cloned().flatten()
    }

    pub(super) fn set(&mut self, index: usize, value: T) {
        if let Some(slot) = self.values.get_mut(index) {
            *slot = Some(value);
        }
    }

    /// Enters a name; the place of the first if there are two.
    pub(super) fn declare(&mut self, name: &str, place: SourcePlace) -> Result<usize, SourcePlace> {
        if let Some((_, first)) = self.names.get(name) {
            return Err(*first);
        }
        let index = self.values.len();
        self.names.insert(name.to_owned(), (index, place));
        self.values.push(None);
        Ok(index)
    }

    /// Returns what to do about `wrong`.
    pub(super) fn choice(&self, wrong: &str) -> String {
        choice(wrong, self.names.keys())
    }
}

/// All names of a description, and what was built of them so far.
#[derive(Debug, Default)]
pub(super) struct NameTable {
    pub(super) symbols: BTreeMap<String, (SymbolKind, SourcePlace)>,
    /// Part of a file is not readable: a name that is missing may stand there.
    pub(super) is_broken: bool,
    /// Names whose unit is not known, because it was written wrong.
    pub(super) vague: BTreeSet<String>,
    pub(super) parameters: Vec<Dimension>,
    pub(super) coordinates: Vec<Dimension>,
    /// The rate of each coordinate.
    pub(super) rates: Vec<Option<Measured>>,
    /// Speeds by the number in the mechanism.
    pub(super) speeds: Vec<Dimension>,
    pub(super) input: Dimension,
    pub(super) definitions: Vec<Option<Measured>>,
    pub(super) points: Catalogue<[Node; 3]>,
    pub(super) frames: Catalogue<super::geometry::WorldFrame>,
    pub(super) laws: Catalogue<(LawPlace, Dimension)>,
    pub(super) constraints: Catalogue<Dimension>,
    motion: Option<Tangent>,
}

impl NameTable {
    /// Returns the rate of `value` along the motion.
    pub(super) fn total_rate(
        &mut self,
        graph: &mut Graph,
        value: Measured,
    ) -> Result<Measured, NameError> {
        let unknown = Reach::ACCELERATIONS.and(Reach::REACTIONS).and(Reach::FORCES);
        if unknown.meets(value.reach) {
            return Err(NameError {
                message: format!("the rate of {} is not known", unknown.words()),
                help: "take rates of coordinates and speeds only".to_owned(),
            });
        }
        let rates = Reach::COORDINATES.and(Reach::SPEEDS).and(Reach::PARAMETERS);
        let mut reach = value.reach;
        if value.reach.meets(Reach::COORDINATES) {
            reach = reach.and(rates);
        }
        if value.reach.meets(Reach::SPEEDS) {
            reach = reach.and(Reach::ACCELERATIONS);
        }
        if value.reach.meets(Reach::INPUT.and(Reach::INPUT_RATES)) {
            reach = reach.and(Reach::INPUT_RATES);
        }
        let mut motion = self.motion.take().unwrap_or_else(|| self.seeds(graph));
        let node = motion.of(graph, value.node);
        self.motion = Some(motion);
        Ok(Measured { node, dimension: value.dimension.over(Dimension::TIME), reach })
    }

    fn seeds(&self, graph: &mut Graph) -> Tangent {
        let mut seeds = Vec::new();
        for (index, rate) in (0u16..).zip(&self.rates) {
            if let Some(rate) = rate {
                seeds.push((Place::Coordinate(index), rate.node));
            }
        }
        for (index, _) in (0u16..).zip(&self.speeds) {
            let rate = graph.symbol(Place::Acceleration(index));
            seeds.push((Place::Speed(index), rate));
        }
        for order in 0..3 {
            let rate = graph.symbol(Place::Input(order + 1));
            seeds.push((Place::Input(order), rate));
        }
        Tangent::new(seeds)
    }

    /// Returns the unprimed value and how many primes are left to take.
    fn first(
        &self,
        graph: &mut Graph,
        kind: SymbolKind,
        primes: u8,
    ) -> Result<(Measured, u8), Option<NameError>> {
        let of = |graph: &mut Graph, place: Place, dimension: Option<&Dimension>, reach: Reach| {
            let dimension = dimension.copied().unwrap_or_default();
            Measured { node: graph.symbol(place), dimension, reach }
        };
        match kind {
            SymbolKind::Parameter(index) => {
                let place = Place::Parameter(number(index));
                let value = of(graph, place, self.parameters.get(index), Reach::PARAMETERS);
                Ok((value, primes))
            }
            SymbolKind::Coordinate(index) if primes == 0 => {
                let place = Place::Coordinate(number(index));
                Ok((of(graph, place, self.coordinates.get(index), Reach::COORDINATES), 0))
            }
            SymbolKind::Coordinate(index) => {
                let rate = self.rates.get(index).copied().flatten().ok_or(None)?;
                Ok((rate, primes - 1))
            }
            SymbolKind::Speed(index) => {
                let place = Place::Speed(number(index));
                Ok((of(graph, place, self.speeds.get(index), Reach::SPEEDS), primes))
            }
            SymbolKind::Definition(index) => {
                let value = self.definitions.get(index).copied().flatten().ok_or(None)?;
                Ok((value, primes))
            }
            SymbolKind::Input => {
                let reach = if primes == 0 { Reach::INPUT } else { Reach::INPUT_RATES };
                let dimension = self.input.over(Dimension::TIME.to(primes.into()));
                Ok((of(graph, Place::Input(primes), Some(&dimension), reach), 0))
            }
        }
    }

    fn named(
        &self,
        graph: &mut Graph,
        function: &str,
        names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)> {
        match (function, names) {
            ("distance", [from, to]) => {
                let (from, to) = (self.point(from, 0)?, self.point(to, 1)?);
                Ok(placed(distance(graph, from, to)))
            }
            ("x" | "y" | "z", [point]) => {
                let [x, y, z] = self.point(point, 0)?;
                Ok(placed(match function {
                    "x" => x,
                    "y" => y,
                    _ => z,
                }))
            }
            ("force", [name]) => self.force(graph, name),
            ("reaction", [name]) => {
                let Some(index) = self.constraints.index(name) else {
                    let help = self.constraints.choice(name);
                    return Err((0, Some(missing("constraint", name, help))));
                };
                let dimension = self.constraints.value(index).ok_or((0, None))?;
                let node = graph.symbol(Place::Reaction(number(index)));
                Ok(Measured { node, dimension, reach: Reach::REACTIONS })
            }
            _ => Err((0, None)),
        }
    }

    fn force(&self, graph: &mut Graph, name: &str) -> Result<Measured, (usize, Option<NameError>)> {
        let Some(index) = self.laws.index(name) else {
            let help = self.laws.choice(name);
            return Err((0, Some(missing("spring, felt, force or contact", name, help))));
        };
        let (place, dimension) = self.laws.value(index).ok_or((0, None))?;
        let (place, reach) = match place {
            LawPlace::Force(index) => (Place::Extra(number(index)), Reach::FORCES),
            LawPlace::Contact(index) => (Place::Contact(number(index)), Reach::REACTIONS),
        };
        Ok(Measured { node: graph.symbol(place), dimension, reach })
    }

    fn point(&self, name: &str, at: usize) -> Result<[Node; 3], (usize, Option<NameError>)> {
        let Some(index) = self.points.index(name) else {
            return Err((at, Some(missing("point", name, self.points.choice(name)))));
        };
        self.points.value(index).ok_or((at, None))
    }
}

/// A length that depends on where things are.
fn placed(node: Node) -> Measured {
    let reach = Reach::COORDINATES.and(Reach::PARAMETERS).and(Reach::INPUT);
    Measured { node, dimension: Dimension::LENGTH, reach }
}

/// Returns the distance of two points.
pub(super) fn distance(graph: &mut Graph, from: [Node; 3], to: [Node; 3]) -> Node {
    let mut squares = Vec::new();
    for (a, b) in from.into_iter().zip(to) {
        let difference = graph.subtract(b, a);
        squares.push((graph.power(difference, 2), 1.0));
    }
    let square = graph.sum(&squares);
    graph.sqrt(square)
}

fn missing(kind: &str, name: &str, help: String) -> NameError {
    NameError { message: format!("there is no {kind} {}", quoted(name)), help }
}

/// Returns the number of a thing; there are never so many that it does not fit.
pub(super) fn number(index: usize) -> u16 {
    u16::try_from(index).unwrap_or(u16::MAX)
}

/// The names as an expression may use them.
#[derive(Debug)]
pub(super) struct NamesInUse<'a> {
    pub(super) names: &'a mut NameTable,
    pub(super) allowed: Reach,
}

impl NameScope for NamesInUse<'_> {
    fn value(
        &mut self,
        graph: &mut Graph,
        name: &str,
        primes: u8,
    ) -> Result<Measured, Option<NameError>> {
        if let ("pi", 0) = (name, primes) {
            return Ok(pi(graph));
        }
        let Some((kind, _)) = self.names.symbols.get(name).copied() else {
            if self.names.is_broken {
                return Err(None);
            }
            let known = self.names.symbols.keys().map(String::as_str).chain(["pi"]);
            let help = choice(name, known);
            return Err(Some(NameError { message: format!("there is no {}", quoted(name)), help }));
        };
        if self.names.vague.contains(name) {
            return Err(None);
        }
        if matches!(kind, SymbolKind::Parameter(_)) && primes > 0 {
            let message = format!("{} is a parameter and has no rate", quoted(name));
            let help = format!("use {name} without the prime");
            return Err(Some(NameError { message, help }));
        }
        let (mut value, left) = self.names.first(graph, kind, primes)?;
        for _ in 0..left {
            value = self.names.total_rate(graph, value).map_err(Some)?;
        }
        Ok(value)
    }

    fn named(
        &mut self,
        graph: &mut Graph,
        function: &str,
        names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)> {
        let value = self.names.named(graph, function, names);
        value.map_err(|(at, error)| (at, error.filter(|_| !self.names.is_broken)))
    }

    fn rate(&mut self, graph: &mut Graph, value: Measured) -> Result<Measured, NameError> {
        self.names.total_rate(graph, value)
    }

    fn allowed(&self) -> Reach {
        self.allowed
    }
}

/// π, which every expression knows.
pub(super) fn pi(graph: &mut Graph) -> Measured {
    let node = graph.constant(std::f64::consts::PI);
    Measured { node, dimension: Dimension::NONE, reach: Reach::NOTHING }
}
