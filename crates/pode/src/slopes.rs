use crate::input::Motion;
use crate::model::Guarded;

/// Slopes of the readout by the input, at one instant: between ticks a board renders
/// F0 + `per_position` (s − s0) + `per_rate` (s' − s0').
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ReadoutSlopes {
    /// ∂F/∂s (readout / unit of the input).
    pub per_position: f64,
    /// ∂F/∂s' (readout × s / unit of the input).
    pub per_rate: f64,
}

/// A model whose readout has slopes; coordinates slaved to the input move with it.
pub trait Sloped: Guarded<Input = Motion> {
    /// Returns the slopes in `mode` at `x`; by default central differences.
    fn slopes(&self, mode: Self::Mode, x: &Self::State, input: &Motion) -> ReadoutSlopes {
        differenced_slopes(self, mode, x, input)
    }
}

/// Computes the slopes of a model's readout by central differences.
pub fn differenced_slopes<M: Guarded<Input = Motion> + ?Sized>(
    model: &M,
    mode: M::Mode,
    x: &M::State,
    input: &Motion,
) -> ReadoutSlopes {
    /// Fraction of the input's size by which it is moved; forces are nearly linear in it.
    const PART: f64 = 1e-6;
    let readout = |input: &Motion| model.readout(mode, &model.constrain(mode, x, input), input);
    let slope = |size: f64, moved: &dyn Fn(f64) -> Motion| {
        let by = PART * (1e-2 + size.abs());
        (readout(&moved(by)) - readout(&moved(-by))) / (2.0 * by)
    };
    let position = |by: f64| Motion { position: input.position + by, ..*input };
    let rate = |by: f64| Motion { rate: input.rate + by, ..*input };
    ReadoutSlopes {
        per_position: slope(input.position, &position),
        per_rate: slope(input.rate, &rate),
    }
}
