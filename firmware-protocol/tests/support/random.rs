//! Reproducible random numbers.

/// Weyl steps through an avalanche: G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom
/// Number Generators", OOPSLA 2014.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ mixed >> 31
    }

    pub(crate) fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.next() >> 33).expect("31 bits") % end
    }

    pub(crate) fn byte(&mut self) -> u8 {
        self.next().to_le_bytes()[7]
    }

    /// Returns `bytes` unchanged, flipped, cut, grown, padded, or random bytes.
    pub(crate) fn near(&mut self, bytes: &[u8], longest: usize) -> Vec<u8> {
        let mut near = bytes.to_vec();
        let len = self.below(longest + 1);
        match self.below(8) {
            0 => {}
            1 | 2 if !near.is_empty() => {
                let at = self.below(near.len());
                near[at] ^= 1 << self.below(8);
            }
            3 if !near.is_empty() => near[0] = self.byte(),
            4 => near.truncate(len),
            5 => near.resize(len.max(near.len()), 0),
            6 => near.resize_with(len, || self.byte()),
            _ => near = (0..len).map(|_| self.byte()).collect(),
        }
        near
    }
}
