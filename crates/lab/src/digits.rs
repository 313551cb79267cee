//! Numbers as people write them.

/// Returns a decimal number without the zeros at its end that say nothing.
pub(crate) fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}
