//! Models that cause as much work as possible.

use pode::{
    GuardId, GuardSpec, GuardValue, Guarded, Model, Nature, Reset, Resets, Settling, State,
};

/// Time, a count of resets, and nothing: x' = (1, 0, 0).
#[derive(Clone, Copy)]
pub(crate) struct Busy {
    pub(crate) guards: &'static [GuardSpec],
    pub(crate) guard: fn(GuardId, [f64; 3]) -> GuardValue,
    pub(crate) nature: Nature,
    pub(crate) longest_step: f64,
    pub(crate) goes_on: bool,
    /// Duration (s) of the impacts that every reset declares, if it does.
    pub(crate) settles: Option<f64>,
}

impl Busy {
    pub(crate) const IDLE: Self = Self {
        guards: &[],
        guard: |_, _| GuardValue::new(1.0, 0.0),
        nature: Nature::new(pode::EquationKind::Smooth, 0.0),
        longest_step: f64::INFINITY,
        goes_on: false,
        settles: None,
    };
}

impl Model for Busy {
    type Mode = bool;
    type State = [f64; 3];
    type Input = ();
    const COORDS: usize = 2;

    fn derivative(&self, _: bool, _: &[f64; 3], (): &()) -> [f64; 3] {
        [1.0, 0.0, 0.0]
    }

    fn jacobian(&self, _: bool, _: &[f64; 3], (): &()) -> <[f64; 3] as State>::Matrix {
        pode::Matrix::from_columns(|_| [0.0; 3])
    }

    fn nature(&self, _: bool) -> Nature {
        self.nature.with_longest_step(self.longest_step)
    }
}

impl Guarded for Busy {
    fn guards(&self, _: bool) -> &'static [GuardSpec] {
        self.guards
    }

    fn guard(&self, _: bool, id: GuardId, x: &[f64; 3], (): &()) -> GuardValue {
        (self.guard)(id, *x)
    }
}

impl Resets for Busy {
    fn reset(&self, mode: bool, _: GuardId, x: &[f64; 3], (): &()) -> Reset<Self> {
        let mode = mode != self.goes_on;
        let state = [x[0], x[1] + 1.0, x[2]];
        let reset = Reset::to(mode, state);
        match self.settles {
            Some(after) => {
                reset.settling(Settling { after, ratio: 0.5, mode, state, impulse: 0.0 })
            }
            None => reset,
        }
    }
}

/// A huge right-hand side, of another sign at every place of the tick.
#[derive(Clone, Copy)]
pub(crate) struct Stirred;

impl Model for Stirred {
    type Mode = ();
    type State = [f64; 1];
    type Input = f64;
    const COORDS: usize = 1;

    fn derivative(&self, (): (), _: &[f64; 1], theta: &f64) -> [f64; 1] {
        let scattered = theta.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40;
        [1e100 * (scattered as f64 - 8e6)]
    }
}

impl Guarded for Stirred {}

impl Resets for Stirred {}
