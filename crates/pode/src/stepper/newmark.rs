use crate::dense::{Cubic, Dense as _};
use crate::mechanical::{
    EntryRole, MAX_SPEEDS, MechanicalLayout, MechanicalPoint, MechanicalValues, SpeedMatrix,
};
use crate::state::State;
use crate::stepper::{Field, Memory, Rk4, Step, Stepper};

/// Order 2, linearly implicit, for modes in mechanical form M u' = Q: one evaluation, one LDLᵀ.
///
/// The acceleration a of the last step predicts; Δ corrects it with the slopes K = −∂Q/∂q and
/// D = −∂Q/∂u of the compliant elements:
///
/// ```text
/// q = q0 + h u0 + h²/2 a,   u = u0 + h a
/// (M + h/2 D + β h² K) Δ = Q(q, u) − M a
/// a + Δ,   u + h/2 Δ,   q + β h² Δ
/// ```
///
/// With β = 1/12 an oscillator's frequency is exact to (hω)⁴/480, and steps are stable for
/// hω < √6: where M − h²/6 K is positive definite, by the pivots of its LDLᵀ. Elsewhere β = 1/4,
/// which is stable at any rate. Internal states, such as a wound-up friction, follow their linear
/// rates in closed form, with the speeds in the middle of the step.
///
/// Steps take 0.5 ms, and 0.25 ms where the correction moves an element's force by more than the
/// tolerance. A step with eight times as much is repeated once. While a contact is closed that does
/// not rest, steps are at most 62.5 µs and half a radian of the fastest rate.
///
/// Dense output: the cubic Hermite by the rates at both ends. The acceleration is void after a
/// reset, and then costs one more evaluation. Modes without a mechanical form are stepped by
/// [`Rk4`]. `[New59]`, `[Hug87]` 9.1; `[FG49]` for β = 1/12.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Newmark {
    /// Force (N) by which the correction may move an element.
    pub tolerance: f64,
}

impl Default for Newmark {
    /// 0.02 N, below what a finger feels.
    fn default() -> Self {
        Self { tolerance: 0.02 }
    }
}

/// Steps (s) where the correction is small, and where it is large.
const LONG: f64 = 5e-4;
const SHORT: f64 = 2.5e-4;

/// Step of a closed contact in terms of its rate (rad), and its limits (s). The longest one is also
/// the first step after an event, when the rate to come is unknown.
const CONTACT_RADIANS: f64 = 0.5;
const CONTACT_STEPS: (f64, f64) = (2e-5, 6.25e-5);

/// Fraction of the tolerance below which steps grow.
const RELAXED: f64 = 1.0 / 16.0;

/// Memory of [`Newmark`]: the last acceleration, and the next step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct NewmarkMemory {
    acceleration: Option<[f64; MAX_SPEEDS]>,
    /// Length of the next step (s).
    next: f64,
    /// `true` after an odd number of short steps in the tick.
    is_odd: bool,
    is_repeated: bool,
    is_mechanical: bool,
}

impl Default for NewmarkMemory {
    fn default() -> Self {
        Self {
            acceleration: None,
            next: LONG,
            is_odd: false,
            is_repeated: false,
            is_mechanical: false,
        }
    }
}

impl Memory for NewmarkMemory {
    #[inline]
    fn restart(&mut self) {
        self.acceleration = None;
        self.next = CONTACT_STEPS.1;
        self.is_repeated = false;
    }

    #[inline]
    fn begin_tick(&mut self) {
        self.is_odd = false;
    }

    #[inline]
    fn reach(&self) -> f64 {
        if self.is_mechanical { self.next } else { f64::INFINITY }
    }

    #[inline]
    fn sets_steps(&self) -> bool {
        self.is_mechanical
    }
}

impl NewmarkMemory {
    /// Chooses the next step after one of `h` (s) with closed contacts, by their relative error and the
    /// fastest rate (rad/s).
    fn touch(&mut self, h: f64, error: f64, rate: f64) {
        let (least, most) = CONTACT_STEPS;
        let is_at_rest = error < RELAXED;
        self.next = if is_at_rest { LONG.min(2.0 * h) } else { CONTACT_RADIANS / rate };
        self.next = self.next.clamp(least, if is_at_rest { LONG } else { most });
        self.is_repeated = false;
    }

    /// Chooses the next step after one of `h` (s) with this `error` (N); returns `false` if that step
    /// must be repeated.
    fn judge(&mut self, h: f64, error: f64, tolerance: f64) -> bool {
        const REPEATED: f64 = 8.0;
        const ROUNDING: f64 = 1e-9;
        if error > REPEATED * tolerance && h > SHORT * (1.0 + ROUNDING) && !self.is_repeated {
            (self.next, self.is_repeated) = (SHORT, true);
            return false;
        }
        (self.is_odd, self.is_repeated) = (!self.is_odd, false);
        let may_be_long = self.next > SHORT || (error < RELAXED * tolerance && !self.is_odd);
        self.next = if error <= tolerance && may_be_long { LONG } else { SHORT };
        true
    }
}

impl Stepper for Newmark {
    const ORDER: u32 = 2;
    const DENSE: u32 = 3;
    const EVALUATIONS: u32 = Rk4::EVALUATIONS;
    const NAME: &'static str = "newmark";

    type Memory<S: State> = NewmarkMemory;
    type Dense<S: State> = Cubic<S>;

    #[inline]
    fn step<S: State>(
        &self,
        field: &mut impl Field<S>,
        x0: &S,
        memory: &mut NewmarkMemory,
        h: f64,
    ) -> Step<S, Cubic<S>> {
        let Some(layout) = field.layout().copied() else {
            *memory = NewmarkMemory::default();
            return Rk4.step(field, x0, &mut (), h);
        };
        let mut values = MechanicalValues::ZERO;
        let start = Start::of(&layout, x0, h);
        let a = match memory.acceleration {
            Some(a) => a,
            None => start.acceleration(field, &mut values),
        };
        let predicted = start.predicted(&a);
        let middle = start.moved(0.5 * h, &a);
        field.mechanics(1.0, &MechanicalPoint { state: &predicted, h, middle }, &mut values);
        let corrected = Correction::of(&layout, &values, &a, h);
        memory.is_mechanical = true;
        if let Some(row) = values.contacts {
            let moved: f64 = row.iter().zip(&corrected.delta).map(|(k, by)| k * by.abs()).sum();
            memory.touch(h, h * h / 12.0 * moved / self.tolerance, rate(&layout, &values));
        } else if !memory.judge(h, corrected.error, self.tolerance) {
            memory.acceleration = Some(a);
            return Step { is_accepted: false, ..Step::new(Cubic::still(x0)) };
        }
        let end = start.corrected(&predicted, (&corrected, &values));
        let a_end = sum(&a, 1.0, &corrected.delta);
        memory.acceleration = Some(a_end);
        let slopes = [(x0, &a), (&end, &a_end)].map(|(x, a)| start.slope(x, a, (x0, &end)));
        Step::new(Cubic::hermite(x0, &slopes[0], &end, &slopes[1], h))
    }

    #[inline]
    fn steps_apart(&self, _entries: usize) -> bool {
        false
    }
}

fn sum(x: &[f64; MAX_SPEEDS], by: f64, y: &[f64; MAX_SPEEDS]) -> [f64; MAX_SPEEDS] {
    core::array::from_fn(|k| x[k] + by * y[k])
}

/// The start of a step, with its speeds.
struct Start<'a, S> {
    layout: &'a MechanicalLayout,
    x0: &'a S,
    speeds: [f64; MAX_SPEEDS],
    h: f64,
}

impl<'a, S: State> Start<'a, S> {
    #[inline]
    fn of(layout: &'a MechanicalLayout, x0: &'a S, h: f64) -> Self {
        Self { layout, x0, speeds: speeds_of(layout, x0), h }
    }

    /// Computes M⁻¹ Q at the start.
    #[cold]
    fn acceleration(
        &self,
        field: &mut impl Field<S>,
        values: &mut MechanicalValues,
    ) -> [f64; MAX_SPEEDS] {
        let point = MechanicalPoint { state: self.x0, h: 0.0, middle: self.speeds };
        field.mechanics(0.0, &point, values);
        let mut matrix = values.matrix(self.layout, 0.0, 0.0);
        factor(&mut matrix, self.layout.speeds);
        let mut a = [0.0; MAX_SPEEDS];
        for (a, force) in a.iter_mut().zip(values.forces(self.layout)).take(self.layout.speeds) {
            *a = *force;
        }
        solve(&matrix, &mut a, self.layout.speeds);
        a
    }

    #[inline]
    fn moved(&self, h: f64, a: &[f64; MAX_SPEEDS]) -> [f64; MAX_SPEEDS] {
        sum(&self.speeds, h, a)
    }

    /// Returns `x` with each entry moved by a function of its role.
    #[inline]
    fn by_role(&self, x: &S, entry: impl Fn(EntryRole, f64) -> f64) -> S {
        x.map_entries(|i, value| {
            entry(self.layout.roles.get(i).copied().unwrap_or(EntryRole::Slaved), value)
        })
    }

    #[inline]
    fn predicted(&self, a: &[f64; MAX_SPEEDS]) -> S {
        let (h, middle) = (self.h, self.moved(0.5 * self.h, a));
        self.by_role(self.x0, |role, value| match role {
            EntryRole::Coordinate(k) => value + h * at(&middle, k),
            EntryRole::Speed(k) => value + h * at(a, k),
            EntryRole::Internal(_) | EntryRole::Slaved => value,
        })
    }

    #[inline]
    fn corrected(&self, x: &S, (by, values): (&Correction, &MechanicalValues)) -> S {
        let (speed, place) = (0.5 * self.h, by.beta * self.h * self.h);
        let internal = values.internal();
        self.by_role(x, |role, value| match role {
            EntryRole::Coordinate(k) => value + place * at(&by.delta, k),
            EntryRole::Speed(k) => value + speed * at(&by.delta, k),
            EntryRole::Internal(k) => internal.get(usize::from(k)).copied().unwrap_or(value),
            EntryRole::Slaved => value,
        })
    }

    /// Returns the rates at `x`, an end of the step; those of internal states are their mean.
    #[inline]
    fn slope(&self, x: &S, a: &[f64; MAX_SPEEDS], ends: (&S, &S)) -> S {
        let speeds = speeds_of(self.layout, x);
        let rise = ends.1.plus(-1.0, ends.0).times(1.0 / self.h);
        self.by_role(&rise, |role, rise| match role {
            EntryRole::Coordinate(k) => at(&speeds, k),
            EntryRole::Speed(k) => at(a, k),
            EntryRole::Internal(_) | EntryRole::Slaved => rise,
        })
    }
}

#[inline]
fn at(all: &[f64; MAX_SPEEDS], index: u8) -> f64 {
    all.get(usize::from(index)).copied().unwrap_or(0.0)
}

#[inline]
fn speeds_of<S: State>(layout: &MechanicalLayout, x: &S) -> [f64; MAX_SPEEDS] {
    let entries = x.entries();
    layout.entries.map(|entry| entries.get(usize::from(entry)).copied().unwrap_or(0.0))
}

/// The correction of a step's acceleration.
struct Correction {
    delta: [f64; MAX_SPEEDS],
    beta: f64,
    /// Largest force of an element that the correction moves (N).
    error: f64,
}

impl Correction {
    #[inline]
    fn of(
        layout: &MechanicalLayout,
        values: &MechanicalValues,
        a: &[f64; MAX_SPEEDS],
        h: f64,
    ) -> Self {
        /// Margin of the stability limit.
        const MARGIN: f64 = 1.1;
        let n = layout.speeds.min(MAX_SPEEDS);
        let mut test = values.matrix(layout, 0.0, -MARGIN * h * h / 6.0);
        let beta = if factor(&mut test, n) { 1.0 / 12.0 } else { 0.25 };
        let mut matrix = values.matrix(layout, 0.5 * h, beta * h * h);
        factor(&mut matrix, n);
        let mut delta = [0.0; MAX_SPEEDS];
        let pulled = values.momentum(layout, a);
        for ((delta, force), pulled) in
            delta.iter_mut().zip(values.forces(layout)).zip(pulled).take(n)
        {
            *delta = force - pulled;
        }
        solve(&matrix, &mut delta, n);
        let error = h * h / 12.0 * moved_force(layout, values, &delta);
        Self { delta, beta, error }
    }
}

/// Returns the largest |∂f/∂q Δ| of the elements.
#[inline]
fn moved_force(
    layout: &MechanicalLayout,
    values: &MechanicalValues,
    delta: &[f64; MAX_SPEEDS],
) -> f64 {
    let (mut most, mut force, mut current) = (0.0, 0.0_f64, 0);
    let entries = layout.slopes.iter().zip(values.slopes(layout)).take(layout.slope_count);
    for ((element, speed), slope) in entries {
        if *element != current {
            most = force.abs().max(most);
            (force, current) = (0.0, *element);
        }
        force += slope * at(delta, *speed);
    }
    force.abs().max(most)
}

/// Returns √(max Kᵢᵢ/Mᵢᵢ) (rad/s): the rate of a contact that is far stiffer than all else.
#[inline]
fn rate(layout: &MechanicalLayout, values: &MechanicalValues) -> f64 {
    let mass = values.matrix(layout, 0.0, 0.0);
    let stiffness = values.matrix(layout, 0.0, 1.0);
    let pairs = mass.iter().zip(&stiffness).enumerate().take(layout.speeds);
    let squares = pairs.map(|(i, (mass, sum))| (sum[i] - mass[i]) / mass[i]);
    crate::math::sqrt(squares.fold(1.0, f64::max))
}

/// Factors a symmetric matrix in place as L D Lᵀ, by its lower triangle, with reciprocal pivots;
/// returns `false` at the first pivot that is not positive.
#[inline]
fn factor(matrix: &mut SpeedMatrix, n: usize) -> bool {
    let n = n.min(MAX_SPEEDS);
    for j in 0..n {
        let column = matrix.map(|row| row[j]);
        let pivot = column[j];
        if pivot.is_nan() || pivot <= 0.0 {
            return false;
        }
        let inverse = 1.0 / pivot;
        for (i, row) in matrix.iter_mut().enumerate().take(n).skip(j + 1) {
            let by = row[j] * inverse;
            for (entry, upper) in row.iter_mut().zip(&column).take(i + 1).skip(j + 1) {
                *entry -= by * upper;
            }
            row[j] = by;
        }
        matrix[j][j] = inverse;
    }
    true
}

#[inline]
fn solve(factors: &SpeedMatrix, x: &mut [f64; MAX_SPEEDS], n: usize) {
    let n = n.min(MAX_SPEEDS);
    for i in 0..n {
        for k in 0..i {
            x[i] -= factors[i][k] * x[k];
        }
    }
    for i in (0..n).rev() {
        x[i] *= factors[i][i];
        for k in i + 1..n {
            x[i] -= factors[k][i] * x[k];
        }
    }
}
