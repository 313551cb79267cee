//! Impacts of rigid contacts: all that touch, at once, with the modes that they lead to.

use core::array;

use pode::contacts::restitution::{Contacts, ImpactLaw, Resolved};
use pode::{GuardSpec, Motion, State as _};

use crate::equations::guards::{HOP, Leads, STILL};
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::EquationModel;
use crate::equations::table::{Equations, ImpactTable};

/// Most rigid contacts of one family of modes.
pub const MOST_RIGID: usize = 8;

/// Time within which contacts close together (s): far above the error of a located event.
const TOGETHER: f64 = 1e-9;

/// Contacts as bits.
type Bits = u32;

struct Meeting {
    contacts: Contacts<MOST_RIGID>,
    touching: [bool; MOST_RIGID],
}

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns where an impact of `contact` leads, with all contacts that touch then.
    ///
    /// # Real-time
    /// One function per contact, and the law's complementarity problems of [`MOST_RIGID`] contacts.
    pub(super) fn struck(
        &self,
        family: &ImpactTable,
        (mode, contact): (ModeNumber, u8),
        x: &[f64; N],
        input: &Motion,
    ) -> Leads<N> {
        let fired = usize::from(contact).min(MOST_RIGID - 1);
        let closed = family.members.iter().find(|it| it.0 == mode.0).map_or(0, |it| it.1);
        let meeting = self.meeting(family, (closed, fired), x, input);
        if meeting.contacts.velocities[fired] > HOP {
            // A jump of the input moved one body into the other, or another impact parted them.
            return Leads::to(mode, *x);
        }
        let law = meeting.resolved(meeting.contacts.restitution, fired, family.law);
        let plastic = meeting.resolved([0.0; MOST_RIGID], fired, ImpactLaw::Newton);
        let (state, impulse) = self.pushed(family, &law, x, input);
        let (at_rest, _) = self.pushed(family, &plastic, x, input);
        let parts = |i: &usize| law.velocities[*i] > STILL && law.impulses[*i] > 0.0;
        let is_lossy = (0..MOST_RIGID).filter(parts).all(|i| meeting.contacts.restitution[i] < 1.0);
        let rebounds = (0..MOST_RIGID).any(|i| parts(&i)) && is_lossy;
        let rests = (family.member(&meeting, &plastic), at_rest);
        let rests = (rebounds && rests.0 != mode).then_some(rests);
        Leads { impulse, rests, ..Leads::to(family.member(&meeting, &law), state) }
    }

    /// Returns the contacts that touch in `x`: those `closed`, the one that fired, and others that
    /// reach zero at the same time.
    fn meeting(
        &self,
        family: &ImpactTable,
        (closed, fired): (Bits, usize),
        x: &[f64; N],
        input: &Motion,
    ) -> Meeting {
        let n = family.responses.len().min(MOST_RIGID);
        let mut numbers = [[0.0; MOST_RIGID]; MOST_RIGID + 3];
        self.call(family.meeting, x, input, numbers.as_flattened_mut());
        let numbers = numbers.as_flattened();
        let at = |block: usize, i: usize| numbers.get(block * n + i).copied().unwrap_or(0.0);
        let entries = |block: usize| -> [f64; MOST_RIGID] {
            array::from_fn(|i| if i < n { at(block, i) } else { 0.0 })
        };
        let is_closed = |i: usize| closed & (1 << i) != 0;
        let (gaps, rates) = (entries(0), entries(1));
        let touching: [bool; MOST_RIGID] = array::from_fn(|i| {
            let scale = family.scales.get(i).copied().unwrap_or(1.0);
            let near = TOGETHER * -rates[i].min(0.0) + GuardSpec::new(0, "").scaled(scale).band();
            i < n && (is_closed(i) || i == fired || gaps[i] <= near)
        });
        let velocities =
            array::from_fn(|i| if is_closed(i) { rates[i].min(0.0) } else { rates[i] });
        let restitution = entries(2);
        let rebounds = |i: usize| touching[i] && restitution[i] * -velocities[i] > STILL;
        let is_rebound = (0..MOST_RIGID).any(rebounds);
        let restitution = if is_rebound { restitution } else { [0.0; MOST_RIGID] };
        let delassus = array::from_fn(|i| if i < n { entries(3 + i) } else { [0.0; MOST_RIGID] });
        let contacts = Contacts { delassus, velocities, restitution };
        Meeting { contacts: contacts.among(touching), touching }
    }

    fn pushed(
        &self,
        family: &ImpactTable,
        resolved: &Resolved<MOST_RIGID>,
        x: &[f64; N],
        input: &Motion,
    ) -> ([f64; N], f64) {
        let mut sums = (*x, 0.0);
        for (response, push) in family.responses.iter().zip(resolved.impulses) {
            if push != 0.0 {
                let (change, [drives]) = self.state_and_numbers(*response, x, input);
                sums = (sums.0.plus(push, &change), sums.1 + push * drives);
            }
        }
        sums
    }
}

impl Meeting {
    /// Resolves the impacts, after a pull that ends what parting the contact that fired has left.
    fn resolved(
        &self,
        restitution: [f64; MOST_RIGID],
        fired: usize,
        law: ImpactLaw,
    ) -> Resolved<MOST_RIGID> {
        let mut contacts = Contacts { restitution, ..self.contacts };
        let mobility = contacts.delassus[fired][fired];
        let parting = contacts.velocities[fired].max(0.0);
        let pull = if mobility > 0.0 { parting / mobility } else { 0.0 };
        for (velocity, row) in contacts.velocities.iter_mut().zip(&contacts.delassus) {
            *velocity -= row[fired] * pull;
        }
        let mut resolved = contacts.resolved(law);
        resolved.impulses[fired] -= pull;
        resolved
    }
}

impl ImpactTable {
    /// Returns the mode after an impact: of those whose closed contacts all touch and neither part
    /// nor close, the one with most contacts that were pushed, then with most contacts.
    fn member(&self, meeting: &Meeting, after: &Resolved<MOST_RIGID>) -> ModeNumber {
        let bits = |holds: &dyn Fn(usize) -> bool| {
            (0..MOST_RIGID).filter(|i| holds(*i)).fold(0, |all: Bits, i| all | 1 << i)
        };
        let still = bits(&|i| meeting.touching[i] && after.velocities[i] <= STILL);
        let pushed = still & bits(&|i| after.impulses[i] > 0.0);
        let fits = self.members.iter().filter(|(_, closed)| closed & !still == 0);
        let best = fits.fold((0, 0, 0), |best: (u32, u32, u8), (mode, closed)| {
            let rank = ((closed & pushed).count_ones(), closed.count_ones(), *mode);
            if (rank.0, rank.1) > (best.0, best.1) { rank } else { best }
        });
        let open = self.members.first().map_or(0, |it| it.0);
        ModeNumber(if best.1 == 0 { open } else { best.2 })
    }
}
