//! How many bytes a frame takes for so many keys: the packings are those of the wire.
//!
//! Forces for all boards are another matter: their frames are always whole, see [`super::bus`].

pub use firmware_protocol::frame::key_forces::ForcePacking;
pub use firmware_protocol::frame::key_samples::SamplePacking;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eleven_keys_with_slopes_or_velocities_fill_a_frame_of_48() {
        assert_eq!(SamplePacking::Position16Velocity.frame_len(11), 48);
        assert_eq!(ForcePacking::Force16Slope.frame_len(11), 48);
    }
}
