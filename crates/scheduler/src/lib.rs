//! 88 voices, one tick: order of execution, and handling of missed deadlines.
//!
//! This crate contains no equations, wire formats, threads or clocks. Time is an argument;
//! everything outside plugs into the ports.
//!
//! One tick is [`tick::Scheduler::poll`]: receive, run the lanes, make safe, send, observe.
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
