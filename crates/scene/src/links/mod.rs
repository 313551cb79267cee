//! `[links]`: the links to the keys, and the terms for their boards.

mod board;
mod bus;
mod table;

use std::path::PathBuf;

use boards::links::address::{Address, BoardLinkKind};
use firmware_protocol::acyclic::arm::VALID_MS;
use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use keyboard::KeyRange;

use super::source::Override;

pub(super) use table::{Rate, read};

/// Bit rates of a CAN bus without rates in the scene.
const BIT_RATES: (u32, u32) = (1_000_000, 5_000_000);

/// The place of the keys.
#[derive(Clone, PartialEq, Debug)]
pub enum LinksConfig {
    /// In a simulated keybed.
    Simulated,
    Boards(Boards),
}

/// Boards, and the terms for them.
#[derive(Clone, PartialEq, Debug)]
pub struct Boards {
    pub samples: SamplePacking,
    pub forces: ForcePacking,
    /// Time for which forces are valid after the samples that they answer (ms).
    pub valid_ms: u8,
    /// Folder of the calibration files; the user's own if none is given.
    pub calibration: Option<PathBuf>,
    pub buses: Vec<BoardBus>,
}

/// A link and the boards that must be on it.
#[derive(Clone, PartialEq, Debug)]
pub struct BoardBus {
    pub address: Address,
    /// Bits per second: of the arbitration and of the data phase.
    pub bit_rates: (u32, u32),
    /// Boards that must be there, by number, and the keys that they must carry.
    pub boards: Vec<(u8, KeyRange)>,
}

impl Default for Boards {
    fn default() -> Self {
        Self {
            samples: SamplePacking::default(),
            forces: ForcePacking::default(),
            valid_ms: VALID_MS,
            calibration: None,
            buses: Vec::new(),
        }
    }
}

impl BoardBus {
    /// Returns a link with default rates and no listed boards.
    pub const fn new(address: Address) -> Self {
        Self { address, bit_rates: BIT_RATES, boards: Vec::new() }
    }
}

/// Returns the period of boards that exchange so often (us): a whole number of the 100 us in which
/// they work, if there is one.
pub fn period_us(tick_hz: u32) -> Option<u16> {
    let divides = 10_000_u32.checked_rem(tick_hz) == Some(0);
    divides.then(|| 1_000_000 / tick_hz).and_then(|period| u16::try_from(period).ok())
}

/// Returns overrides of a scene that replace its links by `addresses`; none without addresses.
pub fn overrides(addresses: &[Address]) -> Vec<Override> {
    if addresses.is_empty() {
        return Vec::new();
    }
    let buses: Vec<_> = addresses.iter().map(bus_at).collect();
    let options: Vec<_> = addresses.iter().map(|it| format!("--link {}", it.typed())).collect();
    let typed = options.join(" ");
    let over = |name: &str, value| Override { name: name.into(), value, typed: typed.clone() };
    vec![over("links.kind", "boards".into()), over("links.bus", format!("[{}]", buses.join(", ")))]
}

/// Returns a bus in a scene that leads to `address`.
pub(super) fn bus_at(address: &Address) -> String {
    let Address { kind, place, baud } = address;
    let baud = baud.map(|baud| format!(", baud = {baud}"));
    let is_usual = BoardLinkKind::find(kind.key, None) == Some(*kind);
    let mode = kind.mode.filter(|_| !is_usual).map(|mode| format!(", mode = {mode:?}"));
    let (baud, mode) = (baud.unwrap_or_default(), mode.unwrap_or_default());
    format!("{{ {} = {place:?}{baud}{mode} }}", kind.key)
}

/// Names of how samples are packed.
pub const SAMPLES: [(&str, SamplePacking); 4] = [
    ("position24", SamplePacking::Position24),
    ("position16", SamplePacking::Position16),
    ("position16-velocity", SamplePacking::Position16Velocity),
    ("position24-velocity", SamplePacking::Position24Velocity),
];

/// Names of how forces are packed.
pub const FORCES: [(&str, ForcePacking); 3] = [
    ("force16", ForcePacking::Force16),
    ("force16-slope", ForcePacking::Force16Slope),
    ("multicast16", ForcePacking::Multicast16),
];
