//! Where the energy of a simulation came from and where it went.

use core::ops::Add;

use crate::input::Signal;
use crate::model::Guarded;
use crate::state::State as _;
use crate::watch::{Event, EventCause, Piece, Watch};

/// Energy and powers of a model at one instant, or a part of them.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct EnergyBalance {
    /// Energy stored (J).
    pub energy: f64,
    /// Power that the input's driver puts in (W).
    pub supplied: f64,
    /// Power that dampers and friction take (W).
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
/// [`Energetic::energy`], [`Energetic::supplied`] and [`Energetic::dissipated`] are the sums of
/// [`Energetic::balance_of_state`] and [`Energetic::balance_of_input`]. A model overrides these
/// two where its energy and powers share costly terms.
pub trait Energetic: Guarded {
    /// Energy stored in `x` (J).
    fn energy(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> f64;

    /// Power that the drive of the input puts in (W).
    fn supplied(&self, mode: Self::Mode, x: &Self::State, input: &Self::Input) -> f64;

    /// Power that dampers and friction take (W).
    fn dissipated(&self, _mode: Self::Mode, _x: &Self::State, _input: &Self::Input) -> f64 {
        0.0
    }

    /// Returns the part of the balance that depends on the state alone.
    ///
    /// An audit evaluates it once per state, even where the input jumps.
    #[inline]
    fn balance_of_state(&self, _mode: Self::Mode, _x: &Self::State) -> EnergyBalance {
        EnergyBalance::default()
    }

    /// Returns the rest of the balance.
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

/// Sums of energy (J) since the start:
/// supplied − dissipated + jumps + sampling + integration = stored.
///
/// What a finger does to a model whose input is sampled is `supplied + sampling`: the input moves
/// as it is continued between two samples, and jumps to where it is at each.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct EnergyAudit {
    /// Work done by what drives the input.
    pub supplied: f64,
    /// Taken by dampers and friction.
    pub dissipated: f64,
    /// Change at events: what impacts took (negative) or reset maps added, and what the input did
    /// while many impacts were taken in one move.
    pub jumps: f64,
    /// Change where the input jumps between two ticks, with what is slaved to it.
    pub sampling: f64,
    /// What the method added or took: the integration error, as energy.
    pub integration: f64,
    /// Change of the stored energy.
    pub stored: f64,
    /// Energy stored at the end of what was audited last, if there was any.
    pub level: Option<f64>,
}

impl EnergyAudit {
    /// What the sums leave unexplained (J): rounding.
    pub fn residual(&self) -> f64 {
        let known = self.supplied - self.dissipated + self.jumps + self.sampling;
        self.stored - (known + self.integration)
    }

    /// Adds another audit's sums.
    pub fn add(&mut self, other: &Self) {
        self.supplied += other.supplied;
        self.dissipated += other.dissipated;
        self.jumps += other.jumps;
        self.sampling += other.sampling;
        self.integration += other.integration;
        self.stored += other.stored;
    }

    /// Forgets the level: state or parameters are set anew, by nobody's work.
    pub const fn forget(&mut self) {
        self.level = None;
    }

    /// Goes on at the level `energy` (J); returns how far that is above where the audit was.
    #[inline]
    fn rise_to(&mut self, energy: f64) -> f64 {
        let rise = self.level.map_or(0.0, |level| energy - level);
        self.stored += rise;
        self.level = Some(energy);
        rise
    }

    /// Adds a piece, where the state alone gives the balances `start` and `end` at its ends.
    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn add_piece<M: Energetic, S: Signal<M::Input>>(
        &mut self,
        model: &M,
        piece: &Piece<'_, M, S>,
        (start, end): (EnergyBalance, EnergyBalance),
    ) {
        let mode = piece.mode;
        let (x, input) = piece.middle(model);
        let start = start + model.balance_of_input(mode, &piece.start, &piece.inputs[0]);
        let middle = model.balance_of_state(mode, &x) + model.balance_of_input(mode, &x, &input);
        let end = end + model.balance_of_input(mode, &piece.end, &piece.inputs[1]);
        let h = piece.duration();
        let supplied = h * mean(start.supplied, middle.supplied, end.supplied);
        let dissipated = h * mean(start.dissipated, middle.dissipated, end.dissipated);
        self.supplied += supplied;
        self.dissipated += dissipated;
        let jump = self.rise_to(start.energy);
        // Within a tick a state is only put back on its constraints.
        let before = if piece.theta.0 == 0.0 { &mut self.sampling } else { &mut self.integration };
        *before += jump;
        self.integration += self.rise_to(end.energy) - (supplied - dissipated);
    }

    /// Adds what an event changes.
    fn add_event<M: Energetic>(&mut self, model: &M, event: &Event<'_, M>) {
        let energy = |(mode, x): &(M::Mode, M::State)| model.energy(*mode, x, &event.input);
        let jump = self.rise_to(energy(&event.before));
        let before = match event.cause {
            EventCause::Guard(_) if event.theta == 0.0 => &mut self.sampling,
            EventCause::Guard(_) => &mut self.integration,
            // Many impacts in one move, over which the input goes on.
            EventCause::Impacts(_) | EventCause::Settled => &mut self.jumps,
        };
        *before += jump;
        self.jumps += self.rise_to(energy(&event.after));
    }
}

/// Simpson's rule, of the dense output's own order.
#[inline]
fn mean(start: f64, middle: f64, end: f64) -> f64 {
    (start + 4.0 * middle + end) / 6.0
}

impl<M: Energetic> Watch<M> for EnergyAudit {
    #[inline]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        let [start, end] =
            [&piece.start, &piece.end].map(|x| model.balance_of_state(piece.mode, x));
        self.add_piece(model, piece, (start, end));
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.add_event(model, event);
    }
}

/// An energy audit that evaluates the balance of each state once: the end of a piece is the
/// start of the next.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Auditor<M: Energetic> {
    /// The sums so far.
    pub sums: EnergyAudit,
    /// Evaluations of the balance so far, of the state's part and of the input's, and of the
    /// energy at events.
    pub evaluations: u64,
    /// Mode and state at the end of the last piece, and the balance of that state.
    mode: Option<M::Mode>,
    state: M::State,
    balance: EnergyBalance,
}

impl<M: Energetic> Default for Auditor<M> {
    fn default() -> Self {
        Self {
            sums: EnergyAudit::default(),
            evaluations: 0,
            mode: None,
            state: M::State::ZERO,
            balance: EnergyBalance::default(),
        }
    }
}

impl<M: Energetic> Auditor<M> {
    /// Forgets the last state's balance: the model's parameters have changed.
    pub const fn forget(&mut self) {
        self.mode = None;
        self.sums.forget();
    }
}

/// The balance of a state that no piece has ended in; apart, since it is seldom needed.
#[cold]
#[inline(never)]
fn balance_anew<M: Energetic>(model: &M, mode: M::Mode, x: M::State) -> EnergyBalance {
    model.balance_of_state(mode, &x)
}

impl<M: Energetic> Watch<M> for Auditor<M> {
    #[expect(clippy::inline_always, reason = "a call takes the piece through memory")]
    #[inline(always)]
    fn piece<S: Signal<M::Input>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        let is_known = self.mode == Some(piece.mode) && self.state == piece.start;
        let start =
            if is_known { self.balance } else { balance_anew(model, piece.mode, piece.start) };
        let end = model.balance_of_state(piece.mode, &piece.end);
        // Three of the input, and of the state in the middle, at the end and where it is unknown.
        self.evaluations += 5 + u64::from(!is_known);
        self.sums.add_piece(model, piece, (start, end));
        (self.mode, self.state, self.balance) = (Some(piece.mode), piece.end, end);
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.evaluations += 2;
        self.sums.add_event(model, event);
    }
}
