//! Changes that can be undone: of values and of instruments, in one order.

use telemetry::Difference;

use super::edit::{EditPatch, ParameterSlot};

const KEPT: usize = 200;

/// One change: by a drag, a typed value, a morph, another instrument.
#[derive(Clone, PartialEq, Debug)]
pub struct UndoStep {
    pub text: String,
    pub before: EditPatch,
    pub after: EditPatch,
    gesture: Option<u64>,
}

impl UndoStep {
    fn is_of(&self, gesture: Option<u64>) -> bool {
        gesture.is_some() && self.gesture == gesture
    }
}

/// Steps done and steps taken back.
#[derive(Clone, Debug, Default)]
pub struct UndoHistory {
    done: Vec<UndoStep>,
    undone: Vec<UndoStep>,
}

impl UndoHistory {
    /// Enters a step, or merges it into the last one of the same gesture.
    pub fn enter(&mut self, text: &str, before: EditPatch, after: EditPatch, gesture: Option<u64>) {
        self.undone.clear();
        if let Some(last) = self.done.last_mut().filter(|last| last.is_of(gesture)) {
            for (slot, difference) in before.slots {
                last.before.slots.entry(slot).or_insert(difference);
            }
            last.after.slots.extend(after.slots);
            return;
        }
        self.done.push(UndoStep { text: text.to_owned(), before, after, gesture });
        if KEPT < self.done.len() {
            self.done.remove(0);
        }
    }

    /// Returns the difference of `slot` before `gesture`, if that has changed it.
    pub fn origin(&self, slot: &ParameterSlot, gesture: Option<u64>) -> Option<Option<Difference>> {
        let last = self.done.last().filter(|last| last.is_of(gesture))?;
        last.before.slots.get(slot).copied()
    }

    /// Undoes the last step; returns the patch that restores the state before.
    pub fn undo(&mut self) -> Option<EditPatch> {
        let step = self.done.pop()?;
        let patch = step.before.clone();
        self.undone.push(step);
        Some(patch)
    }

    /// Redoes the latest undone step; returns its patch.
    pub fn redo(&mut self) -> Option<EditPatch> {
        let step = self.undone.pop()?;
        let patch = step.after.clone();
        self.done.push(step);
        Some(patch)
    }

    pub fn last(&self) -> Option<&UndoStep> {
        self.done.last()
    }

    pub fn next(&self) -> Option<&UndoStep> {
        self.undone.last()
    }

    pub fn steps(&self) -> &[UndoStep] {
        &self.done
    }

    /// Returns the undone steps, that of the next [`Self::redo`] first.
    pub fn undone(&self) -> impl Iterator<Item = &UndoStep> {
        self.undone.iter().rev()
    }

    /// Removes rejected values and instruments from all steps.
    pub fn forget(&mut self, slots: &[ParameterSlot], switched: &[u8]) {
        let is_kept = |key: u8| !switched.contains(&key);
        for step in &mut self.done {
            for patch in [&mut step.before, &mut step.after] {
                patch.slots.retain(|slot, _| !slots.contains(slot) && is_kept(slot.key));
                patch.instruments.retain(|key, _| is_kept(*key));
            }
        }
        self.done.retain(|step| !step.after.is_empty() || !step.before.is_empty());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn patch(value: f64) -> EditPatch {
        let slots = [(ParameterSlot::new(39, "k2"), Some(Difference::Value(value)))].into();
        EditPatch { slots, ..EditPatch::default() }
    }

    #[test]
    fn steps_go_back_and_forth() {
        let mut history = UndoHistory::default();
        history.enter("first", patch(1.0), patch(2.0), None);
        history.enter("second", patch(2.0), patch(3.0), None);
        assert_eq!(history.undo(), Some(patch(2.0)));
        assert_eq!(history.undo(), Some(patch(1.0)));
        assert_eq!(history.undo(), None);
        assert_eq!(history.redo(), Some(patch(2.0)));
        assert_eq!(history.next().map(|step| step.text.as_str()), Some("second"));
        history.enter("third", patch(2.0), patch(9.0), None);
        assert_eq!(history.redo(), None);
        assert_eq!(history.last().map(|step| step.text.as_str()), Some("third"));
    }

    #[test]
    fn memory_is_bounded() {
        let mut history = UndoHistory::default();
        for _ in 0..2 * KEPT {
            history.enter("step", patch(0.0), patch(1.0), None);
        }
        assert_eq!(history.steps().len(), KEPT);
    }
}
