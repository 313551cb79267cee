use super::{Argument, Instruction, Tape, TapeSlot};

/// Arguments of a tape, by kind.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct TapeArguments<'a> {
    pub constants: &'a [f64],
    pub state: &'a [f64],
    pub input: [f64; 4],
    pub extra: &'a [f64],
}

impl TapeArguments<'_> {
    /// Returns the value of `argument`; NaN if it is missing.
    fn value(&self, argument: Argument) -> f64 {
        let of = |list: &[f64], index: usize| list.get(index).copied().unwrap_or(f64::NAN);
        match argument {
            Argument::Constant(index) => of(self.constants, index.into()),
            Argument::State(index) => of(self.state, index.into()),
            Argument::Input(index) => of(&self.input, index.into()),
            Argument::Extra(index) => of(self.extra, index.into()),
        }
    }
}

fn chosen(condition: f64, positive: TapeSlot, other: TapeSlot) -> TapeSlot {
    if condition > 0.0 { positive } else { other }
}

impl Tape {
    pub fn evaluate(&self, arguments: &TapeArguments<'_>) -> Vec<f64> {
        let mut values = vec![0.0; self.instructions.len()];
        let mut out = vec![0.0; self.outputs.len()];
        self.evaluate_into(arguments, &mut values, &mut out);
        out
    }

    /// Writes the outputs' values to `out`; `values` has room for one value per instruction.
    ///
    /// # Real-time
    /// Bounded: one operation per instruction, no heap.
    pub fn evaluate_into(
        &self,
        arguments: &TapeArguments<'_>,
        values: &mut [f64],
        out: &mut [f64],
    ) {
        for (at, instruction) in self.instructions.iter().enumerate() {
            let of = |slot: TapeSlot| -> f64 { values[slot.index()] };
            values[at] = match *instruction {
                Instruction::Number(number) => number,
                Instruction::Argument(argument) => arguments.value(argument),
                Instruction::Add(x, y) => of(x) + of(y),
                Instruction::Subtract(x, y) => of(x) - of(y),
                Instruction::Multiply(x, y) => of(x) * of(y),
                Instruction::Divide(x, y) => of(x) / of(y),
                Instruction::Negate(x) => -of(x),
                Instruction::Unary(function, x) => function.of(of(x)),
                Instruction::Binary(function, x, y) => function.of(of(x), of(y)),
                Instruction::Select(condition, positive, other) => {
                    of(chosen(of(condition), positive, other))
                }
            };
        }
        for (value, slot) in out.iter_mut().zip(&self.outputs) {
            *value = values[slot.index()];
        }
    }
}
