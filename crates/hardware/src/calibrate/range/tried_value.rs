//! One value: does the key come to rest after its pulse?

/// A key is looked at in blocks of so much time (s).
const BLOCK: f64 = 0.15;
/// After so many blocks it is judged.
const BLOCKS: u32 = 8;
/// Way to and fro in a block within which a key is at rest, as a part of its dip.
const RESTING: f64 = 0.01;
/// The same of a key that shakes, in the last block. As trials of instruments have it.
const SHAKING: f64 = 0.4;
/// The same of a key that begins to, and how much more it is than in the block before. As trials
/// have it.
const GROWING: (f64, f64) = (0.15, 1.25);
/// A key that meets its felts asks a mass for more than the largest force, and for less long (s).
const LIMITED: f64 = 10e-3;

/// What a key does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Verdict {
    /// It is not known yet.
    Moves,
    Rests,
    Shakes,
}

/// One value that is tried.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct TriedValue {
    /// Time (s) and place (m) of the first look.
    began: Option<(f64, f64)>,
    /// Blocks that are over.
    blocks: u32,
    /// Ways up and down in this block (m).
    ways: (f64, f64),
    /// Way to and fro in the block before, of the dip.
    before: f64,
    position: f64,
    /// For how long more than the largest force was asked for (s).
    limited: f64,
}

impl TriedValue {
    /// Takes where the key is at `t` (s, m), whose way is `dip` (m).
    pub(super) fn advance(&mut self, t: f64, position: f64, dip: f64) -> Verdict {
        let (began, _) = *self.began.get_or_insert_with(|| {
            self.position = position;
            (t, position)
        });
        let moved = position - self.position;
        self.position = position;
        self.ways.0 -= moved.min(0.0);
        self.ways.1 += moved.max(0.0);
        if t - began < BLOCK * f64::from(self.blocks + 1) {
            return Verdict::Moves;
        }
        // A key that is on its way to the middle goes one way only.
        let (up, down) = std::mem::take(&mut self.ways);
        let swing = 2.0 * up.min(down) / dip;
        let before = std::mem::replace(&mut self.before, swing);
        self.blocks += 1;
        // The pulse is in the first.
        if self.blocks == 1 {
            return Verdict::Moves;
        }
        let is_last = BLOCKS <= self.blocks;
        if GROWING.0.max(GROWING.1 * before) < swing || is_last && SHAKING < swing {
            Verdict::Shakes
        } else if swing < RESTING || is_last {
            Verdict::Rests
        } else {
            Verdict::Moves
        }
    }

    /// Notes that more than the largest force is asked for during `period` (s).
    pub(super) fn limit(&mut self, period: f64) {
        self.limited += period;
    }

    /// Tells whether the object needs a larger force.
    pub(super) fn is_limited(&self) -> bool {
        LIMITED < self.limited
    }

    /// Returns the time since the first look (s).
    pub(super) fn age(&self, t: f64) -> f64 {
        self.began.map_or(0.0, |(began, _)| t - began)
    }

    /// Returns where the key was then (m).
    pub(super) fn began_at(&self) -> f64 {
        self.began.map_or(self.position, |(_, place)| place)
    }
}
