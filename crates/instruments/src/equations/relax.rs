//! A pose at which forces balance, found by descent.
//!
//! From rest to rest: each step is an implicit Euler step with the speeds set to zero after it, so
//! that it descends the potential; a step that does not is rejected. Short steps follow the slope,
//! long ones are Newton's. Contacts act by their own laws where their surfaces overlap, so that
//! bodies come to rest on each other.

use pode::{Guarded as _, Matrix as _, Motion, State};

use crate::equations::jacobian_bound::matrix;
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::EquationModel;
use crate::equations::rows::add_rows;
use crate::equations::table::{Equations, ModeTable};

/// Quantity that must not grow from step to step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Descent {
    /// The energy: the descent ends in a stable equilibrium.
    Energy,
    /// The largest rate of the state, if forces are no gradient of the energy.
    Imbalance,
}

const STEPS: usize = 240;
/// Length of the first step (s), and of one that is as good as Newton's (s).
const FIRST: f64 = 1e-3;
const LONG: f64 = 1e3;
/// Length below which a step leads nowhere (s).
const SHORT: f64 = 1e-8;
/// Growth of the next step, and shrinking of a rejected one.
const GROWTH: f64 = 3.0;
const SHRINKING: f64 = 0.2;
/// Relative rounding of the energy, and of a coordinate.
const ENERGY_ROUNDING: f64 = 1e-13;
const SMALL: f64 = 1e-12;

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns the pose below `guess` where the descent ends or is given up.
    pub(crate) fn relaxed(
        &self,
        mode: ModeNumber,
        guess: &[f64; N],
        input: &Motion,
        descent: Descent,
    ) -> [f64; N] {
        let mut x = self.stopped(mode, guess, input);
        let mut height = self.height(mode, &x, input, descent);
        let mut dt = FIRST;
        for _ in 0..STEPS {
            if dt < SHORT {
                break;
            }
            let Some((next, there)) = self.lower(mode, (&x, height), dt, input, descent) else {
                dt *= SHRINKING;
                continue;
            };
            let is_there = dt >= LONG && is_near(&x, &next, SMALL);
            (x, height, dt) = (next, there, (GROWTH * dt).min(LONG * GROWTH));
            if is_there {
                break;
            }
        }
        x
    }

    /// Takes a step of length `dt` (s) from `x`; returns state and height, `None` if it is higher.
    fn lower(
        &self,
        mode: ModeNumber,
        (x, height): (&[f64; N], f64),
        dt: f64,
        input: &Motion,
        descent: Descent,
    ) -> Option<([f64; N], f64)> {
        let step = self.relaxing_step(self.mode_table(mode), dt, x, input)?;
        let next = self.stopped(mode, &x.plus(1.0, &step), input);
        let there = self.height(mode, &next, input, descent);
        (there <= height + ENERGY_ROUNDING * height.abs()).then_some((next, there))
    }

    fn stopped(&self, mode: ModeNumber, x: &[f64; N], input: &Motion) -> [f64; N] {
        self.constrain(mode, &x.head_of(self.table().coordinates, &[0.0; N]), input)
    }

    /// Returns the height of `x`; NaN if it is unknown.
    fn height(&self, mode: ModeNumber, x: &[f64; N], input: &Motion, descent: Descent) -> f64 {
        let table = self.mode_table(mode);
        match descent {
            Descent::Energy => {
                let [energy, ..]: [f64; 3] = self.values(table.forces.balance, x, input);
                let overlapping = self.overlapping(table, x, input);
                let one = |balance| self.values::<4>(balance, x, input)[1];
                energy + overlapping.filter_map(|it| it.balance).map(one).sum::<f64>()
            }
            Descent::Imbalance => {
                let (_, rate) = self.fastest_entry(table, x, input);
                rate
            }
        }
    }

    fn relaxing_step(
        &self,
        table: &ModeTable,
        dt: f64,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; N]> {
        let (rates, rows) = self.held_up(table, x, input);
        let rows: <[f64; N] as State>::Matrix = matrix(&rows);
        let wanted = [0.0; N].plus(dt, &rates);
        <[f64; N] as State>::Matrix::solve(&rows.factor(dt), &wanted)
            .filter(|step| step.iter().all(|entry| entry.is_finite()))
    }

    /// Returns the derivative with all contacts whose surfaces overlap, and its Jacobian.
    pub(crate) fn held_up(
        &self,
        table: &ModeTable,
        x: &[f64; N],
        input: &Motion,
    ) -> ([f64; N], [[f64; N]; N]) {
        let rates = self.held_rates(table, x, input);
        // Off the constraints that multipliers hold, another pose would balance.
        let mut rows = if table.constraints.is_held {
            self.differenced(table, x, input)
        } else {
            self.mode_rows(table, x, input)
        };
        for contact in self.overlapping(table, x, input) {
            add_rows(&mut rows, &self.contact_rows(contact.gradients.jacobian, x, input));
        }
        (rates, rows)
    }

    fn held_rates(&self, table: &ModeTable, x: &[f64; N], input: &Motion) -> [f64; N] {
        let mut rates = [0.0; N];
        self.call(table.derivative, x, input, &mut rates);
        for contact in self.overlapping(table, x, input) {
            self.add_normal(contact.normal, x, input, &mut rates);
        }
        rates
    }

    /// Returns the moving entry that changes fastest, and its rate's magnitude; NaN if any rate is.
    pub(crate) fn fastest_entry(
        &self,
        table: &ModeTable,
        x: &[f64; N],
        input: &Motion,
    ) -> (usize, f64) {
        let moving = table.parts.iter().fold(0, |all, part| all | part.entries);
        let rates = self.held_rates(table, x, input);
        let own = rates.iter().enumerate().take(self.table().states.len());
        own.filter(|(index, _)| moving >> index & 1 == 1).fold((0, 0.0), |most, (index, rate)| {
            if rate.abs() <= most.1 || most.1.is_nan() { most } else { (index, rate.abs()) }
        })
    }

    fn overlapping<'a>(
        &'a self,
        table: &'a ModeTable,
        x: &'a [f64; N],
        input: &'a Motion,
    ) -> impl Iterator<Item = &'a crate::equations::table::ContactModeTable> + 'a {
        table.contacts.iter().filter(move |contact| {
            contact.gap.is_some_and(|gap| self.values::<2>(gap, x, input)[0] <= 0.0)
        })
    }
}

pub(crate) fn is_near<const N: usize>(x: &[f64; N], y: &[f64; N], part: f64) -> bool {
    x.iter().zip(y).all(|(x, y)| (x - y).abs() <= part * y.abs().max(0.01))
}
