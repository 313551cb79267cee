//! Descriptions by their names and paths.

#![expect(clippy::unwrap_used, reason = "helpers of tests, outside #[test]")]

mod entry;
mod files;
mod memory;
