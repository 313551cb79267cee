//! Promises of the crate, by subject.

mod description;
