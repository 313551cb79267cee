//! The `letoff` command with the hosts that it starts.
#![expect(clippy::expect_used, reason = "helpers of tests, outside #[test]")]

mod boards;
mod bounds;
mod common;
mod control;
mod dash;
mod guardian;
mod interpreted;
mod links;
mod listening;
#[path = "../../../tests/stage/machine_time.rs"]
mod machine_time;
#[expect(unreachable_pub, reason = "a module of another program too")]
#[path = "../../instruments/tests/random/mod.rs"]
mod random;
mod random_mechanisms;
mod recordings;
mod replay;
mod running;
mod service;
mod stopping;
mod stranger;
mod streamed;
mod typed;
