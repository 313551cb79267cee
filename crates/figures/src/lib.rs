//! Figures of one key, computed off the tick: of its action alone, and of the loop that will run.
//!
//! | module | figures |
//! |---|---|
//! | [`action`] | touch, timing, check, repetition and energy of an action that a position drives |
//! | [`rehearsal`] | one key of a scene in virtual time, with the samples and forces of its run |
//! | [`stability`] | whether keys are stable under every finger, their gain margin, what would help |
//! | [`weight`] | weights of a finger: what moves a key, and what sounds at a velocity |
//! | [`plot`] | pictures of figures, as SVG |
//!
//! Commands, the host and studies ask here, so that each figure is computed in one way.
//!
//! Not here: reports, anything of real time, a keyboard of 88 keys at once.
#![forbid(unsafe_code)]

pub mod action;
pub mod digits;
pub mod parallel;
pub mod plot;
pub mod rehearsal;
pub mod stability;
pub mod weight;
