//! One value: does the key come to rest after its pulse?

use haptics::Swing;

/// A key is looked at in blocks of so much time (s), as trials look at it.
const BLOCK: f64 = 0.15;
/// After so many blocks it is judged.
const BLOCKS: u32 = 8;
/// Way to and fro in a block within which a key is at rest, as a part of its dip.
const RESTING: f64 = 0.01;
/// A key that meets its felts asks a mass for more than the largest force, and for less long (s).
const LIMITED: f64 = 10e-3;

/// What a key does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum KeyResponse {
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
    /// How the key moved in this block.
    swing: Swing,
    /// Way to and fro in the block before, of the dip.
    before: f64,
    position: f64,
    /// For how long more than the largest force was asked for (s).
    limited: f64,
}

impl TriedValue {
    /// Takes where the key is at `t` (s, m), whose way is `dip` (m).
    pub(super) fn advance(&mut self, t: f64, position: f64, dip: f64) -> KeyResponse {
        let (began, _) = *self.began.get_or_insert_with(|| {
            self.position = position;
            (t, position)
        });
        self.swing.add(position - self.position);
        self.position = position;
        if t - began < BLOCK * f64::from(self.blocks + 1) {
            return KeyResponse::Moves;
        }
        let swing = std::mem::take(&mut self.swing).to_and_fro() / dip;
        let before = std::mem::replace(&mut self.before, swing);
        self.blocks += 1;
        // The pulse is in the first.
        if self.blocks == 1 {
            return KeyResponse::Moves;
        }
        let is_last = BLOCKS <= self.blocks;
        if Swing::grows(before, swing) || is_last && Swing::SHAKING < swing {
            KeyResponse::Shakes
        } else if swing < RESTING || is_last {
            KeyResponse::Rests
        } else {
            KeyResponse::Moves
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
