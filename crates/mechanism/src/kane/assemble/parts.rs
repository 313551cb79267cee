//! What of a mode moves apart from the rest.

use instruments::equations::table::PartTable;
use pode::{EquationKind, MAX_PARTS, Part, Reads};

use super::AssemblyError;
use super::functions::FunctionList;
use super::jacobian::StateOfMode;
use super::kinds::{LossKind, is_of_input, kind_of};
use super::moving::Moving;
use crate::kane::graph::{Graph, Node};

/// The parts of a mode as sets of entries, in the order of their first entries: what the Jacobian
/// connects moves together. Beyond the most parts that a model can have, the last is the rest.
pub(super) fn components(
    graph: &Graph,
    state: &StateOfMode<'_>,
    jacobian: &[Vec<Node>],
) -> Vec<u64> {
    let mut parts: Vec<u64> = Vec::new();
    for index in state.free() {
        let linked = |other: usize| {
            !graph.is_zero(jacobian[index][other]) || !graph.is_zero(jacobian[other][index])
        };
        let mut own = 1 << index;
        for other in state.free().filter(|other| linked(*other)) {
            own |= 1 << other;
        }
        let (touched, mut apart): (Vec<_>, Vec<_>) =
            parts.iter().copied().partition(|part| part & own != 0);
        apart.push(touched.into_iter().fold(own, |all, part| all | part));
        parts = apart;
    }
    parts.sort_by_key(|part| part.trailing_zeros());
    let rest = parts.split_off(parts.len().min(MAX_PARTS - 1));
    if !rest.is_empty() {
        parts.push(rest.into_iter().fold(0, |all, part| all | part));
    }
    parts
}

pub(super) fn indices(entries: u64) -> Vec<usize> {
    (0..64).filter(|index| entries >> index & 1 == 1).collect()
}

/// A part with what it reads; one with all entries is the whole.
pub(super) fn part(entries: u64, states: usize, reads: Reads) -> Part {
    let is_whole = indices(entries).len() == states;
    let part = if is_whole { Part::WHOLE } else { Part::of(&indices(entries)) };
    match reads {
        Reads::State => part.of_state(),
        Reads::StateAndInput => part,
    }
}

pub(super) fn parts(
    graph: &mut Graph,
    functions: &mut FunctionList,
    moving: &Moving<'_>,
) -> Result<(Vec<PartTable>, Vec<Part>), AssemblyError> {
    let (mut tables, mut list) = (Vec::new(), Vec::new());
    for entries in components(graph, moving.state, moving.jacobian) {
        let own = indices(entries);
        let reads = reads(graph, moving, &own);
        let loss = LossKind::of_entries(graph, moving, &own);
        let kind = own_kind(graph, moving, &own, &loss);
        let zero = graph.constant(0.0);
        let rate = |index: usize| if own.contains(&index) { moving.rates[index] } else { zero };
        let rates: Vec<_> = (0..moving.rates.len()).map(rate).collect();
        let label = format!("{}_part_{}", moving.name, tables.len());
        let derivative = functions.add(graph, &label, &rates)?;
        let loss = loss.function(graph, functions, &format!("{label}_loss"))?;
        tables.push(PartTable { entries, derivative, kind, loss, reads });
        list.push(part(entries, moving.rates.len(), reads));
    }
    Ok((tables, list))
}

fn reads(graph: &mut Graph, moving: &Moving<'_>, own: &[usize]) -> Reads {
    let rates: Vec<_> = own.iter().map(|index| moving.rates[*index]).collect();
    let rates = moving.state.replaced(graph, &rates);
    if rates.iter().any(|rate| is_of_input(graph, *rate)) {
        Reads::StateAndInput
    } else {
        Reads::State
    }
}

fn own_kind(
    graph: &mut Graph,
    moving: &Moving<'_>,
    own: &[usize],
    loss: &LossKind,
) -> EquationKind {
    let rates: Vec<_> = own.iter().map(|index| moving.rates[*index]).collect();
    let rates = moving.state.replaced(graph, &rates);
    let rows: Vec<_> = own.iter().flat_map(|index| moving.jacobian[*index].clone()).collect();
    let rows = moving.state.replaced(graph, &rows);
    kind_of(graph, &rates, &rows, loss)
}
