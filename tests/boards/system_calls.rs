//! The system calls of a tick, traced by strace, against the list in ARCHITECTURE.md.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::letoff;
use crate::machine_time::{judged, say};
use crate::rig::{Boards, machine};

const HEADING: &str = "### System calls of a tick";

struct Listed {
    calls: BTreeSet<String>,
    /// `true` if the threads of the other lanes may call it, too.
    by_lanes: bool,
    /// `true` if only links to boards need it.
    for_links: bool,
}

fn listed() -> Vec<Listed> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("ARCHITECTURE.md");
    let text = fs::read_to_string(path).expect("ARCHITECTURE.md");
    let (_before, section) = text.split_once(HEADING).expect("the section");
    let rows = section.lines().skip_while(|line| !line.starts_with("|---")).skip(1);
    rows.take_while(|line| line.starts_with('|'))
        .map(|row| {
            let [calls, who, why] = cells(row);
            Listed {
                calls: calls.split('`').skip(1).step_by(2).map(str::to_owned).collect(),
                by_lanes: who.contains("lanes"),
                for_links: why.contains("serial ports and CAN sockets"),
            }
        })
        .collect()
}

fn cells(row: &str) -> [&str; 3] {
    let mut cells = row.trim_matches('|').splitn(3, '|');
    std::array::from_fn(|_| cells.next().expect("three cells"))
}

/// One call: name of its thread, name of the call, rest of the line.
struct Call {
    thread: String,
    name: String,
    rest: String,
}

fn calls_between_ticks(trace: &str) -> Vec<Call> {
    let mut threads = BTreeMap::new();
    let mut calls: Vec<Call> = Vec::new();
    for line in trace.lines() {
        let (id, what) = line.trim_start().split_once(' ').unwrap_or_default();
        // Other lines: the end of a call shown before, a signal, the end of a thread.
        let Some((name, rest)) = what.trim_start().split_once('(') else { continue };
        if !name.bytes().all(|it| it.is_ascii_alphanumeric() || it == b'_') {
            continue;
        }
        if let Some(named) = rest.strip_prefix("PR_SET_NAME, \"") {
            let thread = named.split('"').next().unwrap_or_default();
            threads.insert(id.to_owned(), thread.to_owned());
        }
        let Some(thread) = threads.get(id).filter(|it| is_of_tick(it)) else { continue };
        calls.push(Call { thread: thread.clone(), name: name.to_owned(), rest: rest.to_owned() });
    }
    let is_sleep = |call: &Call| call.thread == TICK && call.name == "clock_nanosleep";
    let first = calls.iter().position(is_sleep).unwrap_or(0);
    let last = calls.iter().rposition(is_sleep).unwrap_or(first);
    calls.drain(first..last).collect()
}

const TICK: &str = "letoff-tick";

fn is_of_tick(thread: &str) -> bool {
    thread == TICK || thread.starts_with("letoff-lane-")
}

fn can_trace() -> bool {
    let tried = Command::new("strace").args(["-f", "-qq", "-o", "/dev/null", "true"]).output();
    let can = tried.is_ok_and(|it| it.status.success());
    if !can {
        say("SKIPPED: system calls of a tick: `strace -f true` does not work here");
    }
    can
}

fn traced(folder: &Path, more: &[&str]) -> Option<Vec<Call>> {
    let trace = folder.join("calls");
    let run = ["run", "springs", "--listen", "none", "--json", "--duration", "3"];
    let said = letoff::run_traced(folder, &trace, &[&run, more].concat());
    // Under strace, samples are so late that voices may fail.
    assert!(matches!(said.code, Some(0 | 1)), "{said:?}");
    let calls = calls_between_ticks(&fs::read_to_string(trace).expect("a trace"));
    let ticks = calls.iter().filter(|it| it.name == "clock_nanosleep").count();
    (100 < ticks).then_some(calls)
}

fn judged_calls(what: &str, attempt: impl FnMut() -> Option<Vec<Call>>) -> Option<Vec<Call>> {
    can_trace().then(|| judged(&format!("system calls of a tick, {what}"), attempt))?
}

#[derive(Clone, Copy, PartialEq, Debug)]
enum KeyPlace {
    Simulated,
    OnBoards,
}

#[track_caller]
fn check(calls: &[Call], keys: KeyPlace) {
    let rows = listed();
    for Call { thread, name, rest } in calls {
        let is_listed = rows.iter().any(|row| {
            row.calls.contains(name)
                && (thread == TICK || row.by_lanes)
                && (keys == KeyPlace::OnBoards || !row.for_links)
        });
        assert!(is_listed, "{thread} calls {name}({rest}, which the list does not have");
    }
}

fn count(calls: &[Call], thread: &str, name: &str) -> usize {
    calls.iter().filter(|it| it.thread == thread && it.name == name).count()
}

#[test]
fn one_lane_makes_no_system_call_that_is_not_listed_and_none_for_other_lanes() {
    let _machine = machine();
    let folder = letoff::folder("calls-one-lane");
    let Some(calls) = judged_calls("one lane", || traced(&folder, &["--set", "lanes=1"])) else {
        return;
    };
    check(&calls, KeyPlace::Simulated);
    let others: Vec<_> = calls.iter().filter(|it| it.thread != TICK).collect();
    assert!(others.is_empty(), "there is no other lane");
    for name in ["futex", "sched_yield"] {
        assert_eq!(count(&calls, TICK, name), 0, "{name}");
    }
    let written: Vec<_> = calls.iter().filter(|it| it.name == "write").collect();
    assert!(!written.is_empty(), "nothing was played");
    let is_of_eight_bytes = |it: &&Call| it.rest.contains("\", 8");
    assert!(written.iter().all(is_of_eight_bytes), "more than the eventfd's eight bytes");
}

#[test]
fn two_lanes_make_no_system_call_that_is_not_listed() {
    let _machine = machine();
    let folder = letoff::folder("calls-two-lanes");
    let Some(calls) = judged_calls("two lanes", || traced(&folder, &["--set", "lanes=2"])) else {
        return;
    };
    check(&calls, KeyPlace::Simulated);
    assert!(100 < count(&calls, "letoff-lane-1", "futex"), "the lane was parked and woken");
}

#[test]
fn links_to_boards_are_read_and_written_and_nothing_else() {
    let _machine = machine();
    let folder = letoff::folder("calls-boards");
    let calls = judged_calls("links to boards", || {
        let boards = Boards::start(&folder, 2, &[]);
        let links = boards.links();
        // Stable over links that are traced.
        let sets = ["--set", "lanes=2", "--set", "keys.0.instrument=spring"];
        let more: Vec<_> = links.iter().map(String::as_str).chain(sets).collect();
        traced(&folder, &more)
    });
    let Some(calls) = calls else { return };
    check(&calls, KeyPlace::OnBoards);
    for name in ["read", "write"] {
        assert!(100 < count(&calls, TICK, name), "{name}");
    }
    // A read of an empty port waits for a kernel thread.
    let is_empty = |it: &&Call| it.name == "read" && it.rest.contains("EAGAIN");
    assert_eq!(calls.iter().filter(is_empty).count(), 0, "an empty port is not read");
}

#[test]
fn the_list_is_read_as_it_is_written() {
    let rows = listed();
    let all: BTreeSet<_> = rows.iter().flat_map(|row| &row.calls).map(String::as_str).collect();
    assert!(all.contains("clock_nanosleep") && all.contains("futex"), "{all:?}");
    assert_eq!(rows.iter().filter(|row| row.for_links).count(), 1);
    assert!(rows.iter().any(|row| row.by_lanes) && rows.iter().any(|row| !row.by_lanes));
}
