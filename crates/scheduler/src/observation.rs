//! Observation of a voice beside its turn: the model's state, changes of mode, and the ticks in
//! which it was run. Nothing in the tick depends on it, and only followed keys have it.

use crate::motion::KEYS;

/// Most entries of a state.
///
/// Never cut, since guards and outputs are computed from it: a builder rejects larger models.
pub const MAX_STATES: usize = 32;

/// Changes of mode of one tick that can be shown; more are counted, not kept.
pub const MAX_SWITCHES: usize = 6;

/// Keys with observed voices in a tick, a bit each.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct FollowedKeys {
    all: u128,
    /// Bits of the keys that were not observed yet.
    new: u128,
}

impl FollowedKeys {
    pub const NONE: Self = Self::new(0, 0);

    /// Every key, each as if it had been observed before.
    pub const ALL: Self = Self::new((1 << KEYS) - 1, 0);

    /// Follows the keys with a bit in `all`; a bit in `new` marks those not observed yet.
    pub const fn new(all: u128, new: u128) -> Self {
        Self { all, new: new & all }
    }

    #[inline]
    pub const fn contains(self, key: usize) -> bool {
        self.all >> key & 1 == 1
    }

    #[inline]
    pub const fn is_new(self, key: usize) -> bool {
        self.new >> key & 1 == 1
    }
}

/// Observation of a key's voice; unchanged while the voice rests or its lane is late.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct VoiceObservation {
    /// Last ticks in which the voice was run, with this one as bit 0. If its turn was late: those
    /// before this one, with bit 0 set if all of them are known; nothing otherwise.
    pub ran: u32,
    /// Model after its last run.
    pub snapshot: ModelSnapshot,
    pub switches: Switches,
}

impl VoiceObservation {
    /// Notes an unobserved tick: the model is unchanged and no mode changed.
    pub const fn pass(&mut self, ran: u32) {
        self.ran = ran;
        self.switches.clear();
    }
}

/// Model at the end of a tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ModelSnapshot {
    /// Number of the voice among all voices of a run; 0 for a key without a voice.
    pub revision: u32,
    /// Mode: index of the structural mode in the low 8 bits, state of the contacts above them.
    pub mode: u64,
    /// State, in the model's order; 0 behind its end.
    pub state: [f64; MAX_STATES],
    /// Input and its first three derivatives, in the model's unit.
    pub input: [f64; 4],
}

impl ModelSnapshot {
    /// Returns the structural mode, an index into the model's list.
    pub const fn structure(&self) -> u8 {
        self.mode.to_le_bytes()[0]
    }

    /// Copies `state`, of at most [`MAX_STATES`] entries.
    pub fn show(&mut self, state: &[f64]) {
        debug_assert!(state.len() <= MAX_STATES, "a state of {} entries is cut", state.len());
        for (index, shown) in self.state.iter_mut().enumerate() {
            *shown = state.get(index).copied().unwrap_or_default();
        }
    }
}

/// Change of a mode within a tick.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Switch {
    /// Fraction of the tick, in `0 ..= 1`.
    pub theta: f64,
    /// Modes before and after, indices into the model's list.
    pub from: u8,
    pub to: u8,
    /// Number in the model of the guard that fired; 255 if none did.
    pub guard: u8,
}

/// List of the changes of mode in a tick, with a fixed capacity.
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
    pub const fn clear(&mut self) {
        (self.n, self.dropped) = (0, 0);
    }

    /// Appends a change; counts it as dropped when the list is full.
    pub fn push(&mut self, switch: Switch) {
        if let Some(place) = self.list.get_mut(usize::from(self.n)) {
            *place = switch;
            self.n += 1;
        } else {
            self.dropped = self.dropped.saturating_add(1);
        }
    }

    pub const fn is_empty(&self) -> bool {
        self.n == 0 && self.dropped == 0
    }

    /// Returns the changes in order of time.
    pub fn as_slice(&self) -> &[Switch] {
        &self.list[..usize::from(self.n)]
    }

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
