//! Results of benches in a file, as multiples of the calibration; and the benches that got slower.

use std::collections::{BTreeMap, BTreeSet};
use std::{fmt, fs, path::Path};

use crate::error::Error;

/// Lower quartile, median and upper quartile of all rounds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct RoundRange([f64; 3]);

impl RoundRange {
    /// Returns the range of `rounds`, which must not be empty.
    pub(super) fn of(mut rounds: Vec<f64>) -> Self {
        rounds.sort_by(f64::total_cmp);
        let at = |index: usize| rounds.get(index).copied().unwrap_or(f64::NAN);
        let last = rounds.len().saturating_sub(1);
        Self([at(last / 4), at(last / 2), at(last - last / 4)])
    }

    const fn middle(self) -> f64 {
        self.0[1]
    }

    /// Returns the upper quartile over the lower one.
    const fn noise(self) -> f64 {
        self.0[2] / self.0[0]
    }
}

#[derive(Clone, PartialEq, Debug)]
pub(super) struct BenchBaseline {
    pub(super) machine: String,
    pub(super) ranges: BTreeMap<String, RoundRange>,
}

/// Slowdown of a bench, with its noise.
#[derive(Clone, Copy, PartialEq, Debug)]
struct BenchChange {
    factor: f64,
    noise: f64,
}

impl BenchChange {
    fn is_slower(self) -> bool {
        self.noise < self.factor
    }

    fn is_faster(self) -> bool {
        self.noise * self.factor < 1.0
    }
}

impl BenchBaseline {
    pub(super) fn read(path: &Path) -> Result<Self, Error> {
        let text = fs::read_to_string(path).map_err(|cause| Error::file(path, cause))?;
        Self::of_text(&text).ok_or_else(|| {
            let because = "it is damaged: write it anew with `cargo xtask bench --write-baseline`";
            Error::unobtainable(path.display().to_string(), because)
        })
    }

    fn of_text(text: &str) -> Option<Self> {
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let machine = lines.next()?.strip_prefix("machine = \"")?.strip_suffix('"')?.to_owned();
        let range = |line: &str| {
            let (name, value) = line.split_once(" = ")?;
            let values = value.strip_prefix('[')?.strip_suffix(']')?.split(", ");
            let values: Vec<f64> = values.map(|it| it.parse().ok()).collect::<Option<_>>()?;
            let is_sound = values.iter().all(|it| 0.0 < *it) && values.is_sorted();
            Some((name.to_owned(), RoundRange(values.try_into().ok().filter(|_| is_sound)?)))
        };
        Some(Self { machine, ranges: lines.map(range).collect::<Option<_>>()? })
    }

    /// Returns the change of a bench that is in both; `None` between machines.
    fn change(&self, now: &Self, name: &str) -> Option<BenchChange> {
        let (before, after) = (self.ranges.get(name)?, now.ranges.get(name)?);
        let factor = after.middle() / before.middle();
        let change = BenchChange { factor, noise: before.noise() * after.noise() };
        (self.machine == now.machine).then_some(change)
    }

    /// Returns the benches that got slower by more than the noise.
    pub(super) fn slower(&self, now: &Self) -> Vec<String> {
        let is_slower = |name: &&String| self.change(now, name).is_some_and(BenchChange::is_slower);
        now.ranges.keys().filter(is_slower).cloned().collect()
    }

    /// Formats a line for each common bench, and the rule.
    pub(super) fn table(&self, now: &Self) -> String {
        let shown = |range: Option<&RoundRange>| {
            range.map_or_else(|| "-".to_owned(), |it| format!("{:.5}", it.middle()))
        };
        let head = ["times the calibration", "baseline", "now", "change", "noise"];
        let mut lines = vec![line(head.map(str::to_owned), "")];
        let names: BTreeSet<_> = self.ranges.keys().chain(now.ranges.keys()).collect();
        for name in names {
            let change = self.change(now, name);
            let percent = |of: fn(BenchChange) -> f64, sign: &str| {
                change.map_or_else(String::new, |it| format!("{sign}{:.1} %", 1e2 * of(it) - 1e2))
            };
            let verdict = match change {
                Some(change) if change.is_slower() => "SLOWER",
                Some(change) if change.is_faster() => "faster",
                Some(_) | None => "",
            };
            let [before, after] = [self, now].map(|it| shown(it.ranges.get(name)));
            let change = percent(|it| it.factor, "");
            lines.push(line(
                [name.clone(), before, after, change, percent(|it| it.noise, "± ")],
                verdict,
            ));
        }
        lines.push(if self.machine == now.machine {
            "slower or faster: by more than the middle half of the rounds of both differs"
                .to_owned()
        } else {
            format!(
                "the baseline is of {}, this is {}: nothing is told; write a baseline here with \
                 --write-baseline before your change",
                self.machine, now.machine
            )
        });
        lines.join("\n") + "\n"
    }
}

fn line([name, before, now, change, noise]: [String; 5], verdict: &str) -> String {
    let line = format!("{name:<36} {before:>10} {now:>10} {change:>9} {noise:>9}  {verdict}");
    line.trim_end().to_owned()
}

impl fmt::Display for BenchBaseline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "# Written by `cargo xtask bench --write-baseline`: what benches took,")?;
        writeln!(
            f,
            "# as multiples of the calibration; lower quartile, middle and upper quartile of the rounds."
        )?;
        writeln!(f, "machine = \"{}\"", self.machine)?;
        self.ranges.iter().try_for_each(|(name, RoundRange([lower, middle, upper]))| {
            writeln!(f, "{name} = [{lower:.7}, {middle:.7}, {upper:.7}]")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn baseline(machine: &str, rounds: &[(&str, [f64; 3])]) -> BenchBaseline {
        let range = |(name, rounds): &(&str, [f64; 3])| {
            ((*name).to_owned(), RoundRange::of(rounds.to_vec()))
        };
        BenchBaseline { machine: machine.into(), ranges: rounds.iter().map(range).collect() }
    }

    #[test]
    fn rounds_that_were_disturbed_are_no_noise() {
        let rounds = [9.0, 1.0, 1.2, 1.1, 0.1, 1.3, 1.4, 7.0, 0.2];
        assert_eq!(RoundRange::of(rounds.to_vec()), RoundRange([1.0, 1.2, 1.4]));
        assert_eq!(RoundRange::of(vec![2.0]), RoundRange([2.0; 3]));
    }

    #[test]
    fn what_is_written_is_read_again() {
        let rounds = [("a_b-c", [2.0, 1.5, 1.75]), ("d", [0.0125, 0.0125, 3.0])];
        let before = baseline("2 x some CPU @ 2 GHz", &rounds);
        assert_eq!(BenchBaseline::of_text(&before.to_string()), Some(before));
        for damaged in
            ["a", "a = 1", "a = [1.0, 2.0]", "a = [1, x, 2]", "a = [2, 1, 3]", "a = [0, 1, 1]"]
        {
            assert_eq!(
                BenchBaseline::of_text(&format!("machine = \"x\"\n{damaged}")),
                None,
                "{damaged}"
            );
        }
        assert_eq!(BenchBaseline::of_text("a = [1, 2, 3]"), None, "no machine");
    }

    #[test]
    fn slower_is_what_the_rounds_of_both_do_not_explain() {
        // Both have a noise of 10 %: changes above 1.21 exceed it.
        let before =
            baseline("x", &[("a", [1.0, 1.05, 1.1]), ("b", [1.0, 1.05, 1.1]), ("c", [2.0; 3])]);
        let now = [("a", [1.20, 1.26, 1.32]), ("b", [1.22, 1.28, 1.342]), ("d", [1.0; 3])];
        assert_eq!(before.slower(&baseline("x", &now)), ["b"]);
        assert_eq!(before.slower(&baseline("another", &now)), [""; 0]);
        let shown = before.table(&baseline("x", &now));
        let lines: Vec<Vec<_>> = shown.lines().map(|it| it.split_whitespace().collect()).collect();
        assert_eq!(lines[1], ["a", "1.05000", "1.26000", "20.0", "%", "±", "21.0", "%"]);
        assert_eq!(lines[2], ["b", "1.05000", "1.28000", "21.9", "%", "±", "21.0", "%", "SLOWER"]);
        assert_eq!(
            (&lines[3][..], &lines[4][..]),
            (&["c", "2.00000", "-"][..], &["d", "-", "1.00000"][..])
        );
        let back = baseline("x", &now).table(&before);
        assert!(back.contains("faster") && !back.contains("SLOWER"), "{back}");
        let elsewhere = before.table(&baseline("another", &now));
        assert!(elsewhere.contains("of x, this is another: nothing is told"), "{elsewhere}");
    }
}
