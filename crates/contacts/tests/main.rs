//! Contacts against closed forms, an independent program and the laws of mechanics.

mod automata;
#[path = "../../pode/tests/common/mod.rs"]
mod common;
mod cradle;
#[path = "../../pode/tests/driven/mod.rs"]
mod driven;
mod restitution;
