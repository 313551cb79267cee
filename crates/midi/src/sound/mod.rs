//! Messages made audible, with a SoundFont.
//!
//! ```text
//! message ─▶ LiveSound ─ring─▶ callback of the device ─▶ Sampler ─▶ frames
//! message ─▶ WavFile ─────────────── at the end ───────▶ Sampler ─▶ file
//! ```
//!
//! Both are outputs of the MIDI thread, so the tick knows nothing of them.

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
