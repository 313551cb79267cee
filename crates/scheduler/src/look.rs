//! What a model was like, for those who watch: nothing in the tick depends on it.

/// Most entries that a state may have, or it could not be shown.
///
/// Guards and outputs are worked out from what is shown, so a state is never cut: whoever fills a
/// [`ModelSnapshot`] refuses to compile a model that has more.
pub const MAX_STATES: usize = 8;

/// Changes of mode that one turn can show; more are counted, not kept.
pub const MAX_SWITCHES: usize = 6;

/// A model at the end of a turn.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct ModelSnapshot {
    /// Which voice: numbered by whoever put it in.
    pub revision: u32,
    /// Its mode, an index into the model's list.
    pub mode: u8,
    /// Its state, in the model's order; 0 behind its end.
    pub state: [f64; MAX_STATES],
    /// The input and its first three derivatives, in the model's unit.
    pub input: [f64; 4],
}

impl ModelSnapshot {
    /// Shows `state`, of at most [`MAX_STATES`] entries.
    pub fn show(&mut self, state: &[f64]) {
        debug_assert!(state.len() <= MAX_STATES, "a state of {} entries is cut", state.len());
        for (shown, value) in self.state.iter_mut().zip(state) {
            *shown = *value;
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
    /// Forgets all.
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

    /// In the order in which they happened.
    pub fn as_slice(&self) -> &[Switch] {
        &self.list[..usize::from(self.n)]
    }

    /// How many did not fit.
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
        let is = |look: &ModelSnapshot, wanted: [f64; MAX_STATES]| {
            look.state.map(f64::to_bits) == wanted.map(f64::to_bits)
        };
        let mut look = ModelSnapshot::default();
        look.show(&[1.0, 2.0]);
        assert!(is(&look, [1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
        look.show(&[3.0; MAX_STATES]);
        assert!(is(&look, [3.0; MAX_STATES]));
    }

    #[test]
    #[should_panic(expected = "a state of 12 entries is cut")]
    fn a_state_is_not_cut_without_a_word() {
        ModelSnapshot::default().show(&[3.0; 12]);
    }
}
