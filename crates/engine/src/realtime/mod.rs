//! The tick on a real machine.
//!
//! A running loop makes the system calls `clock_gettime`, `clock_nanosleep`, and with several lanes
//! `futex` and `sched_yield`; nothing here allocates, locks or logs in a tick.

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
