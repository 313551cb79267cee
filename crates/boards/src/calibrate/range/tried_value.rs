//! One value: whether the key comes to rest after its pulse.

use haptics::Swing;

/// Length of a block of observation (s), as in trials.
const BLOCK: f64 = 0.15;
const BLOCKS: u32 = 8;
/// Swing in a block within which a key is at rest, relative to its dip.
const RESTING: f64 = 0.01;
/// Longest demand above the largest force (s): a mass exceeds it briefly when the key meets felts.
const LIMITED: f64 = 10e-3;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum KeyResponse {
    Moves,
    Rests,
    Shakes,
}

#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(super) struct TriedValue {
    /// Time (s) and position (m) of the first sample.
    began: Option<(f64, f64)>,
    blocks: u32,
    swing: Swing,
    /// Swing in the block before, relative to the dip.
    before: f64,
    position: f64,
    /// Total demand above the largest force (s).
    limited: f64,
}

impl TriedValue {
    /// Processes the key's position at `t` (s, m); its travel is `dip` (m).
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

    /// Adds a `period` (s) of demand above the largest force.
    pub(super) fn limit(&mut self, period: f64) {
        self.limited += period;
    }

    pub(super) fn is_limited(&self) -> bool {
        LIMITED < self.limited
    }

    pub(super) fn age(&self, t: f64) -> f64 {
        self.began.map_or(0.0, |(began, _)| t - began)
    }

    /// Returns the position of the first sample (m).
    pub(super) fn began_at(&self) -> f64 {
        self.began.map_or(self.position, |(_, place)| place)
    }
}
