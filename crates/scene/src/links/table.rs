//! The table `links`.

use firmware_protocol::acyclic::arm::{LONGEST_VALID_MS, SHORTEST_VALID_MS};
use firmware_protocol::frame::key_forces::ForcePacking;

use super::{Boards, FORCES, LinksConfig, SAMPLES, bus, period_us};
use crate::quantity::Quantity;
use crate::read::TableReader;
use documents::quoted;
use documents::toml::{FindingList, SourcePlace, TomlNode};

const VALID: Quantity = Quantity {
    unit: "s",
    range: (SHORTEST_VALID_MS as f64 * 1e-3, LONGEST_VALID_MS as f64 * 1e-3),
};

/// Names that only boards have.
const OF_BOARDS: [&str; 5] = ["samples", "forces", "valid", "calibration", "bus"];

#[derive(Clone, Copy, PartialEq, Eq)]
enum LinksKind {
    Simulated,
    Boards,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate {
    pub(crate) hz: u32,
    pub(crate) place: SourcePlace,
}

/// Reads the table `links` of a scene with this rate; a simulated keybed if there is none.
pub(crate) fn read(
    report: &mut FindingList,
    scene: &mut TableReader<'_>,
    rate: Option<Rate>,
) -> LinksConfig {
    let Some(mut reader) = scene.table(report, "links") else { return LinksConfig::Simulated };
    let kinds = [("simulated", LinksKind::Simulated), ("boards", LinksKind::Boards)];
    let kind = reader.choice(report, "kind", "there is no kind of link", &kinds);
    let says_kind = reader.take("kind").is_some();
    let buses = reader.take("bus").map(|entry| &entry.node);
    let boards = read_boards(report, &mut reader, buses);
    match kind {
        Some(LinksKind::Boards) => refuse_no_bus(report, reader.place, buses),
        None if says_kind || buses.is_some() => {}
        Some(LinksKind::Simulated) | None => refuse_of_boards(report, &mut reader),
    }
    reader.finish(report);
    if kind == Some(LinksKind::Boards) || kind.is_none() && buses.is_some() {
        refuse_rate(report, rate);
        LinksConfig::Boards(boards)
    } else {
        LinksConfig::Simulated
    }
}

fn read_boards(
    report: &mut FindingList,
    reader: &mut TableReader<'_>,
    buses: Option<&TomlNode>,
) -> Boards {
    let mut boards = Boards::default();
    let samples = reader.choice(report, "samples", "samples have no packing", &SAMPLES);
    boards.samples = samples.unwrap_or_default();
    if let Some(forces) = reader.choice(report, "forces", "forces have no packing", &FORCES) {
        boards.forces = forces;
    }
    // Of samples that are wrong themselves nothing is known.
    if samples.is_some() || reader.take("samples").is_none() {
        refuse_blind_slopes(report, reader, &boards);
    }
    if let Some(seconds) = reader.number(report, "valid", VALID) {
        boards.valid_ms = milliseconds(seconds);
    }
    boards.calibration =
        reader.text(report, "calibration").map(|(path, place)| report.folder(place).join(path));
    boards.buses = buses.map_or_else(Vec::new, |node| bus::read_all(report, node));
    boards
}

fn refuse_blind_slopes(report: &mut FindingList, reader: &mut TableReader<'_>, boards: &Boards) {
    let Some(entry) = reader.take("forces") else { return };
    if boards.forces == ForcePacking::Force16Slope && !boards.samples.has_velocity() {
        let message = "\"force16-slope\" needs velocities, and these samples have none";
        let help = "give samples = \"position24-velocity\", or forces = \"force16\"";
        report.say(entry.node.place, message, help);
    }
}

fn refuse_no_bus(report: &mut FindingList, place: SourcePlace, buses: Option<&TomlNode>) {
    let message = "boards need a bus";
    let help = "add [[links.bus]] with serial = \"/dev/ttyACM0\" or can = \"can0\"";
    match buses {
        None => report.miss(place, message, help),
        Some(node) if node.items().is_some_and(<[TomlNode]>::is_empty) => {
            report.say(node.place, message, help);
        }
        Some(_) => {}
    }
}

fn refuse_of_boards(report: &mut FindingList, reader: &mut TableReader<'_>) {
    for name in OF_BOARDS {
        let Some(entry) = reader.take(name) else { continue };
        let message = match name {
            "bus" => "a simulated keybed has no bus".to_owned(),
            _ => format!("{} is agreed with boards, and these keys are simulated", quoted(name)),
        };
        report.say(entry.node.place, message, "leave it out, or write kind = \"boards\"");
    }
}

fn refuse_rate(report: &mut FindingList, rate: Option<Rate>) {
    let Some(Rate { hz, place }) = rate.filter(|it| period_us(it.hz).is_none()) else { return };
    let message = format!("boards exchange every whole number of 100 us, and {hz} Hz is none");
    let slower = (1..hz).rev().find(|it| period_us(*it).is_some()).unwrap_or(100);
    let faster = (hz..10_000).find(|it| period_us(*it).is_some()).unwrap_or(10_000);
    report.say(place, message, format!("give {slower} or {faster} Hz"));
}

/// Whole milliseconds in a time that was checked (s).
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "5 to 100")]
fn milliseconds(seconds: f64) -> u8 {
    (seconds * 1e3).round() as u8
}
