//! Steps in the mechanical form of a table's modes.

use pode::contacts::{ContactIndices, ContactMode, ContactSet, ContactSystem};
use pode::{
    Cubic, MAX_SPEEDS, Mechanical, MechanicalEnd, MechanicalOutcome, MechanicalStep, Motion,
    PressedContact,
};

use crate::equations::apart::{Pulse, StruckContact};
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{EquationModel, rates_of};
use crate::equations::table::{ApartTable, Equations, MechanicsLayout as Layout, MechanicsTable};

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
    ) -> Option<MechanicalOutcome<[f64; N]>> {
        let mechanics = self.mechanics(mode)?;
        let (apart, pressed) = self.apart_and_pressed(mode, closed);
        let strike = apart.map(|it| self.strike((mechanics, it), x, input, step)).transpose();
        let strike = match strike {
            Err(after) => return Some(MechanicalOutcome::Opens { after }),
            Ok(strike) => strike,
        };
        let input = rates_of(input);
        let mut extra = [0.0; Layout::COUNT];
        extra[Layout::STEP] = step.h;
        extra[Layout::ACCELERATION..Layout::CONTACTS].copy_from_slice(&step.acceleration);
        let mut predicted = [0.0; N];
        self.call_with(mechanics.prediction, (x, &input), &extra, &mut predicted);
        if let Some(strike) = &strike {
            strike.add_to(&mut predicted);
        }
        let (head, values) = extra.split_at_mut(Layout::VALUES);
        self.call_with(mechanics.values, (&predicted, &input), head, values);
        for contact in pressed {
            let function = self.contact(mode, contact).and_then(|it| it.gradients.mechanics)?;
            let mut added = [0.0; MAX_ADDED];
            self.call_with(function, (&predicted, &input), head, &mut added);
            mechanics.press(&added, head, values);
        }
        let mut out = [[0.0; N]; 6];
        self.call_with(mechanics.correction, (x, &input), &extra, out.as_flattened_mut());
        let strike = strike.map(|it| (it, step.h));
        let end = self.mechanical_end(mechanics, (x, out.as_flattened()), (pressed, strike));
        Some(MechanicalOutcome::End(end))
    }

    fn mechanical_acceleration(
        &self,
        (mode, closed): (ModeNumber, ContactIndices),
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; MAX_SPEEDS]> {
        let mechanics = self.mechanics(mode)?;
        let (_apart, pressed) = self.apart_and_pressed(mode, closed);
        let rates = ContactSystem::derivative(self, mode, pressed, x, input);
        let of_speed = |k: usize| rates[usize::from(mechanics.speed_entries[k]) % N];
        Some(core::array::from_fn(|k| if k < mechanics.speeds { of_speed(k) } else { 0.0 }))
    }

    /// Returns the only closed contact if it can be followed apart, and those that are not.
    fn apart_and_pressed(
        &self,
        mode: ModeNumber,
        closed: ContactIndices,
    ) -> (Option<ApartTable>, ContactIndices) {
        let mut all = closed.into_iter();
        let only = all.next().filter(|_| all.next().is_none());
        let apart = only.and_then(|it| self.contact(mode, it)?.gradients.apart);
        (apart, if apart.is_some() { ContactSet::OPEN.closed() } else { closed })
    }

    /// Follows a contact over a step; returns the length (s) of a shorter one if it opens inside.
    fn strike(
        &self,
        (mechanics, apart): (&MechanicsTable, ApartTable),
        x: &[f64; N],
        input: &Motion,
        step: &MechanicalStep,
    ) -> Result<StatePulse, f64> {
        let rates = rates_of(input);
        let mut place = [0.0; 3];
        self.call_with(apart.place, (x, &rates), &[], &mut place);
        let [depth, slope, mass] = place;
        let law = |depth: f64, rate: f64| {
            let mut out = [0.0; 3];
            self.call_with(apart.law, (x, &rates), &[depth, rate], &mut out);
            out
        };
        let number = usize::from(apart.speed) % MAX_SPEEDS;
        let speed_entry = mechanics.speed_entries[number];
        let contact = StruckContact {
            depth,
            rate: slope * x[usize::from(speed_entry) % N],
            acceleration: slope * step.acceleration[number],
            mobility: slope * slope / mass,
        };
        let Pulse { depth, rate, absorbed } = contact.pulse(step.h, law)?;
        Ok(StatePulse {
            entries: (apart.coordinate, speed_entry),
            place: depth / slope,
            speed: rate / slope,
            absorbed,
        })
    }

    fn mechanical_end(
        &self,
        mechanics: &MechanicsTable,
        (x, out): (&[f64; N], &[f64]),
        (closed, strike): (ContactIndices, Option<(StatePulse, f64)>),
    ) -> MechanicalEnd<[f64; N]> {
        let count = self.table().states.len();
        let mut states = [[0.0; N]; 4];
        for (state, part) in states.iter_mut().zip(out.chunks_exact(count)) {
            state[..count].copy_from_slice(part);
        }
        if let Some((strike, h)) = &strike {
            strike.bend(&mut states, *h);
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
            absorbed: strike.map_or(0.0, |(it, _)| it.absorbed),
        }
    }
}

/// Effect of a struck contact over a step on the state.
struct StatePulse {
    /// Entries of the coordinate and of the speed.
    entries: (u8, u8),
    /// Changes of both.
    place: f64,
    speed: f64,
    absorbed: f64,
}

impl StatePulse {
    fn changes(&self) -> [(usize, f64); 2] {
        [(usize::from(self.entries.0), self.place), (usize::from(self.entries.1), self.speed)]
    }

    fn add_to<const N: usize>(&self, state: &mut [f64; N]) {
        for (entry, change) in self.changes() {
            state[entry % N] += change;
        }
    }

    /// Adds the changes to a step of `h` (s), its end and the terms of τ, τ² and τ³: a cubic move of
    /// the coordinate that starts without one of the speed, and its rate.
    fn bend<const N: usize>(&self, [end, linear, square, cube]: &mut [[f64; N]; 4], h: f64) {
        self.add_to(end);
        let (way, rise) = (self.place, h * self.speed);
        let [place, speed] = self.changes().map(|(entry, _)| entry % N);
        let (of_square, of_cube) = (3.0 * way - rise, rise - 2.0 * way);
        square[place] += of_square;
        cube[place] += of_cube;
        linear[speed] += 2.0 * of_square / h;
        square[speed] += 3.0 * of_cube / h;
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
    fn suits(&self, mode: ModeNumber) -> bool {
        self.mechanics(mode).is_some()
    }

    fn acceleration(
        &self,
        mode: ModeNumber,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; MAX_SPEEDS]> {
        self.mechanical_acceleration((mode, ContactSet::OPEN.closed()), x, input)
    }

    fn step(
        &self,
        mode: ModeNumber,
        x: &[f64; N],
        input: &Motion,
        step: &MechanicalStep,
    ) -> Option<MechanicalOutcome<[f64; N]>> {
        self.mechanical_step((mode, ContactSet::OPEN.closed()), x, input, step)
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize>
    Mechanical<ContactMode<ModeNumber>, [f64; N], Motion> for EquationModel<F, N, C>
{
    fn suits(&self, mode: ContactMode<ModeNumber>) -> bool {
        self.mechanics(mode.structure).is_some()
    }

    /// Returns `None` also where a friction sticks or slides.
    fn acceleration(
        &self,
        mode: ContactMode<ModeNumber>,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; MAX_SPEEDS]> {
        let mode = without_friction(mode)?;
        self.mechanical_acceleration(mode, x, input)
    }

    /// Returns `None` also where a friction sticks or slides, or a closed contact has no slopes.
    fn step(
        &self,
        mode: ContactMode<ModeNumber>,
        x: &[f64; N],
        input: &Motion,
        step: &MechanicalStep,
    ) -> Option<MechanicalOutcome<[f64; N]>> {
        self.mechanical_step(without_friction(mode)?, x, input, step)
    }
}

/// Returns the structure and its closed contacts; `None` where a friction sticks or slides.
fn without_friction(mode: ContactMode<ModeNumber>) -> Option<(ModeNumber, ContactIndices)> {
    let ContactMode { structure, contacts } = mode;
    let is_still = contacts.sticking().is_empty() && contacts.sliding().is_empty();
    is_still.then(|| (structure, contacts.closed()))
}
