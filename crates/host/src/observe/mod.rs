//! What is observed, from the tick's rings to whoever wants it.
//!
//! ```text
//! tick ─ Tap ─rings─▶ Pump ─▶ blocks, overview, events, ticks ─▶ sinks: stream, recording, black box
//! loop ─ Pulses ─ring─▶ ┘
//! desk, control ─channel─▶ ┘
//! ```
//!
//! The pump has a thread of its own, is waited for by nobody, and says nothing that the rings
//! have not told: what found no room in them is counted.

mod block;
mod catalogue;
mod deadlines;
mod events;
mod eye;
mod overview;
mod pulses;
mod pump;
mod ticks;
mod voice;

pub use catalogue::catalogue;
pub use events::NO_KEY;
pub use eye::{Eye, eye, modes, signals};
pub use pulses::{PulseRow, Pulses};
pub use pump::{Pump, Sink, Told};
pub use voice::{Origin, voice};
