//! A model as a key's voice: sample in, force out.
//!
//! Only here is a simulator instantiated per model and method; from outside a voice is a
//! [`RehearsableVoice`], a scheduler's voice that can be copied.
//!
//! | module | contents |
//! |---|---|
//! | [`rendered_key`] | the voice: estimate, advance, read out, limit |
//! | [`input`] | path of a key's samples to the motion of the model's input |
//! | [`coupling`] | a spring and a damper between the player's key and the model's |
//! | [`damper`] | times at which the key lifts and drops its damper |
//! | `aftertouch` | the force on a key that is held down, as pressure |
//! | `rest` | condition for a voice to sleep |
//! | [`audit`] | cell in which a voice publishes its energy audit |
//! | `carried` | state that the next voice takes over |
//! | [`builder`] | voices from a scene's values |

mod aftertouch;
pub mod audit;
pub mod builder;
mod carried;
pub mod coupling;
pub mod damper;
pub mod input;
pub mod rendered_key;
mod rest;
mod shift;
#[cfg(test)]
mod tests;

pub use audit::{AuditCell, AuditReport};
pub use builder::{AnyVoice, BuildError, VoiceBuilder};
pub use carried::KeyMemory;
pub use rendered_key::{CopiedVoice, RehearsableVoice, RenderedKey, SlopeOutput, VoiceSettings};
