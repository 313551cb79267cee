//! Where random states and inputs are.

use pode::Motion;

use crate::random::Random;

/// The middle and the half width of each entry of the state, and the half width of the input and
/// its rates.
#[derive(Clone, Copy)]
pub(super) struct Span {
    state: [(f64, f64); 4],
    input: [(f64, f64); 4],
}

impl Span {
    pub(super) const fn new(state: [(f64, f64); 4], input: [(f64, f64); 4]) -> Self {
        Self { state, input }
    }

    pub(super) fn random(&self, random: &mut Random) -> ([f64; 4], Motion) {
        let mut draw = |(middle, half): (f64, f64)| middle + half * random.between(-1.0, 1.0);
        let x = self.state.map(&mut draw);
        let [position, rate, acceleration, jerk] = self.input.map(draw);
        (x, Motion { position, rate, acceleration, jerk })
    }
}
