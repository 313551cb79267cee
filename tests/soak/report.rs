//! A trial in words.

use crate::plan::SoakPlan;
use crate::trial::{PlayedTrial, SoakChoice, SoakTime};
use crate::watch::Digest;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct PromiseVerdict {
    pub(crate) promise: &'static str,
    pub(crate) is_kept: bool,
    pub(crate) seen: String,
}

/// Returns the music, the intended faults, and a line for each verdict.
///
/// The digest covers the forces of all keys and every MIDI message: in virtual time a seed gives one digest.
pub(crate) fn text(
    choice: &SoakChoice,
    plan: &SoakPlan,
    played: &PlayedTrial,
    verdicts: &[PromiseVerdict],
) -> String {
    let mut digest = Digest::default();
    played.seen.whole.iter().for_each(|key| digest.add(key.0));
    digest.add(played.sounds.digest.0);
    let time = match choice.time {
        SoakTime::Virtual => "virtual",
        SoakTime::Real => "real",
    };
    let (run, wires, acted) = (&played.report, played.seen.wires, &played.acted);
    let mut lines = vec![
        format!(
            "{}: {} ticks in {time} time, {} skipped, {} strikes, {} notes; seed {}, digest {:016x}",
            choice.scene.name,
            run.extent.ticks,
            run.extent.skipped,
            run.totals.strikes,
            played.sounds.notes,
            choice.seed,
            digest.0
        ),
        format!(
            "  frames    {} lost, {} damaged, {} late, {} met a silent line",
            wires.dropped, wires.flipped, wires.delayed, wires.down
        ),
        format!(
            "  keys      {} sensors said NaN, {} voices got impossible values, {} values were set, \
             {} of them wrong",
            plan.sensors.len(),
            plan.voices.len(),
            acted.asked + acted.wrong,
            acted.wrong
        ),
        format!(
            "  outside   {} times the MIDI port vanished, the disk was full once",
            plan.away.len()
        ),
    ];
    lines.extend(played.strangers.iter().map(|what| format!("            {what}")));
    lines.extend(verdicts.iter().map(|PromiseVerdict { promise, is_kept, seen }| {
        format!("  {}  {promise}: {seen}", if *is_kept { "kept  " } else { "BROKEN" })
    }));
    lines.join("\n") + "\n"
}
