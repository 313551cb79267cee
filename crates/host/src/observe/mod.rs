//! Telemetry: from the tick's rings to messages, and from messages to sinks.
//!
//! ```text
//! tick ─ TickRecorder ─rings─▶ TelemetryThread ─▶ blocks, overview, events, ticks ─▶ sinks: stream,
//! loop ─ Pulses ─ring─────────▶┤                                       recording, black box, log
//! keys ─ LinkMonitor ─ring────▶┤
//! MIDI, control ─channel──────▶┘
//! ```
//!
//! No other thread waits for the telemetry thread. Rows that find no room in the rings are counted
//! and missing from the messages.

mod block;
mod catalogue;
mod deadlines;
mod events;
mod links;
mod log;
mod model_probe;
mod overview;
mod pulses;
mod record;
mod telemetry_thread;
mod ticks;
mod voice;

pub(crate) use block::flag;
pub use catalogue::{catalogue, distinct, instrument};
pub use events::{NO_KEY, pedal, pedal_move};
pub use links::LinksWatch;
pub use log::{LogLine, LogSink};
pub use model_probe::{ModelProbe, modes, probe, signals};
pub use pulses::{PulseRow, Pulses};
pub use record::{BlackBoxSink, RecordingHandle};
pub use telemetry_thread::{Attention, MessageSink, TelemetryMessage, TelemetryThread};
pub use voice::{Origin, instrument_of, voice};

fn run_id() -> String {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    format!("{}-{}", now.map_or(0, |it| it.as_secs()), std::process::id())
}

/// Rounds a value that is shown and not replayed.
#[expect(clippy::cast_possible_truncation, reason = "seven digits are enough to look at")]
const fn short(value: f64) -> f32 {
    value as f32
}
