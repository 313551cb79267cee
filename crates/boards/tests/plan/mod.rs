//! The planner against what is known from elsewhere: a bit-exact encoder, frames whose length
//! another program counted, and tables of rates.

mod encoder;
mod frames;
mod rates;
mod serial;
mod shares;

/// A rate as the tables have it (Hz).
fn hertz(rate: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some kilohertz")]
    let whole = rate.round() as u32;
    whole
}
