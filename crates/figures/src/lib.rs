//! Figures of one key, computed off the tick: of its action alone, and of its loop.
//!
//! | module | figures |
//! |---|---|
//! | [`action`] | touch, timing, check, repetition and energy of an action that a position drives |
//! | [`rehearsal`] | one key of a scene in virtual time, with the samples and forces of its run |
//! | [`tick_cost`] | time that a key's ticks take on this machine |
//! | [`stability`] | whether keys are stable under every finger, their gain margin, what would help |
//! | [`weight`] | weights of a finger: what moves a key, and what sounds at a velocity |
//! | [`plot`] | pictures of figures, as SVG |
//!
//! Commands, the host and studies use these functions, so that each figure is computed in one way.
#![forbid(unsafe_code)]

pub mod action;
pub mod digits;
pub mod parallel;
pub mod plot;
pub mod rehearsal;
pub mod stability;
pub mod tick_cost;
pub mod weight;
