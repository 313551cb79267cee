//! Boards on links, in memory.
#![expect(unreachable_pub, reason = "modules of one program")]
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]
#![expect(clippy::disallowed_methods, reason = "boards live in real time")]
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "short tests, some kilohertz"
)]

mod bring_up;
mod calibrate;
mod common;
mod keybed;
mod links;
mod metered;
mod plan;
