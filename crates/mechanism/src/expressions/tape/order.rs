use super::forms::{FormId, Forms, TapeForm};
use crate::expressions::graph::UnaryFunction;

/// Returns the forms that the outputs need in writing order, operands first.
///
/// Angles precede everything else, so that the sines and cosines of two are computed together; the
/// rest follows output by output, so that few values wait at a time.
pub(super) fn of(forms: &Forms) -> Vec<FormId> {
    let mut order = Order { forms, is_written: vec![false; forms.all.len()], all: Vec::new() };
    order.write(&forms.outputs);
    let reached = core::mem::take(&mut order.all);
    order.is_written.fill(false);
    order.write(&angles(forms, &reached));
    order.write(&forms.outputs);
    order.all
}

/// Returns the angles, those within the fewest sines first.
fn angles(forms: &Forms, reached: &[FormId]) -> Vec<FormId> {
    let mut levels = vec![0_u32; forms.all.len()];
    let mut angles = Vec::new();
    for id in reached {
        let form = &forms.all[*id];
        let mut level = 0;
        form.operands(|operand| level = level.max(levels[operand]));
        if let TapeForm::Unary(UnaryFunction::Sin | UnaryFunction::Cos, angle) = form {
            angles.push((level, *angle));
            level += 1;
        }
        levels[*id] = level;
    }
    angles.sort_unstable();
    angles.dedup();
    angles.into_iter().map(|(_, angle)| angle).collect()
}

struct Order<'a> {
    forms: &'a Forms,
    is_written: Vec<bool>,
    all: Vec<FormId>,
}

impl Order<'_> {
    /// Writes each of `wanted` after its operands, without recursion.
    fn write(&mut self, wanted: &[FormId]) {
        for first in wanted {
            let mut waiting = vec![(*first, false)];
            while let Some(next) = waiting.pop() {
                self.one(next, &mut waiting);
            }
        }
    }

    fn one(&mut self, (id, are_written): (FormId, bool), waiting: &mut Vec<(FormId, bool)>) {
        if self.is_written[id] {
            return;
        }
        if are_written {
            self.is_written[id] = true;
            self.all.push(id);
            return;
        }
        waiting.push((id, true));
        let from = waiting.len();
        self.forms.all[id].operands(|operand| waiting.push((operand, false)));
        waiting[from..].reverse();
    }
}
