//! Contents of a file that are not played, counted by kind.

use std::fmt;

/// Kind of contents that are not played as they are in the file; `KINDS` has each in words.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[expect(missing_docs, reason = "the names say it")]
pub enum PassedOver {
    Percussion,
    OffKeyboard,
    NotChosen,
    Overlapping,
    PedalMoves,
    ProgramChanges,
    VolumeChanges,
    Controllers,
    PitchBends,
    Pressures,
    SkippedBytes,
    DamagedBytes,
}

/// Name in reports for programs, and words, of every [`PassedOver`] in its order.
const KINDS: [(&str, &str); PassedOver::DamagedBytes as usize + 1] = [
    ("percussion", "notes of percussion (channel 10)"),
    ("off_keyboard", "notes off the 88 keys"),
    ("not_chosen", "notes of other tracks or channels"),
    ("overlapping", "notes during another on their key, which ends or is one with them"),
    ("pedal_moves", "pedal moves of channels that are not played"),
    ("program_changes", "program changes"),
    ("volume_changes", "changes of volume or expression"),
    ("controllers", "other controllers"),
    ("pitch_bends", "pitch bends"),
    ("pressures", "pressures on held keys"),
    ("skipped_bytes", "bytes that belong to no event"),
    ("damaged_bytes", "bytes missing or unreadable at the end of a track"),
];

/// Number of each kind of contents that are not played.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct PassedOverCounts([u32; KINDS.len()]);

impl PassedOverCounts {
    pub const fn of(&self, kind: PassedOver) -> u32 {
        self.0[kind as usize]
    }

    pub fn add(&mut self, kind: PassedOver, n: usize) {
        let count = &mut self.0[kind as usize];
        *count = count.saturating_add(u32::try_from(n).unwrap_or(u32::MAX));
    }

    /// Returns the name and the number of each kind.
    pub fn named(&self) -> impl Iterator<Item = (&'static str, u32)> {
        KINDS.into_iter().zip(self.0).map(|((name, _), n)| (name, n))
    }

    pub(super) fn add_all(&mut self, other: Self) {
        let counts = self.0.iter_mut().zip(other.0);
        counts.for_each(|(count, more)| *count = count.saturating_add(more));
    }
}

/// Shows every kind that occurs, as "2 program changes, 1 pitch bends".
impl fmt::Display for PassedOverCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let present = KINDS.into_iter().zip(self.0).filter(|(_, n)| 0 < *n);
        let words: Vec<_> = present.map(|((_, words), n)| format!("{n} {words}")).collect();
        let words = words.join(", ");
        f.write_str(if words.is_empty() { "nothing" } else { &words })
    }
}
