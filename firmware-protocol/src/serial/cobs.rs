//! Consistent overhead byte stuffing: the same bytes without a zero among them.

/// Number of bytes that stuffing adds to at most 254.
pub(super) const OVERHEAD: usize = 1;

/// Writes `body` without zeros; returns the length, or `None` if `stuffed` is too short.
pub(super) fn stuff(body: &[u8], stuffed: &mut [u8]) -> Option<usize> {
    cobs::try_encode(body, stuffed).ok()
}

/// Undoes [`stuff`] in place; returns `None` if `bytes` cannot come from it.
pub(super) fn unstuff(bytes: &mut [u8]) -> Option<&[u8]> {
    let n = cobs::decode_in_place(bytes).ok()?;
    bytes.get(..n)
}
