//! Steps in the mechanical form of a table's modes.

use pode::contacts::{ContactIndices, ContactMode, ContactSet};
use pode::{Cubic, MAX_SPEEDS, Mechanical, MechanicalEnd, MechanicalStep, Motion, PressedContact};

use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::table::{Equations, MechanicsLayout as Layout, MechanicsTable};

/// Step (s) from which on RK4 takes a tick in one: it is more accurate then, and as quick.
const SLOW: f64 = 1e-3;

/// Maximum number of values of a contact: those that it adds, and its stiffness row.
const MAX_ADDED: usize = 2 * MAX_SPEEDS + 2 * Layout::packed(MAX_SPEEDS);

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    fn mechanics(&self, mode: ModeNumber) -> Option<&MechanicsTable> {
        let table = self.mode_table(mode);
        let is_slow = SLOW <= self.natures().nature(mode).longest_step && !table.is_stiffening;
        table.mechanics.as_ref().filter(|_| !is_slow)
    }

    /// Takes a step with these contacts closed, whose slopes are known.
    fn mechanical_step(
        &self,
        (mode, closed): (ModeNumber, ContactIndices),
        x: &[f64; N],
        input: &Motion,
        step: &MechanicalStep,
    ) -> Option<MechanicalEnd<[f64; N]>> {
        let mechanics = self.mechanics(mode)?;
        let input = rates_of(input);
        let mut extra = [0.0; Layout::COUNT];
        extra[Layout::STEP] = step.h;
        extra[Layout::ACCELERATION..Layout::CONTACTS].copy_from_slice(&step.acceleration);
        let mut predicted = [0.0; N];
        self.call_with(mechanics.prediction, (x, &input), &extra, &mut predicted);
        let (head, values) = extra.split_at_mut(Layout::VALUES);
        self.call_with(mechanics.values, (&predicted, &input), head, values);
        for contact in closed {
            let function = self.contact(mode, contact).and_then(|it| it.gradients.mechanics)?;
            let mut added = [0.0; MAX_ADDED];
            self.call_with(function, (&predicted, &input), head, &mut added);
            mechanics.press(&added, head, values);
        }
        let mut out = [[0.0; N]; 6];
        self.call_with(mechanics.correction, (x, &input), &extra, out.as_flattened_mut());
        Some(self.mechanical_end(mechanics, (x, out.as_flattened()), closed))
    }

    fn mechanical_end(
        &self,
        mechanics: &MechanicsTable,
        (x, out): (&[f64; N], &[f64]),
        closed: ContactIndices,
    ) -> MechanicalEnd<[f64; N]> {
        let count = self.table().states.len();
        let mut states = [[0.0; N]; 4];
        for (state, part) in states.iter_mut().zip(out.chunks_exact(count)) {
            state[..count].copy_from_slice(part);
        }
        let [end, linear, square, cube] = states;
        let rest = out.get(4 * count..).unwrap_or_default();
        let number = |i: usize| rest.get(i).copied().unwrap_or(0.0);
        let n = mechanics.speeds;
        let acceleration = core::array::from_fn(|k| if k < n { number(k) } else { 0.0 });
        let contact = PressedContact { error: number(n + 1), rate: number(n + 2) };
        MechanicalEnd {
            dense: Cubic::new([*x, linear, square, cube], end),
            acceleration,
            error: number(n),
            contact: (!closed.is_empty()).then_some(contact),
        }
    }
}

impl MechanicsTable {
    /// Adds what a closed contact contributes to the values, and the magnitudes of its stiffness
    /// row.
    fn press(&self, added: &[f64; MAX_ADDED], head: &mut [f64], values: &mut [f64]) {
        let own = values.iter_mut().skip(self.first_added());
        own.zip(added).take(self.added()).for_each(|(value, more)| *value += more);
        let row = added.iter().skip(self.added()).take(self.speeds);
        let sums = head.iter_mut().skip(Layout::CONTACTS);
        sums.zip(row).for_each(|(sum, slope)| *sum += slope.abs());
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> Mechanical<ModeNumber, [f64; N], Motion>
    for EquationModel<F, N, C>
{
    fn step(
        &self,
        mode: ModeNumber,
        x: &[f64; N],
        input: &Motion,
        step: &MechanicalStep,
    ) -> Option<MechanicalEnd<[f64; N]>> {
        self.mechanical_step((mode, ContactSet::OPEN.closed()), x, input, step)
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize>
    Mechanical<ContactMode<ModeNumber>, [f64; N], Motion> for EquationModel<F, N, C>
{
    /// Returns `None` also where a friction sticks or slides, or a closed contact has no slopes.
    fn step(
        &self,
        mode: ContactMode<ModeNumber>,
        x: &[f64; N],
        input: &Motion,
        step: &MechanicalStep,
    ) -> Option<MechanicalEnd<[f64; N]>> {
        let ContactMode { structure, contacts } = mode;
        let is_still = contacts.sticking().is_empty() && contacts.sliding().is_empty();
        let step = Some(step).filter(|_| is_still)?;
        self.mechanical_step((structure, contacts.closed()), x, input, step)
    }
}
