//! Boards on links, in memory.

mod bring_up;
mod calibrate;
mod common;
mod keybed;
mod links;
mod metered;
mod plan;
