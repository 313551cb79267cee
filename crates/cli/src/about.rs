//! Which program this is, and the fields by which its JSON reports say so.

use std::io::{self, Write};
use std::sync::OnceLock;

use serde::Serialize;
use time::OffsetDateTime;
use time::format_description::well_known::Rfc3339;

use super::Failure;

/// The number of the format of JSON reports: it grows when a field goes or means something else.
const FORMAT: u32 = 1;

/// When the command started.
static STARTED: OnceLock<OffsetDateTime> = OnceLock::new();

/// Notes that the command starts.
pub fn start() {
    STARTED.get_or_init(OffsetDateTime::now_utc);
}

/// Returns the program's version, with the commit from which it was built if that is known.
pub fn version() -> &'static str {
    static VERSION: OnceLock<String> = OnceLock::new();
    VERSION.get_or_init(|| match option_env!("LETOFF_BUILT_FROM") {
        Some(commit) => format!("{} (commit {commit})", env!("CARGO_PKG_VERSION")),
        None => format!("{} (commit unknown)", env!("CARGO_PKG_VERSION")),
    })
}

/// Returns `at` as programs and people read it, to the second.
pub fn utc(at: OffsetDateTime) -> String {
    at.replace_nanosecond(0).unwrap_or(at).format(&Rfc3339).unwrap_or_default()
}

/// The fields that each JSON report has beside its own.
#[derive(Clone, Debug, Serialize)]
pub struct ReportHeader {
    format: u32,
    /// The version of the program that made it.
    version: &'static str,
    /// When the command started (UTC).
    started: String,
}

impl ReportHeader {
    /// Returns the header of a report of this command.
    pub fn new() -> Self {
        start();
        let started = STARTED.get().copied().map(utc).unwrap_or_default();
        Self { format: FORMAT, version: version(), started }
    }

    /// Returns its fields, for a report that another crate writes.
    pub fn fields(&self) -> serde_json::Map<String, serde_json::Value> {
        match serde_json::to_value(self) {
            Ok(serde_json::Value::Object(fields)) => fields,
            Ok(_) | Err(_) => serde_json::Map::new(),
        }
    }
}

/// A report below its header.
#[derive(Serialize)]
struct HeadedReport<'a, T> {
    #[serde(flatten)]
    header: ReportHeader,
    #[serde(flatten)]
    report: &'a T,
}

/// Prints a report, which is a structure with fields, as JSON.
pub fn print_report(report: &impl Serialize, out: &mut dyn Write) -> Result<(), Failure> {
    print_json(&HeadedReport { header: ReportHeader::new(), report }, out)
}

/// Prints `value` as JSON: lists, and what is no report of something that was done.
pub fn print_json(value: &impl Serialize, out: &mut dyn Write) -> Result<(), Failure> {
    serde_json::to_writer_pretty(&mut *out, value).map_err(io::Error::from)?;
    Ok(writeln!(out)?)
}
