use documents::toml::SourcePlace;

use std::collections::{BTreeMap, BTreeSet};

use documents::{choice, quoted};

use super::world_frame::WorldPoint;
use crate::kane::graph::{Graph, Node, Place, Tangent};
use crate::kane::text::{Dependence, Dimension, Measured, NameError};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum SymbolKind {
    Parameter(usize),
    Coordinate(usize),
    Speed(usize),
    Definition(usize),
    Input,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LawPlace {
    Force(usize),
    Contact(usize),
    /// Bearing, by its number among the contacts.
    Bearing(usize),
}

#[derive(Clone, Debug)]
pub(super) struct NameCatalogue<T> {
    pub(super) names: BTreeMap<String, (usize, SourcePlace)>,
    /// Value of each; `None` until it is built, or if it is invalid.
    pub(super) values: Vec<Option<T>>,
}

impl<T> Default for NameCatalogue<T> {
    fn default() -> Self {
        Self { names: BTreeMap::new(), values: Vec::new() }
    }
}

impl<T: Clone> NameCatalogue<T> {
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

    pub(super) fn declare(&mut self, name: &str, place: SourcePlace) -> Result<usize, SourcePlace> {
        if let Some((_, first)) = self.names.get(name) {
            return Err(*first);
        }
        let index = self.values.len();
        self.names.insert(name.to_owned(), (index, place));
        self.values.push(None);
        Ok(index)
    }

    pub(super) fn choice(&self, wrong: &str) -> String {
        if self.names.is_empty() {
            return format!("there are none yet: describe one, or leave out {}", quoted(wrong));
        }
        choice(wrong, self.names.keys())
    }
}

#[derive(Debug, Default)]
pub(super) struct NameTable {
    pub(super) symbols: BTreeMap<String, (SymbolKind, SourcePlace)>,
    /// `true` if a part of a file is unreadable and may contain missing names.
    pub(super) is_broken: bool,
    /// Names of unknown unit, because it is invalid in the file.
    pub(super) vague: BTreeSet<String>,
    pub(super) parameters: Vec<Dimension>,
    pub(super) coordinates: Vec<Dimension>,
    pub(super) rates: Vec<Option<Measured>>,
    pub(super) speeds: Vec<Dimension>,
    pub(super) input: Dimension,
    pub(super) definitions: Vec<Option<Measured>>,
    pub(super) points: NameCatalogue<WorldPoint>,
    pub(super) frames: NameCatalogue<super::world_frame::WorldFrame>,
    pub(super) laws: NameCatalogue<(LawPlace, Dimension)>,
    /// Slips of the contacts and bearings with friction, by their numbers.
    pub(super) slips: BTreeMap<usize, Measured>,
    pub(super) constraints: NameCatalogue<Dimension>,
    motion: Option<Tangent>,
}

impl NameTable {
    pub(super) fn total_rate(
        &mut self,
        graph: &mut Graph,
        value: Measured,
    ) -> Result<Measured, NameError> {
        let forces = Dependence::FORCES.and(Dependence::FRICTIONS);
        let unknown = Dependence::ACCELERATIONS.and(Dependence::REACTIONS).and(forces);
        if unknown.meets(value.reach) {
            return Err(NameError {
                message: format!("the rate of {} is not known", unknown.words()),
                help: "take rates of coordinates and speeds only".to_owned(),
            });
        }
        let rates = Dependence::COORDINATES.and(Dependence::SPEEDS).and(Dependence::PARAMETERS);
        let mut reach = value.reach;
        if value.reach.meets(Dependence::COORDINATES) {
            reach = reach.and(rates);
        }
        if value.reach.meets(Dependence::SPEEDS) {
            reach = reach.and(Dependence::ACCELERATIONS);
        }
        if value.reach.meets(Dependence::INPUT.and(Dependence::INPUT_RATES)) {
            reach = reach.and(Dependence::INPUT_RATES);
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

    /// Returns the unprimed value and the number of primes left to apply.
    pub(super) fn first(
        &self,
        graph: &mut Graph,
        kind: SymbolKind,
        primes: u8,
    ) -> Result<(Measured, u8), Option<NameError>> {
        let of =
            |graph: &mut Graph, place: Place, dimension: Option<&Dimension>, reach: Dependence| {
                let dimension = dimension.copied().unwrap_or_default();
                Measured { node: graph.symbol(place), dimension, reach }
            };
        match kind {
            SymbolKind::Parameter(index) => {
                let place = Place::Parameter(number(index));
                let value = of(graph, place, self.parameters.get(index), Dependence::PARAMETERS);
                Ok((value, primes))
            }
            SymbolKind::Coordinate(index) if primes == 0 => {
                let place = Place::Coordinate(number(index));
                Ok((of(graph, place, self.coordinates.get(index), Dependence::COORDINATES), 0))
            }
            SymbolKind::Coordinate(index) => {
                let rate = self.rates.get(index).copied().flatten().ok_or(None)?;
                Ok((rate, primes - 1))
            }
            SymbolKind::Speed(index) => {
                let place = Place::Speed(number(index));
                Ok((of(graph, place, self.speeds.get(index), Dependence::SPEEDS), primes))
            }
            SymbolKind::Definition(index) => {
                let value = self.definitions.get(index).copied().flatten().ok_or(None)?;
                Ok((value, primes))
            }
            SymbolKind::Input => {
                let reach = if primes == 0 { Dependence::INPUT } else { Dependence::INPUT_RATES };
                let dimension = self.input.over(Dimension::TIME.to(primes.into()));
                Ok((of(graph, Place::Input(primes), Some(&dimension), reach), 0))
            }
        }
    }

    pub(super) fn named(
        &self,
        graph: &mut Graph,
        function: &str,
        names: &[&str],
    ) -> Result<Measured, (usize, Option<NameError>)> {
        match (function, names) {
            ("distance", [from, to]) => {
                let (from, to) = (self.point(from, 0)?, self.point(to, 1)?);
                Ok(length(distance(graph, from.at, to.at), from.reach.and(to.reach)))
            }
            ("x" | "y" | "z", [point]) => {
                let WorldPoint { at: [x, y, z], reach } = self.point(point, 0)?;
                let at = match function {
                    "x" => x,
                    "y" => y,
                    _ => z,
                };
                Ok(length(at, reach))
            }
            ("force", [name]) => self.force(graph, name),
            ("friction", [name]) => match self.law(name)?.0 {
                LawPlace::Contact(at) | LawPlace::Bearing(at) if self.slips.contains_key(&at) => {
                    Ok(self.friction(graph, at))
                }
                LawPlace::Force(_) | LawPlace::Contact(_) | LawPlace::Bearing(_) => {
                    let message = format!("{} has no friction", quoted(name));
                    let help = "name a friction, or a contact with one".to_owned();
                    Err((0, Some(NameError { message, help })))
                }
            },
            ("reaction", [name]) => {
                let Some(index) = self.constraints.index(name) else {
                    let help = self.constraints.choice(name);
                    return Err((0, Some(missing("constraint", name, help))));
                };
                let dimension = self.constraints.value(index).ok_or((0, None))?;
                let node = graph.symbol(Place::Reaction(number(index)));
                Ok(Measured { node, dimension, reach: Dependence::REACTIONS })
            }
            _ => Err((0, None)),
        }
    }

    fn law(&self, name: &str) -> Result<(LawPlace, Dimension), (usize, Option<NameError>)> {
        let Some(index) = self.laws.index(name) else {
            let help = self.laws.choice(name);
            let kinds = "spring, felt, force, contact or friction";
            return Err((0, Some(missing(kinds, name, help))));
        };
        self.laws.value(index).ok_or((0, None))
    }

    fn friction(&self, graph: &mut Graph, contact: usize) -> Measured {
        let slip = self.slips.get(&contact).map_or(Dimension::SPEED, |slip| slip.dimension);
        let node = graph.symbol(Place::Friction(number(contact)));
        let dimension = Dimension::POWER.over(slip);
        Measured { node, dimension, reach: Dependence::FRICTIONS }
    }

    fn force(&self, graph: &mut Graph, name: &str) -> Result<Measured, (usize, Option<NameError>)> {
        let (place, dimension) = self.law(name)?;
        let (place, reach) = match place {
            LawPlace::Bearing(at) => return Ok(self.friction(graph, at)),
            LawPlace::Force(index) => (Place::Extra(number(index)), Dependence::FORCES),
            LawPlace::Contact(index) => (Place::Contact(number(index)), Dependence::REACTIONS),
        };
        Ok(Measured { node: graph.symbol(place), dimension, reach })
    }

    fn point(&self, name: &str, at: usize) -> Result<WorldPoint, (usize, Option<NameError>)> {
        let Some(index) = self.points.index(name) else {
            return Err((at, Some(missing("point", name, self.points.choice(name)))));
        };
        self.points.value(index).ok_or((at, None))
    }
}

const fn length(node: Node, reach: Dependence) -> Measured {
    Measured { node, dimension: Dimension::LENGTH, reach }
}

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

/// Returns the number of an item; limits on items make it fit.
pub(super) fn number(index: usize) -> u16 {
    u16::try_from(index).unwrap_or(u16::MAX)
}

pub(super) fn pi(graph: &mut Graph) -> Measured {
    let node = graph.constant(std::f64::consts::PI);
    Measured { node, dimension: Dimension::NONE, reach: Dependence::NOTHING }
}
