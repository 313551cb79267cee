//! The tick in virtual time.

mod deadlines;
mod isolation;
mod rig;
mod safety;
