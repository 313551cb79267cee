//! What a mode's equations are like.

use instruments::equations::table::FunctionId;
use pode::EquationKind;

use super::AssemblyError;
use super::functions::FunctionList;
use super::jacobian::StateOfMode;
use super::moving::Moving;
use crate::kane::graph::{
    BinaryFunction, Graph, Node, NodeOperation, Place, Substitution, UnaryFunction,
};

pub(super) fn is_of_state(graph: &Graph, node: Node) -> bool {
    graph.depends(node, |place| matches!(place, Place::Coordinate(_) | Place::Speed(_)))
}

pub(super) fn is_of_input(graph: &Graph, node: Node) -> bool {
    graph.depends(node, |place| matches!(place, Place::Input(_)))
}

/// Whether `rates` have a constant Jacobian.
pub(super) fn is_linear_in_state(
    graph: &mut Graph,
    state: &StateOfMode<'_>,
    rates: &[Node],
) -> bool {
    let entries: Vec<_> = state.jacobian(graph, rates).into_iter().flatten().collect();
    let entries = state.replaced(graph, &entries);
    entries.iter().all(|it| !is_of_state(graph, *it) && !is_of_input(graph, *it))
}

pub(super) fn kind_of(
    graph: &Graph,
    rates: &[Node],
    jacobian: &[Node],
    loss: &LossKind,
) -> EquationKind {
    let is_constant = |node: &Node| !is_of_state(graph, *node) && !is_of_input(graph, *node);
    if !jacobian.iter().all(is_constant) {
        return if loss.is_nothing() { EquationKind::Conservative } else { EquationKind::Smooth };
    }
    if rates.iter().any(|rate| is_of_input(graph, *rate)) {
        EquationKind::Linear
    } else {
        EquationKind::Affine
    }
}

/// Whether the fastest rate is a matter of the state: where the Jacobian has what sets in or
/// grows with a place, as felts do. Angles turn it by little, and are left to the rest pose; so is
/// what grows with speeds alone, as the loss of a felt.
pub(super) fn is_stiffening(graph: &mut Graph, jacobian: &[Vec<Node>], state: &[Place]) -> bool {
    let entries: Vec<_> = jacobian.iter().flatten().copied().collect();
    let zero = graph.constant(0.0);
    let speeds = state.iter().filter(|place| matches!(place, Place::Speed(_)));
    let mut still = Substitution::new(speeds.map(|place| (*place, zero)));
    graph.reached(&entries).into_iter().any(|node| {
        let Some(by) = grows_by(graph, node) else { return false };
        let at_rest = still.of(graph, by);
        is_of_state(graph, at_rest)
    })
}

/// What makes a node set in or grow, if it does so other than as a product.
fn grows_by(graph: &Graph, node: Node) -> Option<Node> {
    let grows = match graph.operation(node) {
        NodeOperation::Unary(function, _) => matches!(
            function,
            UnaryFunction::Exp
                | UnaryFunction::Softplus
                | UnaryFunction::Logistic
                | UnaryFunction::SoftplusArea
                | UnaryFunction::SoftplusSquareArea
        ),
        NodeOperation::Binary(function, _, _) => {
            matches!(function, BinaryFunction::Power | BinaryFunction::Min | BinaryFunction::Max)
        }
        NodeOperation::Select([condition, _, _]) => return Some(*condition),
        NodeOperation::Number(_)
        | NodeOperation::Symbol(_)
        | NodeOperation::Sum(..)
        | NodeOperation::Product(_) => false,
    };
    grows.then_some(node)
}

/// When nothing is dissipated: a number that is 0 where it is so, or always, or never.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum LossKind {
    Nothing,
    Always,
    /// Sum of the terms' losses. Each loss is multiplied by squared parameters; a zero parameter
    /// removes it.
    Where(Node),
}

impl LossKind {
    pub(super) const fn is_nothing(&self) -> bool {
        matches!(self, Self::Nothing)
    }

    pub(super) fn of(graph: &mut Graph, dissipated: Option<Node>, parameters: u16) -> Self {
        let Some(dissipated) = dissipated else { return Self::Nothing };
        let terms = terms(graph, dissipated);
        Self::of_terms(graph, &terms, parameters)
    }

    pub(super) fn of_entries(graph: &mut Graph, moving: &Moving<'_>, own: &[usize]) -> Self {
        let Some(dissipated) = moving.dissipated else { return Self::Nothing };
        let places: Vec<_> = own.iter().map(|index| moving.state.state[*index]).collect();
        let mut terms = terms(graph, dissipated);
        terms.retain(|term| graph.depends(*term, |place| places.contains(&place)));
        let parameters = moving.parameters;
        Self::of_terms(graph, &terms, parameters)
    }

    fn of_terms(graph: &mut Graph, terms: &[Node], parameters: u16) -> Self {
        let mut lost = Vec::new();
        for term in terms {
            let factors = vanishing(graph, *term, parameters);
            if factors.is_empty() {
                return Self::Always;
            }
            lost.push((graph.product(&factors), 1.0));
        }
        if lost.is_empty() { Self::Nothing } else { Self::Where(graph.sum(&lost)) }
    }

    pub(super) fn function(
        &self,
        graph: &Graph,
        functions: &mut FunctionList,
        name: &str,
    ) -> Result<Option<FunctionId>, AssemblyError> {
        match self {
            Self::Nothing | Self::Always => Ok(None),
            Self::Where(node) => functions.add_whole(graph, name, &[*node]).map(Some),
        }
    }
}

/// The squares of the parameters that make `term` vanish, each by itself.
fn vanishing(graph: &mut Graph, term: Node, parameters: u16) -> Vec<(Node, i32)> {
    let zero = graph.constant(0.0);
    let mut factors = Vec::new();
    let symbols = graph.reached(&[term]).into_iter().filter_map(|node| {
        let NodeOperation::Symbol(place) = graph.operation(node) else { return None };
        matches!(place, Place::Parameter(number) if *number < parameters).then_some((*place, node))
    });
    let mut symbols: Vec<_> = symbols.collect();
    symbols.sort_unstable();
    for (place, symbol) in symbols {
        let without = Substitution::new([(place, zero)]).of(graph, term);
        if graph.is_zero(without) {
            factors.push((symbol, 2));
        }
    }
    factors
}

fn terms(graph: &Graph, node: Node) -> Vec<Node> {
    if let NodeOperation::Sum(0, terms) = graph.operation(node) {
        terms.iter().map(|(term, _)| *term).collect()
    } else if graph.is_zero(node) {
        Vec::new()
    } else {
        vec![node]
    }
}
