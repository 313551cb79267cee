//! Descriptions by their names and paths.

mod entry;
mod files;
mod memory;
