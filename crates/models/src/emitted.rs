//! The Rust that the descriptions of the built-in models give.
//!
//! A test of the crate `kane` proves that each file is what would be emitted today;
//! `EMIT=1 cargo test -p kane emitted_models` writes them again.

#[path = "bouncing_ball/emitted.rs"]
pub mod bouncing_ball;
#[path = "cart_pendulum/emitted.rs"]
pub mod cart_pendulum;
#[path = "key_hammer_rigid/emitted.rs"]
pub mod key_hammer_rigid;
#[path = "key_hammer_springs/emitted.rs"]
pub mod key_hammer_springs;
#[path = "reduced_grand/emitted.rs"]
pub mod reduced_grand;
#[path = "spring_wall/emitted.rs"]
pub mod spring_wall;
