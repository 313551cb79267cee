//! Boards in processes of their own, and the host that drives them.

use std::path::{Path, PathBuf};
use std::process::Child;
use std::sync::{PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::letoff::{self, Said};
use crate::machine_time::{Task, WaitWatch, say};

/// Held exclusively by a test that is judged by time.
static MACHINE: RwLock<()> = RwLock::new(());

pub(crate) fn machine() -> RwLockWriteGuard<'static, ()> {
    MACHINE.write().unwrap_or_else(PoisonError::into_inner)
}

pub(crate) fn part_of_machine() -> RwLockReadGuard<'static, ()> {
    MACHINE.read().unwrap_or_else(PoisonError::into_inner)
}

/// Tests `cases`, `at_once` at a time, each thread in its own folder: they mostly wait.
pub(crate) fn side_by_side<T: Sync>(
    folder: &Path,
    at_once: usize,
    cases: &[T],
    test: impl Fn(&Path, &T) + Sync,
) {
    std::thread::scope(|scope| {
        for first in 0..at_once {
            let (folder, test) = (folder.join(first.to_string()), &test);
            std::fs::create_dir_all(&folder).expect("a folder");
            let cases = cases.iter().skip(first).step_by(at_once);
            scope.spawn(move || cases.for_each(|case| test(&folder, case)));
        }
    });
}

pub(crate) struct Boards {
    child: Option<Child>,
    folder: PathBuf,
    count: usize,
}

impl Boards {
    pub(crate) fn start(folder: &Path, count: usize, arguments: &[&str]) -> Self {
        let links = folder.join("links");
        let _none = std::fs::remove_dir_all(&links);
        let n = count.to_string();
        let mut all = vec!["board", "--json", "--count", &n, "--links", "links"];
        all.extend(arguments);
        let child = letoff::start(folder, &all);
        let boards = Self { child: Some(child), folder: folder.to_owned(), count };
        let last = links.join(format!("board{}", count - 1));
        wait_for("the boards' ports", || last.exists());
        boards
    }

    /// Like [`Self::start`], watched for the time that it waits.
    pub(crate) fn watched(watch: &WaitWatch, folder: &Path, count: usize, more: &[&str]) -> Self {
        let boards = Self::start(folder, count, more);
        watch.add(boards.task());
        boards
    }

    pub(crate) fn task(&self) -> Task {
        Task::process(self.child.as_ref().expect("they live"))
    }

    pub(crate) fn links(&self) -> Vec<String> {
        let port = |n| self.folder.join(format!("links/board{n}"));
        let link = |n| ["--link".to_owned(), format!("serial:{}", port(n).display())];
        (0..self.count).flat_map(link).collect()
    }

    pub(crate) fn stop(mut self) -> Vec<Value> {
        let child = self.child.take().expect("they live");
        interrupt(&child);
        let said = letoff::end(child);
        assert_eq!(said.code, Some(0), "{said:?}");
        // The report follows the paths of the boards.
        let (_places, report) = said.out.split_once('\n').expect("a line and a report");
        let report: Value = serde_json::from_str(report).expect("a report as JSON");
        report.as_array().expect("a list of boards").clone()
    }
}

impl Drop for Boards {
    fn drop(&mut self) {
        if let Some(mut child) = self.child.take() {
            let _gone = child.kill();
            let _status = child.wait();
        }
    }
}

pub(crate) fn interrupt(child: &Child) {
    let pid = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw);
    let signal = rustix::process::Signal::INT;
    rustix::process::kill_process(pid.expect("a process"), signal).expect("it lives");
}

#[track_caller]
pub(crate) fn wait_for(what: &str, is_so: impl Fn() -> bool) {
    let end = Instant::now() + Duration::from_mins(1);
    while !is_so() {
        assert!(Instant::now() < end, "{what} never came");
        std::thread::sleep(Duration::from_millis(20));
    }
}

pub(crate) fn run_watched(watch: &WaitWatch, folder: &Path, arguments: &[&str]) -> Said {
    let child = letoff::start(folder, arguments);
    watch.add(Task::process(&child));
    letoff::end(child)
}

pub(crate) fn arguments<'a>(links: &'a [String], more: &[&'a str]) -> Vec<&'a str> {
    let run = ["run", "springs", "--json"].into_iter();
    run.chain(links.iter().map(String::as_str)).chain(more.iter().copied()).collect()
}

#[track_caller]
pub(crate) fn run(watch: &WaitWatch, folder: &Path, links: &[String], more: &[&str]) -> Value {
    report(&run_watched(watch, folder, &arguments(links, more)))
}

/// Returns the report of a host that ended well or with failed voices. Late samples let a key's
/// loop generate energy; the caller judges if the machine is to blame.
#[track_caller]
pub(crate) fn report(said: &Said) -> Value {
    assert!(matches!(said.code, Some(0 | 1)), "{said:?}");
    let report = said.report();
    let boards = report["boards"].as_array().expect("boards");
    let has_failed = 0 < count(&report, "/faults") || boards.iter().any(has_failed);
    assert_eq!(said.code == Some(1), has_failed, "{said:?}");
    report
}

fn has_failed(board: &Value) -> bool {
    let lists = ["muted", "softened", "unproven"].map(|list| &board[list]);
    let [missing, frames] = ["/missing", "/frames"].map(|it| count(board, it));
    board["state"] != "armed"
        || lists.iter().any(|it| it.as_array().is_none_or(|it| !it.is_empty()))
        || !board["late_periods"].is_null()
        || !board["bursts_ms"].is_null()
        || frames + missing < 4 * missing
}

#[track_caller]
pub(crate) fn count(report: &Value, path: &str) -> u64 {
    let value = report.pointer(path).unwrap_or_else(|| panic!("no {path} in {report}"));
    value.as_u64().unwrap_or_else(|| panic!("{path} is {value}"))
}

#[track_caller]
pub(crate) fn number(report: &Value, path: &str) -> f64 {
    let value = report.pointer(path).unwrap_or_else(|| panic!("no {path} in {report}"));
    value.as_f64().unwrap_or_else(|| panic!("{path} is {value}"))
}

/// Returns `true` if host and boards got their time: the host woke for all but a few ticks, and
/// neither a bare timer nor the boards' service was very late.
///
/// The verdict is independent of the links, so a host that exchanges badly is still judged.
pub(crate) fn had_time(report: &Value, boards: &[Value]) -> bool {
    had_host_time(report) && boards.iter().all(|it| number(it, "/longest_gap_ms") < 10.0)
}

#[track_caller]
pub(crate) fn check_exchange(report: &Value, mut numbers: impl Iterator<Item = usize>) {
    let tick_hz = number(report, "/tick_hz");
    let board = numbers.find(|n| {
        let board = &report["boards"][*n];
        let rate = number(board, "/samples_hz").min(number(board, "/forces_hz"));
        rate < 0.97 * tick_hz || 15.0 < number(board, "/counted/oldest_ms")
    });
    assert_eq!(board, None, "this board was slow: {report}");
    assert_eq!(count(report, "/faults"), 0, "{report}");
}

pub(crate) fn had_emulated_time(report: &Value) -> bool {
    let tick_hz = number(report, "/tick_hz");
    let mut boards = report["boards"].as_array().into_iter().flatten();
    had_host_time(report) && boards.all(|it| 0.97 * tick_hz < number(it, "/samples_hz"))
}

pub(crate) fn had_host_time(report: &Value) -> bool {
    let ticks = count(report, "/ticks") + count(report, "/skipped");
    let late =
        count(report, "/deadline/missed_woken_late") + count(report, "/deadline/missed_preempted");
    100 * late <= ticks && number(report, "/deadline/timer_baseline_us/max") < 10e3
}

pub(crate) fn print_figures(what: &str, report: &Value) {
    say(&format!(
        "{what}: onset error p99 {:.2} ms",
        number_or_nan(report, "/notes/onset_error_ms/p99")
    ));
    for board in report["boards"].as_array().into_iter().flatten() {
        say(&format!(
            "  board {}: {:.0} up/s, {:.0} down/s, {} gaps, round trip p50 {} p99 {} us, oldest answered {} ms",
            board["number"],
            number_or_nan(board, "/samples_hz"),
            number_or_nan(board, "/forces_hz"),
            board["gaps"],
            board["round_trip_us"]["p50"],
            board["round_trip_us"]["p99"],
            board["counted"]["oldest_ms"],
        ));
    }
}

fn number_or_nan(report: &Value, path: &str) -> f64 {
    report.pointer(path).and_then(Value::as_f64).unwrap_or(f64::NAN)
}
