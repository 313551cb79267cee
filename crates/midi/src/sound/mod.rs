//! Messages made audible, with a SoundFont.
//!
//! ```text
//! message ─▶ live output ─ring─▶ callback of the device ─▶ sampler ─▶ frames
//! message ─▶ file output ───────────── at the end ───────▶ sampler ─▶ file
//! ```
//!
//! [`LiveSound`] and [`WavFile`] are outputs of the MIDI thread and play through a [`Sampler`].
//! The tick knows nothing of them.

mod error;
mod font;
mod live;
mod sampler;
mod wav;

pub use error::SoundError;
pub use font::Font;
pub use live::{LiveSound, SoundCounters, SoundReport};
pub use sampler::{Programs, Sampler};
pub use wav::WavFile;
