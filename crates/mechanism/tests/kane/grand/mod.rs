//! The described model C, a reduced grand, against the geometry of its source and the forces on a
//! finger.

mod equations;
mod playing;
mod pressed;

use crate::kane::runnable::{Runnable, value};

const BUTTON: f64 = 0.0082;
const TRIP: f64 = 0.009_109_090_909_090_909;
const STRING: f64 = 0.045;

fn softplus(x: f64) -> f64 {
    if x > 30.0 { x } else { x.exp().ln_1p() }
}

fn lever(model: &Runnable<4>, y: f64) -> f64 {
    let [offset, ratio, drop, width] = ["o_r", "R", "yd", "wd"].map(|name| value(model, name));
    offset + ratio * (y - width * softplus((y - drop) / width))
}

#[track_caller]
fn agree(what: &str, got: f64, expected: f64, tolerance: f64) {
    let error = (got - expected).abs();
    assert!(error <= tolerance * (1.0 + expected.abs()), "{what}: {got} is not {expected}");
}
