//! Events of a run, as sentences in the host's log.

use std::collections::{BTreeMap, BTreeSet};

use firmware_protocol::key::KeyIndex;
use telemetry::{Event, Links, Topic, Update, Voice, event::Kind, log::Level};

use super::telemetry_thread::{Attention, MessageSink};

/// Receiver of log lines with their level; it must not wait for a disk or a terminal.
pub type LogLine = Box<dyn FnMut(Level, String) + Send>;

/// Suffix of news of a board that renders forces and of a link that carries frames.
const ARMED: &str = ": armed";
const ACTIVE: &str = " is active now";

/// Time for which changes of values are combined (ns).
const CHANGES: u64 = 2_000_000_000;

/// Logs boards, clients, changes, faults and lost notes, in a limited number of lines.
pub struct LogSink {
    line: LogLine,
    limit: RateLimit,
    changed: BTreeMap<String, BTreeSet<u32>>,
    versions: BTreeMap<u32, u32>,
    since: u64,
    /// `true` until the boards are named.
    is_naming: bool,
}

impl std::fmt::Debug for LogSink {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LogSink").field("changed", &self.changed).finish_non_exhaustive()
    }
}

impl LogSink {
    pub fn new(line: LogLine) -> Self {
        let (limit, changed) = (RateLimit::default(), BTreeMap::new());
        Self { line, limit, changed, versions: BTreeMap::new(), since: 0, is_naming: false }
    }

    /// Names each board once, which simulated ones do not need.
    #[must_use]
    pub fn naming_boards(mut self) -> Self {
        self.is_naming = true;
        self
    }

    fn say(&mut self, at: u64, subject: Subject, level: Level, text: String) {
        if self.limit.has_room(at, subject) {
            (self.line)(level, text);
        }
    }

    fn is_new_version(&mut self, voice: &Voice) -> bool {
        self.versions.insert(voice.key, voice.version) != Some(voice.version) && 0 < voice.version
    }

    fn event(&mut self, at: u64, event: &Event) {
        match event.kind() {
            Kind::Board => {
                let is_well = event.text.ends_with(ARMED) || event.text.ends_with(ACTIVE);
                let level = if is_well { Level::Info } else { Level::Warning };
                self.say(at, Subject::Boards, level, event.text.clone());
            }
            // Changes of values are combined when their voices arrive.
            Kind::Change if 0 < event.to => {}
            Kind::Change => self.say(at, Subject::Changes, Level::Info, event.text.clone()),
            Kind::Fault => {
                let text = format!("{}: {}", key(event.key), event.text);
                self.say(at, Subject::Voices, Level::Error, text);
            }
            Kind::Recovery => {
                let text = format!("{}: its voice is felt again", key(event.key));
                self.say(at, Subject::Voices, Level::Info, text);
            }
            Kind::Overload => {
                let level = if event.simplified == 0 { Level::Info } else { Level::Warning };
                self.say(at, Subject::Load, level, event.text.clone());
            }
            Kind::Starved => self.say(at, Subject::Load, Level::Error, event.text.clone()),
            Kind::Unknown
            | Kind::Switch
            | Kind::Strike
            | Kind::DamperLift
            | Kind::Pressure
            | Kind::DamperFall
            | Kind::Miss
            | Kind::Skip
            | Kind::Disarm
            | Kind::Arm
            | Kind::Pedal => {}
        }
    }

    fn boards(&mut self, links: &Links) {
        for board in &links.boards {
            let line = usize::try_from(board.line).ok().and_then(|it| links.lines.get(it));
            let line = line.map_or("", |line| line.name.as_str());
            let last = board.first_key + board.keys.saturating_sub(1);
            let (first, last) = (key(board.first_key), key(last));
            let text = format!("board {} on {line}, {first} to {last}: {}", board.id, board.state);
            (self.line)(Level::Info, text);
        }
    }

    fn flush_changes(&mut self, at: u64) {
        for (writer, keys) in std::mem::take(&mut self.changed) {
            let (first, last) = (keys.first().copied(), keys.last().copied());
            let (first, last) = (key(first.unwrap_or_default()), key(last.unwrap_or_default()));
            let text = match keys.len() {
                1 => format!("{writer} changed values of {first}"),
                n => format!("{writer} changed values of {n} keys between {first} and {last}"),
            };
            self.say(at, Subject::Changes, Level::Info, text);
        }
    }
}

impl MessageSink for LogSink {
    fn take(&mut self, at: u64, update: &Update) {
        match update {
            Update::Log(log) => {
                // Failures are logged however many clients come and go.
                let level = log.level();
                let has_failed = level == Level::Error;
                let subject = if has_failed { Subject::Failures } else { Subject::Clients };
                self.say(at, subject, level, log.text.clone());
            }
            Update::Event(event) => self.event(at, event),
            Update::Voice(voice) if !self.is_new_version(voice) && voice.kept => {
                if self.changed.is_empty() {
                    self.since = at;
                }
                self.changed.entry(voice.writer.clone()).or_default().insert(voice.key);
            }
            Update::Links(links) if std::mem::take(&mut self.is_naming) => self.boards(links),
            Update::Midi(midi) if midi.text.contains("lost: ") => {
                self.say(at, Subject::Notes, Level::Warning, format!("MIDI: {}", midi.text));
            }
            Update::Voice(_)
            | Update::Links(_)
            | Update::Midi(_)
            | Update::Catalogue(_)
            | Update::Overview(_)
            | Update::Block(_)
            | Update::State(..)
            | Update::Ticks(_)
            | Update::Deadlines(_)
            | Update::Status(_) => {}
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        let wanted = [Topic::Log, Topic::Events, Topic::Voices, Topic::Links, Topic::Midi];
        wanted.contains(&topic)
    }

    fn followed_keys(&self) -> u128 {
        // Changes of mode are not logged.
        0
    }

    fn attend(&mut self, now: u64) -> Attention {
        if !self.changed.is_empty() && self.since.saturating_add(CHANGES) <= now {
            self.flush_changes(now);
        }
        for (subject, n) in self.limit.held_back(now) {
            let text = format!("and {n} more lines on {} within {} s", subject.words(), SPAN_S);
            (self.line)(Level::Warning, text);
        }
        Attention::Goes
    }
}

impl Drop for LogSink {
    fn drop(&mut self) {
        self.flush_changes(u64::MAX);
        for (subject, n) in self.limit.held_back(u64::MAX) {
            (self.line)(Level::Warning, format!("and {n} more lines on {}", subject.words()));
        }
    }
}

fn key(number: u32) -> String {
    let key = u8::try_from(number).ok().and_then(KeyIndex::new);
    key.map_or_else(|| format!("key {number}"), |key| key.to_string())
}

/// Subject of a line; each has its own limit.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Subject {
    Clients,
    Failures,
    Boards,
    Changes,
    Voices,
    Load,
    Notes,
}

impl Subject {
    const fn words(self) -> &'static str {
        match self {
            Self::Clients => "clients",
            Self::Failures => "what failed",
            Self::Boards => "boards and links",
            Self::Changes => "changes",
            Self::Voices => "voices that failed",
            Self::Load => "what is left out",
            Self::Notes => "MIDI messages that were lost",
        }
    }
}

/// Time span of the limit of lines on a subject (s).
const SPAN_S: u64 = 10;
const SPAN: u64 = SPAN_S * 1_000_000_000;
const LINES: u32 = 10;

#[derive(Debug, Default)]
struct RateLimit(BTreeMap<Subject, LogWindow>);

#[derive(Debug)]
struct LogWindow {
    began: u64,
    written: u32,
    held: u64,
}

impl RateLimit {
    /// Returns `true` if one more line may be written at `now` (ns).
    fn has_room(&mut self, now: u64, subject: Subject) -> bool {
        let fresh = LogWindow { began: now, written: 0, held: 0 };
        let span = self.0.entry(subject).or_insert(fresh);
        if span.held == 0 && span.began.saturating_add(SPAN) <= now {
            (span.began, span.written) = (now, 0);
        }
        let has_room = span.written < LINES;
        span.written += u32::from(has_room);
        span.held += u64::from(!has_room);
        has_room
    }

    /// Takes the numbers of lines held back in spans that are over at `now` (ns).
    fn held_back(&mut self, now: u64) -> Vec<(Subject, u64)> {
        let is_over = |span: &LogWindow| 0 < span.held && span.began.saturating_add(SPAN) <= now;
        let over = self.0.iter().filter(|(_, span)| is_over(span));
        let over: Vec<_> = over.map(|(subject, span)| (*subject, span.held)).collect();
        for (subject, _) in &over {
            self.0.remove(subject);
        }
        over
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::mpsc;
    use telemetry::Log;

    const SECOND: u64 = 1_000_000_000;

    fn sink() -> (LogSink, mpsc::Receiver<String>) {
        let (sender, lines) = mpsc::channel();
        let line = move |_level, text| drop(sender.send(text));
        (LogSink::new(Box::new(line)).naming_boards(), lines)
    }

    fn lines(lines: &mpsc::Receiver<String>) -> Vec<String> {
        lines.try_iter().collect()
    }

    fn board(text: &str) -> Update {
        Update::Event(Event { kind: Kind::Board.into(), text: text.into(), ..Event::default() })
    }

    #[test]
    fn a_board_that_flickers_is_told_of_ten_times_and_then_counted() {
        let (mut sink, said) = sink();
        for n in 0..1000 {
            sink.take(n * SECOND / 200, &board("board 3 on can0 is silent now"));
            sink.attend(n * SECOND / 200);
        }
        sink.take(5 * SECOND, &Update::Log(Log { text: "a client".into(), ..Log::default() }));
        assert_eq!(lines(&said).len(), 11, "each subject has its own room");
        sink.attend(10 * SECOND);
        assert_eq!(lines(&said), ["and 990 more lines on boards and links within 10 s"]);
        sink.take(11 * SECOND, &board("board 3 on can0 is armed now"));
        assert_eq!(lines(&said), ["board 3 on can0 is armed now"]);
    }

    #[test]
    fn a_board_that_is_lost_is_a_warning_and_one_that_is_back_is_none() {
        let (sender, said) = mpsc::channel();
        let line = move |level: Level, _text| _ = sender.send(level);
        let mut sink = LogSink::new(Box::new(line));
        for (text, level) in [
            ("board 3 on can0: silent", Level::Warning),
            ("board 3 on can0: armed", Level::Info),
            ("board 3 on can0: armed; C4 is muted: its readings are noisy", Level::Warning),
            ("can0 is down now", Level::Warning),
            ("can0 is active now", Level::Info),
        ] {
            sink.take(0, &board(text));
            assert_eq!(said.try_recv(), Ok(level), "{text}");
        }
    }

    #[test]
    fn what_failed_is_said_however_many_clients_come_and_go() {
        let (mut sink, said) = sink();
        let log = |level: Level, text: &str| {
            Update::Log(Log { level: level.into(), text: text.to_owned() })
        };
        for _ in 0..1000 {
            sink.take(0, &log(Level::Info, "client 7 has come"));
        }
        sink.take(1, &log(Level::Error, "take.mcap cannot be written any further"));
        assert_eq!(
            lines(&said).last().map(String::as_str),
            Some("take.mcap cannot be written any further")
        );
    }

    #[test]
    fn a_slider_makes_one_line() {
        let (mut sink, said) = sink();
        for n in 0..120 {
            let voice = Voice {
                key: 39 + n % 2,
                kept: true,
                writer: "client 2".into(),
                ..Voice::default()
            };
            sink.take(u64::from(n) * SECOND / 60, &Update::Voice(voice));
            sink.attend(u64::from(n) * SECOND / 60);
        }
        assert_eq!(lines(&said), [""; 0]);
        sink.attend(2 * SECOND);
        assert_eq!(lines(&said), ["client 2 changed values of 2 keys between C4 and C#4"]);
    }

    #[test]
    fn each_board_is_named_once_with_its_keys() {
        let (mut sink, said) = sink();
        let line = telemetry::Line { name: "can0".into(), ..telemetry::Line::default() };
        let board = telemetry::Board {
            id: 3,
            first_key: 39,
            keys: 12,
            state: "armed".into(),
            ..telemetry::Board::default()
        };
        let links = Update::Links(Links { lines: vec![line], boards: vec![board] });
        sink.take(0, &links);
        sink.take(SECOND, &links);
        assert_eq!(lines(&said), ["board 3 on can0, C4 to B4: armed"]);
    }
}
