//! What is set up badly for forces: each finding is one sentence with the command to type.
//!
//! | module | what it looks at |
//! |---|---|
//! | [`can`] | a CAN controller's timing, state and queue |
//! | [`usb`], [`serial`] | where a serial port hangs, and how long it holds bytes back |
//! | [`kernel`], [`limits`] | what delays a tick on this machine |
//! | [`machine`] | the two together, as a list |
//!
//! Nothing is changed and no port is opened. Every reading function takes the root of the
//! files it reads.

pub(super) mod can;
mod files;
pub(super) mod kernel;
mod limits;
pub(super) mod machine;
pub(super) mod serial;
pub(super) mod usb;
