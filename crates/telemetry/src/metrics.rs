//! Figures of a host in the text format of Prometheus, version 0.0.4.
//!
//! They are written from one snapshot; a library's registry would store each a second time.

use std::fmt::Write as _;

use crate::{DeadlineStatus, HostState, HostStatus};

/// Content type of the text for HTTP.
pub const CONTENT_TYPE: &str = "text/plain; version=0.0.4; charset=utf-8";

pub fn metrics(status: &HostStatus, version: &str) -> String {
    let mut text = MetricsText::default();
    let HostStatus { scene, run, .. } = status;
    text.family("info", "gauge", "The program and the scene that it runs.");
    text.sample("info", &[("version", version), ("scene", scene)], 1.0);
    text.family("playing", "gauge", "1 while ticks are run.");
    text.sample("playing", &[], f64::from(u8::from(status.state == HostState::Playing)));
    text.one("tick_hertz", "gauge", "Ticks in a second.", f64::from(run.tick_hz));
    text.deadlines(&run.deadlines);
    text.one("voices", "gauge", "Keys with a voice.", f64::from(run.voices));
    text.one("voices_asleep", "gauge", "Voices that lie still.", f64::from(run.asleep));
    text.one("strikes_total", "counter", "Hammers that met their string.", run.strikes as f64);
    text.one("faults_total", "counter", "Turns of voices that failed.", run.faults as f64);
    let muted = run.muted.len() as f64;
    text.one("muted_keys", "gauge", "Keys that are muted after faults.", muted);
    let left_out = run.left_out.len() as f64;
    text.one("left_out", "gauge", "Parts of the work that are left out by overload.", left_out);
    let waited = run.waited as f64;
    text.one("waited_turns_total", "counter", "Turns of voices that had to wait.", waited);
    let starved = run.starved as f64;
    let help = "Ticks in which voices waited although there was time: an error of the host.";
    text.one("starved_ticks_total", "counter", help, starved);
    text.one("dropped_events_total", "counter", "Key events without room.", run.dropped as f64);
    text.boards(status);
    text.one("clients", "gauge", "Clients of the stream.", f64::from(status.clients));
    let recording = u8::from(status.recording.is_some());
    text.one("recording", "gauge", "1 while a recording is made.", f64::from(recording));
    text.0
}

/// Returns the figure of the stream itself: messages for which its runtime had no time.
pub fn lost_messages(lost: u64) -> String {
    let mut text = MetricsText::default();
    let help = "Messages of the stream that were dropped before any client.";
    text.one("stream_lost_messages_total", "counter", help, lost as f64);
    text.0
}

#[derive(Debug, Default)]
struct MetricsText(String);

impl MetricsText {
    fn deadlines(&mut self, it: &DeadlineStatus) {
        let DeadlineStatus { ticks, skipped, own_work, woken_late, preempted, .. } = *it;
        self.one("ticks_total", "counter", "Ticks that passed, run or not.", ticks as f64);
        self.one("skipped_ticks_total", "counter", "Ticks never run.", skipped as f64);
        self.family("missed_ticks_total", "counter", "Ticks that were run and late, by cause.");
        for (cause, n) in
            [("own_work", own_work), ("woken_late", woken_late), ("preempted", preempted)]
        {
            self.sample("missed_ticks_total", &[("cause", cause)], n as f64);
        }
        let Some(lateness) = it.lateness_us else { return };
        self.family("lateness_seconds", "gauge", "Quantiles of how late ticks were woken.");
        for (quantile, us) in ["0.5", "0.99", "0.999", "1"].into_iter().zip(lateness) {
            self.sample("lateness_seconds", &[("quantile", quantile)], us * 1e-6);
        }
    }

    fn boards(&mut self, status: &HostStatus) {
        type Figure = fn(&crate::BoardState) -> Option<f64>;
        let families: [(&str, &str, &str, Figure); 3] = [
            ("board_armed", "gauge", "1 where a board renders forces on all its keys.", |it| {
                Some(f64::from(u8::from(it.is_armed())))
            }),
            ("board_gaps_total", "counter", "Times that samples of a board are missing.", |it| {
                Some(it.gaps as f64)
            }),
            ("board_round_trip_seconds", "gauge", "Median of a board's round trips.", |it| {
                Some(it.round_trip_us? * 1e-6)
            }),
        ];
        for (name, kind, help, figure) in families {
            let boards = status.boards.iter();
            let figures: Vec<_> = boards.filter_map(|it| Some((it, figure(it)?))).collect();
            if figures.is_empty() {
                continue;
            }
            self.family(name, kind, help);
            for (board, figure) in figures {
                let number = board.number.to_string();
                self.sample(name, &[("link", &board.link), ("board", &number)], figure);
            }
        }
    }

    fn one(&mut self, name: &str, kind: &str, help: &str, value: f64) {
        self.family(name, kind, help);
        self.sample(name, &[], value);
    }

    fn family(&mut self, name: &str, kind: &str, help: &str) {
        let _ok = writeln!(self.0, "# HELP letoff_{name} {help}\n# TYPE letoff_{name} {kind}");
    }

    fn sample(&mut self, name: &str, labels: &[(&str, &str)], value: f64) {
        let label = |(name, value): &(&str, &str)| {
            let value = value.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n");
            format!("{name}=\"{value}\"")
        };
        let labels: Vec<_> = labels.iter().map(label).collect();
        let labels =
            if labels.is_empty() { String::new() } else { format!("{{{}}}", labels.join(",")) };
        let _ok = writeln!(self.0, "letoff_{name}{labels} {value}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_stands_in_a_label_is_escaped() {
        let scene = "a \"b\" \\ c\nd".to_owned();
        let text = metrics(&HostStatus { scene, ..HostStatus::default() }, "0.1.0");
        let line = "letoff_info{version=\"0.1.0\",scene=\"a \\\"b\\\" \\\\ c\\nd\"} 1\n";
        assert!(text.contains(line), "{text}");
    }
}
