//! Lengths of CAN FD frames.

pub const LENGTHS: [usize; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64];

/// Returns the shortest length of a CAN FD frame for `len` bytes, at most 64.
pub const fn padded(len: usize) -> usize {
    let mut i = 0;
    while i < LENGTHS.len() {
        if len <= LENGTHS[i] {
            return LENGTHS[i];
        }
        i += 1;
    }
    crate::MAX_FRAME
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_length_is_padded_to_the_next_that_the_bus_has() {
        for (len, expected) in [(0, 0), (8, 8), (9, 12), (26, 32), (37, 48), (48, 48), (59, 64)] {
            assert_eq!(padded(len), expected);
        }
        assert_eq!(padded(65), 64);
    }
}
