//! The tick in virtual time.
#![expect(unreachable_pub, reason = "modules of one program")]
#![expect(clippy::unwrap_used, clippy::expect_used, reason = "a test may stop here")]
#![expect(clippy::large_stack_frames, reason = "a scheduler on the stack of a test")]

mod deadlines;
mod isolation;
mod rig;
mod safety;
