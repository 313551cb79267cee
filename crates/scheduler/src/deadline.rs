//! Deadlines: the outcome of each tick, and the cause of a miss.
//!
//! A tick is in time if its forces are out by its deadline; a late one has exactly one cause. With
//! `slack = deadline - due`, the time from due to finished is waking up (`woken - due`), work (CPU
//! time) and stolen time (`finished - woken - work`):
//!
//! | condition | cause |
//! |---|---|
//! | work alone is longer than the slack | own work: no state of the machine would have saved it |
//! | otherwise, waking up took at least as long as was stolen | woken late |
//! | otherwise | preempted |
//!
//! Simulated keys run on the tick's own thread, and make up for skipped ticks; their time counts as
//! stolen. Time stolen by a hypervisor is excluded from work where the kernel accounts for it, and
//! counts as own work where it does not, so own work is never blamed on others.
//!
//! A tick that begins late because the one before it was still running has that tick's cause. A
//! skipped tick missed its deadline, with the cause that made the next one begin late.

use crate::time::Nanos;

/// Times measured by the host around one tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct TickTimes {
    pub due: Nanos,
    pub deadline: Nanos,
    pub woken: Nanos,
    pub finished: Nanos,
    /// CPU time by the threads' clocks: the tick's own thread without waiting, and its slowest
    /// lane. Includes exchange with boards, observation and page faults.
    pub work: Nanos,
    /// Part of the work that simulated keys took.
    pub simulated: Nanos,
}

impl TickTimes {
    pub const fn lateness(&self) -> Nanos {
        self.woken.since(self.due)
    }

    pub const fn turnaround(&self) -> Nanos {
        self.finished.since(self.woken)
    }

    pub const fn own_work(&self) -> Nanos {
        self.work.since(self.simulated)
    }

    /// Returns the time between start and end in which the host did not run.
    pub const fn stolen(&self) -> Nanos {
        self.turnaround().since(self.own_work())
    }

    pub const fn is_late_by_simulated_keys(&self) -> bool {
        let slack = self.deadline.since(self.due).as_u64();
        slack < self.work.as_u64() && self.own_work().as_u64() <= slack
    }
}

/// Cause of a missed deadline.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MissCause {
    OwnWork,
    WokenLate,
    Preempted,
}

/// Outcome of a tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[must_use]
pub enum Outcome {
    Met,
    Missed(MissCause),
}

/// Counts of ticks, misses by cause, and skips.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Counters {
    pub ticks: u64,
    pub missed: u64,
    pub missed_own_work: u64,
    pub missed_woken_late: u64,
    pub missed_preempted: u64,
    /// Ticks that were never run; they count as missed.
    pub skipped: u64,
}

/// Counts of ticks and misses, with the end and the miss of the last tick.
#[derive(Clone, Debug, Default)]
pub struct Ledger {
    counters: Counters,
    last_finished: Nanos,
    last_cause: Option<MissCause>,
}

impl Ledger {
    /// Records a tick that came after `skipped` ticks that were not run.
    pub fn enter(&mut self, times: &TickTimes, skipped: u64) -> Outcome {
        let late_because = self.why_it_began_late(times);
        let outcome = judge(times, late_because);
        self.counters.ticks += 1;
        self.counters.skipped += skipped;
        self.count_misses(late_because, skipped);
        self.last_finished = times.finished;
        self.last_cause = match outcome {
            Outcome::Met => None,
            Outcome::Missed(cause) => {
                self.count_misses(cause, 1);
                Some(cause)
            }
        };
        outcome
    }

    pub const fn counters(&self) -> Counters {
        self.counters
    }

    fn why_it_began_late(&self, times: &TickTimes) -> MissCause {
        match self.last_cause {
            Some(cause) if times.due < self.last_finished => cause,
            Some(_) | None => MissCause::WokenLate,
        }
    }

    const fn count_misses(&mut self, cause: MissCause, n: u64) {
        self.counters.missed += n;
        match cause {
            MissCause::OwnWork => self.counters.missed_own_work += n,
            MissCause::WokenLate => self.counters.missed_woken_late += n,
            MissCause::Preempted => self.counters.missed_preempted += n,
        }
    }
}

/// Applies the table above to a tick that began late because of `late_because`.
fn judge(times: &TickTimes, late_because: MissCause) -> Outcome {
    let slack = times.deadline.since(times.due);
    if times.finished <= times.deadline {
        Outcome::Met
    } else if slack < times.own_work() {
        Outcome::Missed(MissCause::OwnWork)
    } else if times.stolen() <= times.lateness() {
        Outcome::Missed(late_because)
    } else {
        Outcome::Missed(MissCause::Preempted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLACK: u64 = 10;

    fn tick(due: u64, late: u64, work: u64, stolen: u64) -> TickTimes {
        TickTimes {
            due: Nanos::new(due),
            deadline: Nanos::new(due + SLACK),
            woken: Nanos::new(due + late),
            finished: Nanos::new(due + late + work + stolen),
            work: Nanos::new(work),
            simulated: Nanos::ZERO,
        }
    }

    #[test]
    fn what_simulated_keys_take_is_no_work_of_the_host_s() {
        let long = tick(100, 0, 15, 0);
        let simulated = |time| TickTimes { simulated: Nanos::new(time), ..long };
        let cause = |times| Ledger::default().enter(&times, 0);
        assert_eq!(cause(long), Outcome::Missed(MissCause::OwnWork));
        assert_eq!(cause(simulated(4)), Outcome::Missed(MissCause::OwnWork));
        assert_eq!(cause(simulated(5)), Outcome::Missed(MissCause::Preempted));
        assert!(
            simulated(5).is_late_by_simulated_keys() && !simulated(4).is_late_by_simulated_keys()
        );
        assert!(!tick(100, 0, 8, 5).is_late_by_simulated_keys());
    }

    #[test]
    fn every_split_of_the_time_has_the_cause_that_would_have_saved_it() {
        for (late, work, stolen) in all_splits(2 * SLACK) {
            let outcome = Ledger::default().enter(&tick(100, late, work, stolen), 0);
            let missed_by = (late + work + stolen).saturating_sub(SLACK);
            match outcome {
                Outcome::Met => assert_eq!(missed_by, 0),
                Outcome::Missed(MissCause::OwnWork) => assert!(SLACK < work),
                Outcome::Missed(MissCause::WokenLate) => {
                    assert!(0 < missed_by && stolen <= late && missed_by <= late + stolen);
                }
                Outcome::Missed(MissCause::Preempted) => {
                    assert!(0 < missed_by && late < stolen && missed_by <= late + stolen);
                }
            }
        }
    }

    fn all_splits(n: u64) -> impl Iterator<Item = (u64, u64, u64)> {
        (0..n * n * n).map(move |i| (i % n, i / n % n, i / n / n))
    }

    #[test]
    fn a_tick_that_waited_for_an_overrun_inherits_its_cause() {
        let mut ledger = Ledger::default();
        assert_eq!(ledger.enter(&tick(100, 0, 19, 0), 0), Outcome::Missed(MissCause::OwnWork));
        assert_eq!(ledger.enter(&tick(110, 9, 2, 0), 0), Outcome::Missed(MissCause::OwnWork));
        assert_eq!(ledger.enter(&tick(120, 1, 2, 0), 0), Outcome::Met);
        assert_eq!(ledger.enter(&tick(130, 9, 2, 0), 0), Outcome::Missed(MissCause::WokenLate));
    }

    #[test]
    fn skipped_ticks_are_charged_to_the_overrun_that_ate_them() {
        let mut ledger = Ledger::default();
        assert_eq!(ledger.enter(&tick(100, 0, 35, 0), 0), Outcome::Missed(MissCause::OwnWork));
        assert_eq!(ledger.enter(&tick(130, 5, 1, 0), 2), Outcome::Met);
        assert_eq!(ledger.enter(&tick(190, 1, 1, 0), 5), Outcome::Met);
        let expected = Counters {
            ticks: 3,
            missed: 8,
            missed_own_work: 3,
            missed_woken_late: 5,
            skipped: 7,
            ..Counters::default()
        };
        assert_eq!(ledger.counters(), expected);
    }

    #[test]
    fn misses_are_counted_by_cause() {
        let mut ledger = Ledger::default();
        for (i, (late, work, stolen)) in
            [(0, 11, 0), (11, 0, 0), (0, 1, 11), (0, 1, 0)].iter().enumerate()
        {
            let _outcome = ledger.enter(&tick(100 * (i as u64 + 1), *late, *work, *stolen), 0);
        }
        let counters = ledger.counters();
        assert_eq!(
            (
                counters.missed,
                counters.missed_own_work,
                counters.missed_woken_late,
                counters.missed_preempted
            ),
            (3, 1, 1, 1),
        );
    }
}
