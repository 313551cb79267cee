//! `[[links.bus]]`: a link, and what it is like.

use boards::links::address::{Address, BAUD};
use boards::links::can::CanMode;

use super::board::{self, Listed};
use super::{BIT_RATES, BoardBus};
use crate::quantity::Quantity;
use crate::read::{self, TableReader};
use documents::quoted;
use documents::toml::{FindingList, TomlNode};

const BAUD_RATE: Quantity = Quantity { unit: "1", range: (9_600.0, 20e6) };
const BIT_RATE: Quantity = Quantity { unit: "1", range: (10e3, 20e6) };

/// Names of what a bus leads to.
const PLACES: [&str; 3] = ["serial", "can", "rig"];

/// Names that only a CAN bus has.
const OF_CAN: [&str; 3] = ["mode", "bit_rate", "data_bit_rate"];

/// Reads every `[[links.bus]]` of a scene.
pub(super) fn read_all(report: &mut FindingList, node: &TomlNode) -> Vec<BoardBus> {
    let mut buses: Vec<BoardBus> = Vec::new();
    let mut listed = Vec::new();
    for node in read::tables(report, "links.bus", node) {
        let Some(mut reader) = TableReader::new(report, "links.bus", node) else { continue };
        let boards = reader.take("board").map(|entry| &entry.node);
        let boards = boards.map_or_else(Vec::new, |node| board::read_all(report, node));
        let bus = read(report, &mut reader);
        reader.finish(report);
        board::refuse_shared_numbers(report, &boards);
        listed.extend_from_slice(&boards);
        let Some(bus) = bus else { continue };
        if buses.iter().any(|other| other.address.name() == bus.address.name()) {
            let message = format!("{} stands here twice", quoted(&bus.address.name()));
            report.say(node.place, message, "leave one of them out");
        }
        buses.push(BoardBus { boards: boards.iter().filter_map(Listed::checked).collect(), ..bus });
    }
    board::refuse_shared_keys(report, &listed);
    buses
}

/// Reads a bus without its boards.
fn read(report: &mut FindingList, reader: &mut TableReader<'_>) -> Option<BoardBus> {
    let [serial, can, rig] = PLACES.map(|name| reader.text(report, name));
    let baud = reader.whole(report, "baud", BAUD_RATE).unwrap_or(BAUD);
    let modes = [("fd", CanMode::Fd), ("classic", CanMode::Classic)];
    let mode = reader.choice(report, "mode", "there is no mode", &modes).unwrap_or(CanMode::Fd);
    let nominal = reader.whole(report, "bit_rate", BIT_RATE).unwrap_or(BIT_RATES.0);
    let data = reader.whole(report, "data_bit_rate", BIT_RATE).unwrap_or(BIT_RATES.1);
    let address = match PLACES.map(|name| reader.take(name)) {
        [Some(_), None, None] => {
            refuse(report, reader, &OF_CAN, "a serial port has");
            Address::Serial { port: serial?.0.into(), baud }
        }
        [None, Some(_), None] => {
            refuse(report, reader, &["baud"], "a CAN bus has");
            if mode == CanMode::Classic {
                refuse(report, reader, &["data_bit_rate"], "classic CAN has");
            }
            Address::Can { interface: can?.0, mode }
        }
        [None, None, Some(_)] => {
            for names in [&OF_CAN[..], &["baud"]] {
                refuse(report, reader, names, "a program in lockstep has");
            }
            Address::Rig { command: rig?.0.trim().to_owned() }
        }
        [Some(_), Some(other), _] | [_, Some(_), Some(other)] | [Some(_), None, Some(other)] => {
            let message = "a bus is either serial, CAN or a program in lockstep";
            let help = "give each its own [[links.bus]]";
            report.say(other.node.place, message, help);
            return None;
        }
        [None, None, None] => {
            let message = "this bus leads nowhere";
            let help = "give serial = \"/dev/ttyACM0\" or can = \"can0\"; \
                        `letoff devices` lists what there is";
            report.miss(reader.place, message, help);
            return None;
        }
    };
    Some(BoardBus { bit_rates: (nominal, data), ..BoardBus::new(address) })
}

/// Refuses what this kind of bus does not have.
fn refuse(
    report: &mut FindingList,
    reader: &mut TableReader<'_>,
    names: &[&'static str],
    has: &str,
) {
    for name in names {
        if let Some(entry) = reader.take(name) {
            report.say(entry.place, format!("{has} no {}", quoted(name)), "leave it out");
        }
    }
}
