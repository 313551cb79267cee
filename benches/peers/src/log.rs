//! The record of one run: its events, and the states at the requested times.

/// Number of events that stops a code in a loop: more than any problem here has.
const MOST_EVENTS: usize = 100;

/// Record of a run, reused by the next one, so that no timed run allocates here.
#[derive(Clone, Debug, Default)]
pub(crate) struct Log {
    /// Time (s) and guard of each event.
    pub(crate) events: Vec<(f64, &'static str)>,
    /// Rising times at which the state is recorded (s); empty in timed runs.
    wanted: Vec<f64>,
    /// The states at the first of these times, one after the other.
    pub(crate) states: Vec<f64>,
    taken: usize,
    pub(crate) evaluations: Option<u64>,
}

impl Log {
    pub(crate) fn new(wanted: &[f64]) -> Self {
        Self { wanted: wanted.to_vec(), events: Vec::with_capacity(MOST_EVENTS), ..Self::default() }
    }

    pub(crate) fn clear(&mut self) {
        self.events.clear();
        self.states.clear();
        self.taken = 0;
        self.evaluations = None;
    }

    pub(crate) fn event(&mut self, t: f64, guard: &'static str) -> Result<(), String> {
        self.events.push((t, guard));
        let last = || format!("stopped after {MOST_EVENTS} events, the last at {t} s");
        if self.events.len() < MOST_EVENTS { Ok(()) } else { Err(last()) }
    }

    pub(crate) fn wants_states(&self) -> bool {
        !self.wanted.is_empty()
    }

    #[inline]
    pub(crate) fn sample<const N: usize>(&mut self, t: f64, mut at: impl FnMut(f64) -> [f64; N]) {
        // The end of a run may be off by rounding; a dense output must not be asked beyond it.
        let until = t * (1.0 + 1e-14);
        while let Some(time) = self.wanted.get(self.taken).filter(|time| **time <= until) {
            self.states.extend(at(time.min(t)));
            self.taken += 1;
        }
    }

    /// Drops the states after `t` (s), for codes that see a step before its event.
    pub(crate) fn forget_after(&mut self, t: f64) {
        let kept = self.wanted.partition_point(|time| *time <= t).min(self.taken);
        if let Some(width) = self.states.len().checked_div(self.taken) {
            self.states.truncate(kept * width);
        }
        self.taken = kept;
    }

    pub(crate) fn count(&mut self, evaluations: u64) {
        self.evaluations = Some(self.evaluations.unwrap_or(0) + evaluations);
    }
}
