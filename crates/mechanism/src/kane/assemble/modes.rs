//! The table of one mode.

use instruments::equations::table::{ConstraintTable, ForceTable, Freedom, FunctionId, ModeTable};

use pode::EquationKind;

use super::builder::{ModeBuilder, ModeContext};
use super::functions::FunctionList;
use super::jacobian::StateOfMode;
use super::kinds::{LossKind, is_linear_in_state, is_of_input, is_stiffening, kind_of};
use super::moving::Moving;
use super::parts::parts;
use super::{AssemblyError, contacts, guards, mechanics, names};
use crate::kane::graph::{Graph, Place};
use crate::kane::mechanism::{ConstraintKind, Mechanism};

pub(super) fn mode(
    graph: &mut Graph,
    functions: &mut FunctionList,
    context: &ModeContext<'_>,
    number: usize,
) -> Result<ModeTable, AssemblyError> {
    let equations = &context.modes[number];
    let name = context.mechanism.modes.get(number).map_or("", |mode| mode.name.as_str());
    let state = StateOfMode::new(graph, context.places, equations);
    let follows_input = state.slaved.iter().any(|it| is_of_input(graph, *it));
    let builder = ModeBuilder { context, name, equations, state, follows_input };
    let motion = motion(graph, functions, &builder)?;
    let forces = forces(graph, functions, &builder)?;
    let (guards, guard_specs) = guards::guards(graph, functions, &builder)?;
    let contacts = contacts::contacts(graph, functions, &builder)?;
    Ok(ModeTable {
        name: names::name(name),
        forces,
        mechanics: mechanics::mechanics(graph, functions, &builder)?,
        guards,
        guard_specs,
        contacts,
        freedom: freedom(context.mechanism, number),
        constraints: ConstraintTable {
            longest_projection: longest_projection(graph, functions, context.mechanism, number)?,
            ..motion.constraints
        },
        ..motion
    })
}

fn motion(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<ModeTable, AssemblyError> {
    let (equations, state) = (builder.equations, &builder.state);
    let rates = &equations.derivative;
    let parameters = u16::try_from(builder.context.mechanism.parameters.len()).unwrap_or(u16::MAX);
    let (rows, is_known) = state.rows(graph, rates);
    let flat: Vec<_> = rows.iter().flatten().copied().collect();
    let loss = LossKind::of(graph, equations.balance.dissipated, parameters);
    let free: Vec<_> = state.free().map(|index| rates[index]).collect();
    let free = state.replaced(graph, &free);
    let entries = state.replaced(graph, &flat);
    let mut kind = kind_of(graph, &free, &entries, &loss);
    let averaged = &equations.averaged;
    if !averaged.is_empty() && is_linear_in_state(graph, state, averaged) {
        kind = EquationKind::Linear;
    }
    let derivative = builder.add(graph, functions, "derivative", rates)?;
    let moving = Moving {
        name: builder.name,
        state,
        rates,
        jacobian: &rows,
        dissipated: equations.balance.dissipated,
        parameters,
    };
    let (parts, part_list) = parts(graph, functions, &moving)?;
    let is_slaving = state.free().count() < builder.context.places.len();
    let slaved = is_slaving.then_some(state.slaved.as_slice());
    let slaved = slaved.map(|slaved| builder.add(graph, functions, "slaved", slaved));
    Ok(ModeTable {
        derivative,
        parts,
        part_list,
        constraints: ConstraintTable {
            slaved: slaved.transpose()?,
            projection: projection(graph, functions, builder)?,
            projected: equations.drift.len(),
            is_held: equations.is_held,
            longest_projection: None,
        },
        jacobian: is_known.then(|| builder.add(graph, functions, "jacobian", &flat)).transpose()?,
        kind,
        loss: loss.function(graph, functions, &format!("{}_loss", builder.name))?,
        is_stiffening: is_stiffening(graph, &rows, builder.context.places),
        ..ModeTable::NOTHING
    })
}

/// A Newton step towards the constraints, and behind it how far each is from zero.
fn projection(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<Option<FunctionId>, AssemblyError> {
    let equations = builder.equations;
    if equations.projection.is_empty() {
        return Ok(None);
    }
    let outputs = [equations.projection.as_slice(), &equations.drift].concat();
    builder.add(graph, functions, "projection", &outputs).map(Some)
}

fn forces(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<ForceTable, AssemblyError> {
    let equations = builder.equations;
    let zero = graph.constant(0.0);
    let readout = equations.readout.unwrap_or(zero);
    let slopes =
        [0, 1].map(|rate| builder.state.direction(graph, Place::Input(rate)).of(graph, readout));
    let balance =
        [equations.balance.energy, equations.balance.supplied, equations.balance.dissipated]
            .map(|node| node.unwrap_or(zero));
    let averaged = (!equations.averaged.is_empty())
        .then(|| builder.add(graph, functions, "averaged", &equations.averaged));
    Ok(ForceTable {
        readout: builder.add(graph, functions, "readout", &[readout])?,
        slopes: builder.add(graph, functions, "slopes", &slopes)?,
        outputs: builder.add(graph, functions, "outputs", &equations.outputs)?,
        balance: builder.add(graph, functions, "balance", &balance)?,
        averaged: averaged.transpose()?,
    })
}

fn longest_projection(
    graph: &Graph,
    functions: &mut FunctionList,
    mechanism: &Mechanism,
    number: usize,
) -> Result<Option<FunctionId>, AssemblyError> {
    let Some(mode) = mechanism.modes.get(number) else { return Ok(None) };
    let label = format!("{}_longest_projection", mode.name);
    let function = |node| functions.add_whole(graph, &label, &[node]);
    mode.longest_projection.map(function).transpose()
}

/// Coordinates, constraints (plain equations: coordinates in closed form) and independent speeds.
fn freedom(mechanism: &Mechanism, number: usize) -> Freedom {
    let count = |count: usize| u8::try_from(count).unwrap_or(u8::MAX);
    let Some(mode) = mechanism.modes.get(number) else { return Freedom { n: 0, m: 0, p: 0 } };
    let n = mechanism.speeds.len();
    let is_tie = |kind| matches!(kind, ConstraintKind::Holonomic | ConstraintKind::Nonholonomic);
    let known = mode.constraints.iter().filter_map(|it| mechanism.constraints.get(*it));
    let ties = known.filter(|it| is_tie(it.kind)).count();
    let m = if mode.equations.is_empty() { ties } else { ties + mode.solved.len() };
    Freedom { n: count(n), m: count(m), p: count(n.saturating_sub(m)) }
}
