//! Scenes and instruments: TOML → checked values, or all mistakes at once.
//!
//! ```text
//! name or path ─ source ─▶ text ─ document ─▶ tree with places ─ overrides ─▶ tree
//!                                               tree ─ read, quantity ─▶ Scene, Instrument
//!                                      mistakes of every stage ─ report ─▶ Diagnostics
//! ```
//!
//! | module | contents |
//! |---|---|
//! | `scene`, `render`, `realtime`, `rig`, `keys`, `links` | the scene, a file per table |
//! | `instrument`, `voicing` | a model, a preset and differences from it, over the compass |
//! | `based`, `edited` | an instrument as differences from another one |
//! | `embedded`, `source` | files that are part of the program, and files on the disk |
//! | `read`, `quantity`, `setting`, `overrides` | the language of all kinds of file |
//!
//! Every value is within its range and every name exists. Ports and boards are not checked here.
//! Paths are relative to the file that names them, or to the working directory where an override or
//! an embedded scene does.

mod based;
mod checked_file;
mod edited;
mod embedded;
mod fidelity;
mod figures;
mod fitted;
mod instrument;
mod keys;
mod kind;
mod links;
mod live;
mod needs;
mod overload;
mod overrides;
mod quantity;
mod read;
mod realtime;
mod render;
mod rig;
mod scene;
mod setting;
mod source;
mod voicing;
mod write;

#[cfg(test)]
mod tests;

pub use based::{Based, CompassDifferences, InstrumentEdit};
pub use checked_file::check_file;
pub use embedded::{performances, scenes};
pub use fidelity::{AutoFidelity, Fidelity, FidelityLevel};
pub use fitted::{FittedValues, fitted_text};
pub use instrument::{Instrument, InstrumentHead, instruments};
pub use keys::KeyVoice;
pub use kind::{FileKind, is_description};
pub use links::{
    BoardBus, Boards, FORCES, LinksConfig, SAMPLES, overrides as link_overrides, period_us,
};
pub use mechanism::Library;
pub use needs::{Needs, Unmet};
pub use realtime::{LaneCount, ThreadPolicy, ThreadRules};
pub use render::{InputReconstruction, PassivityMode, Render};
pub use rig::{FingerName, Rig};
pub use scene::{
    Midi, MidiInput, MidiOutput, PerformanceSource, PlayList, Scene, SoundConfig, is_midi_file,
    midi_output,
};
pub use source::Override;
pub use voicing::{InstrumentFile, Voicing};
pub use write::written;
