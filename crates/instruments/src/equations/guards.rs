//! The guards of a mode, and their resets.

use pode::{
    Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Mechanical, Model as _, Motion,
    Reset, Resets,
};

use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::table::{
    EnclosureLayout, Equations, FunctionId, GuardTable, RestingTable, WayTable,
};

/// Speed below which there is no rebound (m/s): under gravity it would last 20 ps.
pub(super) const STILL: f64 = 1e-10;
/// Parting speed below which a fired guard still counts as an impact (m/s): the rounding of a
/// coordinate of 1 m hides the hop, up to 5 km/s² of pressing.
pub(super) const HOP: f64 = 1e-5;

impl<F: Equations + Clone, const N: usize, const C: usize> Guarded for EquationModel<F, N, C> {
    #[inline]
    fn mechanical(&self) -> Option<&dyn Mechanical<ModeNumber, [f64; N], Motion>> {
        Some(self)
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn constrain(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> [f64; N] {
        let mode = self.mode_table(mode);
        if mode.constraints.slaved.is_none() && mode.constraints.projection.is_none() {
            return *x;
        }
        let mut in_place = *x;
        self.put_in_place(mode, &mut in_place, input);
        in_place
    }

    #[inline]
    fn longest_step_at(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> f64 {
        let longest = self.nature(mode).longest_step;
        if self.mode_table(mode).is_stiffening {
            self.step_at(mode, longest, x, input)
        } else {
            longest
        }
    }

    #[inline]
    fn guards(&self, mode: ModeNumber) -> &[GuardSpec] {
        &self.mode_table(mode).guard_specs
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn guard_bound(
        &self,
        mode: ModeNumber,
        guard: GuardId,
        over: &Enclosure<[f64; N], Motion>,
    ) -> GuardBound {
        let bound = self.guard_table(mode, guard).and_then(|guard| guard.bound);
        self.bound(bound, over)
    }

    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    fn guard(&self, mode: ModeNumber, guard: GuardId, x: &[f64; N], input: &Motion) -> GuardValue {
        let Some(guard) = self.guard_table(mode, guard) else {
            return GuardValue::new(f64::NAN, f64::NAN);
        };
        let (rates, mut out) = (rates_of(input), [f64::NAN; 2]);
        self.functions().call(guard.value, &self.arguments(x, &rates, &[]), &mut out);
        GuardValue::new(out[0], out[1])
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> Resets for EquationModel<F, N, C> {
    fn reset(&self, mode: ModeNumber, guard: GuardId, x: &[f64; N], input: &Motion) -> Reset<Self> {
        let leads = self.leads(mode, guard, x, input);
        let reset = Reset::to(leads.to, leads.state).with_impulse(leads.impulse);
        let reset = reset.releasing(leads.released);
        match leads.rests {
            Some((to, state)) => reset.resting(to, state),
            None => reset,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Leads<const N: usize> {
    pub(crate) to: ModeNumber,
    pub(crate) state: [f64; N],
    pub(crate) impulse: f64,
    pub(crate) rests: Option<(ModeNumber, [f64; N])>,
    pub(crate) released: Option<GuardId>,
}

impl<const N: usize> Leads<N> {
    pub(crate) const fn to(to: ModeNumber, state: [f64; N]) -> Self {
        Self { to, state, impulse: 0.0, rests: None, released: None }
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    #[inline]
    pub(crate) fn guard_table(&self, mode: ModeNumber, id: GuardId) -> Option<&GuardTable> {
        self.mode_table(mode).guards.iter().find(|guard| guard.id == id.0)
    }

    /// Returns the bound of a function over a step; unknown without a function, or if it is NaN.
    #[expect(clippy::inline_always, reason = "a call takes the state through memory")]
    #[inline(always)]
    pub(crate) fn bound(
        &self,
        bound: Option<FunctionId>,
        over: &Enclosure<[f64; N], Motion>,
    ) -> GuardBound {
        let Some(bound) = bound else { return GuardBound::UNKNOWN };
        let numbers = EnclosureLayout::numbers(over);
        let input = over.input.map_or([f64::INFINITY; 4], |most| {
            [most.position, most.rate, most.acceleration, most.jerk]
        });
        let mut out = [f64::INFINITY; 2];
        let arguments = self.arguments(&over.start, &input, numbers.as_flattened());
        self.functions().call(bound, &arguments, &mut out);
        let [moves, bend] = out.map(|it| if it.is_nan() { f64::INFINITY } else { it });
        GuardBound::new(moves, bend)
    }

    /// Returns the target of a guard from `x`; it keeps everything if the table has no way out.
    pub(crate) fn leads(
        &self,
        mode: ModeNumber,
        guard: GuardId,
        x: &[f64; N],
        input: &Motion,
    ) -> Leads<N> {
        let table = self.guard_table(mode, guard);
        if let Some((contact, family)) =
            table.and_then(|it| it.closes).zip(self.table().automata.impacts_in(mode.0))
        {
            return self.struck(family, (mode, contact), x, input);
        }
        let ways = table.map_or(&[][..], |guard| &guard.ways);
        let is_open = |way: &&WayTable| {
            way.when.is_none_or(|when| {
                let [margin] = self.values(when, x, input);
                margin > 0.0
            })
        };
        let Some(way) = ways.iter().find(is_open) else { return Leads::to(mode, *x) };
        let (state, [impulse]) =
            way.reset.map_or((*x, [0.0]), |reset| self.state_and_numbers(reset, x, input));
        let released = way.releases.map(GuardId);
        let leads = Leads { impulse, released, ..Leads::to(ModeNumber(way.to), state) };
        match way.resting {
            Some(resting) => self.met(resting, (mode, leads), x, input),
            None => leads,
        }
    }

    /// Returns the target of an impact: a rebound, rest, or neither if the bodies part already.
    fn met(
        &self,
        resting: RestingTable,
        (from, rebound): (ModeNumber, Leads<N>),
        x: &[f64; N],
        input: &Motion,
    ) -> Leads<N> {
        let [closing, restitution] = self.values(resting.meeting, x, input);
        if closing < -HOP {
            // A jump of the input moved one body into the other.
            return Leads::to(from, self.with_places_of(&rebound.state, x));
        }
        let (state, [impulse]) = self.state_and_numbers(resting.state, x, input);
        let to = ModeNumber(resting.to);
        if restitution * closing <= STILL {
            Leads { impulse, ..Leads::to(to, state) }
        } else {
            Leads { rests: (restitution < 1.0).then_some((to, state)), ..rebound }
        }
    }

    fn with_places_of(&self, places: &[f64; N], x: &[f64; N]) -> [f64; N] {
        let count = self.table().coordinates;
        core::array::from_fn(|i| if i < count { places[i] } else { x[i] })
    }
}
