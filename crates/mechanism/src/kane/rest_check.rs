//! Checks that a mechanism rests in the state of its description.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use documents::Diagnostic;
use instruments::equations::table::{Arguments, Equations, FunctionId, Functions, ModelTable};
use instruments::equations::{EquationModel, ModeNumber};

use crate::kane::assemble::Program;
use crate::kane::graph::{MAX_WORK, Place, WorkEnd};
use crate::kane::mechanism::Mechanism;

/// Keys at the ends of the compass, on which presets are checked.
const KEYS: [u8; 2] = [0, 87];

/// Instructions evaluated in the time of one operand of a graph.
const INSTRUCTIONS: u64 = 16;

/// Functions with an evaluation that stops at a limit of work or on cancellation.
struct LimitedFunctions<'a> {
    program: &'a Program,
    done: AtomicU64,
    most: u64,
    is_cancelled: &'a AtomicBool,
}

impl LimitedFunctions<'_> {
    fn end(&self) -> Option<WorkEnd> {
        if self.done.load(Ordering::Relaxed) > self.most {
            Some(WorkEnd::TooMuch)
        } else {
            self.is_cancelled.load(Ordering::Relaxed).then_some(WorkEnd::Cancelled)
        }
    }
}

impl Functions for LimitedFunctions<'_> {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        let tape = self.program.tapes().get(usize::from(function));
        let instructions = tape.map_or(0, |tape| tape.instructions.len() as u64);
        self.done.fetch_add(instructions, Ordering::Relaxed);
        if self.end().is_some() {
            // A descent on NaN ends within a few steps.
            out.fill(f64::NAN);
        } else {
            self.program.call(function, arguments, out);
        }
    }
}

impl Equations for LimitedFunctions<'_> {
    fn table(&self) -> &ModelTable {
        &self.program.table
    }
}

struct RestingFault {
    mode: ModeNumber,
    entry: usize,
    kind: FaultKind,
}

enum FaultKind {
    /// The entry changes at this rate (its unit / s).
    Moves(f64),
    /// The entry rests here, out of its range.
    OutOfRange(f64),
}

/// Returns a mistake of `[rest]` for the first preset and key on which the mechanism does not rest,
/// or for too many to check; `None` without `[rest]`, or if it states a start instead of a rest.
pub(crate) fn check(
    mechanism: &Mechanism,
    program: &Program,
    state: &[Place],
    is_cancelled: &AtomicBool,
) -> Option<Diagnostic> {
    let (file, line, column) = mechanism.rest.place.clone()?;
    if mechanism.rest.is_start {
        return None;
    }
    let functions = LimitedFunctions {
        program,
        done: AtomicU64::new(0),
        most: INSTRUCTIONS * MAX_WORK.saturating_sub(program.work),
        is_cancelled,
    };
    let ranges: Vec<_> = state.iter().map_while(|place| range(mechanism, *place)).collect();
    let presets = 0..program.table.presets.len();
    let cases = presets.flat_map(|preset| KEYS.map(|key| (preset, key)));
    let mut looked = cases.map_while(|case| {
        let fault = fault(&functions, &ranges, case);
        functions.end().is_none().then_some((case, fault))
    });
    let found = looked.find_map(|(case, fault)| Some(said(&program.table, &fault?, case)));
    let given_up = || Some((functions.end()?.to_string(), "describe a smaller model".to_owned()));
    let (message, help) = found.or_else(given_up)?;
    Some(Diagnostic { file, line: Some(line), column: Some(column), message, help })
}

fn range(mechanism: &Mechanism, place: Place) -> Option<(f64, f64)> {
    let Place::Coordinate(number) = place else { return None };
    mechanism.coordinates.get(usize::from(number)).map(|it| it.range)
}

/// Returns the entry that does not rest; `None` for a model that is too large to check.
fn fault(
    functions: &LimitedFunctions<'_>,
    ranges: &[(f64, f64)],
    case: (usize, u8),
) -> Option<RestingFault> {
    if case.1 > 0 && !is_graded(functions, case.0) {
        return None;
    }
    let table = functions.table();
    match (table.states.len(), table.constants.count) {
        (..=16, ..=384) => fault_of::<16, 384>(functions, ranges, case),
        _ => fault_of::<32, 2048>(functions, ranges, case),
    }
}

fn fault_of<const N: usize, const C: usize>(
    functions: &LimitedFunctions<'_>,
    ranges: &[(f64, f64)],
    case: (usize, u8),
) -> Option<RestingFault> {
    let pose =
        EquationModel::<&LimitedFunctions<'_>, N, C>::rest_of_preset(functions, case).ok()?;
    let of = |entry, kind| RestingFault { mode: pose.mode, entry, kind };
    if let Some((entry, rate)) = pose.imbalance {
        return Some(of(entry, FaultKind::Moves(rate)));
    }
    let mut places = pose.state.iter().zip(ranges).enumerate();
    places.find_map(|(entry, (value, (low, high)))| {
        let is_inside = low <= value && value <= high;
        (!is_inside).then(|| of(entry, FaultKind::OutOfRange(*value)))
    })
}

fn is_graded(functions: &LimitedFunctions<'_>, preset: usize) -> bool {
    let table = functions.table();
    let values = |key: u8| {
        let mut values = vec![0.0; table.parameters.len()];
        let arguments =
            Arguments { constants: &[], state: &[], input: &[0.0; 4], extra: &[f64::from(key)] };
        if let Some(preset) = table.presets.get(preset) {
            functions.call(preset.values, &arguments, &mut values);
        }
        values
    };
    let [first, last] = KEYS.map(values);
    first != last
}

fn said(table: &ModelTable, fault: &RestingFault, (preset, key): (usize, u8)) -> (String, String) {
    let preset = table.presets.get(preset).map_or("", |preset| preset.name);
    let mode = table.modes.get(usize::from(fault.mode.0)).map_or("", |mode| mode.name);
    let (name, unit) = table.states.get(fault.entry).map_or(("", ""), |it| (it.name, it.unit));
    let case = format!("mode \"{mode}\", preset \"{preset}\", key {key}");
    match fault.kind {
        FaultKind::Moves(rate) => (
            format!(
                "nothing holds {name} at rest: it changes by {rate:.3} {unit} per second ({case})"
            ),
            "give what holds it a spring or a contact, or a pose nearer to the equilibrium; if it \
             starts there and moves, write start = true"
                .to_owned(),
        ),
        FaultKind::OutOfRange(value) => (
            format!("it rests at {name} = {value:.4} {unit}, out of its range ({case})"),
            "hold it where it should rest, give a pose nearer to that, or widen the range"
                .to_owned(),
        ),
    }
}
