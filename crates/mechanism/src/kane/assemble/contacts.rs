//! What contacts and bearings do in one mode.

use instruments::equations::table::{
    ApartTable, ContactGradientTable, ContactModeTable, ContactTable, FunctionId,
};
use pode::contacts::{ContactSpec, FrictionSpec, SlipKind};

use super::builder::ModeBuilder;
use super::functions::FunctionList;
use super::kinds::is_linear_in_state;
use super::{AssemblyError, guards, names, switches};
use crate::kane::graph::{Graph, Node, Place, Tangent};
use crate::kane::mechanism::Mechanism;
use crate::kane::system::{
    ApartForce, ContactEquations, EntryRole, FrictionEquations, MechanicalEquations,
};

pub(super) fn specs(mechanism: &Mechanism) -> (Vec<ContactTable>, Vec<ContactSpec>) {
    let one = |contact: &crate::kane::mechanism::MechanismContact| {
        let gap = contact.gap.map(|_| contact.scale);
        let friction = contact.friction.as_ref().map(|friction| FrictionSpec {
            kind: friction.kind,
            ..FrictionSpec::new(names::name(&friction.name), friction.scales.0, friction.scales.1)
        });
        let name = names::name(&contact.name);
        let spec = ContactSpec { name, gap, friction };
        let friction = friction.map(|it| (it.name, it.force, it.slip));
        (ContactTable { name, gap, friction }, spec)
    };
    mechanism.contacts.iter().map(one).unzip()
}

pub(super) fn contacts(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<Vec<ContactModeTable>, AssemblyError> {
    let mut tables = Vec::new();
    let mechanical = builder.equations.mechanical.as_ref();
    for (at, contact) in builder.equations.contacts.iter().enumerate() {
        let name = builder.context.mechanism.contacts.get(contact.contact);
        let name = name.map_or("contact", |contact| contact.name.as_str());
        let mut table = self::contact(graph, functions, builder, (name, contact))?;
        let pressed = mechanical.and_then(|it| Some((it, it.contacts.get(at)?.as_ref()?)));
        if let Some((form, pressed)) = pressed {
            let what = format!("{name}_mechanics");
            table.gradients.mechanics =
                Some(builder.add(graph, functions, &what, &pressed.added)?);
            if let Some(force) = &pressed.apart {
                table.gradients.apart = apart(graph, functions, builder, (name, form, force))?;
            }
        }
        tables.push(table);
    }
    Ok(tables)
}

fn apart(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, form, force): (&str, &MechanicalEquations, &ApartForce),
) -> Result<Option<ApartTable>, AssemblyError> {
    let coordinate = form.entry(EntryRole::Coordinate(force.speed)).map(u8::try_from);
    let (Some(Ok(coordinate)), Ok(speed)) = (coordinate, u8::try_from(force.speed)) else {
        return Ok(None);
    };
    let place = builder.add(graph, functions, &format!("{name}_place"), &force.place)?;
    let law = builder.add(graph, functions, &format!("{name}_law"), &force.law)?;
    Ok(Some(ApartTable { place, law, speed, coordinate }))
}

fn contact(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, contact): (&str, &ContactEquations),
) -> Result<ContactModeTable, AssemblyError> {
    let mut table = ContactModeTable {
        contact: u8::try_from(contact.contact).unwrap_or(u8::MAX),
        gap: None,
        bound: None,
        normal: None,
        gradients: ContactGradientTable::default(),
        balance: None,
        slip: None,
        limits: None,
        kept: None,
        is_linear: false,
        response: None,
        pressed: None,
        slip_bound: None,
        slopes: None,
        sounds: None,
    };
    if let Some(gap) = contact.gap {
        table.gap = Some(builder.add(graph, functions, &format!("{name}_gap"), &gap)?);
        table.bound = Some(guards::bound(graph, functions, builder, (name, gap[0]))?);
        if let Some(speed) = contact.sounds {
            let (closing, zero) = (graph.negate(gap[1]), graph.constant(0.0));
            let speed = graph.select(closing, speed, zero);
            table.sounds =
                Some(builder.add(graph, functions, &format!("{name}_sounds"), &[speed])?);
        }
    }
    if let Some(normal) = contact.normal {
        self::normal(graph, functions, builder, (name, contact), (normal, &mut table))?;
    }
    if let Some(friction) = &contact.friction {
        self::friction(graph, functions, builder, (name, friction), &mut table)?;
    }
    table.is_linear |= is_linear_switch(graph, builder, contact);
    let felt = contact.friction.as_ref().and_then(|friction| friction.response.readout);
    if felt.is_none_or(|readout| graph.is_zero(readout)) {
        table.slopes = Some(slopes(graph, functions, builder, (name, contact))?);
    }
    Ok(table)
}

/// What the closed contact adds to the derivative, and whether its Jacobian is constant; it is then
/// also meant beyond the contact's end.
fn added(
    graph: &mut Graph,
    builder: &ModeBuilder<'_>,
    contact: &ContactEquations,
) -> (Vec<Node>, bool) {
    let zero = graph.constant(0.0);
    let force = contact.normal.map_or(zero, |normal| normal[0]);
    let mut added: Vec<_> =
        contact.normal_response.derivative.iter().map(|per| graph.multiply(*per, force)).collect();
    added.resize(builder.context.places.len(), zero);
    let Some([gap, _]) = contact.gap else { return (added, false) };
    let [_, closed] = switches::sides(graph, &added, gap);
    let is_linear =
        contact.friction.is_none() && is_linear_in_state(graph, &builder.state, &closed);
    (if is_linear { closed } else { added }, is_linear)
}

/// Whether a switch leaves the Jacobian constant on each side.
fn is_linear_switch(
    graph: &mut Graph,
    builder: &ModeBuilder<'_>,
    contact: &ContactEquations,
) -> bool {
    let of_mechanism = builder.context.mechanism.contacts.get(contact.contact);
    let is_switch = of_mechanism
        .and_then(|it| it.friction.as_ref())
        .is_some_and(|it| it.kind == SlipKind::Condition);
    let friction = contact.friction.as_ref().filter(|_| is_switch);
    friction.is_some_and(|it| is_linear_in_state(graph, &builder.state, &it.response.derivative))
}

/// Returns the square of a contact's rate and the rate of its loss, each without all else:
/// −Σ ∂q''/∂q and −Σ ∂u'/∂u, since the Jacobian of one force has one eigenvalue of each.
fn rates(
    graph: &mut Graph,
    builder: &ModeBuilder<'_>,
    contact: &ContactEquations,
    force: Node,
) -> [Node; 2] {
    let (state, context) = (&builder.state, builder.context);
    let per = &contact.normal_response.derivative;
    let speeds = context.places.iter().copied().zip(per.iter().copied()).skip(context.coordinates);
    let mut pushed = Tangent::new(speeds);
    let (mut square, mut loss) = (Vec::new(), Vec::new());
    for index in state.free() {
        let slope = state.direction(graph, context.places[index]).of(graph, force);
        if index < context.coordinates {
            let pushed = pushed.of(graph, builder.equations.derivative[index]);
            square.push((graph.multiply(pushed, slope), -1.0));
        } else {
            loss.push((graph.multiply(per[index], slope), -1.0));
        }
    }
    [graph.sum(&square), graph.sum(&loss)]
}

fn slopes(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, contact): (&str, &ContactEquations),
) -> Result<FunctionId, AssemblyError> {
    let zero = graph.constant(0.0);
    let force = contact.normal.map_or(zero, |normal| normal[0]);
    let readout = graph.multiply(contact.normal_response.readout.unwrap_or(zero), force);
    let slopes =
        [0, 1].map(|rate| builder.state.direction(graph, Place::Input(rate)).of(graph, readout));
    builder.add(graph, functions, &format!("{name}_slopes"), &slopes)
}

fn normal(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, contact): (&str, &ContactEquations),
    ([force, energy, taken], table): ([Node; 3], &mut ContactModeTable),
) -> Result<(), AssemblyError> {
    let zero = graph.constant(0.0);
    let (added, is_linear) = added(graph, builder, contact);
    table.is_linear = is_linear;
    let rows = builder.state.jacobian(graph, &added);
    let rows: Vec<_> = rows.into_iter().flatten().collect();
    let response = &contact.normal_response;
    let [readout, motor] =
        [response.readout, response.motor].map(|per| graph.multiply(per.unwrap_or(zero), force));
    let rate = graph.symbol(Place::Input(1));
    let driven = graph.multiply(readout, rate);
    let supplied = graph.add(driven, motor);
    let balance = [readout, energy, supplied, taken];
    let rates = rates(graph, builder, contact, force);
    table.gradients.rates =
        Some(builder.add(graph, functions, &format!("{name}_rates"), &rates)?);
    table.normal = Some(builder.add(graph, functions, &format!("{name}_normal"), &added)?);
    table.gradients.jacobian =
        Some(builder.add(graph, functions, &format!("{name}_jacobian"), &rows)?);
    table.balance = Some(builder.add(graph, functions, &format!("{name}_balance"), &balance)?);
    Ok(())
}

fn friction(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
    (name, friction): (&str, &FrictionEquations),
    table: &mut ContactModeTable,
) -> Result<(), AssemblyError> {
    let slip = [&[friction.slip, friction.drift], friction.gradient.as_slice()].concat();
    let (zero, per) = (graph.constant(0.0), &friction.response);
    let (readout, motor) = (per.readout.unwrap_or(zero), per.motor.unwrap_or(zero));
    let response = [per.derivative.as_slice(), &[readout, motor]].concat();
    let limits = [friction.stiction, friction.kinetic];
    if let Some(kept) = &friction.kept {
        table.kept = Some(builder.add(graph, functions, &format!("{name}_kept"), kept)?);
    }
    table.slip = Some(builder.add(graph, functions, &format!("{name}_slip"), &slip)?);
    let bound = guards::bound(graph, functions, builder, (&format!("{name}_slip"), friction.slip))?;
    table.slip_bound = Some(bound);
    table.limits = Some(builder.add(graph, functions, &format!("{name}_limits"), &limits)?);
    table.response = Some(builder.add(graph, functions, &format!("{name}_response"), &response)?);
    table.pressed = guards::pressed(graph, functions, builder, (name, &friction.pressed))?;
    Ok(())
}
