//! Compliant contacts and dry friction beside the structural mode.

mod at_once;
mod belt;
mod chain;
mod limits;
mod stacked;
mod thirteen;
