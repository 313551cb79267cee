//! Descriptions by their names and paths.

#![expect(clippy::unwrap_used, reason = "helpers of tests, outside #[test]")]

mod entry;
mod expressions;
mod files;
mod kane;
mod memory;
mod native;
