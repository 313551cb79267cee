//! Check that the connected port still exists.
//!
//! No system informs the sender: messages to a port that is gone are accepted and lost.

#[cfg(target_os = "linux")]
mod announced;
#[cfg(not(target_os = "linux"))]
mod listed;

#[cfg(target_os = "linux")]
pub(super) use announced::PortWatch;
#[cfg(not(target_os = "linux"))]
pub(super) use listed::PortWatch;
