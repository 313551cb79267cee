//! Reports of telemetry and the log on a run.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use host::observe::{LogSink, MessageSink};
use scheduler::motion::KEYS;
use telemetry::event::Kind;
use telemetry::{Event, Topic, Update};

#[derive(Clone, Debug, Default)]
pub(crate) struct ToldEvents {
    pub(crate) faults: BTreeMap<usize, u64>,
    pub(crate) recoveries: u64,
    pub(crate) lines: Vec<String>,
}

impl ToldEvents {
    pub(crate) fn lines_on_voices(&self) -> u64 {
        let of = |line: &String| {
            let held =
                line.strip_prefix("and ")?.split_once(" more lines on voices that failed")?;
            held.0.parse::<u64>().ok()
        };
        let is_on_one = |line: &&String| {
            let (key, text) = line.split_once(": ").unwrap_or_default();
            key.len() <= 3 && !text.is_empty()
        };
        let held: u64 = self.lines.iter().filter_map(of).sum();
        held + self.lines.iter().filter(is_on_one).count() as u64
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Telling(Arc<Mutex<ToldEvents>>);

impl Telling {
    pub(crate) fn told(&self) -> MutexGuard<'_, ToldEvents> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn counter(&self) -> Box<dyn MessageSink> {
        Box::new(EventCounter(self.clone()))
    }

    pub(crate) fn log(&self) -> Box<dyn MessageSink> {
        let told = self.clone();
        Box::new(LogSink::new(Box::new(move |_level, line| told.told().lines.push(line))))
    }
}

struct EventCounter(Telling);

impl MessageSink for EventCounter {
    fn take(&mut self, _at: u64, update: &Update) {
        let Update::Event(event) = update else { return };
        let mut told = self.0.told();
        if event.kind() == Kind::Fault {
            *told.faults.entry(key(event)).or_default() += 1;
        } else if event.kind() == Kind::Recovery {
            told.recoveries += 1;
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        topic == Topic::Events
    }

    fn followed_keys(&self) -> u128 {
        0
    }
}

fn key(event: &Event) -> usize {
    usize::try_from(event.key).unwrap_or(KEYS)
}
