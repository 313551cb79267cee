use super::forms::{FormId, Forms, TapeForm};
use super::order;
use super::{ArgumentLayout, Instruction, Tape, TapeSlot, writer::TapeWriter};
use crate::expressions::graph::{Graph, Node, Place};

impl Tape {
    /// Returns the program of `outputs`.
    ///
    /// Common factors are taken out of sums, shared parts are computed once, shared divisors
    /// inverted once; long sums and products start with what is ready first.
    ///
    /// # Errors
    /// A symbol without an argument in `layout`.
    pub fn lower(graph: &Graph, layout: &ArgumentLayout, outputs: &[Node]) -> Result<Self, Place> {
        let mut forms = Forms::new(graph, layout, outputs)?;
        forms.use_ready(graph, layout);
        graph.spend(forms.all.len());
        forms.factor_sums(graph);
        forms.share_inverses();
        forms.share_products(graph);
        forms.share_sums(graph);
        let mut lowering =
            Lowering { writer: TapeWriter::default(), slots: vec![None; forms.all.len()] };
        for id in order::of(&forms) {
            let slot = lowering.form(&forms.all[id]);
            lowering.slots[id] = Some(slot);
        }
        let outputs = forms.outputs.iter().map(|id| lowering.slot(*id)).collect();
        Ok(Self { instructions: lowering.writer.finish(), outputs })
    }
}

struct Lowering {
    writer: TapeWriter,
    slots: Vec<Option<TapeSlot>>,
}

impl Lowering {
    fn slot(&self, id: FormId) -> TapeSlot {
        self.slots[id].unwrap_or_default()
    }

    fn form(&mut self, form: &TapeForm) -> TapeSlot {
        match form {
            TapeForm::Number(value) => self.writer.number(*value),
            TapeForm::Argument(argument) => self.writer.push(Instruction::Argument(*argument)),
            TapeForm::Sum(number, terms) => {
                let terms: Vec<_> = terms.iter().map(|(it, by)| (self.slot(*it), *by)).collect();
                self.writer.sum(*number, &terms)
            }
            TapeForm::Product(factors) => {
                let factors: Vec<_> =
                    factors.iter().map(|(it, by)| (self.slot(*it), *by)).collect();
                self.writer.product(&factors)
            }
            TapeForm::Inverse(x) => {
                let x = self.slot(*x);
                let one = self.writer.number(1.0);
                self.writer.push(Instruction::Divide(one, x))
            }
            TapeForm::Unary(function, x) => {
                let x = self.slot(*x);
                self.writer.push(Instruction::Unary(*function, x))
            }
            TapeForm::Binary(function, x, y) => {
                let (x, y) = (self.slot(*x), self.slot(*y));
                self.writer.push(Instruction::Binary(*function, x, y))
            }
            TapeForm::Select(all) => {
                let [condition, positive, other] = all.map(|it| self.slot(it));
                self.writer.push(Instruction::Select(condition, positive, other))
            }
        }
    }
}
