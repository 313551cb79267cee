//! `[links]`: where the keys are, and what is agreed with their boards.

use std::path::PathBuf;

use firmware_protocol::acyclic::arm::{LONGEST_VALID_MS, SHORTEST_VALID_MS, VALID_MS};
use firmware_protocol::frame::key_forces::ForcePacking;
use firmware_protocol::frame::key_samples::SamplePacking;
use hardware::link::address::{Address, BAUD};
use hardware::link::can::CanMode;
use hardware::refusal::KeyRange as BoardKeys;

use super::document::{Node, Value};
use super::quantity::Quantity;
use super::range::keys_named;
use super::read::{self, Reader};
use super::report::{Place, Report};
use crate::names::quoted;

const BAUD_RATE: Quantity = Quantity { unit: "1", range: (9_600.0, 20e6) };
const BIT_RATE: Quantity = Quantity { unit: "1", range: (10e3, 20e6) };
const NUMBER: Quantity = Quantity { unit: "1", range: (0.0, 14.0) };
const VALID: Quantity = Quantity {
    unit: "s",
    range: (SHORTEST_VALID_MS as f64 * 1e-3, LONGEST_VALID_MS as f64 * 1e-3),
};

/// Bit rates of a CAN bus of which nothing is said.
const BIT_RATES: (u32, u32) = (1_000_000, 5_000_000);

/// Where the keys are.
#[derive(Clone, PartialEq, Debug)]
pub enum Links {
    /// In a simulated keybed.
    Simulated,
    /// On boards.
    Boards(Boards),
}

/// Boards, and what is agreed with them.
#[derive(Clone, PartialEq, Debug)]
pub struct Boards {
    /// How samples are packed.
    pub samples: SamplePacking,
    /// How forces are packed.
    pub forces: ForcePacking,
    /// How long forces are valid after the samples that they answer [ms].
    pub valid_ms: u8,
    /// Folder of the calibration files; the user's own if none is given.
    pub calibration: Option<PathBuf>,
    /// What leads to them.
    pub buses: Vec<BoardBus>,
}

/// A link and the boards that must be on it.
#[derive(Clone, PartialEq, Debug)]
pub struct BoardBus {
    /// Where it leads.
    pub address: Address,
    /// Bits per second: of the arbitration and of the data phase.
    pub bit_rates: (u32, u32),
    /// Boards that must be there, by number, and the keys that they must carry.
    pub boards: Vec<(u8, BoardKeys)>,
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
    /// A link of which nothing more is said.
    pub const fn new(address: Address) -> Self {
        Self { address, bit_rates: BIT_RATES, boards: Vec::new() }
    }
}

/// What leads to `addresses`, as overrides of a scene; nothing if there are none.
pub fn overrides(addresses: &[Address]) -> Vec<(String, String)> {
    if addresses.is_empty() {
        return Vec::new();
    }
    let bus = |address: &Address| match address {
        Address::Serial { port, baud } => {
            format!("{{ serial = {:?}, baud = {baud} }}", port.display().to_string())
        }
        Address::Can { interface, mode: CanMode::Fd } => format!("{{ can = {interface:?} }}"),
        Address::Can { interface, mode: CanMode::Classic } => {
            format!("{{ can = {interface:?}, mode = \"classic\" }}")
        }
    };
    let buses: Vec<_> = addresses.iter().map(bus).collect();
    vec![
        ("links.kind".into(), "boards".into()),
        ("links.bus".into(), format!("[{}]", buses.join(", "))),
    ]
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

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Simulated,
    Boards,
}

/// Reads the table `links`; a simulated keybed if there is none.
pub(super) fn read(report: &mut Report<'_>, scene: &mut Reader<'_>) -> Links {
    let Some(mut reader) = scene.table(report, "links") else { return Links::Simulated };
    let kinds = [("simulated", Kind::Simulated), ("boards", Kind::Boards)];
    let kind = reader.choice(report, "kind", "there is no kind of link", &kinds);
    let mut boards = Boards::default();
    if let Some(samples) = reader.choice(report, "samples", "samples have no packing", &SAMPLES) {
        boards.samples = samples;
    }
    if let Some(forces) = reader.choice(report, "forces", "forces have no packing", &FORCES) {
        boards.forces = forces;
    }
    if let Some(seconds) = reader.number(report, "valid", VALID) {
        boards.valid_ms = milliseconds(seconds);
    }
    boards.calibration =
        reader.text(report, "calibration").map(|(path, place)| report.folder(place).join(path));
    let buses = reader.take("bus").map(|entry| &entry.node);
    boards.buses = buses.map_or_else(Vec::new, |node| read_buses(report, node));
    let place = reader.place;
    reader.finish(report);
    match (kind, buses) {
        (Some(Kind::Simulated), Some(node)) => {
            let message = "a simulated keybed has no bus";
            report.say(node.place, message, "leave it out, or write kind = \"boards\"");
        }
        (Some(Kind::Boards), None) => {
            let help = "add [[links.bus]] with serial = \"/dev/ttyACM0\" or can = \"can0\"";
            report.miss(place, "boards need a bus", help);
        }
        _ => {}
    }
    if kind == Some(Kind::Boards) || kind.is_none() && buses.is_some() {
        Links::Boards(boards)
    } else {
        Links::Simulated
    }
}

/// Whole milliseconds in a time that was checked [s].
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "5 to 100")]
fn milliseconds(seconds: f64) -> u8 {
    (seconds * 1e3).round() as u8
}

/// The nodes of a list of tables.
fn tables<'a>(report: &mut Report<'_>, name: &str, node: &'a Node) -> &'a [Node] {
    match &node.value {
        Value::List(nodes) => nodes,
        Value::Text(_)
        | Value::Integer(_)
        | Value::Float(_)
        | Value::Truth(_)
        | Value::Date
        | Value::Table(_) => {
            read::wrong_type(report, name, node, "a list", &format!("write it as [[{name}]]"));
            &[]
        }
    }
}

fn read_buses(report: &mut Report<'_>, node: &Node) -> Vec<BoardBus> {
    let mut buses: Vec<BoardBus> = Vec::new();
    for node in tables(report, "links.bus", node) {
        let Some(mut reader) = Reader::new(report, "links.bus", node) else { continue };
        let bus = read_bus(report, &mut reader);
        reader.finish(report);
        let Some(bus) = bus else { continue };
        if buses.iter().any(|other| other.address.name() == bus.address.name()) {
            let message = format!("{} stands here twice", quoted(&bus.address.name()));
            report.say(node.place, message, "leave one of them out");
        }
        buses.push(bus);
    }
    buses
}

fn read_bus(report: &mut Report<'_>, reader: &mut Reader<'_>) -> Option<BoardBus> {
    let serial = reader.text(report, "serial");
    let can = reader.text(report, "can");
    let baud = reader.number(report, "baud", BAUD_RATE).map_or(BAUD, whole);
    let modes = [("fd", CanMode::Fd), ("classic", CanMode::Classic)];
    let mode = reader.choice(report, "mode", "there is no mode", &modes).unwrap_or(CanMode::Fd);
    let nominal = reader.number(report, "bit_rate", BIT_RATE).map_or(BIT_RATES.0, whole);
    let data = reader.number(report, "data_bit_rate", BIT_RATE).map_or(BIT_RATES.1, whole);
    let boards = reader.take("board").map(|entry| &entry.node);
    let boards = boards.map_or_else(Vec::new, |node| read_boards(report, node));
    let address = match (serial, can) {
        (Some((port, _)), None) => Address::Serial { port: port.into(), baud },
        (None, Some((interface, _))) => Address::Can { interface, mode },
        (Some(_), Some((_, place))) => {
            let message = "a bus is either serial or CAN";
            report.say(place, message, "make two of it, each with its own [[links.bus]]");
            return None;
        }
        (None, None) => {
            let message = "this bus leads nowhere";
            let help = "give serial = \"/dev/ttyACM0\" or can = \"can0\"; \
                        `letoff devices` lists what there is";
            report.miss(reader.place, message, help);
            return None;
        }
    };
    Some(BoardBus { address, bit_rates: (nominal, data), boards })
}

fn read_boards(report: &mut Report<'_>, node: &Node) -> Vec<(u8, BoardKeys)> {
    let mut boards = Vec::new();
    for node in tables(report, "links.bus.board", node) {
        let Some(mut reader) = Reader::new(report, "links.bus.board", node) else { continue };
        let number = reader.number(report, "number", NUMBER);
        let keys = reader.text(report, "keys");
        let place = reader.place;
        reader.finish(report);
        if let (Some(number), Some((keys, keys_place))) = (number, keys) {
            boards.extend(board(report, number, &keys, keys_place));
        } else {
            let message = "a board has a number and keys";
            report.miss(place, message, "as number = 3, keys = \"F#3..E4\"");
        }
    }
    boards
}

fn board(
    report: &mut Report<'_>,
    number: f64,
    keys: &str,
    place: Place,
) -> Option<(u8, BoardKeys)> {
    match keys_named(keys) {
        Ok(range) => {
            let n = range.end() - range.start() + 1;
            let number = u8::try_from(whole(number)).unwrap_or(0);
            Some((number, BoardKeys { first: *range.start(), n }))
        }
        Err(sentence) => {
            report.say(place, sentence, "write the first and the last key, as F#3..E4");
            None
        }
    }
}

/// A number that was checked to be small and positive.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range")]
fn whole(value: f64) -> u32 {
    value.round() as u32
}
