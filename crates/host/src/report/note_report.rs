use std::collections::BTreeSet;
use std::fmt;

use firmware_protocol::key::KeyIndex;
use pianist::{Assessment, CutNote, Deviation, DeviationKind, PassedOverCounts, ShortStroke};
use serde::{Serialize, Serializer};
use telemetry::key_name;

/// The quality of a performance.
#[derive(Clone, Debug, Serialize)]
pub struct NoteReport {
    pub pieces: usize,
    /// Passes that have begun; 1 unless the list repeats.
    pub passes: u64,
    /// Notes that the pieces ask for within the run, in all passes.
    pub played: usize,
    pub struck: usize,
    pub missed: usize,
    /// Strikes that are not in the pieces.
    pub extra: usize,
    /// Distances of strikes from their onsets, early or late (ms).
    pub onset_error_ms: ErrorQuantiles,
    /// Distances of strikes from their notes (MIDI velocities).
    pub velocity_error: ErrorQuantiles,
    /// Distances of note ends from the wanted ones, early or late (ms).
    pub end_error_ms: ErrorQuantiles,
    /// Distances of release velocities from the written ones, if the pieces contain any.
    pub release_error: Option<ErrorQuantiles>,
    /// Notes missed or late though the pianist played them, and extra strikes, in order of time.
    pub deviations: Vec<NoteDeviation>,
    /// Softest and loudest hammer speed that every key of the pieces can reach (m/s).
    pub range_m_per_s: Option<(f64, f64)>,
    /// Predicted shortcomings of the keys in one pass, in order of time.
    pub shortfalls: Vec<NoteShortfall>,
    /// Notes that end early for the next stroke on their key, in order of time.
    pub cuts: Vec<NoteCut>,
    pub unplayed: UnplayedNotes,
}

/// Notes that the pianist does not play, or not on their own.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize)]
pub struct UnplayedNotes {
    /// Notes on keys without a voice in the scene.
    pub without_voice: usize,
    pub keys_without_voice: Vec<String>,
    /// Contents of the pieces by kind, such as `percussion` and `program_changes`.
    #[serde(flatten, serialize_with = "by_name")]
    pub passed_over: PassedOverCounts,
}

/// Serializes every kind by its name.
fn by_name<S: Serializer>(counts: &PassedOverCounts, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(counts.named())
}

impl UnplayedNotes {
    /// Counts notes without a voice on `keys` (0 to 87, one per note), and what was passed over.
    pub fn new(keys: &[u8], passed_over: PassedOverCounts) -> Self {
        let names: BTreeSet<u8> = keys.iter().copied().collect();
        let names = names.into_iter().filter_map(KeyIndex::new).map(|key| key.to_string());
        Self { without_voice: keys.len(), keys_without_voice: names.collect(), passed_over }
    }

    fn fmt_lines(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.without_voice > 0 {
            let keys = self.keys_without_voice.join(", ");
            let n = self.without_voice;
            writeln!(f, "              {n} more on keys without a voice in this scene: {keys}")?;
        }
        if self.passed_over != PassedOverCounts::default() {
            writeln!(f, "              not played as in the file: {}", self.passed_over)?;
        }
        Ok(())
    }
}

/// A note that the keys cannot play as written.
#[derive(Clone, Debug, Serialize)]
pub struct NoteShortfall {
    pub key: String,
    /// Intended time of sounding (s since the start of the run).
    pub at_s: f64,
    /// `true` if the note is left out.
    pub is_left_out: bool,
    pub why: String,
}

impl NoteShortfall {
    pub fn new(short: &ShortStroke) -> Self {
        Self {
            key: key_name(short.key.into()),
            at_s: short.onset,
            is_left_out: short.why.is_left_out(),
            why: short.why.to_string(),
        }
    }
}

impl fmt::Display for NoteShortfall {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { key, at_s, why, .. } = self;
        write!(f, "{key} at {at_s:.3} s is {why}")
    }
}

/// A note that ends early for the next stroke on its key.
#[derive(Clone, Debug, Serialize)]
pub struct NoteCut {
    pub key: String,
    /// Intended time of the note (s since the start of the run).
    pub at_s: f64,
    /// Lost time (ms).
    pub by_ms: f64,
    pub why: String,
}

impl NoteCut {
    pub fn new(cut: &CutNote) -> Self {
        let why = format!("for the next stroke of its key at {:.3} s", cut.next);
        Self { key: key_name(cut.key.into()), at_s: cut.onset, by_ms: cut.by * 1e3, why }
    }
}

impl fmt::Display for NoteCut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { key, at_s, by_ms, why } = self;
        write!(f, "{key} at {at_s:.3} s ends {by_ms:.0} ms early {why}")
    }
}

/// A missed or late note, or an extra strike.
#[derive(Clone, Debug, Serialize)]
pub struct NoteDeviation {
    pub key: String,
    /// Intended time of the note, or time of the extra strike (s since the start of the run).
    pub at_s: f64,
    pub what: &'static str,
    /// Lateness of the strike (ms); `None` unless the note is late.
    pub late_ms: Option<f64>,
}

impl NoteDeviation {
    fn new(it: &Deviation) -> Self {
        let (what, late_ms) = match it.kind {
            DeviationKind::Missed => ("missed", None),
            DeviationKind::Extra => ("extra", None),
            DeviationKind::Late { by } => ("late", Some(by * 1e3)),
        };
        Self { key: key_name(it.key.into()), at_s: it.at, what, late_ms }
    }
}

impl fmt::Display for NoteDeviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { key, at_s, what, late_ms } = self;
        write!(f, "{key} at {at_s:.3} s is {what}")?;
        late_ms.map_or(Ok(()), |late| write!(f, " by {late:.0} ms"))
    }
}

/// Quantiles of an error.
#[derive(Clone, Copy, Debug, Serialize)]
#[expect(missing_docs, reason = "the names say it")]
pub struct ErrorQuantiles {
    pub p50: f64,
    pub p99: f64,
    pub max: f64,
}

impl NoteReport {
    pub fn new(it: &Assessment, shortfalls: &[ShortStroke]) -> Self {
        let spread =
            |it: &pianist::Spread| ErrorQuantiles { p50: it.p50, p99: it.p99, max: it.max };
        Self {
            pieces: 1,
            passes: 1,
            played: it.played,
            struck: it.played - it.missed,
            missed: it.missed,
            extra: it.extra,
            onset_error_ms: spread(&it.onset_error_ms),
            velocity_error: spread(&it.velocity_error),
            end_error_ms: spread(&it.end_error_ms),
            release_error: it.release_error.as_ref().map(spread),
            cuts: Vec::new(),
            shortfalls: shortfalls.iter().map(NoteShortfall::new).collect(),
            deviations: it.deviations.iter().map(NoteDeviation::new).collect(),
            unplayed: UnplayedNotes::default(),
            range_m_per_s: None,
        }
    }

    pub(super) fn fmt_lines(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "  notes       {} of {} struck, {} missed, {} extra",
            self.struck, self.played, self.missed, self.extra
        )?;
        let (o, v) = (&self.onset_error_ms, &self.velocity_error);
        writeln!(
            f,
            "              onset error p50 {:.3} p99 {:.3} max {:.3} ms; velocity error p50 {:.0} p99 {:.0} max {:.0}",
            o.p50, o.p99, o.max, v.p50, v.p99, v.max
        )?;
        let end = &self.end_error_ms;
        write!(
            f,
            "              note end error p50 {:.1} p99 {:.1} max {:.1} ms",
            end.p50, end.p99, end.max
        )?;
        match &self.release_error {
            Some(ErrorQuantiles { p50, p99, max }) => {
                writeln!(f, "; release velocity error p50 {p50:.0} p99 {p99:.0} max {max:.0}")?;
            }
            None => writeln!(f)?,
        }
        if 1 < self.pieces || 1 < self.passes {
            let (pieces, passes) = (self.pieces, self.passes);
            writeln!(
                f,
                "              pieces {pieces}, passes {passes}; what follows is of one pass"
            )?;
        }
        if let Some((softest, loudest)) = self.range_m_per_s {
            writeln!(
                f,
                "              these keys give {softest:.2} to {loudest:.2} m/s at the string"
            )?;
        }
        self.fmt_deviations(f)?;
        self.fmt_shortfalls(f)?;
        if !self.cuts.is_empty() {
            writeln!(f, "              {} notes end early for the next stroke:", self.cuts.len())?;
            fmt_first(f, self.cuts.iter())?;
        }
        self.unplayed.fmt_lines(f)
    }

    fn fmt_deviations(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.deviations.is_empty() {
            return Ok(());
        }
        let late = self.deviations.iter().filter(|it| it.late_ms.is_some()).count();
        writeln!(f, "              not as written, {late} of them late:")?;
        fmt_first(f, self.deviations.iter())
    }

    fn fmt_shortfalls(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.shortfalls.is_empty() {
            return Ok(());
        }
        let left_out = self.shortfalls.iter().filter(|it| it.is_left_out).count();
        let others = self.shortfalls.len() - left_out;
        writeln!(
            f,
            "              beyond these keys: {left_out} left out, {others} played otherwise"
        )?;
        fmt_first(f, self.shortfalls.iter())
    }
}

/// Prints the first few of `notes`, a line each, and the number of the others.
fn fmt_first<T: fmt::Display>(
    f: &mut fmt::Formatter<'_>,
    mut notes: impl ExactSizeIterator<Item = T>,
) -> fmt::Result {
    const NAMED: usize = 8;
    for note in notes.by_ref().take(NAMED) {
        writeln!(f, "                {note}")?;
    }
    match notes.len() {
        0 => Ok(()),
        more => writeln!(f, "                and {more} more, which `--json` lists"),
    }
}

#[cfg(test)]
mod tests {
    use pianist::PassedOver;

    use super::*;

    struct Shown(NoteReport);

    impl fmt::Display for Shown {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            self.0.fmt_lines(f)
        }
    }

    #[test]
    fn notes_that_no_key_is_asked_for_are_told_with_their_keys() {
        let mut passed_over = PassedOverCounts::default();
        passed_over.add(PassedOver::Percussion, 2);
        passed_over.add(PassedOver::ProgramChanges, 1);
        let unplayed = UnplayedNotes::new(&[3, 0, 3], passed_over);
        let json = serde_json::to_value(&unplayed).unwrap();
        assert_eq!((&json["percussion"], &json["overlapping"]), (&2.into(), &0.into()), "{json}");
        let report = NoteReport {
            unplayed,
            range_m_per_s: Some((0.12, 4.6)),
            ..NoteReport::new(&Assessment::default(), &[])
        };
        let said = Shown(report).to_string();
        assert!(said.contains("3 more on keys without a voice in this scene: A0, C1"), "{said}");
        let counted = "not played as in the file: 2 notes of percussion (channel 10), 1 program ch";
        assert!(said.contains(counted), "{said}");
        assert!(said.contains("these keys give 0.12 to 4.60 m/s at the string"), "{said}");
    }

    #[test]
    fn a_note_that_is_late_and_a_strike_that_is_extra_are_told_with_key_and_time() {
        let late = Deviation { key: 39, at: 1.0, kind: DeviationKind::Late { by: 4.0 } };
        let extra = Deviation { key: 0, at: 2.5, kind: DeviationKind::Extra };
        let deviations = vec![late, extra];
        let assessed =
            Assessment { played: 1, struck: 2, extra: 1, deviations, ..Assessment::default() };
        let said = Shown(NoteReport::new(&assessed, &[])).to_string();
        assert!(said.contains("1 of 1 struck, 0 missed, 1 extra"), "{said}");
        assert!(said.contains("not as written, 1 of them late:\n"), "{said}");
        assert!(said.contains("C4 at 1.000 s is late by 4000 ms\n"), "{said}");
        assert!(said.contains("A0 at 2.500 s is extra\n"), "{said}");
    }
}
