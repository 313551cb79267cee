//! Sources and sinks of a simulation's energy.

use core::ops::Add;

use crate::input::Signal;
use crate::model::Guarded;
use crate::state::State as _;
use crate::stepper::PowerRule;
use crate::watch::{Event, EventCause, Piece, Watch};

/// Energy and powers of a model at one instant, or a part of them.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct EnergyBalance {
    /// Energy stored (J).
    pub energy: f64,
    /// Power from the input's driver (W).
    pub supplied: f64,
    /// Power that dampers and friction absorb (W).
    pub dissipated: f64,
}

impl Add for EnergyBalance {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            energy: self.energy + other.energy,
            supplied: self.supplied + other.supplied,
            dissipated: self.dissipated + other.dissipated,
        }
    }
}

/// A model that can account for its energy.
///
/// Models with costly common terms override [`Energetic::balance_of_state`] and `balance_of_input`.
pub trait Energetic: Guarded {
    /// Returns the energy stored in `x` (J).
    fn energy(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> f64;

    /// Returns the power from the input's driver (W).
    fn supplied(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> f64;

    /// Returns the power that dampers and friction absorb (W).
    fn dissipated(&self, _mode: Self::Mode, _x: &Self::State, _input: &Self::Input) -> f64 {
        0.0
    }

    /// Returns the share of the balance that depends on the state alone, evaluated once per state.
    #[inline]
    fn balance_of_state(&self, _mode: Self::Mode, _x: &Self::State) -> EnergyBalance {
        EnergyBalance::default()
    }

    #[inline]
    fn balance_of_input(
        &self,
        mode: Self::Mode,
        x: &Self::State,
        input: &Self::Input,
    ) -> EnergyBalance {
        EnergyBalance {
            energy: self.energy(mode, x, input),
            supplied: self.supplied(mode, x, input),
            dissipated: self.dissipated(mode, x, input),
        }
    }
}

/// Energy sums (J) since the start:
/// supplied − dissipated + jumps + sampling + integration = stored.
///
/// A finger does the work `supplied + sampling` on a model with a sampled input: between two
/// samples the input is extrapolated, and at each sample it jumps to the measured value.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct EnergyAudit {
    pub supplied: f64,
    pub dissipated: f64,
    /// Change at events: impacts (negative), reset maps, and the input's work in a move.
    pub jumps: f64,
    /// Change where the input and the entries slaved to it jump between two ticks, and where an
    /// input that jumps through a guard moves coordinates.
    pub sampling: f64,
    /// Integration error, as energy.
    pub integration: f64,
    pub stored: f64,
    pub level: Option<f64>,
}

impl EnergyAudit {
    /// Returns the unexplained rest of the sums (J): rounding.
    pub fn residual(&self) -> f64 {
        let known = self.supplied - self.dissipated + self.jumps + self.sampling;
        self.stored - (known + self.integration)
    }

    pub fn add(&mut self, other: &Self) {
        self.supplied += other.supplied;
        self.dissipated += other.dissipated;
        self.jumps += other.jumps;
        self.sampling += other.sampling;
        self.integration += other.integration;
        self.stored += other.stored;
    }

    /// Clears the level: a change of state or parameters does no work.
    pub const fn forget(&mut self) {
        self.level = None;
    }

    /// Sets the level to `energy` (J); returns its rise since the last piece.
    #[inline]
    fn rise_to(&mut self, energy: f64) -> f64 {
        let rise = self.level.map_or(0.0, |level| energy - level);
        self.stored += rise;
        self.level = Some(energy);
        rise
    }

    /// Adds a piece with the balances at its ends.
    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn add_piece<M: Energetic, S: Signal<M::Input>>(
        &mut self,
        model: &M,
        piece: &Piece<'_, M, S>,
        (start, end): (EnergyBalance, EnergyBalance),
    ) {
        let mode = piece.mode;
        let (middle, absorbed) = match piece.powers {
            PowerRule::Simpson => {
                let (x, input) = piece.middle(model);
                let middle =
                    model.balance_of_state(mode, &x) + model.balance_of_input(mode, &x, &input);
                (Some(middle), 0.0)
            }
            PowerRule::Trapezoid { absorbed } => (None, absorbed * piece.tau),
        };
        let h = piece.duration();
        let supplied = h * mean(start.supplied, middle.map(|it| it.supplied), end.supplied);
        let dissipated = h * mean(start.dissipated, middle.map(|it| it.dissipated), end.dissipated);
        self.supplied += supplied;
        let dissipated = dissipated + absorbed;
        self.dissipated += dissipated;
        let jump = self.rise_to(start.energy);
        // Within a tick a state is only put back on its constraints.
        let before = if piece.theta.0 == 0.0 { &mut self.sampling } else { &mut self.integration };
        *before += jump;
        self.integration += self.rise_to(end.energy) - (supplied - dissipated);
    }

    /// Adds an event; returns the number of evaluations of the energy.
    fn add_event<M: Energetic>(&mut self, model: &M, event: &Event<'_, M>) -> u64 {
        let energy = |(mode, x): &(M::Mode, M::State)| model.energy(*mode, x, &event.input);
        let jump = self.rise_to(energy(&event.before));
        let before = match event.cause {
            EventCause::Guard(_) if event.theta == 0.0 => &mut self.sampling,
            EventCause::Guard(_) => &mut self.integration,
            EventCause::Impacts(_) | EventCause::Settled => &mut self.jumps,
        };
        *before += jump;
        let mut evaluations = 2;
        if event.leap(model).is_some() {
            let ((mode, before), (_, after)) = (&event.before, &event.after);
            let moved = after.head_of(model.coordinates(), before);
            self.sampling += self.rise_to(energy(&(*mode, moved)));
            evaluations += 1;
        }
        self.jumps += self.rise_to(energy(&event.after));
        evaluations
    }
}

/// Simpson's rule, of the same order as the dense output; the trapezoidal rule without a middle.
#[inline]
fn mean(start: f64, middle: Option<f64>, end: f64) -> f64 {
    let middle = middle.unwrap_or(0.5 * (start + end));
    (start + 4.0 * middle + end) / 6.0
}

impl<M: Energetic> Watch<M> for EnergyAudit {
    #[inline]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        let ends = [(&piece.start, &piece.inputs[0]), (&piece.end, &piece.inputs[1])];
        let [start, end] = ends.map(|(x, input)| {
            model.balance_of_state(piece.mode, x) + model.balance_of_input(piece.mode, x, input)
        });
        self.add_piece(model, piece, (start, end));
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.add_event(model, event);
    }
}

/// An energy audit that evaluates each balance once: a piece starts where the last ended, and within
/// a tick with the same input.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Auditor<M: Energetic> {
    pub sums: EnergyAudit,
    /// Evaluations of the balance, by state and by input, and of the energy at events.
    pub evaluations: u64,
    last: Option<LastEnd<M>>,
}

/// The end of the last piece, with its balance by the state, and whole.
#[derive(Clone, Copy, PartialEq, Debug)]
struct LastEnd<M: Energetic> {
    mode: M::Mode,
    state: M::State,
    input: M::Input,
    of_state: EnergyBalance,
    whole: EnergyBalance,
}

impl<M: Energetic> Default for Auditor<M> {
    fn default() -> Self {
        Self { sums: EnergyAudit::default(), evaluations: 0, last: None }
    }
}

impl<M: Energetic> Auditor<M> {
    /// Clears the last state's balance after a change of the model's parameters.
    pub const fn forget(&mut self) {
        self.last = None;
        self.sums.forget();
    }
}

/// Computes the balance of a state that ended no piece; out of line, since it is seldom needed.
#[cold]
#[inline(never)]
fn balance_anew<M: Energetic>(model: &M, mode: M::Mode, x: M::State) -> EnergyBalance {
    model.balance_of_state(mode, &x)
}

impl<M: Energetic> Watch<M> for Auditor<M> {
    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        let [input, end_input] = piece.inputs;
        let mode = piece.mode;
        let known = self.last.as_ref().filter(|it| it.mode == mode && it.state == piece.start);
        let start = match known {
            Some(it) if it.input == input => it.whole,
            Some(it) => it.of_state + model.balance_of_input(mode, &piece.start, &input),
            None => {
                balance_anew(model, mode, piece.start)
                    + model.balance_of_input(mode, &piece.start, &input)
            }
        };
        let of_state = model.balance_of_state(mode, &piece.end);
        let end = of_state + model.balance_of_input(mode, &piece.end, &end_input);
        // Of input and state at each place that is not known.
        let at_start = known.map_or(2, |it| u64::from(it.input != input));
        let inside = if piece.powers == PowerRule::Simpson { 2 } else { 0 };
        self.evaluations += 2 + inside + at_start;
        self.sums.add_piece(model, piece, (start, end));
        self.last =
            Some(LastEnd { mode, state: piece.end, input: end_input, of_state, whole: end });
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.evaluations += self.sums.add_event(model, event);
    }
}
