//! The built-in models once more, by hand: what their descriptions are judged by.
//!
//! Each has its equations as a person derived and arranged them, with bounds, natures and
//! closed forms stated; the tests compare them with what `kane` derives from
//! `crates/models/src/*/model.toml`, number by number, and with trajectories of other programs.
//! The program never runs them. Their READMEs, with coordinates, modes and sources, stand beside
//! the descriptions.
#![forbid(unsafe_code)]

mod bounds;
mod entry;
mod impact;
mod parameter;
mod parameters;
mod values;

pub mod bouncing_ball;
pub mod cart_pendulum;
pub mod key_hammer;
pub mod key_hammer_rigid;
pub mod key_hammer_springs;
pub mod reduced_grand;
pub mod spring_wall;

pub use bouncing_ball::BouncingBall;
pub use cart_pendulum::CartPendulum;
pub use key_hammer_rigid::KeyHammerRigid;
pub use key_hammer_springs::KeyHammerSprings;
pub use reduced_grand::ReducedGrand;
pub use spring_wall::SpringWall;
