//! The planner against independent sources: a bit-exact encoder, frame lengths counted by another
//! program, and tables of rates.

mod encoder;
mod frames;
mod rates;
mod serial;
mod shares;

fn hertz(rate: f64) -> u32 {
    rate.round() as u32
}
