//! The functions of a program, and their values by interpretation.

use std::collections::HashMap;

use instruments::MAX_CODED_CONTACTS;
use instruments::equations::table::{
    Arguments, EnclosureLayout, FunctionId, Functions, MechanicsLayout,
};

use super::AssemblyError;
use super::hoist::Hoisting;
use crate::kane::graph::{Graph, Node, Place};
use crate::kane::tape::{self, Argument, ArgumentLayout, Tape};

/// Functions by number, interpreted: for checks, and where no machine code can be made.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct TapeFunctions {
    tapes: Vec<Tape>,
}

impl TapeFunctions {
    pub fn tapes(&self) -> &[Tape] {
        &self.tapes
    }
}

/// Instructions of a function of most steps, and of the longest one of the shipped models.
const SHORT: usize = 256;
const LONG: usize = 8192;

#[inline(never)]
#[expect(
    clippy::large_stack_frames,
    clippy::large_stack_arrays,
    reason = "a lane's stack has room for 64 KiB, and its tick no heap"
)]
fn evaluate_long(tape: &Tape, arguments: &tape::TapeArguments<'_>, out: &mut [f64]) {
    tape.evaluate_into(arguments, &mut [0.0; LONG], out);
}

impl Functions for TapeFunctions {
    fn call(&self, function: FunctionId, arguments: &Arguments<'_>, out: &mut [f64]) {
        let Some(tape) = self.tapes.get(usize::from(function)) else { return };
        let arguments = tape::TapeArguments {
            constants: arguments.constants,
            state: arguments.state,
            input: *arguments.input,
            extra: arguments.extra,
        };
        // On the stack, since the tick may ask; what is longer than any shipped function is not.
        let length = tape.instructions.len();
        if length <= SHORT {
            tape.evaluate_into(&arguments, &mut [0.0; SHORT], out);
        } else if length <= LONG {
            evaluate_long(tape, &arguments, out);
        } else {
            tape.evaluate_into(&arguments, &mut vec![0.0; length], out);
        }
    }
}

#[derive(Debug)]
pub(super) struct FunctionList {
    layout: ArgumentLayout,
    parameters: usize,
    placed: usize,
    pub(super) hoisting: Hoisting,
    /// Functions by their outputs: a part that is the whole is one with it.
    lowered: HashMap<Vec<Node>, FunctionId>,
    pub(super) functions: TapeFunctions,
    pub(super) names: Vec<String>,
}

impl FunctionList {
    pub(super) fn new(parameters: usize, state: &[Place]) -> Self {
        let mut layout = ArgumentLayout::default();
        for (index, place) in (0..).zip(state) {
            layout.place(*place, Argument::State(index));
        }
        for rate in 0..4 {
            layout.place(Place::Input(rate), Argument::Input(rate));
        }
        for entry in 0..state.len() {
            for number in [EnclosureLayout::moves, EnclosureLayout::speed, EnclosureLayout::bend] {
                let number = u16::try_from(number(entry)).unwrap_or(u16::MAX);
                layout.place(Place::Extra(number), Argument::Extra(number));
            }
        }
        // Sides of contacts, the step and the start of the input have lower numbers.
        for number in (0..).take(MechanicsLayout::COUNT) {
            layout.place(Place::Extra(number), Argument::Extra(number));
        }
        layout.place(Place::Key, Argument::Extra(0));
        for contact in (0..).take(MAX_CODED_CONTACTS) {
            layout.place(Place::Friction(contact), Argument::Extra(contact));
        }
        Self {
            layout,
            parameters,
            placed: 0,
            hoisting: Hoisting::new(parameters),
            lowered: HashMap::new(),
            functions: TapeFunctions::default(),
            names: Vec::new(),
        }
    }

    /// Adds the function of `outputs`, with what the parameters alone give found before.
    pub(super) fn add(
        &mut self,
        graph: &mut Graph,
        name: &str,
        outputs: &[Node],
    ) -> Result<FunctionId, AssemblyError> {
        let outputs = self.hoisting.of(graph, outputs);
        self.add_whole(graph, name, &outputs)
    }

    pub(super) fn add_whole(
        &mut self,
        graph: &Graph,
        name: &str,
        outputs: &[Node],
    ) -> Result<FunctionId, AssemblyError> {
        if let Some(known) = self.lowered.get(outputs) {
            return Ok(*known);
        }
        for number in self.placed..self.parameters + self.hoisting.constants.len() {
            let number = u16::try_from(number).unwrap_or(u16::MAX);
            self.layout.place(Place::Parameter(number), Argument::Constant(number));
            self.placed += 1;
        }
        let tape = Tape::lower(graph, &self.layout, outputs);
        // What was given up may read anything.
        if let Some(end) = graph.given_up() {
            return Err(AssemblyError::GivenUp(end));
        }
        let tape = tape.map_err(|place| AssemblyError::UnknownSymbol(name.to_owned(), place))?;
        let number = self.add_tape(name, tape)?;
        self.lowered.insert(outputs.to_vec(), number);
        Ok(number)
    }

    fn add_tape(&mut self, name: &str, tape: Tape) -> Result<FunctionId, AssemblyError> {
        let tapes = &mut self.functions.tapes;
        let number = tapes.iter().position(|it| *it == tape).unwrap_or(tapes.len());
        if number == tapes.len() {
            tapes.push(tape);
            self.names.push(name.to_owned());
        }
        // The largest number is that of no function.
        let number = FunctionId::try_from(number).ok().filter(|it| *it < FunctionId::MAX);
        number.ok_or(AssemblyError::TooManyFunctions(self.functions.tapes.len()))
    }
}
