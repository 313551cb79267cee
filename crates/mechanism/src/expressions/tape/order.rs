//! The order in which forms are written.

use super::forms::{FormId, Forms, TapeForm};
use crate::expressions::graph::UnaryFunction;

/// Returns the forms that the outputs need, operands first.
///
/// Angles come before all else, so that the sines and cosines of two can be computed together;
/// the rest output by output, so that few values wait at a time.
pub(super) fn of(forms: &Forms) -> Vec<FormId> {
    let mut order = Order { forms, is_written: vec![false; forms.all.len()], all: Vec::new() };
    // Before all else means after what the outputs reach is known.
    order.write(&forms.outputs);
    let reached = core::mem::take(&mut order.all);
    order.is_written.fill(false);
    order.write(&angles(forms, &reached));
    order.write(&forms.outputs);
    order.all
}

/// The angles, those first that are within the fewest sines.
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
    /// Writes each of `wanted` after its operands, without going down the stack.
    fn write(&mut self, wanted: &[FormId]) {
        for first in wanted {
            let mut waiting = vec![(*first, false)];
            while let Some(next) = waiting.pop() {
                self.one(next, &mut waiting);
            }
        }
    }

    /// Writes a form whose operands are written, or lets it wait for them.
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
