//! The mechanical impedance at a key's front, Z(f) = F/v, `letoff lab impedance`.
//!
//! ```text
//! curve.rs    Z over frequency, and where it is not passive
//! mode.rs     linearises a model that is held in a mode
//! sampled.rs  shakes a voice by a small sinusoid, its force held and late
//! stroke.rs   analyses a recorded stroke: cross-spectrum and coherence
//! picture.rs  the curves as a picture    sheet.rs  CSV, page, figures for programs
//! ```
//!
//! The force is the key's on the finger, up positive; the velocity is the finger's, down positive.
//! A spring has Z = K/(jω), a damper Z = B, a mass Z = jω m. Z is passive where Re Z ≥ 0: there a
//! finger that shakes the key cannot get work out of it. `[GC93]` §2.

mod curve;
mod mode;
mod picture;
mod sampled;
mod sheet;
mod stroke;
#[cfg(test)]
mod tests;

pub use curve::{ActiveBand, ImpedanceCurve, ImpedancePoint, frequencies};
pub use mode::{HeldMode, LinearMode, linearise};
pub use sampled::{ForceHold, ShakenVoice};
pub use sheet::{ImpedanceSummary, write_impedance};
pub use stroke::RecordedStroke;
