use super::can_link::CanLink;
use crate::links::obstacle::Obstacle;

/// A CAN interface of this machine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CanInterface {
    pub name: String,
    /// `true` if it exists in memory only.
    pub is_virtual: bool,
    pub carries_fd: bool,
    pub is_up: bool,
    /// Operational state: `up`, `down`, `unknown` and others.
    pub state: String,
    /// Longest frame with its head, as the kernel keeps it (bytes).
    pub mtu: Option<u32>,
    /// Maximum number of frames that wait for the bus, if known.
    pub queue_length: Option<u32>,
    pub driver: Option<String>,
    pub link: Option<CanLink>,
    pub obstacle: Option<Obstacle>,
    pub advice: Vec<String>,
}
