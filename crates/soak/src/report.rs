//! What is said of a trial, for people and as JSON.

use std::fmt;

use serde::Serialize;

use crate::plan::SoakPlan;
use crate::trial::{PlayedTrial, SoakChoice, SoakTime};
use crate::watch::Digest;

/// A promise, and whether it was kept.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct PromiseVerdict {
    /// The promise, in a few words.
    pub promise: &'static str,
    pub is_kept: bool,
    /// What was seen, in words.
    pub seen: String,
}

/// What went wrong on purpose.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct Injected {
    /// Frames that were lost, damaged, late, or met a silent line.
    pub lost: u64,
    pub damaged: u64,
    pub late: u64,
    pub silent: u64,
    /// Sensors that said NaN for a while.
    pub sensors: usize,
    /// Voices that got impossible values for a while.
    pub voices: usize,
    /// Values set by a tuner, and those of them that are none.
    pub values: u64,
    pub wrong_values: u64,
    /// Times that the MIDI port vanished.
    pub ports: usize,
    /// What strangers did, in words.
    pub strangers: Vec<String>,
    /// Times that a supervised host was killed beside the trial.
    pub kills: usize,
}

/// What came of a trial.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct SoakReport {
    /// Number of this format.
    pub format: u32,
    pub scene: String,
    pub seed: u64,
    pub seconds: f64,
    pub time: SoakTime,
    pub ticks: u64,
    pub skipped: u64,
    pub strikes: u64,
    pub notes: u64,
    /// Forces of all keys and messages of MIDI as one number: in virtual time the same for the
    /// same seed.
    pub digest: String,
    pub injected: Injected,
    pub verdicts: Vec<PromiseVerdict>,
}

impl SoakReport {
    pub(crate) fn new(
        choice: &SoakChoice,
        plan: &SoakPlan,
        played: &PlayedTrial,
        verdicts: Vec<PromiseVerdict>,
    ) -> Self {
        let mut digest = Digest::default();
        played.seen.whole.iter().for_each(|key| digest.add(key.0));
        digest.add(played.sounds.digest.0);
        let wires = played.seen.wires;
        Self {
            format: 1,
            scene: choice.scene.name.clone(),
            seed: choice.seed,
            seconds: choice.seconds,
            time: choice.time,
            ticks: played.report.ticks,
            skipped: played.report.skipped,
            strikes: played.report.strikes,
            notes: played.sounds.notes,
            digest: format!("{:016x}", digest.0),
            injected: Injected {
                lost: wires.dropped,
                damaged: wires.flipped,
                late: wires.delayed,
                silent: wires.down,
                sensors: plan.sensors.len(),
                voices: plan.voices.len(),
                values: played.acted.asked + played.acted.wrong,
                wrong_values: played.acted.wrong,
                ports: plan.away.len(),
                strangers: played.strangers.clone(),
                kills: played.killed.as_ref().map_or(0, |it| it.kills),
            },
            verdicts,
        }
    }

    /// Returns the promises that were broken, a sentence each.
    pub fn broken(&self) -> Vec<String> {
        let broken = self.verdicts.iter().filter(|it| !it.is_kept);
        broken.map(|it| format!("{}: {}", it.promise, it.seen)).collect()
    }
}

impl fmt::Display for SoakReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let time = match self.time {
            SoakTime::Virtual => "virtual",
            SoakTime::Real => "real",
        };
        writeln!(
            f,
            "{}: {} ticks in {time} time, {} skipped, {} strikes, {} notes; seed {}, digest {}",
            self.scene, self.ticks, self.skipped, self.strikes, self.notes, self.seed, self.digest
        )?;
        let it = &self.injected;
        writeln!(
            f,
            "  frames    {} lost, {} damaged, {} late, {} met a silent line",
            it.lost, it.damaged, it.late, it.silent
        )?;
        writeln!(
            f,
            "  keys      {} sensors said NaN, {} voices got impossible values, {} values were set, \
             {} of them wrong",
            it.sensors, it.voices, it.values, it.wrong_values
        )?;
        writeln!(
            f,
            "  outside   the MIDI port vanished {} times, the disk was full once",
            it.ports
        )?;
        it.strangers.iter().try_for_each(|what| writeln!(f, "            {what}"))?;
        if 0 < it.kills {
            writeln!(f, "            a supervised host was killed {} times", it.kills)?;
        }
        for PromiseVerdict { promise, is_kept, seen } in &self.verdicts {
            writeln!(f, "  {}  {promise}: {seen}", if *is_kept { "kept  " } else { "BROKEN" })?;
        }
        Ok(())
    }
}
