//! Consistent overhead byte stuffing: the same bytes without a zero among them.

/// Bytes that stuffing adds to at most 254.
pub(super) const OVERHEAD: usize = 1;

/// Writes `body` without zeros; returns the length, or nothing if `stuffed` is too short.
pub(super) fn stuff(body: &[u8], stuffed: &mut [u8]) -> Option<usize> {
    cobs::try_encode(body, stuffed).ok()
}

/// Undoes [`stuff`] in place; returns nothing if `bytes` cannot come from it.
pub(super) fn unstuff(bytes: &mut [u8]) -> Option<&[u8]> {
    let n = cobs::decode_in_place(bytes).ok()?;
    bytes.get(..n)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_example_is_met() {
        // S. Cheshire, M. Baker, "Consistent Overhead Byte Stuffing", 1999, fig. 2.
        let (body, expected) = ([0x11, 0x22, 0, 0x33], [3, 0x11, 0x22, 2, 0x33]);
        let mut bytes = [0xAA; 5];
        assert_eq!(stuff(&body, &mut bytes), Some(5));
        assert_eq!(bytes, expected);
        assert_eq!(unstuff(&mut bytes), Some(&body[..]));
    }

    #[test]
    fn a_run_that_leaves_the_frame_is_refused() {
        assert_eq!(unstuff(&mut [9, 1, 2]), None);
    }
}
