use crate::State;

/// The surface function h at a point: a slip speed, or the condition of a switch.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Surface<S> {
    /// h: positive above, negative below.
    pub value: f64,
    /// ∂h/∂x, entry by entry, not zero.
    pub gradient: S,
    /// ∂h/∂t at a fixed state: how the input moves the surface (1/s).
    pub drift: f64,
}

impl<S: State> Surface<S> {
    /// Returns the rate of h along the derivative `flow` (1/s).
    pub fn rate(&self, flow: &S) -> f64 {
        self.slope(flow) + self.drift
    }

    /// Returns the rate of h along `direction` at a fixed time.
    pub fn slope(&self, direction: &S) -> f64 {
        let pairs = self.gradient.entries().iter().zip(direction.entries());
        pairs.map(|(a, b)| a * b).sum()
    }
}
