//! A serial wire with faults, between two ports that any program can open.
//!
//! ```text
//! host ── port ══ relay ══ port ── board
//! ```
//!
//! A thread of its own hands bytes on: each takes its time at the baud rate, some are lost or
//! come with an inverted bit, sometimes the wire stands still. Not for the tick: it plays what
//! lies outside.

mod direction;
mod relay;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;

use super::serial::PtyPair;
use crate::links::Error;

/// How a wire treats its bytes; by default it hands them on at once and whole.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct WirePlan {
    /// Where chance starts from. The same seed has the same fate for the n-th byte of a
    /// direction.
    pub seed: u64,
    /// Bits per second, ten for each byte; none takes no time.
    pub baud: Option<u32>,
    /// Share of the bytes that are lost, `0 ..= 1`.
    pub loss: f64,
    /// Share of the bytes that come with one bit inverted, `0 ..= 1`.
    pub flip: f64,
    /// Share of the bytes at which the wire stands still, `0 ..= 1`.
    pub stall: f64,
    /// How long it then stands still (us).
    pub stall_us: u32,
    /// How much later than without it each byte arrives (us).
    pub late_us: u32,
}

/// What has happened to the bytes of a wire, both ways.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct WireCounts {
    /// Bytes that were handed on, damaged ones among them.
    pub passed: u64,
    /// Bytes that were lost, by chance or because the wire was cut.
    pub lost: u64,
    /// Bytes that came with an inverted bit.
    pub flipped: u64,
    /// Times that the wire stood still.
    pub stalls: u64,
}

/// A wire that is there until it is dropped, which is as if both ends were unplugged.
#[derive(Debug)]
pub struct Wire {
    host: PathBuf,
    board: PathBuf,
    control: Arc<WireControl>,
    relay: Option<JoinHandle<()>>,
}

/// What the relay and its owner tell each other.
#[derive(Debug, Default)]
struct WireControl {
    cut: AtomicBool,
    stop: AtomicBool,
    passed: AtomicU64,
    lost: AtomicU64,
    flipped: AtomicU64,
    stalls: AtomicU64,
}

impl Wire {
    /// Opens a wire that works as `plan` says.
    ///
    /// # Errors
    /// The system has no pseudo-terminal or no thread left.
    pub fn open(plan: WirePlan) -> Result<Self, Error> {
        let (one, other) =
            (PtyPair::open().map_err(Error::Pty)?, PtyPair::open().map_err(Error::Pty)?);
        let (host, board) = (one.path.clone(), other.path.clone());
        let control = Arc::<WireControl>::default();
        let run = {
            let control = Arc::clone(&control);
            move || relay::run(&one, &other, plan, &control)
        };
        let thread = std::thread::Builder::new().name("wire".to_owned());
        let relay = Some(thread.spawn(run).map_err(Error::Thread)?);
        Ok(Self { host, board, control, relay })
    }

    /// Returns the port at the host's end.
    pub fn host(&self) -> &Path {
        &self.host
    }

    /// Returns the port at the board's end.
    pub fn board(&self) -> &Path {
        &self.board
    }

    /// Cuts the wire: what is on it and what is sent is lost, and the ports stay.
    pub fn cut(&self) {
        self.control.cut.store(true, Ordering::Relaxed);
    }

    /// Mends the wire again.
    pub fn mend(&self) {
        self.control.cut.store(false, Ordering::Relaxed);
    }

    /// Returns what has happened so far.
    pub fn counts(&self) -> WireCounts {
        let read = |count: &AtomicU64| count.load(Ordering::Relaxed);
        let WireControl { passed, lost, flipped, stalls, .. } = &*self.control;
        WireCounts {
            passed: read(passed),
            lost: read(lost),
            flipped: read(flipped),
            stalls: read(stalls),
        }
    }
}

impl Drop for Wire {
    fn drop(&mut self) {
        self.control.stop.store(true, Ordering::Relaxed);
        if let Some(relay) = self.relay.take() {
            let _panicked = relay.join();
        }
    }
}
