//! Boards on links, in memory.

mod bring_up;
mod calibrate;
mod common;
mod keybed;
mod metered;
mod plan;
