//! Forces that were sent in vain, with the reason.

use std::fmt;

/// Forces that a board did not accept.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UntakenForces {
    pub sent: u64,
    /// Frames that it rejected, and that it counted as stale.
    pub refused: u32,
    pub stale: u32,
}

impl fmt::Display for UntakenForces {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { sent, refused, stale } = self;
        if stale < refused {
            write!(
                f,
                "; {refused} of {sent} forces were refused: their packing or their length is not \
                 what it takes, as if it left the checksum on, or bytes were lost"
            )
        } else {
            write!(f, "; {stale} of {sent} forces were stale: they answer samples it has forgotten")
        }
    }
}
