//! Sliding modes (Filippov) and stick: one description of two sides gives all three modes.
//!
//! A surface h(x, u) = 0 separates two sets of equations, f₊ above it and f₋ below. Where both lead
//! onto it, neither can hold: a simulation that switches between them chatters at its own step.
//! Filippov's solution slides along the surface with the one mixture that stays on it:
//!
//! ```text
//! x' = (1 − α) f₋ + α f₊,   α = h'₋ / (h'₋ − h'₊),   so that h' = 0
//! ```
//!
//! Dry friction is the same mechanism, with h the slip speed: sliding along the surface is
//! sticking. [`Sided`] describes the two sides, and [`Filippov`] is the whole model:
//!
//! | mode | holds while | ends where | next |
//! |---|---|---|---|
//! | `Above` | h > 0 | h = 0 | by the rule below |
//! | `Below` | h < 0 | h = 0 | by the rule below |
//! | `Sliding` | h = 0, h'₊ < 0 < h'₋ | h'₊ = 0 | `Above` |
//! | | | h'₋ = 0 | `Below` |
//! | | | the surface jumped away from the state | the side where it left it |
//!
//! At the surface the one-sided rates decide, and where one is zero, its own derivative:
//!
//! | h'₊ | h'₋ | surface | next mode |
//! |---|---|---|---|
//! | − | + | attracts | `Sliding` |
//! | − | − | is crossed downwards | `Below` |
//! | + | + | is crossed upwards | `Above` |
//! | + | − | repels | the side that the state comes from; `Above` if none |
//!
//! A slide ends tangentially, with h = h' = 0 and h'' ≠ 0: the next side departs from there and
//! fires nothing. The state is kept on the surface by a move along f₊ − f₋, the only direction in
//! which an error of the share α can push it, so no error accumulates.
//!
//! # What is not here
//!
//! More than one surface at a time: Filippov leaves the mixture open where two meet.
//!
//! # References
//! `[Fil88]` §4, §10, §19; `[PK08]`, whose event functions these are; `[DL09]` for exit conditions.

mod continued;
mod heading;
mod modes;
mod point;
mod sided;

pub use continued::Continued;
pub use sided::{Branch, Sided, Surface, SurfaceSide};

use heading::Heading;
use point::SurfacePoint;

/// The field that holds, or the slide between both.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    Above,
    Below,
    Sliding,
}

impl From<SurfaceSide> for Mode {
    fn from(side: SurfaceSide) -> Self {
        match side {
            SurfaceSide::Above => Self::Above,
            SurfaceSide::Below => Self::Below,
        }
    }
}

/// A two-sided system as a model with the modes [`Mode`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Filippov<M>(pub M);

impl<M: Sided> Filippov<M> {
    /// Returns the mode of `x`, `Above` where the surface repels, and `x`, moved onto it if there.
    pub fn start(&self, x: &M::State, input: &M::Input) -> (Mode, M::State) {
        let height = self.0.surface(x, input).value;
        if height.abs() > Sizes::<M>::HEIGHT_BAND {
            let side = if height > 0.0 { SurfaceSide::Above } else { SurfaceSide::Below };
            return (side.into(), *x);
        }
        self.meet(SurfaceSide::Above, x, input)
    }

    /// Returns mode and state of a state that reaches the surface `from` a side: the table above. A
    /// state left on the wrong side of its mode by rounding is moved onto the surface.
    fn meet(&self, from: SurfaceSide, x: &M::State, input: &M::Input) -> (Mode, M::State) {
        let height = self.0.surface(x, input).value;
        let foot = SurfacePoint::new(&self.0, x, input).onto_surface();
        let point = SurfacePoint::new(&self.0, &foot, input);
        let mode = match (point.heading(SurfaceSide::Above), point.heading(SurfaceSide::Below)) {
            (Heading::Up, Heading::Down) => from.into(),
            (Heading::Up, Heading::Up | Heading::Still) => Mode::Above,
            (Heading::Down | Heading::Still, Heading::Down) => Mode::Below,
            (Heading::Down | Heading::Still, Heading::Up | Heading::Still) => Mode::Sliding,
        };
        let is_there = match mode {
            Mode::Above => height >= 0.0,
            Mode::Below => height <= 0.0,
            Mode::Sliding => false,
        };
        (mode, if is_there { *x } else { foot })
    }
}

struct Sizes<M>(core::marker::PhantomData<M>);

impl<M: Sided> Sizes<M> {
    const HEIGHT_BAND: f64 = 16.0 * f64::EPSILON * M::SIZE;
    /// Rounding at the size of h's rates (1/s).
    const RATE_BAND: f64 = 16.0 * f64::EPSILON * M::RATE;
    /// Interval over which rates are differenced (s).
    const MOMENT: f64 = M::SIZE / M::RATE / 16_384.0;
    /// Rounding of a differenced rate, with some to spare (1/s²).
    const CHANGE_BAND: f64 = 64.0 * Self::RATE_BAND / Self::MOMENT;
}
