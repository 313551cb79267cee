//! Random numbers from a seed, equal on every machine.

/// The generator `SplitMix64`.
#[derive(Clone, Debug)]
pub struct SeededRandom(u64);

impl SeededRandom {
    pub const fn new(seed: u64, system: u64) -> Self {
        let mut random = Self(seed ^ system.wrapping_mul(0xD134_2543_DE82_EF95));
        random.next();
        random
    }

    const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Returns a uniform number from `lo` to `hi`.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        let part = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        lo + part * (hi - lo)
    }

    /// Returns a number from `lo` to `hi`, both positive, with a uniform logarithm.
    pub fn spread(&mut self, lo: f64, hi: f64) -> f64 {
        self.between(lo.ln(), hi.ln()).exp()
    }

    /// Returns a nearly Gaussian number of mean 0 and variance 1: a sum of twelve.
    pub fn gaussian(&mut self) -> f64 {
        (0..12).map(|_| self.between(-0.5, 0.5)).sum()
    }

    #[expect(clippy::cast_possible_truncation, reason = "below n")]
    pub const fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// Returns `true` with probability 1 / `n`.
    pub const fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }
}
