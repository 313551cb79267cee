//! The table of a model as the structure of a mechanism with contacts.

use core::array;

use pode::contacts::{
    ContactGuard, ContactIndices, ContactMode, ContactSet, ContactSpec, ContactSystem,
    CoupledFrictions, FrictionForces, FrictionLimits, FrictionalContacts, GuardedContacts,
    MAX_FRICTIONS, SlipKind, Surface, WithContacts,
};
use pode::{
    Enclosure, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Mechanical,
    Model, Motion, Nature, ReadoutSlopes, Reset, Sloped,
};

use crate::equations::jacobian_bound::RADIANS;
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::rows::add_rows;
use crate::equations::table::{ContactModeTable, Equations, FunctionId, MAX_CODED_CONTACTS};

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns the table of a contact in a mode; `None` if it cannot close there.
    #[inline]
    pub(crate) fn contact(&self, mode: ModeNumber, contact: usize) -> Option<&ContactModeTable> {
        self.mode_table(mode).contacts.iter().find(|it| usize::from(it.contact) == contact)
    }

    fn is_switch(&self, contact: usize) -> bool {
        let friction = self.table().automata.contacts.get(contact).and_then(|it| it.friction);
        friction.is_some_and(|it| it.kind == SlipKind::Condition)
    }

    /// Sums the balances of all closed contacts: readout, energy, supplied, dissipated.
    #[inline]
    pub(crate) fn contact_sums(
        &self,
        (mode, closed): (ModeNumber, ContactIndices),
        x: &[f64; N],
        input: &Motion,
    ) -> [f64; 4] {
        let closed = closed.iter().filter_map(|contact| self.contact(mode, contact)?.balance);
        closed.fold([0.0; 4], |sums, balance| {
            let one: [f64; 4] = self.values(balance, x, input);
            array::from_fn(|number| sums[number] + one[number])
        })
    }

    /// Sums the effects of all frictions: on the readout, and on the power of what moves by itself.
    pub(crate) fn friction_effects(
        &self,
        mode: ModeNumber,
        forces: &FrictionForces,
        x: &[f64; N],
        input: &Motion,
    ) -> [f64; 2] {
        let one = |(contact, force): (usize, f64)| {
            let response = self.contact(mode, contact)?.response?;
            let (_, effects) = self.response_of(response, ContactSet::OPEN, x, input);
            Some(effects.map(|per| force * per))
        };
        let add = |sums: [f64; 2], more: [f64; 2]| array::from_fn(|i| sums[i] + more[i]);
        forces.iter().filter_map(one).fold([0.0; 2], add)
    }

    /// Returns a friction's contribution to the derivative; to the readout and to motors' power.
    fn response_of(
        &self,
        response: FunctionId,
        contacts: ContactSet,
        x: &[f64; N],
        input: &Motion,
    ) -> ([f64; N], [f64; 2]) {
        let sides: [f64; MAX_CODED_CONTACTS] = array::from_fn(|it| contacts.state(it).slip_sign());
        let mut out = [[0.0; N]; 3];
        self.call_with(response, (x, &rates_of(input)), &sides, out.as_flattened_mut());
        self.split(&out)
    }

    /// Returns a surface by its value, drift and gradient; zero without a function.
    fn surface(
        &self,
        function: Option<FunctionId>,
        x: &[f64; N],
        input: &Motion,
    ) -> Surface<[f64; N]> {
        let mut out = [[0.0; N]; 3];
        if let Some(function) = function {
            self.call(function, x, input, out.as_flattened_mut());
        }
        let (flat, count) = (out.as_flattened(), self.table().states.len());
        let at = |index: usize| flat.get(index).copied().unwrap_or(0.0);
        let gradient = array::from_fn(|i| if i < count { at(2 + i) } else { 0.0 });
        Surface { value: at(0), drift: at(1), gradient }
    }

    /// Returns the fastest rate (rad/s) with these contacts closed, in a mode of a constant rate:
    /// the larger of both, at most √2 too low where they move the same part.
    fn contact_rate(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        (x, input): (&[f64; N], &Motion),
        longest: f64,
    ) -> f64 {
        let (mut square, mut loss) = (0.0, 0.0);
        for contact in closed.iter().filter_map(|contact| self.contact(mode, contact)) {
            let [own, lost] =
                self.contact_values(contact.gradients.rates, x, input).unwrap_or([0.0; 2]);
            square += own.max(0.0);
            loss += lost.max(0.0);
        }
        let of_contacts = 0.5 * (loss + pode::math::sqrt(loss * loss + 4.0 * square));
        of_contacts.max(RADIANS / longest)
    }

    fn contact_values<const K: usize>(
        &self,
        function: Option<FunctionId>,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; K]> {
        function.map(|function| self.values(function, x, input))
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> ContactSystem
    for EquationModel<F, N, C>
{
    type Structure = ModeNumber;
    type State = [f64; N];
    type Input = Motion;
    const COORDS: usize = N / 2;

    #[inline]
    fn coordinates(&self) -> usize {
        self.table().coordinates
    }

    fn contacts(&self) -> &[ContactSpec] {
        &self.table().automata.contacts
    }

    #[inline]
    fn gap(&self, mode: ModeNumber, contact: usize, x: &[f64; N], input: &Motion) -> GuardValue {
        let gap = self.contact(mode, contact).and_then(|contact| contact.gap);
        // A contact that cannot close is open.
        let [value, rate] = self.contact_values(gap, x, input).unwrap_or([1.0, 0.0]);
        GuardValue::new(value, rate)
    }

    #[inline]
    fn derivative(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        x: &[f64; N],
        input: &Motion,
    ) -> [f64; N] {
        let table = self.mode_table(mode);
        let mut rates = [0.0; N];
        self.call(table.forces.averaged.unwrap_or(table.derivative), x, input, &mut rates);
        for contact in closed.iter().filter_map(|contact| self.contact(mode, contact)) {
            self.add_normal(contact.normal, x, input, &mut rates);
        }
        rates
    }

    fn readout(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
        forces: &FrictionForces,
        x: &[f64; N],
        input: &Motion,
    ) -> f64 {
        Model::readout(self, mode, x, input)
            + self.contact_sums((mode, closed), x, input)[0]
            + self.friction_effects(mode, forces, x, input)[0]
    }

    /// Sums structure and closed contacts; `None` if a friction is felt at the input.
    fn slopes(
        &self,
        mode: ModeNumber,
        contacts: ContactSet,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<ReadoutSlopes> {
        let mut all = Sloped::slopes(self, mode, x, input);
        for contact in contacts.closed() {
            let slopes = self.contact(mode, contact)?.slopes?;
            let [per_position, per_rate] = self.values(slopes, x, input);
            all.per_position += per_position;
            all.per_rate += per_rate;
        }
        Some(all)
    }

    /// A closed contact's rate depends on the state, so the longest step handles it. Contacts and
    /// switches that leave the Jacobian constant may add forces of the input.
    fn nature(&self, mode: ModeNumber, contacts: ContactSet) -> Nature {
        let nature = self.natures().nature(mode);
        if contacts.closed().is_empty() {
            return nature;
        }
        let is_linear = |contact| self.contact(mode, contact).is_none_or(|it| it.is_linear);
        let sticks = |contact| FrictionalContacts::acts(self, mode, contact);
        let stays_linear = nature.is_linear()
            && contacts.closed().into_iter().all(is_linear)
            && !contacts.sticking().into_iter().any(sticks);
        let kind = if stays_linear { EquationKind::Linear } else { EquationKind::Smooth };
        Nature { kind, ..nature }
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> FrictionalContacts
    for EquationModel<F, N, C>
{
    fn slip(
        &self,
        mode: ModeNumber,
        contact: usize,
        x: &[f64; N],
        input: &Motion,
    ) -> Surface<[f64; N]> {
        let slip = self.contact(mode, contact).and_then(|contact| contact.slip);
        self.surface(slip, x, input)
    }

    fn mechanical(&self) -> Option<&dyn Mechanical<ContactMode<ModeNumber>, [f64; N], Motion>> {
        Some(self)
    }

    fn acts(&self, mode: ModeNumber, contact: usize) -> bool {
        !self.is_switch(contact) || self.contact(mode, contact).is_some()
    }

    fn kept(
        &self,
        mode: ModeNumber,
        contact: usize,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<Surface<[f64; N]>> {
        let kept = self.contact(mode, contact).and_then(|contact| contact.kept)?;
        Some(self.surface(Some(kept), x, input))
    }

    fn response_among(
        &self,
        mode: ModeNumber,
        contacts: ContactSet,
        contact: usize,
        x: &[f64; N],
        input: &Motion,
    ) -> [f64; N] {
        let response = self.contact(mode, contact).and_then(|contact| contact.response);
        response.map_or([0.0; N], |response| self.response_of(response, contacts, x, input).0)
    }

    fn friction(
        &self,
        mode: ModeNumber,
        contact: usize,
        x: &[f64; N],
        input: &Motion,
    ) -> FrictionLimits {
        let limits = self.contact(mode, contact).and_then(|contact| contact.limits);
        let [stiction, kinetic] = self.contact_values(limits, x, input).unwrap_or([0.0; 2]);
        FrictionLimits { stiction, kinetic }
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> CoupledFrictions
    for EquationModel<F, N, C>
{
    fn is_coupled(&self, mode: ModeNumber) -> bool {
        self.mode_table(mode).contacts.iter().any(|contact| contact.pressed.is_some())
    }

    fn pressed_by(
        &self,
        mode: ModeNumber,
        contact: usize,
        pressed: ContactGuard,
        x: &[f64; N],
        input: &Motion,
    ) -> FrictionLimits {
        let (function, width) = match pressed {
            ContactGuard::Friction(other) => {
                (self.contact(mode, other).and_then(|it| it.pressed), 2)
            }
            ContactGuard::Structure(guard) => {
                (self.guard_table(mode, guard).and_then(|it| it.pressed), 1)
            }
            ContactGuard::Gap(_) => (None, 1),
        };
        let mut frictions = self.mode_table(mode).contacts.iter().filter(|it| it.slip.is_some());
        let own = frictions.position(|it| usize::from(it.contact) == contact);
        let Some((function, own)) = function.zip(own) else { return FrictionLimits::coulomb(0.0) };
        let mut out = [[0.0; 2]; MAX_FRICTIONS];
        self.call(function, x, input, out.as_flattened_mut());
        let at = |index: usize| out.as_flattened().get(index).copied().unwrap_or(0.0);
        FrictionLimits { stiction: at(width * own), kinetic: at(width * own + width - 1) }
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> GuardedContacts
    for EquationModel<F, N, C>
{
    fn structure_guards(&self) -> &[GuardSpec] {
        &self.table().automata.guards
    }

    fn is_watched(&self, mode: ModeNumber, guard: GuardId) -> bool {
        self.guard_table(mode, guard).is_some()
    }

    fn structure_guard(
        &self,
        mode: ModeNumber,
        guard: GuardId,
        x: &[f64; N],
        input: &Motion,
    ) -> GuardValue {
        self.guard(mode, guard, x, input)
    }

    #[inline]
    fn guard_bound(
        &self,
        mode: ModeNumber,
        guard: ContactGuard,
        over: &Enclosure<[f64; N], Motion>,
    ) -> GuardBound {
        let bound = match guard {
            ContactGuard::Gap(contact) => match self.contact(mode, contact) {
                Some(contact) => contact.bound,
                None => return GuardBound::STILL,
            },
            ContactGuard::Structure(guard) => {
                self.guard_table(mode, guard).and_then(|guard| guard.bound)
            }
            ContactGuard::Friction(contact) => {
                self.contact(mode, contact).and_then(|contact| contact.slip_bound)
            }
        };
        self.bound(bound, over)
    }

    /// Two rates of the touching contacts in each step, and a derivative; two Jacobians where the
    /// mode stiffens or a contact rubs.
    fn longest_step_at(
        &self,
        mode: ModeNumber,
        contacts: ContactSet,
        x: &[f64; N],
        input: &Motion,
    ) -> f64 {
        let closed = contacts.closed();
        if closed.iter().all(|contact| self.is_switch(contact)) {
            return Guarded::longest_step_at(self, mode, x, input);
        }
        let longest = self.natures().nature(mode).longest_step;
        let rates = ContactSystem::derivative(self, mode, closed, x, input);
        let has_rates = |contact| {
            self.contact(mode, contact)
                .is_some_and(|it| it.gradients.rates.is_some() && it.slip.is_none())
        };
        if !self.mode_table(mode).is_stiffening && closed.iter().all(has_rates) {
            let fastest = |x: &[f64; N]| self.contact_rate(mode, closed, (x, input), longest);
            return self.step_by(fastest, (longest, rates), x);
        }
        let jacobian = |x: &[f64; N]| {
            let mut rows = self.mode_rows(self.mode_table(mode), x, input);
            for contact in closed.iter().filter_map(|contact| self.contact(mode, contact)) {
                add_rows(&mut rows, &self.contact_rows(contact.gradients.jacobian, x, input));
            }
            rows
        };
        self.step_by(|x| self.fastest_of(&jacobian(x)), (longest, rates), x)
    }

    fn constrain(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> [f64; N] {
        Guarded::constrain(self, mode, x, input)
    }

    fn reset(
        &self,
        mode: ModeNumber,
        contacts: ContactSet,
        guard: GuardId,
        x: &[f64; N],
        input: &Motion,
    ) -> Reset<WithContacts<Self>> {
        let leads = self.leads(mode, guard, x, input);
        let with = |structure| ContactMode { structure, contacts };
        let reset = Reset::to(with(leads.to), leads.state).with_impulse(leads.impulse);
        let reset = reset.releasing(leads.released);
        match leads.rests {
            Some((to, state)) => reset.resting(with(to), state),
            None => reset,
        }
    }
}
