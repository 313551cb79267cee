//! 88 voices, one tick: order of execution, and handling of missed deadlines.
//!
//! This crate contains no equations, wire formats, threads or clocks.
//! Time is an argument; everything outside plugs into the ports.
//!
//! One tick is [`tick::Scheduler::poll`]: receive, run the lanes, make safe, send, observe.
//!
//! | module | content |
//! |---|---|
//! | [`time`] | host time, the period, when each tick is due |
//! | [`motion`], [`voice`] | input and output of a voice |
//! | [`values`] | new values for the model of a playing voice |
//! | [`observation`] | state of a voice whose key is followed |
//! | [`port`] | interfaces that the host implements |
//! | [`slot`], [`lane`] | assignment of voices to lanes; one lane's share of the tick |
//! | [`safety`] | the force when a voice cannot be trusted |
//! | [`tick`] | the tick, top to bottom |
//! | [`work`] | costs of work, and the time of a lane |
//! | [`deadline`] | outcome of a tick, and the cause of a miss |
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
