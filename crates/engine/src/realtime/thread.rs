//! Scheduling policy and processor of the calling thread, and the system's answer.

use std::num::NonZeroU64;
use std::time::Duration;

use rustix::thread::set_current_timer_slack;
use scheduler::time::Nanos;
use thread_priority::{
    DeadlineFlags, RealtimeThreadSchedulePolicy, ThreadPriority, ThreadPriorityValue,
    ThreadSchedulePolicy, set_thread_priority_and_policy, thread_native_id,
    thread_schedule_policy_param,
};

use super::affinity;

/// Default priority of the tick: above the sound server, below `ksoftirqd` and kernel timers.
pub const DEFAULT_PRIORITY: u8 = 80;

/// Shortest timer slack (ns). The usual one delays threads without real-time rights by up to 50 us.
const SLACK: NonZeroU64 = NonZeroU64::MIN;

/// Request to the system for threads with a deadline.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ThreadPlan {
    pub policy: WantedPolicy,
    /// Processors by number: lane n runs on the n-th in turn; empty for any.
    pub cpus: Vec<usize>,
}

/// Scheduling policy to request for a thread.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum WantedPolicy {
    /// No request: the thread keeps its policy.
    #[default]
    Ordinary,
    /// `SCHED_FIFO` at this priority, in `1 ..= 99`.
    Fifo(u8),
    /// `SCHED_DEADLINE`, else `SCHED_FIFO`: `runtime` of every `period`, without child threads.
    Deadline { runtime: Nanos, period: Nanos },
}

impl WantedPolicy {
    pub const FIFO: Self = Self::Fifo(DEFAULT_PRIORITY);

    /// Returns `SCHED_DEADLINE` with three quarters of `period`; the rest is left to others.
    pub const fn deadline(period: Nanos) -> Self {
        Self::Deadline { runtime: Nanos::new(period.as_u64() / 4 * 3), period }
    }
}

/// Scheduling of a thread as granted by the system.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SchedulingPolicy {
    /// Policy and priority, as `SCHED_FIFO 80` or `SCHED_OTHER`.
    pub policy: String,
    /// Remedies where the policy is not the requested one, a sentence each.
    pub advice: Vec<String>,
}

impl ThreadPlan {
    /// Requests the plan of `lane` (0 is the tick's own); returns the policy reported afterwards.
    pub fn ask(&self, lane: usize) -> SchedulingPolicy {
        let _set = set_current_timer_slack(Some(SLACK));
        let mut advice = Vec::new();
        if !self.cpus.is_empty() {
            advice.extend(affinity::keep_to(self.cpus[lane % self.cpus.len()]).err());
        }
        match self.policy {
            WantedPolicy::Ordinary => {}
            WantedPolicy::Fifo(priority) => advice.extend(try_fifo(priority).err()),
            WantedPolicy::Deadline { runtime, period } => {
                if let Err(refused) = try_deadline(runtime, period) {
                    advice.push(refused);
                    advice.extend(try_fifo(DEFAULT_PRIORITY).err());
                }
            }
        }
        SchedulingPolicy { policy: current_policy(), advice }
    }

    /// Returns the plan of a timer thread, which does next to nothing beside the tick.
    #[must_use]
    pub fn for_timer(&self) -> Self {
        let policy = match self.policy {
            WantedPolicy::Deadline { runtime, period } => {
                WantedPolicy::Deadline { runtime: Nanos::new(runtime.as_u64() / 8), period }
            }
            WantedPolicy::Ordinary | WantedPolicy::Fifo(_) => self.policy,
        };
        Self { policy, cpus: self.cpus.clone() }
    }

    /// Returns the plan of a thread that must not delay the tick: FIFO `priority`, any processor.
    #[must_use]
    pub const fn below(&self, priority: u8) -> Self {
        let policy = match self.policy {
            WantedPolicy::Ordinary => WantedPolicy::Ordinary,
            WantedPolicy::Fifo(_) | WantedPolicy::Deadline { .. } => WantedPolicy::Fifo(priority),
        };
        Self { policy, cpus: Vec::new() }
    }
}

fn try_fifo(priority: u8) -> Result<(), String> {
    let value = ThreadPriorityValue::try_from(priority)
        .map_err(|range| format!("Real-time priority {priority} was refused: {range}."))?;
    let fifo = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Crossplatform(value), fifo)
        .map_err(|error| advice(priority, &error))
}

fn try_deadline(runtime: Nanos, period: Nanos) -> Result<(), String> {
    let whole = Duration::from_nanos(period.as_u64());
    let wanted = ThreadPriority::Deadline {
        runtime: Duration::from_nanos(runtime.as_u64()),
        deadline: whole,
        period: whole,
        flags: DeadlineFlags::empty(),
    };
    let deadline = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Deadline);
    // The kernel takes 0 for the calling thread; the library's own number is one of the C library.
    set_thread_priority_and_policy(0, wanted, deadline).map_err(|_minus_one| {
        "SCHED_DEADLINE was refused, so SCHED_FIFO is asked for; no limit of a user allows it, so \
         give the program the capability (`sudo setcap cap_sys_nice,cap_ipc_lock+ep <letoff>`), \
         let it run on all processors (`taskset -p <pid>` shows which), and leave room for it \
         (`sysctl kernel.sched_rt_runtime_us` shows how much there is)."
            .to_owned()
    })
}

fn advice(priority: u8, error: &thread_priority::Error) -> String {
    format!(
        "Real-time priority {priority} was refused ({error}), so other programs may delay ticks; \
         put the user into a group whose limits allow it (`@realtime - rtprio 95` in \
         /etc/security/limits.d, then log in again; `ulimit -r` shows the limit), or give the \
         program the capability: `sudo setcap cap_sys_nice,cap_ipc_lock+ep <letoff>`."
    )
}

fn current_policy() -> String {
    use RealtimeThreadSchedulePolicy::{Deadline, Fifo, RoundRobin};
    match thread_schedule_policy_param(thread_native_id()) {
        Ok((ThreadSchedulePolicy::Realtime(Fifo), params)) => {
            format!("SCHED_FIFO {}", params.sched_priority)
        }
        Ok((ThreadSchedulePolicy::Realtime(RoundRobin), params)) => {
            format!("SCHED_RR {}", params.sched_priority)
        }
        Ok((ThreadSchedulePolicy::Realtime(Deadline), _)) => "SCHED_DEADLINE".to_owned(),
        Ok((ThreadSchedulePolicy::Normal(_), _)) => "SCHED_OTHER".to_owned(),
        Err(error) => format!("unknown ({error})"),
    }
}

#[cfg(test)]
mod tests {
    use rustix::thread::{CapabilitySet, capabilities, current_timer_slack};

    use super::*;

    fn granted(policy: WantedPolicy, cpus: &[usize], lane: usize) -> SchedulingPolicy {
        let plan = ThreadPlan { policy, cpus: cpus.to_vec() };
        std::thread::spawn(move || plan.ask(lane)).join().unwrap()
    }

    #[test]
    fn the_answer_is_either_what_was_asked_for_or_says_what_to_do() {
        let standing = granted(WantedPolicy::Fifo(7), &[], 0);
        if standing.advice.is_empty() {
            assert_eq!(standing.policy, "SCHED_FIFO 7");
        } else {
            let advice = &standing.advice[0];
            assert!(advice.contains("ulimit -r") && advice.contains("setcap"), "{advice}");
        }
    }

    #[test]
    fn a_deadline_that_is_refused_falls_back_on_fifo_and_says_what_to_do() {
        let standing = granted(WantedPolicy::deadline(Nanos::from_millis(10)), &[], 0);
        let may = capabilities(None).unwrap().effective.contains(CapabilitySet::SYS_NICE);
        if standing.policy == "SCHED_DEADLINE" {
            assert_eq!(standing.advice, [""; 0]);
        } else {
            assert!(!may || affinity::allowed() != affinity::online(), "{standing:?}");
            assert!(standing.advice[0].contains("setcap"), "{standing:?}");
            assert!(standing.policy == "SCHED_FIFO 80" || standing.advice.len() == 2);
        }
        // More than one processor has, so any system refuses it.
        let (runtime, period) = (Nanos::from_millis(20), Nanos::from_millis(10));
        let refused = granted(WantedPolicy::Deadline { runtime, period }, &[], 0);
        assert!(refused.policy != "SCHED_DEADLINE", "{refused:?}");
        assert!(refused.advice[0].starts_with("SCHED_DEADLINE was refused"), "{refused:?}");
    }

    #[test]
    fn a_priority_that_does_not_exist_is_refused() {
        for priority in [0, 100] {
            let standing = granted(WantedPolicy::Fifo(priority), &[], 0);
            assert!(!standing.advice.is_empty() && !standing.policy.starts_with("SCHED_FIFO"));
        }
    }

    #[test]
    fn lanes_run_on_their_processors_in_turn_and_say_which_cannot_be_had() {
        let cpus = affinity::allowed();
        let (first, last) = (cpus[0], cpus[cpus.len() - 1]);
        for (lane, expected) in [(0, first), (1, last), (2, first)] {
            let plan = ThreadPlan { cpus: vec![first, last], ..ThreadPlan::default() };
            let ask = move || (plan.ask(lane).advice, affinity::allowed());
            let (advice, is_on) = std::thread::spawn(ask).join().unwrap();
            assert_eq!((advice, is_on), (Vec::new(), vec![expected]), "lane {lane}");
        }
        let standing = granted(WantedPolicy::Ordinary, &[1023], 0);
        assert!(standing.advice[0].contains("processor 1023"), "{standing:?}");
    }

    #[test]
    fn sleeps_end_as_exactly_as_they_can() {
        let slack = || {
            let _standing = ThreadPlan::default().ask(0);
            current_timer_slack().unwrap()
        };
        // 1 ns, or none for a thread that is scheduled in real time already.
        assert!(std::thread::spawn(slack).join().unwrap() <= 1);
    }
}
