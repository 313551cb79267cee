//! What is known of a CAN interface.

use super::can_link::CanLink;
use crate::links::obstacle::Obstacle;

/// A CAN interface of this machine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CanInterface {
    /// Its name, as `ip link` has it.
    pub name: String,
    /// It exists in memory only.
    pub is_virtual: bool,
    /// It is set up to carry CAN FD frames.
    pub carries_fd: bool,
    /// It was brought up.
    pub is_up: bool,
    /// What the kernel says of its operation: `up`, `down`, `unknown` and others.
    pub state: String,
    /// Longest frame with its head, as the kernel keeps it (bytes).
    pub mtu: Option<u32>,
    /// Frames that wait for the bus at most, if the kernel says.
    pub queue_length: Option<u32>,
    /// The kernel's driver of its adapter.
    pub driver: Option<String>,
    /// What `ip` tells of its controller.
    pub link: Option<CanLink>,
    /// Why it cannot be used, if that is known.
    pub obstacle: Option<Obstacle>,
    /// What to change, each in a sentence.
    pub advice: Vec<String>,
}
