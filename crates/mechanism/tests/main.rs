//! Descriptions by their names and paths.
#![expect(unreachable_pub, reason = "modules of one program")]
#![expect(clippy::expect_used, clippy::unwrap_used, clippy::panic, reason = "a test fails aloud")]
#![expect(clippy::float_cmp, reason = "these values are exact")]
#![expect(clippy::large_stack_frames, reason = "models are values, and a test has the stack")]
#![expect(clippy::print_stdout, reason = "what was compared is shown")]

mod entry;
mod expressions;
mod files;
mod kane;
mod memory;
mod native;
