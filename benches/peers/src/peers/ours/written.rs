//! A problem of this package as a model of `pode`: contacts whose modes are written out.

use std::fmt::Debug;

use pode::{
    Enclosure, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Model, Nature, Reset, Resets,
    State,
};

use crate::problem::Problem;
use crate::problems::{Ball, Block, Cradle};

/// The problem behind the traits of `pode`; autonomous.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Written<P, const N: usize, const G: usize>(pub(crate) P);

pub(crate) trait Specified {
    type Mode;

    fn specs(mode: Self::Mode) -> &'static [GuardSpec];

    /// Entry of the state that is the only guard of every mode, if any.
    const GUARD: Option<usize> = None;
}

impl Specified for Ball {
    type Mode = ();

    const GUARD: Option<usize> = Some(0);

    fn specs((): ()) -> &'static [GuardSpec] {
        const FLOOR: [GuardSpec; 1] = [GuardSpec::new(0, "floor").of_state()];
        &FLOOR
    }
}

impl Specified for Cradle {
    type Mode = ();

    fn specs((): ()) -> &'static [GuardSpec] {
        const PAIRS: [GuardSpec; 4] = [
            GuardSpec::new(0, "pair0").of_state(),
            GuardSpec::new(1, "pair1").of_state(),
            GuardSpec::new(2, "pair2").of_state(),
            GuardSpec::new(3, "pair3").of_state(),
        ];
        &PAIRS
    }
}

impl Specified for Block {
    type Mode = <Self as Problem<4, 3>>::Mode;

    fn specs(mode: Self::Mode) -> &'static [GuardSpec] {
        const IMPACT: GuardSpec = GuardSpec::new(0, "impact").of_state();
        const SLIDES: [GuardSpec; 2] = [IMPACT, GuardSpec::new(1, "stick").of_state()];
        const STICKS: [GuardSpec; 3] =
            [IMPACT, GuardSpec::new(1, "slip").of_state(), GuardSpec::new(2, "slip").of_state()];
        if mode.slides == 0 { &STICKS } else { &SLIDES }
    }
}

impl<P, const N: usize, const G: usize> Model for Written<P, N, G>
where
    P: Problem<N, G, Mode: Eq + Debug + Send> + Specified<Mode = <P as Problem<N, G>>::Mode>,
    [f64; N]: State,
{
    type Mode = <P as Problem<N, G>>::Mode;
    type State = [f64; N];
    type Input = ();

    const COORDS: usize = N / 2;

    #[inline]
    fn derivative(&self, mode: Self::Mode, x: &[f64; N], (): &()) -> [f64; N] {
        self.0.derivative(mode, 0.0, x)
    }

    fn readout(&self, _: Self::Mode, _: &[f64; N], (): &()) -> f64 {
        0.0
    }

    fn nature(&self, _: Self::Mode) -> Nature {
        self.0.nature()
    }
}

impl<P, const N: usize, const G: usize> Guarded for Written<P, N, G>
where
    P: Problem<N, G, Mode: Eq + Debug + Send> + Specified<Mode = <P as Problem<N, G>>::Mode>,
    [f64; N]: State,
{
    fn guards(&self, mode: Self::Mode) -> &'static [GuardSpec] {
        P::specs(mode)
    }

    #[inline]
    fn guard_bound(&self, _: Self::Mode, _: GuardId, over: &Enclosure<[f64; N], ()>) -> GuardBound {
        P::GUARD.map_or(GuardBound::UNKNOWN, |entry| over.entry(entry))
    }

    #[inline]
    fn guard(&self, mode: Self::Mode, id: GuardId, x: &[f64; N], (): &()) -> GuardValue {
        let (value, rate) = self.0.guard(mode, usize::from(id.0), x);
        GuardValue::new(value, rate)
    }
}

impl<P, const N: usize, const G: usize> Resets for Written<P, N, G>
where
    P: Problem<N, G, Mode: Eq + Debug + Send> + Specified<Mode = <P as Problem<N, G>>::Mode>,
    [f64; N]: State,
{
    fn reset(&self, mode: Self::Mode, id: GuardId, x: &[f64; N], (): &()) -> Reset<Self> {
        let (mode, x) = self.0.fire(mode, usize::from(id.0), x);
        Reset::to(mode, x)
    }
}
