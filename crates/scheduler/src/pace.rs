//! What so many evaluations take, learnt from the ticks themselves.
//!
//! A thread's CPU clock goes on while a hypervisor has the processor, so on a virtual
//! machine a tick can seem to have worked for milliseconds that it never had.
//! Counted work cannot be stolen: if as many evaluations were ever done in less time, that
//! is what they take, and the rest was not ours. Without such evidence the clock is believed.

use crate::time::Nanos;

/// Evaluations that count as equally many: half a microsecond's worth.
const GRAIN: usize = 16;

/// Steps of evaluations that are told apart; more count as the last.
const STEPS: usize = 256;

/// The least CPU time in which at least so many evaluations were done.
#[derive(Clone, Debug)]
pub struct Pace {
    /// By steps of [`GRAIN`] evaluations; never falls from one step to the next.
    least: [Nanos; STEPS],
}

impl Default for Pace {
    fn default() -> Self {
        Self { least: [Nanos::new(u64::MAX); STEPS] }
    }
}

impl Pace {
    /// CPU time that a tick of so many `evaluations` needed, if its clock says `cpu`.
    ///
    /// # Real-time
    /// At most 256 comparisons, usually one.
    pub fn needed(&mut self, evaluations: u32, cpu: Nanos) -> Nanos {
        let step = (evaluations as usize / GRAIN).min(STEPS - 1);
        // The tick is evidence for itself and for all smaller ones.
        for least in self.least[..=step].iter_mut().rev() {
            if *least <= cpu {
                break;
            }
            *least = cpu;
        }
        self.least[step]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(pace: &mut Pace, evaluations: u32, cpu: u64, needed: u64) {
        assert_eq!(pace.needed(evaluations, Nanos::new(cpu)), Nanos::new(needed));
    }

    #[test]
    fn without_evidence_the_clock_is_believed() {
        let mut pace = Pace::default();
        check(&mut pace, 100, 5000, 5000);
        check(&mut pace, 1000, 9000, 9000);
        check(&mut pace, u32::MAX, 90_000, 90_000);
    }

    #[test]
    fn time_beyond_what_as_many_evaluations_once_took_is_not_needed() {
        let mut pace = Pace::default();
        check(&mut pace, 500, 20_000, 20_000);
        check(&mut pace, 500, 2_000_000, 20_000);
        check(&mut pace, 40, 1_000_000, 20_000);
        check(&mut pace, 40, 3_000, 3_000);
        check(&mut pace, 500, 2_000_000, 20_000);
    }

    #[test]
    fn fewer_evaluations_are_no_evidence_for_more() {
        let mut pace = Pace::default();
        check(&mut pace, 10, 1_000, 1_000);
        check(&mut pace, 600, 2_000_000, 2_000_000);
    }
}
