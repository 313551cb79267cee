//! The version of the program, and the header of its JSON reports.

use std::io::{self, Write};
use std::sync::OnceLock;

use serde::Serialize;
use time::OffsetDateTime;
use time::format_description::well_known::Rfc3339;

use super::Failure;

/// Version of the JSON reports: it grows when a field is removed or changes its meaning.
const FORMAT: u32 = 1;

static STARTED: OnceLock<OffsetDateTime> = OnceLock::new();

/// Records the start of the command.
pub fn start() {
    STARTED.get_or_init(OffsetDateTime::now_utc);
}

/// Returns the program's version, with the commit of its build if known.
pub fn version() -> &'static str {
    static VERSION: OnceLock<String> = OnceLock::new();
    VERSION.get_or_init(|| match option_env!("LETOFF_BUILT_FROM") {
        Some(commit) => format!("{} (commit {commit})", env!("CARGO_PKG_VERSION")),
        None => format!("{} (commit unknown)", env!("CARGO_PKG_VERSION")),
    })
}

/// Formats `at` in UTC, to the second.
pub fn utc(at: OffsetDateTime) -> String {
    at.replace_nanosecond(0).unwrap_or(at).format(&Rfc3339).unwrap_or_default()
}

/// Common fields of all JSON reports.
#[derive(Clone, Debug, Serialize)]
pub struct ReportHeader {
    format: u32,
    version: &'static str,
    /// Start of the command (UTC).
    started: String,
}

impl ReportHeader {
    pub fn of_command() -> Self {
        start();
        let started = STARTED.get().copied().map(utc).unwrap_or_default();
        Self { format: FORMAT, version: version(), started }
    }

    pub fn fields(&self) -> serde_json::Map<String, serde_json::Value> {
        match serde_json::to_value(self) {
            Ok(serde_json::Value::Object(fields)) => fields,
            Ok(_) | Err(_) => serde_json::Map::new(),
        }
    }
}

#[derive(Serialize)]
struct HeadedReport<'a, T> {
    #[serde(flatten)]
    header: ReportHeader,
    #[serde(flatten)]
    report: &'a T,
}

/// Prints a report, which must be a structure with fields, as JSON with its header.
pub fn print_report(report: &impl Serialize, out: &mut dyn Write) -> Result<(), Failure> {
    print_json(&HeadedReport { header: ReportHeader::of_command(), report }, out)
}

/// Prints `value` as JSON without a header, for lists and states.
pub fn print_json(value: &impl Serialize, out: &mut dyn Write) -> Result<(), Failure> {
    serde_json::to_writer_pretty(&mut *out, value).map_err(io::Error::from)?;
    Ok(writeln!(out)?)
}
