//! Stability of a closed loop: a wall or an instrument, on a key that is knocked and left alone.
//!
//! ```text
//! quantity.rs  variables of a loop               axis.rs     variables of a map
//! trial.rs     one loop, knocked once            judge.rs    whether it comes to rest
//! voice.rs     what answers the key              map.rs      all points of a grid, and between
//! theory.rs    boundaries of theory              poles.rs    exact poles of key and wall
//! contour.rs   lines where a margin is zero      picture.rs  a map as a picture
//! sheet.rs     CSV, page, figures for programs
//! ```
//!
//! The theory is of passivity: a loop is stable under any passive load of the key. A key of a given
//! mass allows more. The worst load is a mass that goes to zero: then the loop's pole at z = -1
//! lies on b = K T/2 + B, Colgate and Schenkel's boundary.

mod axis;
mod contour;
mod judge;
mod map;
mod picture;
mod poles;
mod quantity;
mod sheet;
#[cfg(test)]
mod tests;
mod theory;
mod trial;
mod voice;

pub use axis::{AxisTarget, LoopPoint, MapAxis};
pub use judge::LoopVerdict;
pub use map::{
    StabilityMap, StabilityStudy, StabilitySubject, TheoryLine, VerdictCounts, VoiceMaker,
};
pub use poles::spectral_radius;
pub use quantity::{FINGERS, LONGEST_DELAY, LoopQuantity, LoopValues, QUANTITIES, QuantityEntry};
pub use sheet::{StabilitySummary, write_maps};
pub use theory::StabilityTheory;
pub use voice::{TrialAnswer, TrialVoice, VoiceOrder, wall};
