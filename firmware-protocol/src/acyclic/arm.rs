//! Disarming and arming of a board: the only exit from the safe state.
//!
//! ```text
//! host  disarm  ──▶  board: no force; a new nonce
//! host  arm(nonce, what was agreed)  ──▶  board: armed, until its forces expire
//! ```
//!
//! A nonce serves once, so neither a repeated request nor an old host arms a board.
//!
//! Forces expire from the first that the board accepts after arming: an armed board without forces
//! renders none, so nothing can be stale. If a board has keys in two multicast groups, the older
//! force frame counts, and the board renders nothing before both have arrived.
//!
//! A stopped board, or one with a failed key, is safe for good: it answers a Disarm with
//! [`super::Status::WrongState`] and changes nothing, so no request arms it and its reason can
//! still be read. Only power clears that, so a person has been there. A stop or a failed key
//! replaces any other reason, also on a safe or disarmed board; of the two the first stays.

record! {
    /// The answer to a disarming.
    Disarmed {
        /// Number that the next Arm must contain; another one after every Disarm.
        nonce: u32,
    }
}

record! {
    /// Properties of the forces that follow.
    Arm {
        /// The nonce of the last Disarm.
        nonce: u32,
        /// Number of the force packing.
        packing: u8,
        /// Time for which forces are valid after the samples that they answer (ms).
        valid_ms: u8,
    }
}

pub const SHORTEST_VALID_MS: u8 = 5;
pub const LONGEST_VALID_MS: u8 = 100;
/// Usual time for which forces are valid (ms).
pub const VALID_MS: u8 = 20;
/// Time in which expired forces fade (ms).
pub const FADE_MS: u8 = 10;
/// Time for which an extrapolated force's reference moves (us), see [`crate::frame::key_forces`].
pub const PATH_US: u16 = 2_000;
/// Number of sample frames that a board remembers for forces to answer.
pub const HISTORY: usize = 64;
