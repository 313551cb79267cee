//! The other side of the wire: a simulated key, and a finger that plays it.
//!
//! One file per component; [`KeyRig`] combines them. Every component steps by a given time and
//! holds its whole state, so a copy of a rig is a rehearsal of its future. No action is here: the
//! feel of the key comes from outside, as a force.

mod encoder;
mod felt;
mod finger;
mod gesture;
mod key;
mod motor;
mod rig;
mod smooth;

pub use encoder::Encoder;
pub use felt::Felt;
pub use finger::{Finger, FingerParameters, Grasp, HandCommand};
pub use gesture::{Gesture, MuscleCommand, Touch};
pub use key::{KeyFront, KeyParameters};
pub use motor::{MAX_DELAY_STEPS, Motor, MotorParameters};
pub use rig::{KeyRig, MAX_SUBSTEP, MAX_SUBSTEPS, RigParameters};
pub use smooth::quintic;
