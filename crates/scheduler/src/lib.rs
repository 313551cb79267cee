//! 88 voices, one tick: who runs when, and what happens when a deadline is missed.
//!
//! This crate has never heard of an equation, a wire, a thread or a clock.
//! Time arrives as an argument; everything outside plugs into the ports.
//!
//! One tick is [`tick::Scheduler::poll`]: receive, run the lanes, make safe, send, observe.
//!
//! | module | what stands there |
//! |---|---|
//! | [`time`] | host time, the period, when each tick is due |
//! | [`motion`], [`voice`] | what goes into a voice and what comes out |
//! | [`values`] | other values for the model of a voice that plays |
//! | [`observation`] | what is seen of a voice whose key is followed |
//! | [`port`] | what the outside must supply |
//! | [`slot`], [`lane`] | which lane runs which voice; one lane's share of the tick |
//! | [`safety`] | what is sent when a voice cannot be trusted |
//! | [`tick`] | the tick, top to bottom |
//! | [`work`] | what work costs, and the time of a lane |
//! | [`deadline`] | was it in time, and if not, why |
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

pub mod deadline;
pub mod lane;
pub mod motion;
pub mod observation;
pub mod overload;
pub mod port;
pub mod safety;
pub mod slot;
pub mod tick;
pub mod time;
pub mod values;
pub mod voice;
pub mod work;
