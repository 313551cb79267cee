use documents::{choice, quoted};

use super::names::{NameTable, SymbolKind, pi};
use crate::kane::graph::Graph;
use crate::kane::text::{Dependence, Measured, NameError, NameScope};

#[derive(Debug)]
pub(super) struct NamesInUse<'a> {
    pub(super) names: &'a mut NameTable,
    pub(super) allowed: Dependence,
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

    fn allowed(&self) -> Dependence {
        self.allowed
    }
}
