//! The whole tick allocates nothing and frees nothing.
//!
//! [`trap`] is a global allocator that counts the calls of marked threads: the tick's own thread
//! while it ticks, and the threads of the lanes from their first tick after the warm-up to their
//! last.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

mod hardware_exchange;
mod marking;
#[path = "../stage/mod.rs"]
mod stage;
mod tick;
mod trap;
mod trouble;
