//! The model with three modes: equations, guards and resets of each.

use super::{Branch, Filippov, Heading, Mode, Sided, Sizes, SurfacePoint, SurfaceSide};
use crate::guard::{GuardId, GuardSpec, GuardValue};
use crate::model::{Guarded, Model, Reset, Resets};
use crate::nature::{EquationKind, Nature};

const MEETS: [GuardId; 2] = [GuardId(0), GuardId(1)];
const LEAVES: [GuardId; 2] = [GuardId(2), GuardId(3)];
const TORN: GuardId = GuardId(4);

const fn free(side: SurfaceSide) -> Branch {
    Branch { side, holds: false }
}

const fn limit(side: SurfaceSide) -> Branch {
    Branch { side, holds: true }
}

fn side_of(guard: GuardId) -> SurfaceSide {
    if guard == MEETS[0] || guard == LEAVES[0] { SurfaceSide::Above } else { SurfaceSide::Below }
}

impl<M: Sided> Model for Filippov<M> {
    type Mode = Mode;
    type State = M::State;
    type Input = M::Input;
    const COORDS: usize = M::COORDS;

    fn derivative(&self, mode: Mode, x: &M::State, input: &M::Input) -> M::State {
        match mode {
            Mode::Above => self.0.derivative(free(SurfaceSide::Above), x, input),
            Mode::Below => self.0.derivative(free(SurfaceSide::Below), x, input),
            Mode::Sliding => SurfacePoint::new(&self.0, x, input).sliding_flow(),
        }
    }

    fn readout(&self, mode: Mode, x: &M::State, input: &M::Input) -> f64 {
        let readout = |branch| self.0.readout(branch, x, input);
        match mode {
            Mode::Above => readout(free(SurfaceSide::Above)),
            Mode::Below => readout(free(SurfaceSide::Below)),
            Mode::Sliding => {
                let share = SurfacePoint::new(&self.0, x, input).limits().share();
                (1.0 - share) * readout(limit(SurfaceSide::Below))
                    + share * readout(limit(SurfaceSide::Above))
            }
        }
    }

    fn nature(&self, mode: Mode) -> Nature {
        let [above, below] =
            [SurfaceSide::Above, SurfaceSide::Below].map(|side| self.0.nature(side));
        match mode {
            Mode::Above => above,
            Mode::Below => below,
            Mode::Sliding => {
                let is_stiff =
                    above.kind == EquationKind::Stiff || below.kind == EquationKind::Stiff;
                let kind = if is_stiff { EquationKind::Stiff } else { EquationKind::Smooth };
                Nature::new(kind, above.rate.max(below.rate))
                    .with_longest_step(above.longest_step.min(below.longest_step))
            }
        }
    }
}

impl<M: Sided> Filippov<M> {
    const ABOVE: [GuardSpec; 1] = [GuardSpec::new(0, "meets from above").scaled(M::SIZE)];
    const BELOW: [GuardSpec; 1] = [GuardSpec::new(1, "meets from below").scaled(M::SIZE)];
    const SLIDING: [GuardSpec; 3] = [
        GuardSpec::new(2, "leaves upwards").scaled(M::RATE),
        GuardSpec::new(3, "leaves downwards").scaled(M::RATE),
        // This guard precedes those that evaluate a share.
        GuardSpec::new(4, "torn off").scaled(M::SLACK).with_priority(0),
    ];
}

impl<M: Sided> Guarded for Filippov<M> {
    fn constrain(&self, mode: Mode, x: &M::State, input: &M::Input) -> M::State {
        /// Each move squares the rest of a jump of [`Sided::SLACK`]; the last removes rounding.
        const MOVES: usize = 4;
        let mut x = *x;
        if mode != Mode::Sliding {
            return x;
        }
        for _ in 0..MOVES {
            let height = self.0.surface(&x, input).value.abs();
            if height == 0.0 || height > M::SLACK {
                break;
            }
            x = SurfacePoint::new(&self.0, &x, input).back();
            if height <= Sizes::<M>::HEIGHT_BAND {
                break;
            }
        }
        x
    }

    fn guards(&self, mode: Mode) -> &'static [GuardSpec] {
        match mode {
            Mode::Above => &Self::ABOVE,
            Mode::Below => &Self::BELOW,
            Mode::Sliding => &Self::SLIDING,
        }
    }

    fn guard(&self, _: Mode, guard: GuardId, x: &M::State, input: &M::Input) -> GuardValue {
        let point = SurfacePoint::new(&self.0, x, input);
        if guard == TORN {
            GuardValue::new(M::SLACK - point.surface().value.abs(), 0.0)
        } else if MEETS.contains(&guard) {
            distance(&point, side_of(guard))
        } else {
            grip(&point, side_of(guard))
        }
    }
}

/// Distance of the state from the surface on its `side`. A side entered tangentially, at the end of
/// a slide, starts at zero with a rate of either sign by rounding. A rate that its change makes up
/// for is zero.
fn distance<M: Sided>(point: &SurfacePoint<'_, M>, side: SurfaceSide) -> GuardValue {
    let surface = point.surface();
    let height = side.sign() * surface.value;
    let rate = side.sign() * surface.rate(&point.flow(free(side)));
    let falls = match side {
        SurfaceSide::Above => Heading::Down,
        SurfaceSide::Below => Heading::Up,
    };
    let is_on = height.abs() <= point.rounding(&surface);
    if is_on && (rate >= 0.0 || point.heading_on(free(side)) != falls) {
        return GuardValue::new(height.max(0.0), rate.max(0.0));
    }
    GuardValue::new(height, rate)
}

/// Speed at which the equations of `side` lead back onto the surface: the hold on the state.
fn grip<M: Sided>(point: &SurfacePoint<'_, M>, side: SurfaceSide) -> GuardValue {
    let rate = point.rate(limit(side));
    let change = point.change(limit(side), &point.sliding_flow());
    let leaves = match side {
        SurfaceSide::Above => Heading::Up,
        SurfaceSide::Below => Heading::Down,
    };
    let grip = -side.sign() * rate;
    let is_hidden = grip < 0.0 && SurfacePoint::<M>::heading_of(rate, change) != leaves;
    GuardValue::new(if is_hidden { 0.0 } else { grip }, -side.sign() * change)
}

impl<M: Sided> Resets for Filippov<M> {
    fn reset(&self, _: Mode, guard: GuardId, x: &M::State, input: &M::Input) -> Reset<Self> {
        let height = self.0.surface(x, input).value;
        if LEAVES.contains(&guard) {
            return Reset::to(side_of(guard).into(), *x);
        }
        if guard == TORN || height.abs() > M::SLACK {
            return Reset::to(if height > 0.0 { Mode::Above } else { Mode::Below }, *x);
        }
        let (mode, x) = self.meet(side_of(guard), x, input);
        Reset::to(mode, x)
    }
}
