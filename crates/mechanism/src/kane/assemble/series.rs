//! The Taylor series of a mode, from the tape of its derivative and guards.

use instruments::equations::table::SeriesTable;
use pode::series::MOST_GUARDS;

use super::AssemblyError;
use super::builder::ModeBuilder;
use super::functions::FunctionList;
use crate::kane::graph::{Graph, Node};
use crate::kane::taylor::Recursion;

/// Most instructions of an expanded mode: the detection of too many sums takes quadratic time.
const LONGEST: usize = 2048;

/// The series of a mode; none where nothing moves by equations, or contacts act, whose forces are no
/// part of the equations, and none of a mode that is too large for a step's arrays.
pub(super) fn series(
    graph: &mut Graph,
    functions: &mut FunctionList,
    builder: &ModeBuilder<'_>,
) -> Result<Option<SeriesTable>, AssemblyError> {
    if builder.state.free().next().is_none() || !builder.equations.contacts.is_empty() {
        return Ok(None);
    }
    let state = &builder.state;
    let states = state.state.len();
    let rates: Vec<_> = state.free().map(|index| builder.equations.derivative[index]).collect();
    let is_slaved = |index: &usize| !state.is_free(*index);
    let slaved: Vec<_> = (0..states).filter(is_slaved).map(|index| state.slaved[index]).collect();
    let guards: Vec<Node> = builder.equations.guards.iter().map(|guard| guard.value).collect();
    let guards = guards.get(..MOST_GUARDS).unwrap_or(&guards);
    let outputs = state.replaced(graph, &[rates.as_slice(), &slaved, guards].concat());
    // Sharing halves a program at best.
    if graph.reached(&outputs).len() > 2 * LONGEST {
        return Ok(None);
    }
    let name = format!("{}_series", builder.name);
    let tape = functions.tape(graph, &name, &outputs)?;
    if tape.instructions.len() > LONGEST {
        return Ok(None);
    }
    let tapes = Recursion::new(&tape, rates.len()).tapes();
    let mut table = SeriesTable {
        start: 0,
        step: 0,
        entries: state.free().fold(0, |entries, index| entries | 1 << index),
        guards: guards.len(),
        conditions: tapes.conditions,
        lanes: tapes.lanes,
        carried: tapes.carried,
    };
    if !table.fits(states) {
        return Ok(None);
    }
    table.start = functions.add_tape(&format!("{name}_start"), tapes.start)?;
    table.step = functions.add_tape(&format!("{name}_step"), tapes.step)?;
    Ok(Some(table))
}
