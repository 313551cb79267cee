//! Checks of numbers and modes, which need no derivation.

use super::reader::DescriptionReader;

impl DescriptionReader {
    pub(super) fn check(&mut self) {}
}
