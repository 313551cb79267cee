//! `letoff devices --boards`: the boards that answer on links.

use std::io::Write;

use boards::calibration::file;
use boards::identity::ClaimedKeys;
use boards::keybed::{FoundBoard, Identified, Keybed, Offline};
use boards::links::address::Address;
use boards::refusal::{Refusal, reason_words};
use boards::rt::board_supervisor::LIGHT_S;
use documents::shown;
use firmware_protocol::Nothing;
use firmware_protocol::acyclic::bootloader::{self, Bootloader};
use firmware_protocol::acyclic::light::Light;
use firmware_protocol::acyclic::log::{LogLine, ReadLog};
use firmware_protocol::acyclic::{Operation, Status};
use firmware_protocol::frame::hello::feature;
use firmware_protocol::key::KeyIndex;
use serde::Serialize;

use super::health::{self, HealthRow};
use super::{DevicesArgs, PATIENCE_US, settings, test};
use crate::{Failure, print_json};
use host::connected_boards::{clock, folder, open};
use scene::{BoardBus, Boards};
/// Maximum number of lines to read from a log.
const MOST_LINES: u16 = 1_000;

#[derive(Debug, Serialize)]
struct OnLink {
    link: String,
    boards: Vec<BoardRow>,
    /// Reasons why it, or a board on it, cannot be used; a sentence each.
    refusals: Vec<String>,
    /// Reasons why settings were not written; a sentence each.
    #[serde(skip)]
    unwritten: Vec<String>,
}

#[derive(Debug, Serialize)]
struct BoardRow {
    number: u8,
    uid: String,
    keys: String,
    #[serde(skip)]
    range: ClaimedKeys,
    protocol: String,
    firmware: String,
    #[serde(flatten)]
    abilities: BoardAbilities,
    reset_reason: u8,
    /// Reason why it renders no force.
    safe_reason: &'static str,
    config_crc: String,
    /// Path of its calibration file, and `true` if the file exists.
    calibration: Option<String>,
    is_calibrated: bool,
    #[serde(flatten)]
    answers: BoardAnswers,
}

#[derive(Debug, Serialize)]
struct BoardAbilities {
    /// Maximum rates of samples and of forces, and the rate of its control of the motors (1/s).
    sample_hz: u16,
    force_hz: u16,
    law_hz: u16,
    quantum_nm: u32,
    max_force_n: f64,
    features: Vec<&'static str>,
}

/// Results of the requests that the command line asks for.
#[derive(Debug, Default, Serialize)]
struct BoardAnswers {
    log: Vec<String>,
    written: Vec<String>,
    /// Other requests that it carried out; a sentence each.
    done: Vec<String>,
    /// Health of the board and its keys, if it was asked and has that feature.
    health: Option<HealthRow>,
}

pub(super) fn run(args: &DevicesArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if args.links.is_empty() {
        return Err(Failure::Usage(
            "--boards needs a link: give --link serial:PORT or --link can:INTERFACE; `letoff \
             devices` lists what there is"
                .into(),
        ));
    }
    if let Some(depth) = args.test {
        return test::run(args, depth, out);
    }
    let links: Vec<_> = args.links.iter().map(|address| look(address, args)).collect();
    if args.json {
        print_json(&links, out)?;
    } else {
        links.iter().try_for_each(|link| print(link, out))?;
    }
    let mut wrong: Vec<_> = links.iter().flat_map(|link| &link.unwritten).cloned().collect();
    let boards: Vec<_> = links.iter().flat_map(|link| &link.boards).collect();
    wrong.extend(absent(args, &boards));
    let empty = links.iter().filter(|link| link.boards.is_empty());
    wrong.extend(empty.map(|link| format!("no board can be used on {}", link.link)));
    if wrong.is_empty() { Ok(()) } else { Err(Failure::Running(wrong.join("\nletoff: "))) }
}

/// Finds the boards on a link, and executes the requests of the command line.
fn look(address: &Address, args: &DevicesArgs) -> OnLink {
    let (boards, refusals, unwritten) = (Vec::new(), Vec::new(), Vec::new());
    let mut link = OnLink { link: address.place.clone(), boards, refusals, unwritten };
    let bus = BoardBus::new(address.clone());
    let clock = clock(std::slice::from_ref(&bus));
    let line = match open(&bus, &clock) {
        Ok(line) => line,
        Err(error) => {
            link.refusals.push(error.to_string());
            return link;
        }
    };
    let mut keybed = match Keybed::<Offline>::new(vec![line], clock).identify(PATIENCE_US) {
        Ok(keybed) => keybed,
        Err(refusals) => {
            link.refusals.extend(refusals.0.iter().map(ToString::to_string));
            return link;
        }
    };
    keybed.keep(|found| args.board.is_none_or(|number| found.board.number() == number));
    let mut settings = &args.set[..];
    if !settings.is_empty() && (keybed.boards().len() != 1 || args.links.len() != 1) {
        link.unwritten.push(
            "settings are written to one board: give one --link, and --board with its number"
                .into(),
        );
        settings = &[];
    }
    for found in keybed.boards().to_vec() {
        let (mut board, trouble) = describe(&found);
        link.refusals.extend(trouble);
        if args.log && found.hello.features & feature::LOG != 0 {
            match log(&found, &mut keybed) {
                Ok(lines) => board.answers.log = lines,
                Err(refusal) => link.refusals.push(refusal.to_string()),
            }
        }
        if let Err(refusal) = change(args, &found, &mut keybed, &mut board.answers.done) {
            link.unwritten.push(refusal.to_string());
        }
        if args.health && found.hello.features & feature::HEALTH != 0 {
            match health::read(&found, &mut keybed) {
                Ok(health) => board.answers.health = Some(health),
                Err(refusal) => link.refusals.push(refusal.to_string()),
            }
        }
        match settings::write(settings, &found, &mut keybed) {
            Ok(written) => board.answers.written = written,
            Err(refusal) => link.unwritten.push(refusal.to_string()),
        }
        link.boards.push(board);
    }
    link
}

/// Does the requested actions on a board; `done` receives a sentence on each.
fn change(
    args: &DevicesArgs,
    found: &FoundBoard,
    keybed: &mut Keybed<Identified>,
    done: &mut Vec<String>,
) -> Result<(), Refusal> {
    if args.light == Some(found.board.number()) {
        let _lit: Nothing = light(found, keybed)?;
        done.push(format!("it blinks for {LIGHT_S} s"));
    }
    let off = (&args.mute, 1, "has its motor off until the board starts anew");
    let on = (&args.unmute, 0, "has its motor back on");
    for (keys, muted, what) in [off, on] {
        for key in keys.iter().filter(|key| found.keys().contains(**key)) {
            health::mute(found, keybed, *key, muted)?;
            done.push(format!("{key} {what}"));
        }
    }
    if args.bootloader {
        let mut asker = keybed.asker(found.line, found.board);
        let wanted = Bootloader { magic: bootloader::MAGIC };
        let _left: Nothing = keybed.ask(&mut asker, Operation::Bootloader, &wanted)?;
        done.push("it starts its bootloader".to_owned());
    }
    Ok(())
}

fn absent(args: &DevicesArgs, boards: &[&BoardRow]) -> Vec<String> {
    let has_board = |number: &u8| boards.iter().any(|it| it.number == *number);
    let has_key = |key: &KeyIndex| boards.iter().any(|it| it.range.contains(*key));
    let numbers = args.light.iter().chain(&args.board).filter(|number| !has_board(number));
    let keys = args.mute.iter().chain(&args.unmute).filter(|key| !has_key(key));
    let mut absent: Vec<_> = numbers.map(|it| format!("no board has the number {it}")).collect();
    absent.dedup();
    absent.extend(keys.map(|key| format!("no board here has the key {key}")));
    absent
}

/// Returns the description of a board, and the mistakes of its calibration file.
fn describe(found: &FoundBoard) -> (BoardRow, Option<String>) {
    let hello = &found.hello;
    let file = folder(&Boards::default()).map(|folder| file::path(&folder, found.uid()));
    let n_keys = usize::from(hello.n_keys);
    let read = file.as_ref().map(|file| file::read(file, found.uid(), n_keys));
    let is_calibrated = matches!(read, Some(Ok(Some(_))));
    let board = BoardRow {
        number: found.board.number(),
        uid: found.uid().to_string(),
        keys: found.keys().to_string(),
        range: found.keys(),
        protocol: format!("{}.{}", hello.major, hello.minor),
        firmware: format!("{}.{}", hello.firmware_major, hello.firmware_minor),
        abilities: BoardAbilities {
            sample_hz: hello.max_sample_hz,
            force_hz: hello.max_force_hz,
            law_hz: hello.law_hz,
            quantum_nm: hello.quantum_nm,
            max_force_n: f64::from(hello.max_force_mn) * 1e-3,
            features: features(hello.features),
        },
        reset_reason: hello.reset_reason,
        safe_reason: reason_words(hello.safe_reason),
        config_crc: format!("{:08x}", hello.config_crc),
        is_calibrated,
        calibration: file.map(|file| shown(&file)),
        answers: BoardAnswers::default(),
    };
    (board, read.and_then(Result::err))
}

fn features(bits: u16) -> Vec<&'static str> {
    const WORDS: [(u16, &str); 7] = [
        (feature::SLOPES, "slopes"),
        (feature::MULTICAST, "multicast forces"),
        (feature::VELOCITY, "velocities"),
        (feature::FINGERS, "simulated fingers"),
        (feature::LOG, "a log"),
        (feature::HEALTH, "health"),
        (feature::BOOTLOADER, "a bootloader"),
    ];
    WORDS.iter().filter(|(bit, _)| bits & bit != 0).map(|(_, word)| *word).collect()
}

fn light(found: &FoundBoard, keybed: &mut Keybed<Identified>) -> Result<Nothing, Refusal> {
    let mut asker = keybed.asker(found.line, found.board);
    keybed.ask(&mut asker, Operation::Light, &Light { seconds: LIGHT_S })
}

fn log(found: &FoundBoard, keybed: &mut Keybed<Identified>) -> Result<Vec<String>, Refusal> {
    let mut asker = keybed.asker(found.line, found.board);
    let mut lines = Vec::new();
    for line in 0..MOST_LINES {
        let read = keybed.ask::<_, LogLine>(&mut asker, Operation::ReadLog, &ReadLog { line });
        let it = match read {
            Ok(it) => it,
            // The log has no such line: it is empty, or was shortened.
            Err(Refusal::Declined { status: Status::BadValue, .. }) => break,
            Err(refusal) => return Err(refusal),
        };
        let text = String::from_utf8_lossy(&it.text);
        let text = printable(text.trim_end_matches('\0'));
        lines.push(format!("{:12.6} s  {text}", f64::from(it.board_us) * 1e-6));
        if it.lines <= line + 1 {
            break;
        }
    }
    Ok(lines)
}

/// Returns `text` without control characters for terminals.
fn printable(text: &str) -> String {
    text.replace(char::is_control, "\u{FFFD}")
}

fn print(link: &OnLink, out: &mut dyn Write) -> Result<(), Failure> {
    writeln!(out, "{}:", link.link)?;
    for it in &link.boards {
        let (can, answers) = (&it.abilities, &it.answers);
        writeln!(
            out,
            "  board {:<3} {} {:9} firmware {}, protocol {}, configuration {}",
            it.number, it.uid, it.keys, it.firmware, it.protocol, it.config_crc
        )?;
        writeln!(
            out,
            "    samples {}/s, forces {}/s, worked out {}/s, at most {:.1} N, {} nm a count",
            can.sample_hz, can.force_hz, can.law_hz, can.max_force_n, can.quantum_nm
        )?;
        let has = if can.features.is_empty() { "nothing".into() } else { can.features.join(", ") };
        writeln!(out, "    has {has}")?;
        let start = match it.reset_reason {
            1 => "started by power".to_owned(),
            other => format!("started for reason {other}"),
        };
        writeln!(out, "    {start}; {}", it.safe_reason)?;
        let file = it.calibration.as_deref().unwrap_or("anywhere");
        let is = if it.is_calibrated { "calibrated in" } else { "no calibration in" };
        writeln!(out, "    {is} {file}")?;
        answers
            .done
            .iter()
            .chain(&answers.written)
            .try_for_each(|line| writeln!(out, "    {line}"))?;
        if let Some(health) = &answers.health {
            health::print(health, out)?;
        }
        answers.log.iter().try_for_each(|line| writeln!(out, "    {line}"))?;
    }
    link.refusals.iter().try_for_each(|why| Ok(writeln!(out, "  {why}")?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_cannot_command_the_terminal() {
        assert_eq!(printable("\u{1b}[2Jhot\r µN"), "\u{FFFD}[2Jhot\u{FFFD} µN");
    }
}
