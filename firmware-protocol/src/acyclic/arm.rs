//! How a board is disarmed and armed: the only way out of the safe state.
//!
//! ```text
//! host  disarm  ──▶  board: no force; a new nonce
//! host  arm(nonce, what was agreed)  ──▶  board: armed, until its forces expire
//! ```
//!
//! A nonce serves once, so neither a repeated request nor an old host arms a board.
//!
//! Forces expire from the first on that is taken after the arming: a board that is armed and was
//! given none renders none, so nothing can be stale. Of multicast forces the older group counts
//! where a board has keys in two, and there are none before both have come.
//!
//! A board that was stopped or whose key failed is safe for good: a disarming is answered with
//! [`super::Status::WrongState`] and changes nothing, so no request arms it and its reason can
//! still be asked for. Only its power clears that, so a person has been there. A stop or a failed
//! key takes the place of any other reason, on a board that is safe or disarmed as well; of the
//! two the first stays.

record! {
    /// The answer to a disarming.
    Disarmed {
        /// Number that the next Arm must contain; another one after every Disarm.
        nonce: u32,
    }
}

record! {
    /// What forces will be like.
    Arm {
        /// The nonce of the last Disarm.
        nonce: u32,
        /// Number of the force packing.
        packing: u8,
        /// Time for which forces are valid after the samples that they answer (ms).
        valid_ms: u8,
    }
}

/// The shortest time that forces may be valid (ms).
pub const SHORTEST_VALID_MS: u8 = 5;
/// The longest time that forces may be valid (ms).
pub const LONGEST_VALID_MS: u8 = 100;
/// What is usual (ms).
pub const VALID_MS: u8 = 20;
/// Time in which forces fade when they have expired (ms).
pub const FADE_MS: u8 = 10;
/// How long the point around which a force goes on moves on (us), see
/// [`crate::frame::key_forces`].
pub const PATH_US: u16 = 2_000;
/// Samples that a board remembers for forces to answer.
pub const HISTORY: usize = 64;
