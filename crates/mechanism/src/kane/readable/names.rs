use std::collections::HashMap;

use crate::kane::graph::Place;
use crate::kane::mechanism::Mechanism;

/// Names of symbols in equations, in the notation of descriptions.
#[derive(Clone, Debug, Default)]
pub struct SymbolNames {
    names: HashMap<Place, String>,
    input: String,
}

impl SymbolNames {
    pub fn of(mechanism: &Mechanism) -> Self {
        let mut names = Self { input: mechanism.input.name.clone(), ..Self::default() };
        for (at, parameter) in (0..).zip(&mechanism.parameters) {
            names.set(Place::Parameter(at), &parameter.name);
        }
        for (at, coordinate) in (0..).zip(&mechanism.coordinates) {
            names.set(Place::Coordinate(at), &coordinate.name);
        }
        for (at, speed) in (0..).zip(&mechanism.speeds) {
            names.set(Place::Speed(at), &speed.name);
            names.set(Place::Acceleration(at), &format!("{}'", speed.name));
        }
        for (at, constraint) in (0..).zip(&mechanism.constraints) {
            names.set(Place::Reaction(at), &format!("reaction({})", constraint.name));
        }
        for (at, contact) in (0..).zip(&mechanism.contacts) {
            names.set(Place::Contact(at), &format!("force({})", contact.name));
            let function = if contact.gap.is_some() { "friction" } else { "force" };
            names.set(Place::Friction(at), &format!("{function}({})", contact.name));
        }
        names
    }

    pub fn set(&mut self, place: Place, name: &str) {
        self.names.insert(place, name.to_owned());
    }

    /// Returns the name of the symbol at `place`, generated where none was set.
    pub fn name(&self, place: Place) -> String {
        if let Some(name) = self.names.get(&place) {
            return name.clone();
        }
        match place {
            Place::Parameter(at) => format!("p{at}"),
            Place::Coordinate(at) => format!("q{at}"),
            Place::Speed(at) => format!("u{at}"),
            Place::Acceleration(at) => format!("u{at}'"),
            Place::Input(rate) => {
                let name = if self.input.is_empty() { "s" } else { &self.input };
                format!("{name}{}", "'".repeat(rate.into()))
            }
            Place::Reaction(at) => format!("reaction({at})"),
            Place::Contact(at) => format!("force({at})"),
            Place::Friction(at) => format!("friction({at})"),
            Place::Extra(at) => format!("extra{at}"),
            Place::Key => "key".to_owned(),
        }
    }
}
