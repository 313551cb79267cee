//! `[realtime]`: scheduling and processors of the tick's threads.

use super::quantity::Quantity;
use super::read::{self, TableReader};
use documents::toml::{FindingList, TomlKind};

const PROCESSOR: Quantity = Quantity { unit: "1", range: (0.0, 1023.0) };

/// Scheduling of the threads of the tick.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ThreadRules {
    pub lanes: LaneCount,
    pub policy: ThreadPolicy,
    /// Processors of the lanes by number, one for each in turn; empty for any.
    pub cpus: Vec<usize>,
}

/// Number of threads of the tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum LaneCount {
    /// One for each processor, at most 16.
    #[default]
    Auto,
    /// Fixed number, 1 ..= 16.
    Count(usize),
}

/// Scheduling requested for the threads of the tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ThreadPolicy {
    /// `SCHED_FIFO`, on isolated processors if the machine has some.
    #[default]
    Auto,
    /// `SCHED_FIFO`, on any processor or the named ones.
    Fifo,
    /// `SCHED_DEADLINE`, on any processor.
    Deadline,
    /// No request to the system.
    Ordinary,
}

impl ThreadPolicy {
    const ALL: [(&'static str, Self); 4] = [
        ("auto", Self::Auto),
        ("fifo", Self::Fifo),
        ("deadline", Self::Deadline),
        ("ordinary", Self::Ordinary),
    ];
}

pub(super) fn read(
    report: &mut FindingList,
    scene: &mut TableReader<'_>,
    lanes: LaneCount,
) -> ThreadRules {
    let mut rules = ThreadRules { lanes, ..ThreadRules::default() };
    let Some(mut reader) = scene.table(report, "realtime") else { return rules };
    let policies = &ThreadPolicy::ALL;
    if let Some(policy) = reader.choice(report, "policy", "there is no policy", policies) {
        rules.policy = policy;
    }
    rules.cpus = read_cpus(report, &mut reader);
    if rules.policy == ThreadPolicy::Deadline {
        refuse_for_deadline(report, &reader, &rules);
    }
    reader.finish(report);
    rules
}

fn read_cpus(report: &mut FindingList, reader: &mut TableReader<'_>) -> Vec<usize> {
    let Some(entry) = reader.take("cpus") else { return Vec::new() };
    let TomlKind::List(nodes) = &entry.node.kind else {
        let help = "write the processors' numbers, as [2, 3]";
        read::wrong_kind(report, "cpus", &entry.node, "a list", help);
        return Vec::new();
    };
    let number = |node| usize::try_from(read::whole(report, "cpus", node, PROCESSOR)?).ok();
    nodes.iter().filter_map(number).collect()
}

/// Says what the kernel does not allow for `SCHED_DEADLINE`, and what would stop such a thread.
fn refuse_for_deadline(report: &mut FindingList, reader: &TableReader<'_>, rules: &ThreadRules) {
    if !rules.cpus.is_empty() {
        let message = "\"cpus\" is set, and \"deadline\" runs on any processor";
        report.say(reader.place, message, "leave cpus out, or give policy = \"fifo\"");
    }
    if let LaneCount::Count(count @ 2..) = rules.lanes {
        let message = format!("\"deadline\" is for one lane, and \"lanes\" is {count}");
        report.say(reader.place, message, "give lanes = 1, or policy = \"fifo\"");
    }
}

impl ThreadRules {
    pub(super) fn written(&self) -> toml_edit::Table {
        let mut table = toml_edit::Table::new();
        let name = ThreadPolicy::ALL.iter().find(|(_, policy)| *policy == self.policy);
        table["policy"] = toml_edit::value(name.map_or("auto", |(name, _)| name));
        let cpus = self.cpus.iter().filter_map(|cpu| i64::try_from(*cpu).ok());
        table["cpus"] = toml_edit::value(cpus.collect::<toml_edit::Array>());
        table
    }
}
