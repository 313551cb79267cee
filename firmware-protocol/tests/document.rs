//! PROTOCOL.md against the code: its tables are those of the C header, which is generated from
//! the code, and its examples are golden vectors.

use std::collections::BTreeMap;

use firmware_protocol::acyclic::config;
use firmware_protocol::schema;
use firmware_protocol::version::PROTOCOL_VERSION;

use crate::c_header::{header, screaming};

type Rows = Vec<Vec<String>>;

fn document() -> String {
    let path = crate::tools::crate_root().join("PROTOCOL.md");
    std::fs::read_to_string(path).expect("the document")
}

#[track_caller]
fn table(title: &str) -> Rows {
    let document = document();
    let mut lines = document.lines().skip_while(|line| line.trim_start_matches('#') != title);
    assert!(lines.next().is_some(), "no heading:{title}");
    let rows = lines.skip_while(|line| !line.starts_with('|')).take_while(|it| it.starts_with('|'));
    let cells = |line: &str| {
        let cells = line.trim_matches('|').split('|');
        cells.map(|it| it.trim().trim_matches('`').to_owned()).collect::<Vec<_>>()
    };
    rows.skip(2).map(cells).collect()
}

fn defined(prefix: &str) -> BTreeMap<String, String> {
    let start = format!("#define LETOFF_{prefix}");
    let header = header();
    let numbers = header.lines().filter_map(|line| {
        let (name, value) = line.strip_prefix(&start)?.split_once(' ')?;
        Some((name.to_owned(), value.trim_end_matches('u').to_owned()))
    });
    numbers.collect()
}

#[track_caller]
fn check(title: &str, prefix: &str, beside: &[&str]) {
    let said: BTreeMap<_, _> =
        table(title).iter().map(|it| (name(&it[1]), it[0].clone())).collect();
    let mut defined = defined(prefix);
    defined.retain(|name, _| !beside.contains(&name.as_str()));
    assert!(1 < said.len() && said == defined, "{title}: {said:?}, the code has {defined:?}");
}

fn name(text: &str) -> String {
    let is_upper = |it: char| it.is_uppercase() || it == '_' || it.is_ascii_digit();
    if text.chars().all(is_upper) { text.to_owned() } else { screaming(text) }
}

#[test]
fn every_number_in_the_document_is_that_of_the_code() {
    check(" Frame kinds", "KIND_", &[]);
    check(" Sample packings", "SAMPLES_", &[]);
    check(" Force packings", "FORCES_", &[]);
    check(" Messages", "BROADCAST_", &["MAX_LEN"]);
    check(" Safe reasons", "SAFE_", &[]);
    check(" Statuses", "STATUS_", &[]);
    check(" Settings", "SETTING_", &["COUNT"]);
    check(" CAN classes", "CLASS_", &[]);
    check(" Key faults", "KEY_FAULT_", &[]);
    let features = table(" Features").into_iter().map(|it| {
        let bit: u32 = it[0].parse().expect("a bit");
        (it[1].clone(), (1_u32 << bit).to_string())
    });
    assert_eq!(features.collect::<BTreeMap<_, _>>(), defined("FEATURE_"));
    let all = defined("");
    for row in table(" Constants") {
        assert_eq!(all.get(&row[0]), Some(&row[1]), "{row:?}");
    }
}

#[test]
fn the_generated_tables_are_current() {
    let hint = "run: cargo run -p firmware-protocol --example c_header";
    assert!(document() == crate::c_header::document(&document()), "PROTOCOL.md is old; {hint}");
}

#[test]
fn the_examples_in_the_document_are_golden_vectors() {
    let vectors = crate::vector::all();
    let rows = table(" Examples");
    assert!(5 < rows.len());
    for row in rows {
        let vector = vectors.iter().find(|it| it.name == row[0]).expect("a vector");
        assert_eq!([vector.text("frame"), vector.text("wire")], [&row[1], &row[2]], "{row:?}");
    }
}

#[test]
fn the_sums_in_the_document_are_right() {
    let document = document();
    let (version, crc) = (PROTOCOL_VERSION, config::crc(&[3, 33, 30_000]));
    let check = crc::Crc::<u16>::new(&crc::CRC_16_IBM_3740).checksum(b"123456789");
    for words in [
        format!("# The Letoff protocol, version {}.{}\n", version.major, version.minor),
        format!("30000 is `{crc:08X}`"),
        format!("`123456789` is `{check:04X}`"),
        format!("In this version it is `{:016X}`", schema::HASH),
    ] {
        assert!(document.contains(&words), "no `{words}`");
    }
    for line in schema::CYCLIC.lines().map(|it| format!("    {it}\n")) {
        assert!(document.contains(&line), "no `{line}`");
    }
}
