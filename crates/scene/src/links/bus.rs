//! `[[links.bus]]`: a link, and what it is like.

use boards::links::LINKS;
use boards::links::address::{Address, BoardLinkKind, listed};

use super::board::{self, Listed};
use super::{BIT_RATES, BoardBus};
use crate::quantity::Quantity;
use crate::read::{self, TableReader};
use documents::quoted;
use documents::toml::{FindingList, TomlNode};

const BAUD_RATE: Quantity = Quantity { unit: "1", range: (9_600.0, 20e6) };
const BIT_RATE: Quantity = Quantity { unit: "1", range: (10e3, 20e6) };

/// Keys that only some kinds of links have.
const OPTIONS: [&str; 4] = ["mode", "bit_rate", "data_bit_rate", "baud"];

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
        if buses.iter().any(|other| other.address.place == bus.address.place) {
            let message = format!("{} stands here twice", quoted(&bus.address.place));
            report.say(node.place, message, "leave one of them out");
        }
        buses.push(BoardBus { boards: boards.iter().filter_map(Listed::checked).collect(), ..bus });
    }
    board::refuse_shared_keys(report, &listed);
    buses
}

fn read(report: &mut FindingList, reader: &mut TableReader<'_>) -> Option<BoardBus> {
    let keys = || LINKS.iter().filter(|it| BoardLinkKind::find(it.key, None) == Some(it));
    let places: Vec<_> = keys().map(|it| reader.text(report, it.key)).collect();
    let baud = reader.whole(report, "baud", BAUD_RATE);
    let modes: Vec<_> = LINKS.iter().filter_map(|it| Some((it.mode?, it.mode?))).collect();
    let mode = reader.choice(report, "mode", "there is no mode", &modes);
    let nominal = reader.whole(report, "bit_rate", BIT_RATE).unwrap_or(BIT_RATES.0);
    let data = reader.whole(report, "data_bit_rate", BIT_RATE).unwrap_or(BIT_RATES.1);
    let given =
        keys().zip(places).filter_map(|(kind, text)| Some((reader.take(kind.key)?, kind, text)));
    let mut given = given.collect::<Vec<_>>().into_iter();
    let Some((_, usual, place)) = given.next() else {
        let message = "this bus leads nowhere";
        let help = "give serial = \"/dev/ttyACM0\" or can = \"can0\"; \
                    `letoff devices` lists what there is";
        report.miss(reader.place, message, help);
        return None;
    };
    if let Some((other, ..)) = given.next() {
        let message = format!("a bus is either {}", listed(keys().map(|it| it.noun), " or "));
        report.say(other.node.place, message, "give each its own [[links.bus]]");
        return None;
    }
    let kind = BoardLinkKind::find(usual.key, mode)?;
    for name in OPTIONS {
        let lacking = [usual, kind].into_iter().find(|it| !it.options.contains(&name));
        if let (Some(it), Some(entry)) = (lacking, reader.take(name)) {
            let message = format!("{} has no {}", it.subject, quoted(name));
            report.say(entry.place, message, "leave it out");
        }
    }
    let address = Address::new(kind, &place?.0, baud);
    Some(BoardBus { bit_rates: (nominal, data), ..BoardBus::new(address) })
}
