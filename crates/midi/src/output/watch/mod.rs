//! Whether the port that was connected is still there.
//!
//! No system tells the sender: messages to a port that has gone are accepted and lost.

#[cfg(target_os = "linux")]
mod announced;
#[cfg(not(target_os = "linux"))]
mod listed;

#[cfg(target_os = "linux")]
pub(super) use announced::PortWatch;
#[cfg(not(target_os = "linux"))]
pub(super) use listed::PortWatch;
