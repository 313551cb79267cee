//! A step of a mode, part by part: what moves by no equations takes no step at all.

use super::field::ModeField;
use crate::dense::Dense;
use crate::input::Signal;
use crate::model::Model;
use crate::outcome::Work;
use crate::part::{MAX_PARTS, Part};
use crate::state::State;
use crate::stepper::{Memory, Step, Stepper};

/// What a method carries from one step to the next, for each part of the mode.
pub(super) type Memories<M, T> = [<T as Stepper>::Memory<<M as Model>::State>; MAX_PARTS];

/// A step of one mode over a part of the tick.
pub(super) struct ModeStep<'a, M: Model, T: Stepper, S> {
    pub(super) model: &'a M,
    pub(super) stepper: &'a T,
    pub(super) mode: M::Mode,
    pub(super) signal: &'a S,
    /// Where the step begins in the tick, and which part of the tick it is.
    pub(super) span: (f64, f64),
    /// Length of the step (s).
    pub(super) h: f64,
}

/// The step that a method takes of a model.
type Taken<M, T> = Step<<M as Model>::State, <T as Stepper>::Dense<<M as Model>::State>>;

/// The step of several parts with that of one more.
#[inline]
fn together<S: State, D: Dense<S>>(
    whole: &Step<S, D>,
    step: &Step<S, D>,
    part: &Part,
) -> Step<S, D> {
    Step {
        dense: whole.dense.merged(&step.dense, part),
        error: whole.error.with_entries(&step.error, part),
        is_accepted: whole.is_accepted && step.is_accepted,
    }
}

impl<M: Model, T: Stepper, S: Signal<M::Input>> ModeStep<'_, M, T, S> {
    fn field(&self, index: usize, part: Part) -> ModeField<'_, M, S> {
        ModeField::new(self.model, (self.mode, index, part), self.signal, self.span)
    }

    /// Steps all parts from `x0`, one after another, and counts their evaluations; a step that one
    /// of them refuses is refused by all.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    pub(super) fn take(
        &self,
        x0: &M::State,
        memories: &mut Memories<M, T>,
        work: &mut Work,
    ) -> Taken<M, T> {
        let parts = self.model.parts(self.mode);
        let mut whole: Option<Taken<M, T>> = None;
        for (index, (part, memory)) in parts.iter().zip(memories.iter_mut()).enumerate() {
            let mut field = self.field(index, *part);
            let step = self.stepper.step(&mut field, x0, memory, self.h);
            field.count(work);
            whole = Some(whole.map_or(step, |whole| together(&whole, &step, part)));
        }
        let whole = whole.unwrap_or_else(|| Step::new(T::Dense::still(x0)));
        if !whole.is_accepted && parts.len() > 1 {
            memories.iter_mut().take(parts.len()).for_each(Memory::refuse);
        }
        whole
    }

    /// Brings the dense output of the step just taken to its full order.
    #[inline]
    pub(super) fn refine(
        &self,
        memories: &Memories<M, T>,
        dense: &mut T::Dense<M::State>,
        work: &mut Work,
    ) {
        for (index, (part, memory)) in self.model.parts(self.mode).iter().zip(memories).enumerate()
        {
            let mut field = self.field(index, *part);
            let mut refined = *dense;
            self.stepper.refine(&mut field, memory, &mut refined, self.h);
            field.count(work);
            *dense = dense.merged(&refined, part);
        }
    }
}
