//! A state near the surface: its one-sided rates, their changes, and its projection onto it.

use super::{Branch, Continued as _, Heading, Sided, Sizes, Surface, SurfaceSide, heading};
use crate::state::State as _;

pub(super) struct SurfacePoint<'a, M: Sided> {
    system: &'a M,
    x: &'a M::State,
    input: &'a M::Input,
}

pub(super) struct SurfaceLimits<S> {
    above: S,
    below: S,
    /// Their rates of h (1/s).
    rate_above: f64,
    rate_below: f64,
}

impl<S> SurfaceLimits<S> {
    /// Returns α, the share of the equations above that keeps h' = 0; between 0 and 1 on a surface
    /// that attracts, and the same formula a little beyond its end.
    pub(super) fn share(&self) -> f64 {
        let share = self.rate_below / (self.rate_below - self.rate_above);
        // Both rates are zero: both sides lead along the surface.
        if share.is_finite() { share } else { 0.5 }
    }
}

impl<'a, M: Sided> SurfacePoint<'a, M> {
    pub(super) const fn new(system: &'a M, x: &'a M::State, input: &'a M::Input) -> Self {
        Self { system, x, input }
    }

    pub(super) fn surface(&self) -> Surface<M::State> {
        self.system.surface(self.x, self.input)
    }

    /// Returns the rounding of h: of its declared size, or of its terms if they are larger.
    pub(super) fn rounding(&self, surface: &Surface<M::State>) -> f64 {
        let pairs = surface.gradient.entries().iter().zip(self.x.entries());
        let terms: f64 = pairs.map(|(a, b)| (a * b).abs()).sum();
        Sizes::<M>::HEIGHT_BAND.max(16.0 * f64::EPSILON * terms)
    }

    pub(super) fn flow(&self, branch: Branch) -> M::State {
        self.system.derivative(branch, self.x, self.input)
    }

    pub(super) fn rate(&self, branch: Branch) -> f64 {
        self.surface().rate(&self.flow(branch))
    }

    /// Returns the change of the rate on `branch` along `flow` (1/s²), by a central difference.
    pub(super) fn change(&self, branch: Branch, flow: &M::State) -> f64 {
        let dt = Sizes::<M>::MOMENT;
        let [late, early] = [dt, -dt].map(|dt| {
            let (x, input) = (self.x.plus(dt, flow), self.input.after(dt));
            SurfacePoint::new(self.system, &x, &input).rate(branch)
        });
        (late - early) / (2.0 * dt)
    }

    pub(super) fn heading(&self, side: SurfaceSide) -> Heading {
        self.heading_on(Branch { side, holds: true })
    }

    pub(super) fn heading_on(&self, branch: Branch) -> Heading {
        let flow = self.flow(branch);
        let rate = self.surface().rate(&flow);
        Self::heading_of(rate, self.change(branch, &flow))
    }

    pub(super) fn heading_of(rate: f64, change: f64) -> Heading {
        let [height, band] = [Sizes::<M>::HEIGHT_BAND, Sizes::<M>::RATE_BAND];
        heading::heading((rate, change), height, band, Sizes::<M>::CHANGE_BAND)
    }

    pub(super) fn limits(&self) -> SurfaceLimits<M::State> {
        let surface = self.surface();
        let [above, below] = [SurfaceSide::Above, SurfaceSide::Below]
            .map(|side| self.flow(Branch { side, holds: true }));
        let (rate_above, rate_below) = (surface.rate(&above), surface.rate(&below));
        SurfaceLimits { above, below, rate_above, rate_below }
    }

    pub(super) fn sliding_flow(&self) -> M::State {
        let limits = self.limits();
        let share = limits.share();
        limits.below.times(1.0 - share).plus(share, &limits.above)
    }

    pub(super) fn onto_surface(&self) -> M::State {
        let surface = self.surface();
        let step = surface.value / surface.slope(&surface.gradient);
        if step.is_finite() { self.x.plus(-step, &surface.gradient) } else { *self.x }
    }

    /// Returns the surface point along f₊ − f₋; the state itself if none is near.
    pub(super) fn back(&self) -> M::State {
        let limits = self.limits();
        // Shift (s) of the share's change that would have kept the state on the surface.
        let time = self.surface().value / (limits.rate_below - limits.rate_above);
        let is_soon = time.abs() <= M::SIZE / M::RATE;
        if !is_soon || limits.rate_below <= limits.rate_above {
            return *self.x;
        }
        self.x.plus(time, &limits.above.plus(-1.0, &limits.below))
    }
}
