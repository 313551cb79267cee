//! The tick on a real machine: clocks, priority, memory, lanes, the loop.
//!
//! | module | what stands there |
//! |---|---|
//! | [`clock`] | the only place that reads clocks and sleeps |
//! | [`thread`], [`affinity`], [`memory`], [`wake_latency`] | what the system grants us, and what to do if it does not |
//! | [`pool`] | voices on one or several threads |
//! | [`run`] | the loop in real time; [`virtual_time`] the same as fast as it will go |
//! | [`baseline`] | what the machine does to a thread that does nothing |
//! | [`stolen`] | what a hypervisor takes from the machine |
//!
//! Once a loop runs, its system calls are `clock_gettime`, `clock_nanosleep`, and with several
//! lanes `futex` and `sched_yield`; nothing here allocates, locks or logs in a tick.

pub mod affinity;
pub mod baseline;
pub mod clock;
pub mod memory;
pub mod pool;
pub mod run;
pub mod stolen;
pub mod thread;
pub mod virtual_time;
pub mod wake_fd;
pub mod wake_latency;

#[cfg(test)]
mod tests;
