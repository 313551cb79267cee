//! Writes expressions bottom up, with names for parts that occur more than once.

use std::collections::HashMap;

use super::SymbolNames;
use super::notation::{Notation, Tightness, WrittenPart};
use crate::kane::graph::{Graph, Node, NodeOperation};

/// Operations from which a part that occurs more than once is named.
const NAMED_WHEN_SHARED: u64 = 6;
/// Operations from which any part is named, because longer lines are unreadable.
const NAMED_ALWAYS: u64 = 60;

/// Named definition on one line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Equation {
    pub left: String,
    pub right: String,
}

/// Returns `node` without names for its parts, possibly far longer than [`equations()`].
pub fn expression(graph: &Graph, node: Node, names: &SymbolNames, notation: Notation) -> String {
    let mut writer = EquationWriter::new(graph, names, notation);
    writer.write(&[node], &|_, _| false);
    writer.text(node)
}

/// Returns the definitions of named parts, then `wanted` in terms of them.
///
/// The left sides of `wanted` are in the notation of descriptions.
pub fn equations(
    graph: &Graph,
    wanted: &[(String, Node)],
    names: &SymbolNames,
    notation: Notation,
) -> (Vec<Equation>, Vec<Equation>) {
    let outputs: Vec<Node> = wanted.iter().map(|(_, node)| *node).collect();
    let mut writer = EquationWriter::new(graph, names, notation);
    writer.write(&outputs, &|size, uses| {
        size >= NAMED_ALWAYS || uses > 1 && size >= NAMED_WHEN_SHARED
    });
    let equations = wanted
        .iter()
        .map(|(left, node)| Equation { left: notation.name(left).text, right: writer.text(*node) })
        .collect();
    (writer.definitions, equations)
}

struct EquationWriter<'a> {
    graph: &'a Graph,
    names: &'a SymbolNames,
    notation: Notation,
    written: HashMap<Node, WrittenPart>,
    definitions: Vec<Equation>,
    sums: HashMap<SumTerms, WrittenPart>,
}

/// Number of a sum, and its terms with their factors.
type SumTerms = (u64, Vec<(Node, u64)>);

impl<'a> EquationWriter<'a> {
    fn new(graph: &'a Graph, names: &'a SymbolNames, notation: Notation) -> Self {
        Self {
            graph,
            names,
            notation,
            written: HashMap::new(),
            definitions: Vec::new(),
            sums: HashMap::new(),
        }
    }

    fn text(&self, node: Node) -> String {
        self.written.get(&node).map(|it| it.text.clone()).unwrap_or_default()
    }

    fn write(&mut self, outputs: &[Node], is_named: &dyn Fn(u64, u32) -> bool) {
        let reached = self.graph.reached(outputs);
        let mut uses: HashMap<Node, u32> = HashMap::new();
        for node in &reached {
            self.graph.operation(*node).operands(|it| *uses.entry(it).or_default() += 1);
        }
        for output in outputs {
            *uses.entry(*output).or_default() += 1;
        }
        let mut sizes: HashMap<Node, u64> = HashMap::new();
        for node in reached {
            let mut size = 0_u64;
            self.graph.operation(node).operands(|it| size = size.saturating_add(sizes[&it] + 1));
            if let Some(written) = self.negated(node) {
                self.written.insert(node, written);
                sizes.insert(node, 1);
                continue;
            }
            let mut written = self.one(node);
            if is_named(size, uses[&node]) {
                let name = self.notation.name(&format!("z{}", self.definitions.len() + 1));
                self.definitions.push(Equation { left: name.text.clone(), right: written.text });
                self.remember_sum(node, &name);
                (written, size) = (name, 0);
            }
            self.written.insert(node, written);
            sizes.insert(node, size);
        }
    }

    fn remember_sum(&mut self, node: Node, name: &WrittenPart) {
        if let NodeOperation::Sum(number, terms) = self.graph.operation(node) {
            self.sums.insert((*number, terms.to_vec()), name.clone());
        }
    }

    /// Returns the negative of a named sum if `node` has its terms with opposite signs.
    fn negated(&self, node: Node) -> Option<WrittenPart> {
        let NodeOperation::Sum(number, terms) = self.graph.operation(node) else { return None };
        // The graph has no −0, only 0.
        let opposite = |bits: u64| (0.0 - f64::from_bits(bits)).to_bits();
        let terms = terms.iter().map(|(node, by)| (*node, opposite(*by))).collect();
        let name = self.sums.get(&(opposite(*number), terms))?;
        Some(WrittenPart { text: format!("-{}", name.text), tightness: Tightness::Sum })
    }

    fn of(&self, node: Node) -> WrittenPart {
        self.written.get(&node).cloned().unwrap_or_else(|| WrittenPart::atom(String::new()))
    }

    fn one(&self, node: Node) -> WrittenPart {
        match self.graph.operation(node) {
            NodeOperation::Number(bits) => self.signed_number(f64::from_bits(*bits)),
            NodeOperation::Symbol(place) => self.notation.name(&self.names.name(*place)),
            NodeOperation::Sum(number, terms) => {
                let terms: Vec<(Node, f64)> =
                    terms.iter().map(|(node, by)| (*node, f64::from_bits(*by))).collect();
                self.sum(f64::from_bits(*number), &terms)
            }
            NodeOperation::Product(factors) => self.product(factors),
            NodeOperation::Unary(function, x) => self.notation.unary(*function, &self.of(*x)),
            NodeOperation::Binary(function, x, y) => {
                self.notation.binary(*function, &self.of(*x), &self.of(*y))
            }
            NodeOperation::Select(all) => {
                let [condition, positive, other] = all.map(|it| self.of(it));
                self.notation.select([&condition, &positive, &other])
            }
        }
    }

    fn signed_number(&self, value: f64) -> WrittenPart {
        let written = self.notation.number(value.abs());
        if value < 0.0 {
            WrittenPart { text: format!("-{}", written.text), tightness: Tightness::Sum }
        } else {
            written
        }
    }

    /// Writes positive terms first, the number last.
    fn sum(&self, number: f64, terms: &[(Node, f64)]) -> WrittenPart {
        let mut ordered: Vec<(Option<Node>, f64)> =
            terms.iter().map(|(node, factor)| (Some(*node), *factor)).collect();
        if number != 0.0 {
            ordered.push((None, number));
        }
        ordered.sort_by_key(|(_, factor)| *factor < 0.0);
        let mut text = String::new();
        for (node, factor) in ordered {
            text.push_str(match (text.is_empty(), factor < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            });
            let size = factor.abs();
            let term = match node {
                None => self.notation.number(size),
                Some(node) if (size - 1.0).abs() == 0.0 => self.of(node),
                Some(node) => self.notation.product(&[self.notation.number(size), self.of(node)]),
            };
            text.push_str(&self.notation.within(&term, Tightness::Product));
        }
        WrittenPart { text, tightness: Tightness::Sum }
    }

    fn product(&self, factors: &[(Node, i32)]) -> WrittenPart {
        let powers = |wanted: fn(i32) -> bool| -> Vec<WrittenPart> {
            let chosen = factors.iter().filter(|(_, exponent)| wanted(*exponent));
            chosen.map(|(node, exponent)| self.power(*node, exponent.unsigned_abs())).collect()
        };
        let above = self.notation.product(&powers(|exponent| exponent > 0));
        let below = powers(|exponent| exponent < 0);
        if below.is_empty() {
            above
        } else {
            self.notation.fraction(&above, &self.notation.product(&below))
        }
    }

    fn power(&self, node: Node, exponent: u32) -> WrittenPart {
        if exponent == 1 {
            return self.of(node);
        }
        self.notation.power(&self.of(node), &WrittenPart::atom(exponent.to_string()))
    }
}
