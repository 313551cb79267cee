//! How many bytes a frame takes for so many keys: the packings are those of the wire.

use firmware_protocol::frame::multicast_forces::GROUP;

pub use firmware_protocol::frame::key_forces::ForcePacking;
pub use firmware_protocol::frame::key_samples::SamplePacking;

/// Keys that a force frame to all boards has room for: the longest CAN FD frame.
pub const MULTICAST_KEYS: usize = GROUP;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::can::FD_MOST;

    #[test]
    fn eleven_keys_with_slopes_or_velocities_fill_a_frame_of_48() {
        assert_eq!(SamplePacking::Position16Velocity.frame_len(11), 48);
        assert_eq!(ForcePacking::Force16Slope.frame_len(11), 48);
    }

    #[test]
    fn a_frame_for_thirty_keys_is_the_longest_there_is() {
        assert_eq!(ForcePacking::Multicast16.frame_len(MULTICAST_KEYS), FD_MOST);
    }
}
