//! Compliant contacts and dry friction beside the structural mode.

#![allow(clippy::disallowed_macros, reason = "a test may use the heap")]
#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "a test may use the heap")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod at_once;
mod belt;
mod chain;
mod limits;
mod stacked;
mod thirteen;
