//! Settings that are bad for forces: each finding is one sentence with the command to type.
//!
//! | module | subject |
//! |---|---|
//! | [`can`] | timing, state and queue of a CAN controller |
//! | [`usb`], [`serial`] | position of a serial port in the USB tree, and its delay of bytes |
//! | [`kernel`], [`limits`] | causes of late ticks on this machine |
//! | [`machine`] | the two together, as a list |
//!
//! No setting is changed and no port is opened. Every reading function takes the root of its files.

pub(super) mod can;
mod files;
pub(super) mod kernel;
mod limits;
pub(super) mod machine;
pub(super) mod serial;
pub(super) mod usb;
