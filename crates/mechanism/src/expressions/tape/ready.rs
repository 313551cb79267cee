//! Values that depend on the parameters alone, and their use within larger sums and products.

use std::collections::{BTreeMap, BTreeSet};

use super::forms::{FormId, Forms, TapeForm};
use super::{Argument, ArgumentLayout};
use crate::expressions::graph::{Graph, Node, NodeOperation, Place};

/// Returns the parts of `outputs` over constant symbols alone that are worth computing once.
///
/// The constant factors of a product and the constant terms of a sum count as one part, which
/// becomes a node if it is none yet; [`ArgumentLayout::ready`] then finds it there.
pub fn constant_parts(
    graph: &mut Graph,
    outputs: &[Node],
    is_constant: impl Fn(Place) -> bool,
) -> Vec<Node> {
    let reached = graph.reached(outputs);
    let mut constant: BTreeSet<Node> = BTreeSet::new();
    for node in &reached {
        let operation = graph.operation(*node);
        let mut all = !matches!(operation, NodeOperation::Symbol(place) if !is_constant(*place));
        graph.operation(*node).operands(|it| all &= constant.contains(&it));
        if all {
            constant.insert(*node);
        }
    }
    let mut parts: BTreeSet<Node> = outputs.iter().copied().collect();
    let mut made = Vec::new();
    for node in reached.iter().filter(|it| !constant.contains(it)) {
        graph.operation(*node).operands(|it| {
            parts.insert(it);
        });
        made.extend(constant_part(graph, *node, &constant));
    }
    parts.retain(|it| constant.contains(it));
    parts.extend(made);
    let is_computed = |node: &Node| {
        !matches!(graph.operation(*node), NodeOperation::Number(_) | NodeOperation::Symbol(_))
    };
    parts.into_iter().filter(is_computed).collect()
}

fn constant_part(graph: &mut Graph, node: Node, constant: &BTreeSet<Node>) -> Option<Node> {
    match graph.operation(node).clone() {
        NodeOperation::Product(factors) => {
            let some: Vec<_> =
                factors.iter().filter(|it| constant.contains(&it.0)).copied().collect();
            let is_work = some.len() > 1 || some.iter().any(|it| it.1 != 1);
            is_work.then(|| graph.product(&some))
        }
        NodeOperation::Sum(_, terms) => {
            let some: Vec<_> = terms
                .iter()
                .filter(|it| constant.contains(&it.0))
                .map(|(it, by)| (*it, f64::from_bits(*by)))
                .collect();
            (some.len() > 1).then(|| graph.sum(&some))
        }
        NodeOperation::Number(_)
        | NodeOperation::Symbol(_)
        | NodeOperation::Unary(..)
        | NodeOperation::Binary(..)
        | NodeOperation::Select(_) => None,
    }
}

impl Forms {
    pub(super) fn use_ready(&mut self, graph: &Graph, layout: &ArgumentLayout) {
        let mut ready: Vec<(Node, Argument)> =
            layout.ready.iter().map(|it| (*it.0, *it.1)).collect();
        ready.sort_by_key(|(node, _)| {
            let mut parts = 0_usize;
            graph.operation(*node).operands(|_| parts += 1);
            (core::cmp::Reverse(parts), *node)
        });
        let mut owners: BTreeMap<FormId, Vec<FormId>> = BTreeMap::new();
        for (id, form) in self.all.iter().enumerate() {
            if matches!(form, TapeForm::Sum(..) | TapeForm::Product(_)) {
                form.operands(|operand| owners.entry(operand).or_default().push(id));
            }
        }
        for (node, argument) in ready {
            let Some(part) = self.part(graph.operation(node)) else { continue };
            let mut first = None;
            part.operands(|operand| first = first.or(Some(operand)));
            let candidates = first.and_then(|it| owners.get(&it)).cloned().unwrap_or_default();
            let ready = self.push(TapeForm::Argument(argument));
            for owner in candidates {
                let left = without(&self.all[owner], &part);
                self.all[owner] =
                    left.map_or_else(|| self.all[owner].clone(), |it| with(it, ready));
            }
        }
    }

    /// Returns a ready sum or product in terms of forms; `None` if one of its operands has no form.
    fn part(&self, operation: &NodeOperation) -> Option<TapeForm> {
        let id = |node: &Node| self.ids.get(node).copied();
        match operation {
            NodeOperation::Sum(0, terms) => {
                let terms = terms.iter().map(|(it, by)| Some((id(it)?, f64::from_bits(*by))));
                Some(TapeForm::Sum(0.0, terms.collect::<Option<_>>()?))
            }
            NodeOperation::Product(factors) => {
                let factors = factors.iter().map(|(it, by)| Some((id(it)?, *by)));
                Some(TapeForm::Product(factors.collect::<Option<_>>()?))
            }
            NodeOperation::Number(_)
            | NodeOperation::Symbol(_)
            | NodeOperation::Sum(..)
            | NodeOperation::Unary(..)
            | NodeOperation::Binary(..)
            | NodeOperation::Select(_) => None,
        }
    }
}

/// Returns the rest of a form without `part`, and the factor that `part` had in it.
fn without(form: &TapeForm, part: &TapeForm) -> Option<(TapeForm, f64)> {
    match (form, part) {
        (TapeForm::Product(all), TapeForm::Product(part)) => {
            let mut left = all.clone();
            for (base, exponent) in part {
                let it = left.iter_mut().find(|it| it.0 == *base)?;
                let fits = it.1.signum() == exponent.signum() && it.1.abs() >= exponent.abs();
                it.1 -= if fits { *exponent } else { return None };
            }
            left.retain(|it| it.1 != 0);
            Some((TapeForm::Product(left), 1.0))
        }
        (TapeForm::Sum(number, all), TapeForm::Sum(_, part)) => {
            let (first, of_part) = *part.first()?;
            let scale = all.iter().find(|it| it.0 == first)?.1 / of_part;
            let mut left = all.clone();
            for (term, factor) in part {
                let at = left.iter().position(|it| it.0 == *term)?;
                let is_exact = (scale * factor).to_bits() == left[at].1.to_bits();
                left.remove(if is_exact { at } else { return None });
            }
            Some((TapeForm::Sum(*number, left), scale))
        }
        _ => None,
    }
}

fn with((form, scale): (TapeForm, f64), ready: FormId) -> TapeForm {
    let mut form = form;
    match &mut form {
        TapeForm::Product(factors) => factors.push((ready, 1)),
        TapeForm::Sum(_, terms) => terms.push((ready, scale)),
        TapeForm::Number(_)
        | TapeForm::Argument(_)
        | TapeForm::Inverse(_)
        | TapeForm::Unary(..)
        | TapeForm::Binary(..)
        | TapeForm::Select(_) => {}
    }
    form
}
