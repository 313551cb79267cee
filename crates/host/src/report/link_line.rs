use std::fmt;

use boards::keybed::{BoardReport, LineReport};
use boards::links::WireState;
use boards::plan::{BusPlan, BusVerdict};
use serde::Serialize;

/// The part of a report about one link.
#[derive(Clone, Debug, Serialize)]
pub struct LinkLine {
    pub name: String,
    pub medium: Option<String>,
    #[serde(flatten)]
    pub load: LinkLoad,
    /// Receptions that were no frame.
    pub corrupt: u64,
    pub foreign: u64,
    pub down: u64,
    pub state: &'static str,
    /// Transmission errors, which the controller counts up and down.
    pub transmit_errors: u8,
    pub receive_errors: u8,
    pub reports: u64,
    pub restarts: u64,
    /// Frames dropped by the host because earlier ones were still on their way.
    pub dropped: u64,
    /// Tight part of its plan; a sentence.
    pub warning: Option<String>,
    /// Reason why it is down for good; a sentence.
    pub fault: Option<String>,
}

/// Load of a link: planned, and measured in the run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LinkLoad {
    /// Planned share of its time, at worst.
    pub planned_load: Option<f64>,
    /// Used share of its time, payloads charged as the worst.
    pub seen_load: Option<f64>,
    /// Used share of its time, payloads charged as the best.
    pub seen_load_least: Option<f64>,
    /// Planned samples of each board (1/s).
    pub planned_hz: Option<f64>,
    /// Received samples of each board, on average (1/s).
    pub seen_hz: f64,
}

impl LinkLine {
    /// Returns the row of `line` after `seconds`; `boards` are those of all lines.
    pub fn new(
        line: &LineReport,
        plan: Option<&BusPlan>,
        boards: &[BoardReport],
        seconds: f64,
    ) -> Self {
        let LineReport { name, statistics, medium, load, fault } = line;
        let on_it = boards.iter().filter(|board| board.name.line == *name);
        let frames: Vec<_> = on_it.map(|board| board.exchanged.0).collect();
        let mean = frames.iter().sum::<u64>() as f64 / frames.len().max(1) as f64;
        let health = statistics.health;
        Self {
            name: name.clone(),
            medium: medium.map(|it| it.to_string()),
            load: LinkLoad {
                planned_load: plan.map(BusPlan::load),
                seen_load: load.map(|it| it.most),
                seen_load_least: load.map(|it| it.least),
                planned_hz: plan.map(|it| it.sample_rate),
                seen_hz: mean / seconds.max(1e-9),
            },
            corrupt: statistics.corrupt,
            foreign: statistics.foreign,
            down: statistics.down,
            state: wire_words(health.state),
            transmit_errors: health.transmit_errors,
            receive_errors: health.receive_errors,
            reports: health.reports,
            restarts: health.restarts,
            dropped: health.dropped,
            warning: plan.filter(|it| it.verdict() != BusVerdict::Fits).map(BusPlan::sentence),
            fault: fault.clone(),
        }
    }
}

pub(crate) const fn wire_words(state: WireState) -> &'static str {
    match state {
        WireState::Active => "active",
        WireState::Warning => "warning",
        WireState::Passive => "passive",
        WireState::Off => "off",
    }
}

pub(super) fn fmt_table(lines: &[LinkLine], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if lines.is_empty() {
        return Ok(());
    }
    writeln!(
        f,
        "              link                 medium                   planned    seen     Hz   seen corrupt foreign   state TEC/REC restarts"
    )?;
    lines.iter().try_for_each(|line| line.fmt_row(f))?;
    let mut warnings = lines.iter().filter_map(|line| line.warning.as_ref());
    warnings.try_for_each(|warning| writeln!(f, "              {warning}"))
}

impl LinkLine {
    fn fmt_row(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |load: Option<f64>| {
            load.map_or_else(|| "-".to_owned(), |load| format!("{:.1} %", 100.0 * load))
        };
        let planned = self.load.planned_hz.map_or_else(|| "-".to_owned(), |hz| format!("{hz:.0}"));
        writeln!(
            f,
            "              {:20} {:24} {:>7} {:>7} {planned:>6} {:6.0} {:7} {:7} {:>7} {:>7} {:8}",
            self.name,
            self.medium.as_deref().unwrap_or("-"),
            percent(self.load.planned_load),
            percent(self.load.seen_load),
            self.load.seen_hz,
            self.corrupt,
            self.foreign,
            self.state,
            format!("{}/{}", self.transmit_errors, self.receive_errors),
            self.restarts,
        )
    }
}
