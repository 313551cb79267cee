//! What ends a mode, and where that leads.

use instruments::equations::table::{FunctionId, GuardTable, ImpactTable, RestingTable, WayTable};
use pode::{GuardId, GuardSpec, Reads};

use super::builder::{ModeBuilder, ModeContext};
use super::functions::FunctionList;
use super::kinds::is_of_input;
use super::{AssemblyError, names};
use crate::kane::bound::Bounds;
use crate::kane::graph::{Graph, Node};
use crate::kane::system::{GuardEquations, Way};

pub(super) fn guards(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<(Vec<GuardTable>, Vec<GuardSpec>), AssemblyError> {
    let (mut tables, mut specs) = (Vec::new(), Vec::new());
    for guard in &builder.equations.guards {
        let table = self::guard(graph, functions, builder, guard)?;
        specs.push(GuardSpec {
            id: GuardId(table.id),
            name: table.name,
            priority: table.priority,
            scale: table.scale,
            fires: table.fires,
            reads: table.reads,
        });
        tables.push(table);
    }
    Ok((tables, specs))
}

fn guard(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    guard: &GuardEquations,
) -> Result<GuardTable, AssemblyError> {
    let name = &guard.name;
    let values = [guard.value, guard.rate];
    let mut ways = Vec::new();
    for (number, way) in guard.ways.iter().enumerate() {
        let label = format!("{name}_{number}");
        ways.push(self::way(graph, functions, builder, (&label, guard.value, way))?);
    }
    let sounds =
        guard.sounds.map(|node| builder.add(graph, functions, &format!("{name}_sounds"), &[node]));
    Ok(GuardTable {
        id: builder.context.numbers.number(guard),
        name: names::name(name),
        unit: names::name(&guard.unit),
        priority: guard.priority,
        scale: guard.scale,
        fires: guard.fires,
        closes: guard.closes,
        reads: reads(graph, builder, &values),
        value: builder.add(graph, functions, &format!("{name}_guard"), &values)?,
        // What frictions add has no bound.
        bound: (guard.pressed.is_empty())
            .then(|| bound(graph, functions, builder, (name, guard.value)))
            .transpose()?,
        pressed: pressed(graph, functions, builder, (name, &guard.pressed))?,
        ways,
        sounds: sounds.transpose()?,
    })
}

fn reads(graph: &Graph, builder: &ModeBuilder<'_>, values: &[Node]) -> Reads {
    if builder.follows_input || values.iter().any(|value| is_of_input(graph, *value)) {
        Reads::StateAndInput
    } else {
        Reads::State
    }
}

pub(super) fn bound(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, value): (&str, Node),
) -> Result<FunctionId, AssemblyError> {
    let value = builder.state.replaced(graph, &[value])[0];
    let bounds = Bounds::new(graph, builder.context.places).of(graph, value);
    builder.add(graph, functions, &format!("{name}_bound"), &bounds)
}

fn way(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, value, way): (&str, Node, &Way),
) -> Result<WayTable, AssemblyError> {
    let when =
        way.branch.when.map(|when| builder.add(graph, functions, &format!("{name}_when"), &[when]));
    let places = builder.context.places;
    let keeps = way.state.iter().zip(places).all(|(node, place)| *node == graph.symbol(*place));
    let reset = if keeps && graph.is_zero(way.impulse) {
        None
    } else {
        let outputs = [way.state.as_slice(), &[way.impulse]].concat();
        Some(builder.add(graph, functions, &format!("{name}_reset"), &outputs)?)
    };
    Ok(WayTable {
        when: when.transpose()?,
        to: u8::try_from(way.branch.to).unwrap_or(u8::MAX),
        reset,
        resting: resting(graph, functions, builder, (name, value, way))?,
        releases: way.releases.and_then(|released| {
            let next = builder.context.modes.get(way.branch.to)?;
            Some(builder.context.numbers.number(next.guards.get(released)?))
        }),
    })
}

/// Returns the impacts of each family of modes.
pub(super) fn impacts(
    graph: &mut Graph,
    functions: &mut FunctionList,
    context: &ModeContext<'_>,
) -> Result<Vec<ImpactTable>, AssemblyError> {
    let impacts = &context.mechanism.instrument.impacts;
    let mut tables = Vec::new();
    for family in &impacts.families {
        let base = family.members.first().and_then(|it| context.modes.get(it.0));
        let Some((base, found)) = base.and_then(|it| it.impacts.as_ref().map(|found| (it, found)))
        else {
            continue;
        };
        let name = family.members.first().and_then(|it| context.mechanism.modes.get(it.0));
        let name = name.map_or("", |mode| mode.name.as_str());
        let scale = |contact: u8| {
            base.guards.iter().find(|it| it.closes == Some(contact)).map_or(1.0, |it| it.scale)
        };
        let mut responses = Vec::new();
        for (number, response) in found.responses.iter().enumerate() {
            responses.push(functions.add(graph, &format!("{name}_pushed_{number}"), response)?);
        }
        let members = family.members.iter();
        tables.push(ImpactTable {
            law: impacts.law,
            members: members.map(|it| (u8::try_from(it.0).unwrap_or(u8::MAX), it.1)).collect(),
            scales: (0..).take(responses.len()).map(scale).collect(),
            meeting: functions.add(graph, &format!("{name}_meeting"), &found.meeting)?,
            responses,
        });
    }
    Ok(tables)
}

/// How an impact comes to rest: in the mode that has, beside the constraints of the mode after a
/// rebound, the one whose rate is the separation. An impulse is proportional to 1 + e, and so is
/// what it does to the speeds: without a rebound they change by the part 1/(1 + e) of it.
fn resting(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, value, way): (&str, Node, &Way),
) -> Result<Option<RestingTable>, AssemblyError> {
    let Some(impact) = way.branch.impact else { return Ok(None) };
    let Some(to) = resting_mode(graph, builder, way.branch.to, [value, impact.separation]) else {
        return Ok(None);
    };
    let one = graph.constant(1.0);
    let part = graph.add(one, impact.restitution);
    let mut outputs = Vec::new();
    for (index, (after, place)) in way.state.iter().zip(builder.context.places).enumerate() {
        let before = graph.symbol(*place);
        let change = graph.subtract(*after, before);
        let change = graph.divide(change, part);
        let is_place = index < builder.context.coordinates;
        outputs.push(if is_place { *after } else { graph.add(before, change) });
    }
    outputs.push(graph.divide(way.impulse, part));
    let closing = graph.negate(impact.separation);
    let meeting = [closing, impact.restitution];
    Ok(Some(RestingTable {
        to: u8::try_from(to).unwrap_or(u8::MAX),
        state: builder.add(graph, functions, &format!("{name}_rest"), &outputs)?,
        meeting: builder.add(graph, functions, &format!("{name}_meeting"), &meeting)?,
    }))
}

/// The mode in which what meets stays together: of constraints with the separation's rate, the one
/// that is zero where the guard is, if there is any.
fn resting_mode(
    graph: &mut Graph,
    builder: &ModeBuilder<'_>,
    to: usize,
    [value, separation]: [Node; 2],
) -> Option<usize> {
    let mechanism = builder.context.mechanism;
    let places = [value, graph.negate(value)];
    let opposite = graph.negate(separation);
    let all = mechanism.constraints.iter();
    let constraint = all
        .clone()
        .position(|it| places.contains(&it.zero))
        .or_else(|| all.clone().position(|it| it.rate == separation))
        .or_else(|| all.clone().position(|it| it.rate == opposite))?;
    let mut wanted = mechanism.modes.get(to)?.constraints.clone();
    wanted.push(constraint);
    wanted.sort_unstable();
    wanted.dedup();
    mechanism.modes.iter().enumerate().position(|(number, mode)| {
        let mut own = mode.constraints.clone();
        own.sort_unstable();
        number != to && own == wanted
    })
}

/// Adds the function of what frictions add to a limit or guard; `None` if that is nothing.
pub(super) fn pressed(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, nodes): (&str, &[Node]),
) -> Result<Option<FunctionId>, AssemblyError> {
    let function = || builder.add(graph, functions, &format!("{name}_pressed"), nodes);
    (!nodes.is_empty()).then(function).transpose()
}
