//! The mechanical form of a table's modes, for methods that use the mass matrix.

use pode::contacts::ContactMode;
use pode::{Mechanical, MechanicalLayout, MechanicalPoint, MechanicalValues, Motion};

use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::table::{Equations, FunctionId};

/// Count of the extra arguments: the step's length, then its middle speeds.
const EXTRA: usize = 1 + pode::MAX_SPEEDS;

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    #[inline]
    fn call_at(
        &self,
        function: FunctionId,
        point: &MechanicalPoint<'_, [f64; N]>,
        input: &Motion,
        out: &mut [f64],
    ) {
        let mut extra = [point.h; EXTRA];
        for (place, speed) in extra.iter_mut().skip(1).zip(&point.middle) {
            *place = *speed;
        }
        self.call_with(function, (point.state, &rates_of(input)), &extra, out);
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> Mechanical<ModeNumber, [f64; N], Motion>
    for EquationModel<F, N, C>
{
    #[inline]
    fn layout(&self, mode: ModeNumber) -> Option<&MechanicalLayout> {
        self.mode_table(mode).mechanics.as_ref().map(|it| &it.layout)
    }

    #[inline]
    fn evaluate(
        &self,
        mode: ModeNumber,
        point: &MechanicalPoint<'_, [f64; N]>,
        input: &Motion,
        out: &mut MechanicalValues,
    ) {
        if let Some(mechanics) = &self.mode_table(mode).mechanics {
            self.call_at(mechanics.values, point, input, &mut out.numbers);
            out.contacts = None;
        }
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize>
    Mechanical<ContactMode<ModeNumber>, [f64; N], Motion> for EquationModel<F, N, C>
{
    /// Returns the structure's layout; `None` if a friction sticks or slides, or if a closed
    /// contact has no slopes.
    #[inline]
    fn layout(&self, mode: ContactMode<ModeNumber>) -> Option<&MechanicalLayout> {
        let ContactMode { structure, contacts } = mode;
        let is_still = contacts.sticking().is_empty() && contacts.sliding().is_empty();
        let has_slopes =
            |contact| self.contact(structure, contact).is_none_or(|it| it.mechanics.is_some());
        let is_mechanical = is_still && contacts.closed().into_iter().all(has_slopes);
        Mechanical::<ModeNumber, _, _>::layout(self, structure).filter(|_| is_mechanical)
    }

    #[inline]
    fn evaluate(
        &self,
        mode: ContactMode<ModeNumber>,
        point: &MechanicalPoint<'_, [f64; N]>,
        input: &Motion,
        out: &mut MechanicalValues,
    ) {
        let ContactMode { structure, contacts } = mode;
        Mechanical::<ModeNumber, _, _>::evaluate(self, structure, point, input, out);
        let Some(mechanics) = &self.mode_table(structure).mechanics else { return };
        for contact in contacts.closed() {
            let function = self.contact(structure, contact).and_then(|it| it.mechanics);
            let Some(function) = function else { continue };
            let mut added = [0.0; MechanicalLayout::MAX_ADDED];
            self.call_at(function, point, input, &mut added);
            out.add_contact(&mechanics.layout, &added);
        }
    }
}
