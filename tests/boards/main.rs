//! Boards behind real drivers and the real program: a piece is played over every link, and
//! whatever fails, no board pushes without permission.
//!
//! Simulated boards live behind pseudo-terminals and the serial driver; the reference firmware
//! in emulated Cortex-M3 processors. CAN and USB need a kernel of their own:
//! `cargo xtask guest-boards`.
//!
//! These tests need machine time: they run one at a time and skip themselves if they got none.
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
