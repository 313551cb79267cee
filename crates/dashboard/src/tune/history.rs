//! Changes that can be undone.

use super::snapshot::{ParameterSlot, SlotValues};

const KEPT: usize = 200;

/// One change: by a drag, a typed value, a morph.
#[derive(Clone, PartialEq, Debug)]
pub struct UndoStep {
    /// Description of the change in a few words.
    pub text: String,
    pub before: SlotValues,
    pub after: SlotValues,
    /// Steps of the same drag are one.
    gesture: Option<u64>,
}

/// Steps done and steps taken back.
#[derive(Clone, Debug, Default)]
pub struct UndoHistory {
    done: Vec<UndoStep>,
    undone: Vec<UndoStep>,
}

impl UndoHistory {
    /// Enters a step, or merges it into the last one of the same gesture.
    pub fn enter(
        &mut self,
        text: &str,
        before: SlotValues,
        after: SlotValues,
        gesture: Option<u64>,
    ) {
        self.undone.clear();
        if let Some(last) = self.done.last_mut()
            && gesture.is_some()
            && last.gesture == gesture
        {
            for (slot, value) in before {
                last.before.entry(slot).or_insert(value);
            }
            last.after.extend(after);
            return;
        }
        self.done.push(UndoStep { text: text.to_owned(), before, after, gesture });
        if KEPT < self.done.len() {
            self.done.remove(0);
        }
    }

    /// Undoes the last step; returns the values to restore.
    pub fn undo(&mut self) -> Option<SlotValues> {
        let step = self.done.pop()?;
        let values = step.before.clone();
        self.undone.push(step);
        Some(values)
    }

    /// Redoes the latest undone step; returns its values.
    pub fn redo(&mut self) -> Option<SlotValues> {
        let step = self.undone.pop()?;
        let values = step.after.clone();
        self.done.push(step);
        Some(values)
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

    /// Removes rejected values from all steps.
    pub fn forget(&mut self, slots: &[ParameterSlot]) {
        for step in &mut self.done {
            step.before.retain(|slot, _| !slots.contains(slot));
            step.after.retain(|slot, _| !slots.contains(slot));
        }
        self.done.retain(|step| !step.after.is_empty());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(value: f64) -> SlotValues {
        [(ParameterSlot::new(39, "k2"), value)].into()
    }

    #[test]
    fn steps_go_back_and_forth() {
        let mut history = UndoHistory::default();
        history.enter("first", value(1.0), value(2.0), None);
        history.enter("second", value(2.0), value(3.0), None);
        assert_eq!(history.undo(), Some(value(2.0)));
        assert_eq!(history.undo(), Some(value(1.0)));
        assert_eq!(history.undo(), None);
        assert_eq!(history.redo(), Some(value(2.0)));
        assert_eq!(history.next().map(|step| step.text.as_str()), Some("second"));
        history.enter("third", value(2.0), value(9.0), None);
        assert_eq!(history.redo(), None);
        assert_eq!(history.last().map(|step| step.text.as_str()), Some("third"));
    }

    #[test]
    fn memory_is_bounded() {
        let mut history = UndoHistory::default();
        for _ in 0..2 * KEPT {
            history.enter("step", value(0.0), value(1.0), None);
        }
        assert_eq!(history.steps().len(), KEPT);
    }
}
