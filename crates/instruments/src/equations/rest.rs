//! Rest of a model: an equilibrium of the intended mode, or of another one that holds.

use pode::{Fires, Guarded as _, Matrix as _, Motion, State};

use crate::equations::jacobian_bound::matrix;
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::{DoesNotFit, EquationModel};
use crate::equations::relax::{Descent, is_near};
use crate::equations::table::{Equations, ModeTable};

/// Maximum number of Newton rounds: 4 to 6 from a guess a tenth off; 40 leave room for soft felts.
const ROUNDS: usize = 40;
/// Relative change of each entry below which a step is rounding.
const ROUNDING: f64 = 4e-16;
/// Rate that counts as zero (m/s², or rad/s²): a micrometre in four seconds.
const STILL: f64 = 1e-7;

/// Rate (1/s) at which Newton's method holds what constraints hold: far below any of a mechanism.
const HOLDING: f64 = 1e-4;

/// Rest of a model, and the imbalance if it is no equilibrium.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RestPose<const N: usize> {
    /// Mode at rest; it holds there if any of the model's modes does.
    pub mode: ModeNumber,
    /// State at rest, or the guess if no equilibrium was found near it.
    pub state: [f64; N],
    /// Fastest entry, and its rate (unit of the entry / s); `None` if the forces balance.
    pub imbalance: Option<(usize, f64)>,
}

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns the rest with a preset's values for a key and input 0. Fails as [`Self::new`].
    pub fn rest_of_preset(
        functions: F,
        (preset, key): (usize, u8),
    ) -> Result<RestPose<N>, DoesNotFit> {
        let mut values = [0.0; C];
        Self::without_natures(functions.clone(), &[])?.preset(preset, key, &mut values);
        let model = Self::without_natures(functions, &values)?;
        Ok(model.rest_pose(&Motion::default()))
    }

    /// Returns mode and state at rest under a constant input, or the start that the table states.
    /// Bounded as [`Self::rest_pose`], but intended for once per voice.
    pub fn at_rest(&self, input: &Motion) -> (ModeNumber, [f64; N]) {
        let RestPose { mode, state, .. } = self.rest_pose(input);
        (mode, state)
    }

    /// Returns the rest with the imbalance of the forces.
    ///
    /// The mode is the table's if its equilibrium violates none of its guards, else the first other
    /// such mode. A mode without equilibrium near the table's guess rests at the guess.
    ///
    /// # Real-time
    /// Bounded: per mode two descents of 240 steps, and Newton's method twice, at most 40 rounds
    /// each. The first mode needs some 20 of all these steps.
    pub fn rest_pose(&self, input: &Motion) -> RestPose<N> {
        let still = Motion { position: input.position, ..Motion::default() };
        let first = self.rest_mode(&still);
        let own = self.rest_in(first, &still);
        let pose = if !self.table().rest.is_improved || self.is_valid(&own, &still) {
            own
        } else {
            let numbers = (0..).zip(&self.table().modes).map(|(number, _)| ModeNumber(number));
            let mut others = numbers
                .filter(|mode| *mode != first)
                .map(|mode| self.rest_in(mode, &still))
                .filter(|pose| self.is_valid(pose, &still));
            others.next().unwrap_or(own)
        };
        RestPose { state: self.constrain(pose.mode, &pose.state, input), ..pose }
    }

    /// Returns the rest of the table's mode, even if the mode is over there.
    pub(crate) fn own_rest(&self, input: &Motion) -> [f64; N] {
        self.rest_in(self.rest_mode(input), input).state
    }

    fn rest_mode(&self, input: &Motion) -> ModeNumber {
        let rest = &self.table().rest;
        let is_met = |when| {
            let [margin] = self.values(when, &[0.0; N], input);
            margin > 0.0
        };
        let other = rest.instead.iter().find(|(when, _)| is_met(*when));
        ModeNumber(other.map_or(rest.mode, |(_, mode)| *mode))
    }

    fn rest_in(&self, mode: ModeNumber, input: &Motion) -> RestPose<N> {
        let rest = &self.table().rest;
        let mut guess = [0.0; N];
        self.call(rest.state, &[0.0; N], input, &mut guess);
        let guess = self.constrain(mode, &guess, input);
        if !rest.is_improved {
            return RestPose { mode, state: guess, imbalance: None };
        }
        let found = self.balanced(mode, &guess, input);
        let state = found.unwrap_or(guess);
        let (entry, rate) = self.fastest_entry(self.mode_table(mode), &state, input);
        let is_balanced = found.is_some() || rate <= STILL;
        RestPose { mode, state, imbalance: (!is_balanced).then_some((entry, rate)) }
    }

    /// Returns `true` if the pose is an equilibrium at which the mode is not over.
    fn is_valid(&self, pose: &RestPose<N>, input: &Motion) -> bool {
        const TOUCHING: f64 = -1e-9;
        let mut guards =
            self.guards(pose.mode).iter().filter(|it| it.fires == Fires::WhileNegative);
        pose.imbalance.is_none()
            && guards.all(|it| {
                self.guard(pose.mode, it.id, &pose.state, input).value >= TOUCHING * it.scale
            })
    }

    /// Finds the equilibrium near `guess` by Newton's method, after a descent if something is near.
    fn balanced(&self, mode: ModeNumber, guess: &[f64; N], input: &Motion) -> Option<[f64; N]> {
        let at_once = || self.equilibrium(mode, guess, input);
        let by = |descent| {
            let low = self.relaxed(mode, guess, input, descent);
            self.settled(mode, &low, input)
        };
        let downhill = || by(Descent::Energy).or_else(|| by(Descent::Imbalance));
        if self.mode_table(mode).contacts.is_empty() {
            at_once().or_else(downhill)
        } else {
            downhill().or_else(at_once)
        }
    }

    /// Refines the end of a descent to rounding by Newton's method. Where that fails, since the
    /// model can move without a force, the end of the descent may be an equilibrium.
    fn settled(&self, mode: ModeNumber, low: &[f64; N], input: &Motion) -> Option<[f64; N]> {
        /// Maximum distance of Newton's method from the end of the descent, relative to an entry.
        const NEAR: f64 = 1e-3;
        let exact = self.equilibrium(mode, low, input).filter(|exact| is_near(low, exact, NEAR));
        let is_still = || self.fastest_entry(self.mode_table(mode), low, input).1 <= STILL;
        exact.or_else(|| is_still().then_some(*low))
    }

    fn equilibrium(&self, mode: ModeNumber, guess: &[f64; N], input: &Motion) -> Option<[f64; N]> {
        let table = self.mode_table(mode);
        let moving = table.parts.iter().fold(0, |all, part| all | part.entries);
        let mut x = *guess;
        for _ in 0..ROUNDS {
            let step = self.newton_step(table, moving, &x, input)?;
            x = self.constrain(mode, &x.plus(1.0, &step), input);
            if is_near(&x, &x.plus(1.0, &step), ROUNDING) {
                return Some(x);
            }
        }
        // Oscillation in the last digits is as good.
        (self.fastest_entry(table, &x, input).1 <= STILL).then_some(x)
    }

    /// Takes a step of Newton's method towards a zero of the moving entries' rates.
    fn newton_step(
        &self,
        table: &ModeTable,
        moving: u64,
        x: &[f64; N],
        input: &Motion,
    ) -> Option<[f64; N]> {
        let has = |index: usize| index < self.table().states.len() && moving >> index & 1 == 1;
        let (rates, rows) = self.held_up(table, x, input);
        let imbalance = core::array::from_fn(|i| if has(i) { rates[i] } else { 0.0 });
        // 1 − M is minus the Jacobian where something moves, and 1 elsewhere.
        // Across constraints that multipliers hold, rates say nothing.
        let own = if table.constraints.is_held { 1.0 - HOLDING } else { 1.0 };
        let unit = |i: usize, j: usize| if i == j { own } else { 0.0 };
        let entry = |i, j| if has(i) && has(j) { unit(i, j) + rows[i][j] } else { 0.0 };
        let shifted = core::array::from_fn(|i| core::array::from_fn(|j| entry(i, j)));
        let shifted: <[f64; N] as State>::Matrix = matrix(&shifted);
        let factored = shifted.factor(1.0);
        <[f64; N] as State>::Matrix::solve(&factored, &imbalance)
            .filter(|step| step.iter().all(|entry| entry.is_finite()))
    }
}
