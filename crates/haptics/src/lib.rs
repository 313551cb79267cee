//! The feel of a key, from both sides of it.
//!
//! [`estimate`] computes motion from quantised positions, [`limits`] is the last gate of a force,
//! [`passivity`] detects and prevents generated energy, [`swing`] detects shaking, [`stability`]
//! bounds the stiffness of a sampled wall. [`plant`] is the other side: a simulated key with
//! encoder, motor and finger, for running without hardware and for rehearsals.
//!
//! **Signs.** A position is the displacement of the key's front (m), *down positive*, zero
//! at rest. A force is what the finger feels (N), *up positive*: it decreases the position.
//!
//! **Time.** No clock is read here; model time `t` and steps `h` (s) are arguments. Nothing
//! allocates and every loop has a bound, so everything but the constructors is for the tick.
//! All state is `Copy`: a snapshot is an assignment, and a replay from it gives the same bits.
//!
//! | word | meaning |
//! |---|---|
//! | key | the lever that the finger touches, the paper's manipulandum |
//! | count, quantum | what an encoder reports; the displacement (m) of one count |
//! | tick, substep | one period of the control loop; the plant's own fixed part of it |
//! | stuck | at exactly zero velocity, held there by stiction |
//! | felt | a unilateral spring and damper that stops the key |
//! | pulp | the soft fingertip; it pushes, and pulls only where the finger grips its key |
//! | gesture | what a finger's muscle commands over time: one stroke and its release |

#![forbid(unsafe_code)]

pub mod device;
pub mod estimate;
pub mod limits;
pub mod passivity;
pub mod plant;
pub mod stability;
pub mod swing;

pub use device::DeviceCompensation;
pub use estimate::{
    AnyEstimator, BackwardDifference, Estimator, EstimatorName, EstimatorSettings, Kalman,
    KeyMotion,
};
pub use limits::{ForceGate, Gated, LimitError};
pub use passivity::{EnergyBound, PassivityController, PassivityObserver};
pub use plant::{
    Encoder, Felt, Finger, FingerParameters, Gesture, Grasp, HandCommand, KeyFront, KeyParameters,
    KeyRig, Motor, MotorParameters, MuscleCommand, RigParameters, Touch, quintic,
};
pub use stability::{RoundedDevice, SampledWall};
pub use swing::Swing;
