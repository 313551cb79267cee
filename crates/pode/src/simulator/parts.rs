//! A step of a mode, part by part: entries that move by no equations take no step.

use super::field::{ModeField, TOGETHER};
use crate::dense::Dense;
use crate::input::Signal;
use crate::model::{Guarded, Model};
use crate::outcome::Work;
use crate::part::{MAX_PARTS, Part};
use crate::state::State;
use crate::stepper::{Memory, Step, Stepper};

pub(super) type Memories<M, T> =
    [PartMemory<<T as Stepper>::Memory<<M as Model>::State>, DenseOf<M, T>>; MAX_PARTS];

type DenseOf<M, T> = <T as Stepper>::Dense<<M as Model>::State>;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct PartMemory<M, D> {
    method: M,
    /// A step of the part that is longer than the mode's, with its unused rest.
    ahead: Option<Ahead<D>>,
    /// `true` if the method's dense output cannot be cut, so no step can be ahead.
    is_uncut: bool,
}

#[derive(Clone, Copy, PartialEq, Debug)]
struct Ahead<D> {
    dense: D,
    /// Its length (s).
    length: f64,
    /// Length that the other parts have followed (s).
    passed: f64,
}

impl<D> Ahead<D> {
    /// Returns its dense output over the next `h` (s), if it is long enough.
    fn next<S>(&mut self, h: f64) -> Option<D>
    where
        D: Dense<S>,
    {
        const ROUNDING: f64 = 1e-9;
        let (from, to) = (self.passed / self.length, (self.passed + h) / self.length);
        self.passed += h;
        if to > 1.0 + ROUNDING { None } else { self.dense.within(from, to.min(1.0)) }
    }
}

impl<M: Default, D> Default for PartMemory<M, D> {
    fn default() -> Self {
        Self { method: M::default(), ahead: None, is_uncut: false }
    }
}

impl<M: Memory, D> PartMemory<M, D> {
    pub(super) fn restart(&mut self) {
        self.method.restart();
        self.ahead = None;
    }

    pub(super) fn begin_tick(&mut self) {
        self.method.begin_tick();
    }

    pub(super) fn jump(&mut self) {
        self.method.jump();
    }

    fn refuse(&mut self) {
        self.method.refuse();
        self.ahead = None;
    }

    #[inline]
    pub(super) fn sets_steps(&self) -> bool {
        self.method.sets_steps()
    }

    /// Returns the longest step (s) worth trying next.
    #[inline]
    pub(super) fn reach(&self, stretch: f64) -> f64 {
        self.method.reach(stretch)
    }
}

pub(super) struct ModeStep<'a, M: Model, T: Stepper, S> {
    pub(super) model: &'a M,
    pub(super) stepper: &'a T,
    pub(super) mode: M::Mode,
    pub(super) signal: &'a S,
    pub(super) theta: (f64, f64),
    pub(super) input: M::Input,
    /// How many times faster the motion is than the mode's rate.
    pub(super) excess: f64,
    /// Length of the step, and of the rest of the tick from its begin (s).
    pub(super) h: f64,
    pub(super) rest: f64,
    /// Longest step of a part (s).
    pub(super) longest: f64,
}

type Taken<M, T> = Step<<M as Model>::State, DenseOf<M, T>>;

/// Merges the step of several parts with that of one more.
#[inline]
fn together<S: State, D: Dense<S>>(
    whole: &Step<S, D>,
    step: &Step<S, D>,
    part: &Part,
) -> Step<S, D> {
    Step {
        dense: whole.dense.merged(&step.dense, part),
        powers: whole.powers,
        error: whole.error.with_entries(&step.error, part),
        is_accepted: whole.is_accepted && step.is_accepted,
    }
}

impl<M: Guarded, T: Stepper, S: Signal<M::Input>> ModeStep<'_, M, T, S> {
    fn field(&self, (index, part): (usize, Part), end: f64) -> ModeField<'_, M, S> {
        let theta = (self.theta.0, end);
        let mode = (self.mode, index, part);
        ModeField::new(self.model, mode, self.signal, theta, self.input, self.excess)
    }

    /// Returns the mode's only part, or several as one; `None` if stepped apart or nothing moves.
    #[inline]
    fn whole(&self) -> Option<Part> {
        let length = M::State::ZERO.entries().len();
        match self.model.parts(self.mode) {
            [] => None,
            [only] => Some(*only),
            _ if self.stepper.steps_apart(length) && !self.is_mechanical() => None,
            several => Some(Part::union(several, length)),
        }
    }

    fn is_mechanical(&self) -> bool {
        let form = self.model.mechanical().filter(|_| self.stepper.is_mechanical());
        form.is_some_and(|it| it.suits(self.mode))
    }

    /// Steps all parts from `x0`, counts their evaluations, and also returns the input at the end.
    #[expect(clippy::inline_always, reason = "a call takes the step through memory")]
    #[inline(always)]
    pub(super) fn take(
        &self,
        x0: &M::State,
        memories: &mut Memories<M, T>,
        work: &mut Work,
    ) -> (Taken<M, T>, M::Input) {
        let Some(whole) = self.whole() else { return self.take_apart(x0, memories, work) };
        let mut field = self.field((TOGETHER, whole), self.theta.1);
        let [memory, ..] = memories;
        let step = self.stepper.step(&mut field, x0, &mut memory.method, self.h);
        field.count(work);
        (step, field.end_input())
    }

    /// Steps the parts one after another; a step refused by one of them is refused by all.
    fn take_apart(
        &self,
        x0: &M::State,
        memories: &mut Memories<M, T>,
        work: &mut Work,
    ) -> (Taken<M, T>, M::Input) {
        let mut end = None;
        let parts = self.model.parts(self.mode);
        let mut whole: Option<Taken<M, T>> = None;
        for (index, (part, memory)) in parts.iter().zip(memories.iter_mut()).enumerate() {
            let mut field = self.field((index, *part), self.theta.1);
            let step = self.take_part((index, *part), x0, memory, &mut field, work);
            field.count(work);
            end = end.or_else(|| field.known_end_input());
            whole = Some(whole.map_or(step, |whole| together(&whole, &step, part)));
        }
        let whole = whole.unwrap_or_else(|| Step::new(T::Dense::still(x0)));
        if !whole.is_accepted {
            memories.iter_mut().take(parts.len()).for_each(PartMemory::refuse);
        }
        (whole, end.unwrap_or_else(|| self.signal.at(self.theta.1)))
    }

    /// Steps one of several parts by the step ahead, or by a new one of the mode's length or more.
    fn take_part(
        &self,
        (index, part): (usize, Part),
        x0: &M::State,
        memory: &mut PartMemory<T::Memory<M::State>, DenseOf<M, T>>,
        field: &mut ModeField<'_, M, S>,
        work: &mut Work,
    ) -> Taken<M, T> {
        let known = memory.ahead.as_mut().map(|ahead| ahead.next(self.h));
        if let Some(Some(dense)) = known {
            return Step::new(dense);
        }
        if known.is_some() {
            // The rest of it is shorter than the step: it belongs to another grid.
            memory.restart();
        }
        let length = part.own_step(self.h, self.rest, self.longest);
        if length > self.h && memory.reach(1.0).is_infinite() && !memory.is_uncut {
            let theta = self.theta.0 + length / self.h * (self.theta.1 - self.theta.0);
            let mut own = self.field((index, part), theta);
            let step = self.stepper.step(&mut own, x0, &mut memory.method, length);
            own.count(work);
            let mut ahead = Ahead { dense: step.dense, length, passed: 0.0 };
            if let Some(dense) = ahead.next(self.h) {
                memory.ahead = Some(ahead);
                return Step { dense, ..step };
            }
            memory.restart();
            memory.is_uncut = true;
        }
        self.stepper.step(field, x0, &mut memory.method, self.h)
    }

    #[inline]
    pub(super) fn refine(
        &self,
        memories: &Memories<M, T>,
        dense: &mut T::Dense<M::State>,
        work: &mut Work,
    ) {
        if let Some(whole) = self.whole() {
            let mut field = self.field((TOGETHER, whole), self.theta.1);
            let [memory, ..] = memories;
            self.stepper.refine(&mut field, &memory.method, dense, self.h);
            return field.count(work);
        }
        for (index, (part, memory)) in self.model.parts(self.mode).iter().zip(memories).enumerate()
        {
            let mut field = self.field((index, *part), self.theta.1);
            let mut refined = *dense;
            self.stepper.refine(&mut field, &memory.method, &mut refined, self.h);
            field.count(work);
            *dense = dense.merged(&refined, part);
        }
    }
}
