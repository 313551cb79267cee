//! `letoff devices --boards --test`: conformance of boards to the protocol, item by item.

use std::io::Write;

use boards::conformance::{
    ConformanceDepth, ConformanceItem, ConformanceOutcome, MOST_FORCE_MN, TestedBoard, conformance,
    introductions,
};
use boards::identity::Uid;
use boards::links::{BusSide, address::Address};
use serde::Serialize;

use super::{DevicesArgs, PATIENCE_US};
use crate::{Failure, print_json, tell};
use host::connected_boards::clock;
use scene::BoardBus;

#[derive(Debug, Serialize)]
struct BoardTest {
    link: String,
    number: u8,
    uid: String,
    items: Vec<ConformanceItem>,
}

pub(super) fn depth(text: &str) -> Result<ConformanceDepth, String> {
    match text {
        "quiet" => Ok(ConformanceDepth::Quiet),
        "arm" => Ok(ConformanceDepth::Arm),
        "stop" => Ok(ConformanceDepth::Stop),
        _ => Err("give quiet, arm or stop".to_owned()),
    }
}

/// Tests the boards on all links, and prints the items that each keeps and breaks.
pub(super) fn run(
    args: &DevicesArgs,
    depth: ConformanceDepth,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    announce(depth);
    let (mut boards, mut wrong) = (Vec::new(), Vec::new());
    for address in &args.links {
        match on_link(address, args.board, depth) {
            Ok(tested) => boards.extend(tested),
            Err(sentence) => wrong.push(sentence),
        }
    }
    if args.json {
        print_json(&boards, out)?;
    } else {
        boards.iter().try_for_each(|board| print(board, out))?;
    }
    wrong.extend(boards.iter().filter_map(broken));
    if wrong.is_empty() { Ok(()) } else { Err(Failure::Running(wrong.join("\nletoff: "))) }
}

/// Announces the motions of the keys.
fn announce(depth: ConformanceDepth) {
    let newtons = f64::from(MOST_FORCE_MN) * 1e-3;
    tell(&match depth {
        ConformanceDepth::Quiet => "no board is armed, and no force is sent".to_owned(),
        ConformanceDepth::Arm => format!(
            "boards are armed, and each key is asked for {newtons} N upwards for a second; if this \
             is broken off, they let go by themselves after 0.1 s"
        ),
        ConformanceDepth::Stop => format!(
            "boards are armed, each key is asked for {newtons} N upwards for a second, and in the \
             end every board on the link is stopped until it is started anew"
        ),
    });
}

/// Tests the boards on a link, or `only` the one with this number.
fn on_link(
    address: &Address,
    only: Option<u8>,
    depth: ConformanceDepth,
) -> Result<Vec<BoardTest>, String> {
    let clock = clock(&[BoardBus::new(address.clone())]);
    let mut link = address.open(BusSide::Host, &clock).map_err(|error| error.to_string())?;
    let mut found = introductions(&mut *link, &clock, PATIENCE_US);
    found.retain(|it| only.is_none_or(|number| it.board.number() == number));
    if let Some(fault) = link.fault() {
        return Err(fault.to_string());
    }
    if found.is_empty() {
        return Err(format!(
            "no hello of protocol 2 came over {}; see that the board has power and answers the \
             broadcast Who, as firmware-protocol/PROTOCOL.md says",
            address.place
        ));
    }
    let tested = found.iter().map(|introduction| {
        let mut board = TestedBoard::new(&mut *link, introduction, clock.clone());
        BoardTest {
            link: address.place.clone(),
            number: introduction.board.number(),
            uid: Uid(introduction.hello.uid).to_string(),
            items: conformance(&mut board, introduction, depth),
        }
    });
    Ok(tested.collect())
}

fn broken(board: &BoardTest) -> Option<String> {
    let n = board.items.iter().filter(|it| it.outcome == ConformanceOutcome::Broken).count();
    let items = if n == 1 { "item" } else { "items" };
    (0 < n).then(|| {
        format!(
            "board {} on {} breaks {n} {items} of firmware-protocol/PROTOCOL.md: see to its \
             firmware",
            board.number, board.link
        )
    })
}

fn print(board: &BoardTest, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "board {} on {}, {}:", board.number, board.link, board.uid)?;
    for ConformanceItem { item, outcome, seen } in &board.items {
        let outcome = match outcome {
            ConformanceOutcome::Kept => "kept",
            ConformanceOutcome::Broken => "BROKEN",
            ConformanceOutcome::Undecided => "undecided",
            ConformanceOutcome::NotTried => "not tried",
        };
        writeln!(out, "  {outcome:9}  {item}: {seen}")?;
    }
    Ok(())
}
