//! Lines and boards as a message, and their changes in sentences.

use boards::rt::board::BoardStatistics;
use boards::rt::link_snapshot::{BoardSnapshot, BoardStatus, LineSnapshot, LinkSnapshot};
use rtrb::Consumer;
use telemetry::Links;

use boards::rt::board_supervisor::ArmState;

use crate::report::{
    key_names, late_periods_words, misplaced_words, muted_keys, softened_words, stage_words,
    unproven_words, wire_words,
};
use boards::refusal::{burst_words, restart_words};
use boards::rt::link_monitor::LinkSample;

/// State of lines and boards, and the ring from which it is updated.
#[derive(Debug)]
pub struct LinksWatch {
    seen: Consumer<LinkSample>,
    /// Tick period (s).
    period: f64,
    links: Links,
    last: Vec<Option<(u64, LineSnapshot)>>,
}

impl LinksWatch {
    /// Watches `links`, in ticks of `period` (s).
    pub fn new(seen: Consumer<LinkSample>, links: Links, period: f64) -> Self {
        let last = vec![None; links.lines.len()];
        Self { seen, period, links, last }
    }

    pub const fn links(&self) -> &Links {
        &self.links
    }

    /// Receives new snapshots, if any; returns a sentence on each change.
    pub fn look(&mut self) -> Option<Vec<String>> {
        let mut changes = Vec::new();
        let mut is_news = false;
        while let Ok((tick, glance)) = self.seen.pop() {
            is_news = true;
            changes.extend(match glance {
                LinkSnapshot::Line(line, it) => self.line(line, tick, &it),
                LinkSnapshot::Board(board, it) => self.board(board, &it),
            });
        }
        is_news.then_some(changes)
    }

    fn line(&mut self, index: usize, tick: u64, it: &LineSnapshot) -> Option<String> {
        let before = self.last.get_mut(index)?.replace((tick, *it));
        let line = self.links.lines.get_mut(index)?;
        let LineSnapshot { statistics, .. } = it;
        let since = before.filter(|(last, _)| *last < tick);
        let load = since.and_then(|(last, was)| {
            let seconds = (tick - last) as f64 * self.period;
            Some(it.meter?.since(&was.meter?).seen(seconds).most)
        });
        line.seen = load.unwrap_or(line.seen);
        (line.corrupt, line.foreign) = (statistics.corrupt, statistics.foreign);
        line.dropped = statistics.health.dropped;
        let is_down = before.is_some_and(|(_, was)| was.statistics.down < statistics.down);
        let state = if is_down { "down" } else { wire_words(statistics.health.state) };
        let told = news(&line.state, state).then(|| format!("{} is {state} now", line.name));
        line.state = state.into();
        told
    }

    fn board(&mut self, index: usize, it: &BoardSnapshot) -> Option<String> {
        let board = self.links.boards.get_mut(index)?;
        let BoardStatistics { samples, refused, .. } = it.statistics;
        (board.samples, board.gaps, board.refused) = (samples.frames, samples.gaps, refused);
        let care = it.status?;
        // A rearming between two polls shows in the count only.
        let is_armed_anew = 0 < board.armings && board.armings < care.armings;
        board.armings = care.armings;
        board.muted = muted(board.first_key, it);
        board.round_trip = care.round_trip_us.map_or(f64::NAN, f64::from);
        let first_key = u8::try_from(board.first_key).unwrap_or(u8::MAX);
        let state = board_words(first_key, it, &care);
        let line = usize::try_from(board.line).ok().and_then(|it| self.links.lines.get(it));
        let line = line.map_or("", |line| line.name.as_str());
        let told = if news(&board.state, &state) {
            Some(format!("board {} on {line}: {state}", board.id))
        } else if is_armed_anew && board.state == state {
            let text = "it had taken its forces away, and was armed anew";
            Some(format!("board {} on {line}: {state}; {text}", board.id))
        } else {
            None
        };
        board.state = state;
        told
    }
}

fn muted(first_key: u32, it: &BoardSnapshot) -> Vec<u32> {
    let keys = (first_key..).zip(&it.statistics.keys.muted);
    keys.filter_map(|(key, fault)| fault.is_some().then_some(key)).collect()
}

fn board_words(first_key: u8, it: &BoardSnapshot, care: &BoardStatus) -> String {
    let keys = &it.statistics.keys;
    let list = |slots: u16, words: fn(&str) -> String| {
        (slots != 0).then(|| words(&key_names(first_key, slots).join(", ")))
    };
    let notes = [
        (0 < care.restarts).then(|| restart_words(care.restarts, care.reset_reason)),
        care.burst_us.map(|it| burst_words(it as f64)),
        care.late.map(late_periods_words),
        list(keys.softened, softened_words),
        list(keys.unproven, unproven_words).filter(|_| care.state == ArmState::Armed),
        list(keys.misplaced, misplaced_words),
    ];
    let muted = muted_keys(first_key, &keys.muted);
    let muted = muted.iter().map(ToString::to_string);
    let all = std::iter::once(stage_words(care.state)).chain(notes.into_iter().flatten());
    all.chain(muted).collect::<Vec<_>>().join("; ")
}

fn news(before: &str, now: &str) -> bool {
    let is_well = ["armed", "active"].contains(&now);
    before != now && (!before.is_empty() || !is_well)
}

#[cfg(test)]
mod tests {
    use super::*;
    use boards::links::{Health, WireState};
    use boards::plan::{LinkMeter, Medium};
    use boards::rt::bus::LineStatistics;
    use boards::rt::key_fault::{GuardFindings, KeyFault};
    use firmware_protocol::key::MOST_KEYS;
    use rtrb::{Producer, RingBuffer};
    use telemetry::{Board, Line};

    fn watch() -> (Producer<LinkSample>, LinksWatch) {
        let (told, seen) = RingBuffer::new(16);
        let line = Line { name: "can0".into(), planned: 0.25, seen: f64::NAN, ..Line::default() };
        let board = Board { id: 3, first_key: 33, keys: 11, ..Board::default() };
        let links = Links { lines: vec![line], boards: vec![board] };
        (told, LinksWatch::new(seen, links, 1e-3))
    }

    fn line(state: WireState, meter: Option<LinkMeter>) -> LinkSnapshot {
        let health = Health { state, ..Health::default() };
        let statistics = LineStatistics { health, ..LineStatistics::default() };
        LinkSnapshot::Line(0, LineSnapshot { statistics, meter })
    }

    fn board(stage: ArmState) -> LinkSnapshot {
        with_muted(stage, [None; MOST_KEYS])
    }

    fn with_muted(stage: ArmState, muted: [Option<KeyFault>; MOST_KEYS]) -> LinkSnapshot {
        armed(stage, muted, 2)
    }

    fn armed(stage: ArmState, muted: [Option<KeyFault>; MOST_KEYS], armings: u64) -> LinkSnapshot {
        let care = Some(BoardStatus {
            state: stage,
            armings,
            round_trip_us: Some(990),
            restarts: 0,
            reset_reason: 0,
            burst_us: None,
            late: None,
        });
        let keys = GuardFindings { muted, ..GuardFindings::default() };
        let statistics = BoardStatistics { keys, ..BoardStatistics::default() };
        LinkSnapshot::Board(0, BoardSnapshot { statistics, status: care })
    }

    #[test]
    fn a_load_is_that_of_the_time_between_two_looks() {
        let (mut told, mut watch) = watch();
        let mut meter = LinkMeter::new(Medium::CanFd { nominal: 1_000_000, data: 5_000_000 });
        (0..10_000).for_each(|_| meter.saw_up(26));
        told.push((1_000, line(WireState::Active, Some(meter)))).unwrap();
        watch.look().unwrap();
        assert!(watch.links().lines[0].seen.is_nan(), "one look is no time");
        (0..1_000).for_each(|_| meter.saw_up(26));
        told.push((2_000, line(WireState::Active, Some(meter)))).unwrap();
        watch.look().unwrap();
        let links = watch.links();
        // 104.8 us each, by the planner's tables.
        assert!((links.lines[0].seen - 0.1048).abs() < 1e-6, "{links:?}");
        assert_eq!(watch.look(), None, "nothing was seen");
    }

    #[test]
    fn what_becomes_of_a_board_or_a_line_is_told_once() {
        let (mut told, mut watch) = watch();
        let mut look = |glance| {
            told.push((0, glance)).unwrap();
            let changes = watch.look().unwrap();
            (watch.links().clone(), changes)
        };
        assert_eq!(look(board(ArmState::Armed)).1, [""; 0], "it begins so");
        assert_eq!(look(board(ArmState::Greeting)).1, ["board 3 on can0: silent"]);
        let (links, changes) = look(board(ArmState::Greeting));
        assert_eq!(changes, [""; 0]);
        let it = &links.boards[0];
        assert_eq!((it.state.as_str(), it.armings, it.round_trip), ("silent", 2, 990.0));
        let mut muted = [None; MOST_KEYS];
        muted[6] = Some(KeyFault::Noisy);
        let told = look(with_muted(ArmState::Armed, muted)).1;
        assert!(
            told[0].starts_with("board 3 on can0: armed; C4 is muted: its readings"),
            "{told:?}"
        );
        look(board(ArmState::Armed));
        let again = armed(ArmState::Armed, [None; MOST_KEYS], 3);
        let text = "board 3 on can0: armed; it had taken its forces away, and was armed anew";
        assert_eq!(look(again).1, [text]);
        assert_eq!(look(again).1, [""; 0]);
        look(line(WireState::Active, None));
        assert_eq!(look(line(WireState::Off, None)).1, ["can0 is off now"]);
        let unplugged = LineStatistics { down: 900, ..LineStatistics::default() };
        let glance = LineSnapshot { statistics: unplugged, meter: None };
        assert_eq!(look(LinkSnapshot::Line(0, glance)).1, ["can0 is down now"]);
        assert_eq!(look(LinkSnapshot::Line(0, glance)).1, ["can0 is active now"], "it was mended");
    }
}
