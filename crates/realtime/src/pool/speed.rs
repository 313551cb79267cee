//! How many evaluations fit into a tick, as lanes were seen to run them.

use scheduler::overload::LaneBudget;
use scheduler::time::Nanos;

use super::WaitLimit;
use super::worker::SHARES;

/// Part of the best speed that is forgotten with each tick that tells of it.
const FORGOTTEN: f64 = 1.0 / 1024.0;

/// Lanes say how quick they are in ticks that take at least this part of the time: in others, what
/// voices take beside their evaluations counts for too much.
const TELLING: f64 = 0.5;

/// Keys at rest may take this part of what others may, in addition: those that wake.
const AT_REST: f64 = 0.125;

/// The evaluations that lanes compute in a nanosecond when nothing slows them down.
///
/// It is the best of late: what a hypervisor or a neighbour takes makes a lane seem slower, and
/// nothing makes it seem quicker.
#[derive(Debug, Default)]
pub(super) struct LaneSpeed {
    /// The best of late (1/ns); none before the first tick that says anything.
    best: Option<f64>,
    /// What ticks took of late beside the lanes (ns).
    beside: f64,
}

impl LaneSpeed {
    /// Takes note of a lane that computed so many `evaluations` in `cpu`.
    pub(super) fn learn(&mut self, evaluations: u64, cpu: Nanos, patience: WaitLimit) {
        let Some(share) = patience.share() else { return };
        let (share, cpu) = (share.as_u64() as f64, cpu.as_u64() as f64);
        if TELLING * share <= cpu {
            let speed = evaluations as f64 / cpu;
            let known = self.best.map(|best| best * (1.0 - FORGOTTEN));
            self.best = Some(known.map_or(speed, |known| known.max(speed)));
        }
    }

    /// Takes note of what the last tick took beside the lanes.
    pub(super) fn learn_beside(&mut self, cpu: Nanos) {
        self.beside += (cpu.as_u64() as f64 - self.beside) / 64.0;
    }

    /// Returns what a lane's voices that move, and those at rest, may take in a tick.
    pub(super) fn budgets(&self, patience: WaitLimit) -> [LaneBudget; SHARES] {
        let (Some(share), Some(best)) = (patience.share(), self.best) else {
            return [LaneBudget::UNLIMITED; SHARES];
        };
        let share = share.as_u64() as f64;
        let evaluations = best * (share - self.beside).max(0.25 * share);
        [evaluations, AT_REST * evaluations].map(budget)
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "as saturates")]
const fn budget(evaluations: f64) -> LaneBudget {
    LaneBudget::of(evaluations as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ticks of 100 µs.
    const TICK: WaitLimit = WaitLimit::Until { time: Nanos::ZERO, share: Nanos::from_micros(100) };

    fn budgets(evaluations: u32) -> [LaneBudget; SHARES] {
        [LaneBudget::of(evaluations), LaneBudget::of(evaluations / 8)]
    }

    #[test]
    fn a_lane_may_take_what_fits_into_a_tick_by_the_best_that_was_seen() {
        let mut speed = LaneSpeed::default();
        let micros = Nanos::from_micros;
        assert_eq!(speed.budgets(TICK), [LaneBudget::UNLIMITED; SHARES], "nothing is known");
        speed.learn(4900, micros(49), TICK);
        assert_eq!(speed.budgets(TICK), [LaneBudget::UNLIMITED; SHARES], "too little to tell");
        speed.learn(8000, micros(80), TICK);
        assert_eq!(speed.budgets(TICK), budgets(10_000));
        speed.learn(8000, micros(400), TICK);
        assert_eq!(speed.budgets(TICK), budgets(9990), "slowed down by others");
        assert_eq!(speed.budgets(WaitLimit::Endless), [LaneBudget::UNLIMITED; SHARES]);
        for _ in 0..2000 {
            speed.learn(8000, micros(160), TICK);
        }
        assert_eq!(speed.budgets(TICK), budgets(5000), "the machine has become slower");
    }

    #[test]
    fn what_ticks_take_beside_the_lanes_is_not_theirs() {
        let mut speed = LaneSpeed::default();
        speed.learn(8000, Nanos::from_micros(80), TICK);
        for _ in 0..2000 {
            speed.learn_beside(Nanos::from_micros(20));
        }
        assert_eq!(speed.budgets(TICK), budgets(8000));
        for _ in 0..2000 {
            speed.learn_beside(Nanos::from_millis(20));
        }
        assert_eq!(speed.budgets(TICK), budgets(2500), "keys are played all the same");
    }
}
