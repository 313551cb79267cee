//! Linearises motion and readout of a model that is held in one of its modes.
//!
//! In a mode x' = f(x, u) and y = r(x, u), with the input u = (s, s', s'', s'''). Slopes at one
//! point give y = (d(p) + c (p − A)⁻¹ b(p)) s with b(p) = Σ bₖ pᵏ, and Z = y/(p s), p = jω.
//! Entries that the mode slaves to the input are no states.

use figures::digits::rounded;
use instruments::{LoadedModel, ModeName, Playable, Visitor};
use nalgebra_of_lm::{Complex, DMatrix, DVector};
use pode::{Advance, Limits, Motion, Silent, Simulator, stepper::Any};

use crate::impedance::curve::{ImpedanceCurve, ImpedancePoint};
use crate::impedance::sampled::{APPROACH, smooth};

/// Time at rest after the way down (s).
const REST: f64 = 1.0;
/// Tick of the way down (s).
const TICK: f64 = 1e-3;

/// Displacement for a slope, as a fraction of a value's size.
const PART: f64 = 1e-6;
/// Usual size of a coordinate (m, rad), and of its rates up to the third.
const SIZES: [f64; 4] = [1e-2, 1.0, 10.0, 1e3];

/// Maximum Newton steps to a mode's rest, and the relative step that ends them.
const MOST_STEPS: usize = 40;
const NO_STEP: f64 = 1e-10;

/// A model with values, at a depth of its key.
#[derive(Clone, Copy, Debug)]
pub struct HeldMode<'a> {
    pub model: &'a LoadedModel,
    pub values: &'a [f64],
    /// Structural mode; `None` for that in which the model rests.
    pub mode: Option<&'a str>,
    /// Travel of the key's front (m).
    pub depth: f64,
}

/// Presses the key slowly to its depth, and linearises the model there.
///
/// # Errors
/// If the mode is unknown or the model fails, in a sentence.
pub fn linearise(held: &HeldMode<'_>) -> Result<LinearMode, String> {
    held.model.visit(Lineariser(held))
}

/// Linear model around a point of one mode.
#[derive(Clone, Debug)]
pub struct LinearMode {
    pub mode: String,
    /// Force on the finger there (N).
    pub force: f64,
    /// `true` if the point is at rest; otherwise the model passes through it.
    pub is_at_rest: bool,
    scale: f64,
    a: DMatrix<f64>,
    b: [DVector<f64>; 4],
    c: DVector<f64>,
    d: [f64; 4],
}

impl LinearMode {
    /// Returns the impedance at `frequency` (Hz); `None` at an undamped resonance.
    pub fn at(&self, frequency: f64) -> Option<Complex<f64>> {
        let p = Complex::new(0.0, std::f64::consts::TAU * frequency);
        let mut powers = [Complex::new(1.0, 0.0); 4];
        for order in 1..powers.len() {
            powers[order] = powers[order - 1] * p;
        }
        let mut sum: Complex<f64> = self.d.iter().zip(powers).map(|(d, power)| power * *d).sum();
        if !self.c.is_empty() {
            let state = self.driven(&powers)?;
            sum += self.c.iter().zip(state.iter()).map(|(c, x)| x * *c).sum::<Complex<f64>>();
        }
        let z = sum * (self.scale * self.scale) / p;
        (z.re.is_finite() && z.im.is_finite()).then_some(z)
    }

    /// Returns the state per input: (p − A)⁻¹ b(p), with the powers of p.
    fn driven(&self, powers: &[Complex<f64>; 4]) -> Option<DVector<Complex<f64>>> {
        let size = self.c.len();
        let input = |row: usize| self.b.iter().zip(powers).map(|(b, it)| it * b[row]).sum();
        let driven = DVector::<Complex<f64>>::from_fn(size, |row, _| input(row));
        let own = DMatrix::from_diagonal_element(size, size, powers[1]);
        (own - self.a.map(Complex::from)).lu().solve(&driven)
    }

    /// Returns the impedance at `frequencies` (Hz).
    pub fn curve(&self, frequencies: &[f64]) -> ImpedanceCurve {
        let point = |it: &f64| Some(ImpedancePoint::exact(*it, self.at(*it)?));
        let force = rounded(self.force);
        let remark = if self.is_at_rest {
            format!("at rest under {force} N")
        } else {
            format!("not at rest there; the force is {force} N")
        };
        let name = format!("mode {}", self.mode);
        ImpedanceCurve { name, remark, points: frequencies.iter().filter_map(point).collect() }
    }
}

struct Lineariser<'a>(&'a HeldMode<'a>);

impl Visitor for Lineariser<'_> {
    type Output = Result<LinearMode, String>;

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let HeldMode { values, mode, depth, .. } = *self.0;
        let model = model.with_values(values);
        let scale = model.input_per_metre();
        let (resting, rest) = pressed(model.clone(), scale * depth)
            .ok_or_else(|| format!("{} cannot be followed to {depth} m", model.entry().name))?;
        let input = Motion { position: scale * depth, ..Motion::default() };
        let structure = |mode| model.mode_code(mode).structure();
        let (mode, state) = match mode {
            None => (resting, rest),
            Some(name) => {
                let found = model.modes().find(|it| it.1 == name);
                let (found, _) = found.ok_or_else(|| format!("there is no mode {name}"))?;
                let is_resting = structure(found) == structure(resting);
                if is_resting { (resting, rest) } else { model.begin(found, &rest, &input) }
            }
        };
        let free = free_entries(&model, mode);
        let place = ModePlace { model, mode, input, free };
        Ok(place.linear(scale, &state))
    }
}

/// Moves the input slowly to `to` (its unit), and waits; `None` if the model fails.
fn pressed<M: Playable>(model: M, to: f64) -> Option<(M::Mode, M::State)> {
    let stepper = Any::named("rodas3").unwrap_or_default();
    let limits = Limits { longest_step: TICK, ..Limits::default() };
    let (mode, state) = model.at_rest(&Motion::default());
    let mut simulator = Simulator::new(model, stepper, limits, mode, state);
    let mut t = 0.0;
    while t < APPROACH + REST {
        let signal = |theta: f64| approach(to, t + theta * TICK);
        let tick = simulator.advance(TICK, &signal, &mut Silent);
        if matches!(tick.advance, Advance::Faulty(_)) {
            return None;
        }
        t += TICK;
    }
    Some((simulator.mode(), *simulator.state()))
}

/// Returns a motion from 0 to `to` at `t` (s), with zero speed at both ends.
fn approach(to: f64, t: f64) -> Motion {
    let x = (t / APPROACH).clamp(0.0, 1.0);
    let speed = to / APPROACH;
    Motion {
        position: to * smooth(x),
        rate: speed * 6.0 * x * (1.0 - x),
        acceleration: speed / APPROACH * if x < 1.0 { 6.0 - 12.0 * x } else { 0.0 },
        jerk: 0.0,
    }
}

fn free_entries<M: Playable>(model: &M, mode: M::Mode) -> Vec<usize> {
    let parts = model.parts(mode);
    let states = 0..model.entry().states.len();
    states.filter(|entry| parts.iter().any(|part| part.has(*entry))).collect()
}

struct ModePlace<M: Playable> {
    model: M,
    mode: M::Mode,
    input: Motion,
    free: Vec<usize>,
}

impl<M: Playable> ModePlace<M> {
    fn linear(&self, scale: f64, state: &M::State) -> LinearMode {
        let rest = self.rest(state);
        let is_at_rest = rest.is_some();
        let state = rest.unwrap_or(*state);
        let inputs = [0, 1, 2, 3].map(|order| {
            let size = PART * (SIZES[order] + component(&self.input, order).abs());
            let moved = |by: f64| moved(&self.input, order, by);
            let [high, low] = [size, -size].map(|by| self.rates(&state, &moved(by)));
            let (up, down) =
                (self.readout(&state, &moved(size)), self.readout(&state, &moved(-size)));
            ((high - low) / (2.0 * size), (up - down) / (2.0 * size))
        });
        let slopes = self.free.iter().map(|entry| {
            let (size, [up, down]) = self.beside(&state, *entry);
            (self.readout(&up, &self.input) - self.readout(&down, &self.input)) / (2.0 * size)
        });
        let mode = self.model.mode_code(self.mode);
        LinearMode {
            mode: ModeName { model: self.model.shared(), mode }.to_string(),
            force: scale * self.readout(&state, &self.input),
            is_at_rest,
            scale,
            a: self.jacobian(&state),
            c: DVector::from_iterator(self.free.len(), slopes),
            d: inputs.each_ref().map(|it| it.1),
            b: inputs.map(|it| it.0),
        }
    }

    /// Searches by Newton a point of rest near `state` with no guard below zero.
    fn rest(&self, state: &M::State) -> Option<M::State> {
        let mut state = *state;
        if self.free.is_empty() {
            return self.holds(&state).then_some(state);
        }
        for _step in 0..MOST_STEPS {
            let rates = self.rates(&state, &self.input);
            let svd = self.jacobian(&state).svd(true, true);
            let least = 1e-12 * svd.singular_values.max();
            let step = svd.solve(&-rates, least).ok()?;
            for (entry, by) in self.free.iter().zip(step.iter()) {
                state.as_mut()[*entry] += by;
            }
            if step.amax() < NO_STEP {
                break;
            }
        }
        let state = self.model.constrain(self.mode, &state, &self.input);
        // Rates that the last step leaves, of the stiffest entry; gravity in free flight is more.
        let slope = self.jacobian(&state).abs().max().max(1.0);
        let is_still = self.rates(&state, &self.input).amax() < 10.0 * NO_STEP * slope;
        (is_still && self.holds(&state)).then_some(state)
    }

    fn holds(&self, state: &M::State) -> bool {
        let watched = self.model.guards(self.mode).iter();
        let mut watched = watched.filter(|it| self.model.is_watched(self.mode, it.id));
        watched.all(|it| {
            let value = self.model.guard(self.mode, it.id, state, &self.input).value;
            value >= -1e-9 * it.scale
        })
    }

    fn jacobian(&self, state: &M::State) -> DMatrix<f64> {
        let columns = self.free.iter().map(|entry| {
            let (size, [up, down]) = self.beside(state, *entry);
            (self.rates(&up, &self.input) - self.rates(&down, &self.input)) / (2.0 * size)
        });
        let columns: Vec<_> = columns.collect();
        DMatrix::from_fn(columns.len(), columns.len(), |row, column| columns[column][row])
    }

    fn beside(&self, state: &M::State, entry: usize) -> (f64, [M::State; 2]) {
        let order = usize::from(entry >= self.model.coordinates());
        let mut sides = [*state; 2];
        let size = PART * (SIZES[order] + sides[0].as_mut()[entry].abs());
        for (side, by) in sides.iter_mut().zip([size, -size]) {
            side.as_mut()[entry] += by;
        }
        (size, sides)
    }

    fn rates(&self, state: &M::State, input: &Motion) -> DVector<f64> {
        let whole = self.model.constrain(self.mode, state, input);
        let mut rates = self.model.derivative(self.mode, &whole, input);
        let rates = self.free.iter().map(|entry| rates.as_mut()[*entry]);
        DVector::from_iterator(self.free.len(), rates)
    }

    fn readout(&self, state: &M::State, input: &Motion) -> f64 {
        let whole = self.model.constrain(self.mode, state, input);
        self.model.readout(self.mode, &whole, input)
    }
}

const fn component(motion: &Motion, order: usize) -> f64 {
    match order {
        0 => motion.position,
        1 => motion.rate,
        2 => motion.acceleration,
        _ => motion.jerk,
    }
}

const fn moved(motion: &Motion, order: usize, by: f64) -> Motion {
    let mut motion = *motion;
    match order {
        0 => motion.position += by,
        1 => motion.rate += by,
        2 => motion.acceleration += by,
        _ => motion.jerk += by,
    }
    motion
}
