//! Keys without a force, with the reason.

use telemetry::{Board, KEYS, Severity, Status};

use crate::{names, number};

/// Condition of a key.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum KeyCondition {
    #[default]
    Well,
    /// The key is muted after a failure.
    Muted,
    /// The key's board renders no force, for this reason.
    Silent(String),
    /// No board carries the key.
    Absent,
}

/// Conditions of all keys.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Conditions {
    keys: Vec<KeyCondition>,
    pub boards: Vec<String>,
    pub others: Vec<String>,
}

impl Default for Conditions {
    fn default() -> Self {
        Self { keys: vec![KeyCondition::Well; KEYS], boards: Vec::new(), others: Vec::new() }
    }
}

impl Conditions {
    pub(crate) fn new(boards: &[Board], lines: &[String], status: Option<&Status>) -> Self {
        let mut conditions = Self::default();
        let (muted, absent) =
            status.map_or((&[][..], &[][..]), |it| (&it.muted[..], &it.absent[..]));
        conditions.mark(absent, &KeyCondition::Absent, "no board");
        let muted: Vec<u32> =
            boards.iter().flat_map(|it| &it.muted).chain(muted).copied().collect();
        conditions.mark(&muted, &KeyCondition::Muted, "muted, no force");
        for board in boards.iter().filter(|board| board.severity() == Severity::Lost) {
            let name = name(board, lines);
            let end = board.first_key.saturating_add(board.keys).min(u32::from(names::LAST) + 1);
            let keys: Vec<u32> = (board.first_key..end).collect();
            let condition = KeyCondition::Silent(format!("{name}: {}", board.state));
            let ranges = conditions.set(&keys, &condition);
            // The rest of the state is the remedy, which Links has.
            let state = board.state.split([';', ':']).next().unwrap_or_default();
            let text = format!("{name} {state}: {ranges} have no force");
            conditions.boards.push(text);
        }
        conditions
    }

    fn mark(&mut self, keys: &[u32], condition: &KeyCondition, words: &str) {
        let ranges = self.set(keys, condition);
        if !ranges.is_empty() {
            self.others.push(format!("{ranges}: {words}"));
        }
    }

    fn set(&mut self, keys: &[u32], condition: &KeyCondition) -> String {
        let mut keys: Vec<u8> = keys.iter().filter_map(|key| number::key(*key)).collect();
        keys.sort_unstable();
        keys.dedup();
        for key in &keys {
            if let Some(place) = self.keys.get_mut(usize::from(*key)) {
                place.clone_from(condition);
            }
        }
        let runs = keys.chunk_by(|a, b| *a + 1 == *b);
        let ends = runs.filter_map(|run| Some(*run.first()?..=*run.last()?));
        ends.map(|range| names::range_name(&range)).collect::<Vec<_>>().join(", ")
    }

    pub fn key(&self, key: u8) -> &KeyCondition {
        self.keys.get(usize::from(key)).unwrap_or(&KeyCondition::Well)
    }
}

impl KeyCondition {
    /// Returns the reason why the key has no force, in words; empty if it has one.
    pub fn words(&self) -> String {
        match self {
            Self::Well => String::new(),
            Self::Muted => "muted: no force".to_owned(),
            Self::Silent(board) => format!("no force: {board}"),
            Self::Absent => "no board".to_owned(),
        }
    }
}

fn name(board: &Board, lines: &[String]) -> String {
    let line = usize::try_from(board.line).ok().and_then(|line| lines.get(line));
    format!("board {} on {}", board.id, line.map_or_else(|| board.line.to_string(), Clone::clone))
}
