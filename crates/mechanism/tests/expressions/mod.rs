//! Expressions against recursive evaluation, tapes against both, series against closed forms.

pub(crate) mod common;
mod graph;
mod tape;
