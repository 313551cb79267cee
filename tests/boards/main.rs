//! Boards behind real drivers, driven by the real program: a piece is played over every link,
//! and whatever breaks, no board pushes that has no right to.
//!
//! Simulated boards live behind pseudo-terminals and the serial driver; the reference firmware
//! in emulated Cortex-M3 processors. CAN and USB need a kernel of their own:
//! `cargo xtask guest-boards`.
//!
//! These are the tests that need a machine with time: they run one at a time, and one that was
//! not given any says so and does not judge.
#![allow(clippy::expect_used, clippy::panic, reason = "helpers of tests, outside #[test]")]

#[path = "../stage/letoff.rs"]
mod letoff;
#[path = "../stage/machine_time.rs"]
mod machine_time;

mod conformance;
mod cortex;
mod fault_rig;
mod lockstep;
mod python;
mod refused;
mod rig;
mod serial;
mod system_calls;
