//! The table of a whole model.

use instruments::equations::table::{
    AutomatonTable, ConstantTable, DamperTable, DriveTable, FunctionId, ModelTable, NamedQuantity,
    ParameterTable, PresetTable, RequirementTable, RestTable, SoundTable,
};
use pode::GuardSpec;

use super::builder::ModeContext;
use super::functions::FunctionList;
use super::guard_numbers::GuardNumbers;
use super::guards::impacts;
use super::modes::mode;
use super::{AssemblyError, Program, contacts, drawing, names, switches};
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::mechanism::{Mechanism, StringDamper};
use crate::kane::system::EquationSystem;

pub(super) fn assemble(system: EquationSystem) -> Result<Program, AssemblyError> {
    let EquationSystem { mut mechanism, state, coordinates, mut modes } = system;
    if state.len() > 64 {
        return Err(AssemblyError::TooManyStates(state.len()));
    }
    if modes.len() > instruments::equations::MAX_MODES {
        return Err(AssemblyError::TooManyModes(modes.len()));
    }
    let mut graph = std::mem::take(&mut mechanism.graph);
    let graph = &mut graph;
    switches::add(graph, &mut mechanism, &state, &mut modes);
    let parameters = mechanism.parameters.len();
    let mut functions = FunctionList::new(parameters, &state);
    let numbers = GuardNumbers::of(&modes)?;
    let context = ModeContext {
        mechanism: &mechanism,
        places: &state,
        coordinates,
        modes: &modes,
        numbers: &numbers,
    };
    let mut tables = Vec::new();
    for number in 0..modes.len() {
        tables.push(mode(graph, &mut functions, &context, number)?);
    }
    let impacts = impacts(graph, &mut functions, &context)?;
    let (contact_tables, contact_specs) = contacts::specs(&mechanism);
    let outputs = named(mechanism.outputs.iter().map(|it| (&it.name, &it.unit)));
    let first_pose = outputs.len().saturating_sub(3 * mechanism.instrument.drawing.frames.len());
    let drawing = drawing::table(graph, &mut functions, &mechanism, first_pose)?;
    let values = Values::of(graph, &mut functions, &mechanism, &state)?;
    let (derive, count) = constants(graph, &mut functions, parameters)?;
    let table = ModelTable {
        name: names::name(&mechanism.name),
        summary: mechanism.instrument.summary.as_str().into(),
        parameters: mechanism.parameters.iter().map(parameter).collect(),
        presets: values.presets,
        states: named(state.iter().map(|place| quantity(&mechanism, *place))),
        coordinates,
        constants: ConstantTable { count, derive, requirements: values.requirements },
        input: DriveTable {
            quantity: NamedQuantity {
                name: names::name(&mechanism.input.name),
                unit: names::name(&mechanism.input.unit),
            },
            per_metre: values.input_per_metre,
        },
        automata: AutomatonTable { contacts: contact_specs, guards: all_specs(&tables), impacts },
        modes: tables,
        contacts: contact_tables,
        outputs,
        rest: values.rest,
        sound: sound(&mechanism),
        drawing,
    };
    let FunctionList { functions, names, .. } = functions;
    Ok(Program { table, functions, names, work: graph.work() })
}

fn sound(mechanism: &Mechanism) -> SoundTable {
    let damper = |it: &StringDamper| DamperTable {
        lift: it.lift,
        fall: it.fall,
        softest_tone: it.softest_tone,
    };
    SoundTable {
        damper: mechanism.instrument.sound.as_ref().map(damper),
        midi: mechanism.instrument.midi,
    }
}

/// The function from parameters to what follows from them alone, and how many numbers both are.
fn constants(
    graph: &Graph,
    functions: &mut FunctionList,
    parameters: usize,
) -> Result<(FunctionId, usize), AssemblyError> {
    let derived = functions.hoisting.constants.clone();
    let count = parameters + derived.len();
    if count >= usize::from(u16::MAX) {
        return Err(AssemblyError::TooManyFunctions(count));
    }
    Ok((functions.add_whole(graph, "constants", &derived)?, count))
}

struct Values {
    presets: Vec<PresetTable>,
    requirements: Vec<RequirementTable>,
    input_per_metre: FunctionId,
    rest: RestTable,
}

impl Values {
    fn of(
        graph: &mut Graph,
        functions: &mut FunctionList,
        mechanism: &Mechanism,
        state: &[Place],
    ) -> Result<Self, AssemblyError> {
        let mut presets = Vec::new();
        for preset in &mechanism.instrument.presets {
            let name = format!("preset_{}", preset.name);
            let values = functions.add_whole(graph, &name, &preset.values)?;
            let (name, doc) = (names::name(&preset.name), preset.doc.as_str().into());
            presets.push(PresetTable { name, doc, values });
        }
        let mut requirements = Vec::new();
        for (number, requirement) in mechanism.instrument.requirements.iter().enumerate() {
            let name = format!("requirement_{number}");
            let margin = functions.add_whole(graph, &name, &[requirement.margin])?;
            requirements.push(RequirementTable { text: requirement.text.as_str().into(), margin });
        }
        let one = graph.constant(1.0);
        let per_metre = mechanism.input.per_metre.unwrap_or(one);
        Ok(Self {
            presets,
            requirements,
            input_per_metre: functions.add_whole(graph, "input_per_metre", &[per_metre])?,
            rest: rest(graph, functions, mechanism, state)?,
        })
    }
}

/// The state to start from: coordinates and speeds as they are given, else 0.
fn rest(
    graph: &mut Graph,
    functions: &mut FunctionList,
    mechanism: &Mechanism,
    state: &[Place],
) -> Result<RestTable, AssemblyError> {
    let zero = graph.constant(0.0);
    let guess = |place: &Place| {
        let of = |given: &[Option<Node>], number: u16| given.get(usize::from(number)).copied();
        let given = match *place {
            Place::Coordinate(number) => of(&mechanism.rest.coordinates, number),
            Place::Speed(number) => of(&mechanism.rest.speeds, number),
            Place::Parameter(_)
            | Place::Acceleration(_)
            | Place::Input(_)
            | Place::Reaction(_)
            | Place::Contact(_)
            | Place::Friction(_)
            | Place::Extra(_)
            | Place::Key => None,
        };
        given.flatten().unwrap_or(zero)
    };
    let guess: Vec<_> = state.iter().map(guess).collect();
    let number = |mode: usize| u8::try_from(mode).unwrap_or(u8::MAX);
    let mut instead = Vec::new();
    for (when, mode) in &mechanism.rest.instead {
        instead.push((functions.add_whole(graph, "rest_when", &[*when])?, number(*mode)));
    }
    Ok(RestTable {
        mode: number(mechanism.rest.mode),
        instead,
        state: functions.add_whole(graph, "rest", &guess)?,
        is_improved: !mechanism.rest.is_start,
    })
}

fn named<'a>(all: impl Iterator<Item = (&'a String, &'a String)>) -> Vec<NamedQuantity> {
    all.map(|(name, unit)| NamedQuantity { name: names::name(name), unit: names::name(unit) })
        .collect()
}

fn quantity(mechanism: &Mechanism, place: Place) -> (&String, &String) {
    let found = if let Place::Coordinate(number) = place {
        mechanism.coordinates.get(usize::from(number)).map(|it| (&it.name, &it.unit))
    } else if let Place::Speed(number) = place {
        mechanism.speeds.get(usize::from(number)).map(|it| (&it.name, &it.unit))
    } else {
        None
    };
    found.unwrap_or((&mechanism.input.name, &mechanism.input.unit))
}

fn parameter(parameter: &crate::kane::mechanism::MechanismParameter) -> ParameterTable {
    ParameterTable {
        name: names::name(&parameter.name),
        title: parameter.title.as_str().into(),
        unit: names::name(&parameter.unit),
        range: parameter.range,
        doc: parameter.doc.as_str().into(),
        reading: parameter.reading,
    }
}

fn all_specs(modes: &[instruments::equations::table::ModeTable]) -> Vec<GuardSpec> {
    let mut all: Vec<GuardSpec> = Vec::new();
    for spec in modes.iter().flat_map(|mode| &mode.guard_specs) {
        match all.iter_mut().find(|it| it.id == spec.id) {
            // One that reads the input in one mode is taken again in all of them.
            Some(known) if spec.reads == pode::Reads::StateAndInput => known.reads = spec.reads,
            Some(_) => {}
            None => all.push(*spec),
        }
    }
    all
}
