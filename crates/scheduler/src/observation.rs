//! What is seen of a voice beside its turn: the model's state, changes of mode, and when it was
//! run. Nothing in the tick depends on it, and it is taken of followed keys only.

use crate::motion::KEYS;

/// Most entries that a state may have, or it could not be shown.
///
/// Guards and outputs are worked out from what is shown, so a state is never cut: whoever builds
/// a voice refuses a model that has more.
pub const MAX_STATES: usize = 32;

/// Changes of mode of one tick that can be shown; more are counted, not kept.
pub const MAX_SWITCHES: usize = 6;

/// The keys whose voices are observed in a tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FollowedKeys {
    /// Bit n is key n.
    all: u128,
    /// Those of them that were not seen yet.
    new: u128,
}

impl FollowedKeys {
    pub const NONE: Self = Self::new(0, 0);

    /// Every key, each as if it had been seen before.
    pub const ALL: Self = Self::new((1 << KEYS) - 1, 0);

    /// Follows the keys whose bit is set in `all`; those that have it in `new`, too, were not
    /// seen yet.
    pub const fn new(all: u128, new: u128) -> Self {
        Self { all, new: new & all }
    }

    /// Returns whether `key` is followed.
    #[inline]
    pub const fn contains(self, key: usize) -> bool {
        self.all >> key & 1 == 1
    }

    /// Returns whether `key` is followed, and its voice was not seen yet.
    #[inline]
    pub const fn is_new(self, key: usize) -> bool {
        self.new >> key & 1 == 1
    }
}

/// What is seen of a voice.
///
/// It belongs to a key and stays as it is while the voice rests or its lane is late.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct VoiceObservation {
    /// In which of the last ticks the voice was run: this one is bit 0. If its turn was late, those
    /// before this one, with bit 0 where all of them are known; else nothing is.
    pub ran: u32,
    /// The model when it was run last.
    pub snapshot: ModelSnapshot,
    /// Changes of mode in this tick.
    pub switches: Switches,
}

impl VoiceObservation {
    /// Notes a tick after which the voice was not looked at: its model is as it was, and nothing
    /// happened to it.
    pub const fn pass(&mut self, ran: u32) {
        self.ran = ran;
        self.switches.clear();
    }
}

/// A model at the end of a tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ModelSnapshot {
    /// The voice's number among all voices of a run; 0 of a key that has none.
    pub revision: u32,
    /// The mode: the structural one, an index into the model's list, in the low 8 bits, and above
    /// them what its contacts do.
    pub mode: u64,
    /// The state, in the model's order; 0 behind its end.
    pub state: [f64; MAX_STATES],
    /// The input and its first three derivatives, in the model's unit.
    pub input: [f64; 4],
}

impl ModelSnapshot {
    /// Returns the structural mode, an index into the model's list.
    pub const fn structure(&self) -> u8 {
        self.mode.to_le_bytes()[0]
    }

    /// Shows `state`, of at most [`MAX_STATES`] entries.
    pub fn show(&mut self, state: &[f64]) {
        debug_assert!(state.len() <= MAX_STATES, "a state of {} entries is cut", state.len());
        for (index, shown) in self.state.iter_mut().enumerate() {
            *shown = state.get(index).copied().unwrap_or_default();
        }
    }
}

/// A change of mode.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Switch {
    /// Where in the tick, in `0 ..= 1`.
    pub theta: f64,
    /// Modes before and after, indices into the model's list.
    pub from: u8,
    pub to: u8,
    /// The guard that fired, by its number in the model; 255 if none did.
    pub guard: u8,
}

/// A short list of changes of mode with a fixed capacity.
#[derive(Clone, Copy, Debug, Default)]
pub struct Switches {
    list: [Switch; MAX_SWITCHES],
    n: u8,
    dropped: u8,
}

impl PartialEq for Switches {
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice() && self.dropped == other.dropped
    }
}

impl Switches {
    /// Removes every change of mode.
    pub const fn clear(&mut self) {
        (self.n, self.dropped) = (0, 0);
    }

    /// Appends one; counts it as dropped when the list is full.
    pub fn push(&mut self, switch: Switch) {
        if let Some(place) = self.list.get_mut(usize::from(self.n)) {
            *place = switch;
            self.n += 1;
        } else {
            self.dropped = self.dropped.saturating_add(1);
        }
    }

    /// Returns whether nothing changed.
    pub const fn is_empty(&self) -> bool {
        self.n == 0 && self.dropped == 0
    }

    /// Returns the changes in the order in which they happened.
    pub fn as_slice(&self) -> &[Switch] {
        &self.list[..usize::from(self.n)]
    }

    /// Returns how many did not fit.
    pub const fn dropped(&self) -> u8 {
        self.dropped
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_counted() {
        let mut switches = Switches::default();
        for to in 0..9 {
            switches.push(Switch { to, ..Switch::default() });
        }
        assert_eq!(switches.as_slice().len(), MAX_SWITCHES);
        assert_eq!((switches.as_slice()[5].to, switches.dropped()), (5, 3));
        switches.clear();
        assert_eq!(switches, Switches::default());
    }

    #[test]
    fn what_is_behind_a_state_is_zero() {
        let is = |snapshot: &ModelSnapshot, wanted: [f64; MAX_STATES]| {
            snapshot.state.map(f64::to_bits) == wanted.map(f64::to_bits)
        };
        let mut snapshot = ModelSnapshot::default();
        snapshot.show(&[3.0; MAX_STATES]);
        assert!(is(&snapshot, [3.0; MAX_STATES]));
        snapshot.show(&[1.0, 2.0]);
        let mut wanted = [0.0; MAX_STATES];
        wanted[..2].copy_from_slice(&[1.0, 2.0]);
        assert!(is(&snapshot, wanted));
    }

    #[test]
    #[should_panic(expected = "a state of 33 entries is cut")]
    fn a_state_is_not_cut_without_a_word() {
        ModelSnapshot::default().show(&[3.0; MAX_STATES + 1]);
    }
}
