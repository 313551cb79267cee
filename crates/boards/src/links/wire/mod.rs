//! A serial wire with faults, between two ports that any program can open.
//!
//! ```text
//! host ── port ══ relay ══ port ── board
//! ```
//!
//! A separate thread relays the bytes: each takes its time at the baud rate, some are lost or get
//! an inverted bit, and sometimes the wire stalls. Not for the tick.

mod direction;
mod relay;

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::{sync::Arc, thread::JoinHandle};

use super::serial::PtyPair;
use crate::links::Error;

/// Treatment of a wire's bytes; by default immediate and whole.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct WirePlan {
    /// Random seed. The n-th byte of a direction has the same fate for the same seed.
    pub seed: u64,
    /// Bits per second, ten for each byte; `None` takes no time.
    pub baud: Option<u32>,
    /// Fraction of the bytes that are lost, `0 ..= 1`.
    pub loss: f64,
    /// Fraction of the bytes that get one inverted bit, `0 ..= 1`.
    pub flip: f64,
    /// Fraction of the bytes at which the wire stalls, `0 ..= 1`.
    pub stall: f64,
    pub stall_us: u32,
    /// Additional delay of each byte (us).
    pub late_us: u32,
}

/// Counts of a wire's bytes, both ways.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct WireCounts {
    /// Relayed bytes, including damaged ones.
    pub passed: u64,
    /// Bytes that were lost, by chance or because the wire was cut.
    pub lost: u64,
    pub flipped: u64,
    pub stalls: u64,
}

/// A wire; dropping it is as if both ends were unplugged.
#[derive(Debug)]
pub struct Wire {
    host: PathBuf,
    board: PathBuf,
    control: Arc<WireControl>,
    relay: Option<JoinHandle<()>>,
}

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

    pub fn host(&self) -> &Path {
        &self.host
    }

    pub fn board(&self) -> &Path {
        &self.board
    }

    /// Cuts the wire: bytes on it and sent to it are lost, and the ports stay.
    pub fn cut(&self) {
        self.control.cut.store(true, Ordering::Relaxed);
    }

    pub fn mend(&self) {
        self.control.cut.store(false, Ordering::Relaxed);
    }

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
