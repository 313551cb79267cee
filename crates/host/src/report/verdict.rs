//! One line on the quality of a run.

use super::RunReport;

/// Limits of a measure: up to the first it is good, up to the second fair.
type GradeLimits = (f64, f64);

/// Share of ticks with late forces, or that never ran (%). A board renders its last force meanwhile.
const LATE_TICKS: GradeLimits = (0.01, 0.1);

/// Share of missed notes (%).
const MISSED_NOTES: GradeLimits = (0.0, 1.0);

/// 99 % of the onset errors (ms): listeners notice some 10 ms.
const ONSET: GradeLimits = (2.0, 10.0);

/// 99 % of the velocity errors: a step of dynamics, as from p to mp, is about 16.
const VELOCITY: GradeLimits = (3.0, 8.0);

impl RunReport {
    /// Returns the run's quality, by its worst measure, in a sentence.
    pub(super) fn verdict(&self) -> String {
        let due = self.extent.ticks + self.extent.skipped;
        let percent = |part: u64, whole: u64| 100.0 * part as f64 / whole.max(1) as f64;
        let late = percent(self.deadline.missed, due);
        let mut measures = vec![(late, LATE_TICKS, "of the ticks were late or lost", "%")];
        if let Some(notes) = self.notes.as_ref().filter(|notes| 0 < notes.played) {
            let missed = percent(notes.missed as u64, notes.played as u64);
            measures.extend([
                (missed, MISSED_NOTES, "of the notes were missed", "%"),
                (notes.onset_error_ms.p99, ONSET, "is the p99 of the onset error", "ms"),
                (notes.velocity_error.p99, VELOCITY, "is the p99 of the velocity error", "units"),
            ]);
        }
        let grade = |&(value, (good, fair), ..): &(f64, GradeLimits, &str, &str)| {
            u8::from(good < value) + u8::from(fair < value)
        };
        let worst = measures.iter().map(grade).max().unwrap_or(0);
        if worst == 0 {
            return "good: no tick and no note beyond what a player notices".to_owned();
        }
        let named = measures.iter().filter(|it| grade(it) == worst);
        let named = named.map(|(value, (good, _), what, unit)| {
            format!("{value:.2} {unit} {what} (good is up to {good})")
        });
        let named = named.collect::<Vec<_>>().join(", ");
        let own_work = self.deadline.missed_own_work;
        let remedy = if late <= LATE_TICKS.0 {
            ""
        } else if self.deadline.missed < 2 * own_work {
            "; fewer voices, a lower tick_hz or a cheaper instrument help"
        } else {
            "; this machine was busy otherwise"
        };
        format!("{}: {named}{remedy}", if worst == 1 { "fair" } else { "poor" })
    }
}
