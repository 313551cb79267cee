//! A real-time priority for the calling thread, and whether the system granted it.

use thread_priority::{
    RealtimeThreadSchedulePolicy, ThreadPriority, ThreadPriorityValue, ThreadSchedulePolicy,
    set_thread_priority_and_policy, thread_native_id, thread_schedule_policy_param,
};

/// Priority of the tick when a scene does not say: above the sound server, below the kernel's
/// own threads that must run for us (`ksoftirqd`, timers).
pub const DEFAULT_PRIORITY: u8 = 80;

/// How the system schedules a thread.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SchedulingPolicy {
    /// Policy and priority, as `SCHED_FIFO 80` or `SCHED_OTHER`.
    pub policy: String,
    /// What to do if this is not what was asked for.
    pub note: Option<String>,
}

/// Asks for `SCHED_FIFO` at `priority`, in `1 ..= 99`, for the calling thread.
///
/// `None` asks for nothing. Either way the answer is what the system says afterwards, not
/// what was asked for.
pub fn ask_for_fifo(priority: Option<u8>) -> SchedulingPolicy {
    let note = priority.and_then(|priority| try_fifo(priority).err());
    SchedulingPolicy { policy: current_policy(), note }
}

fn try_fifo(priority: u8) -> Result<(), String> {
    let value = ThreadPriorityValue::try_from(priority)
        .map_err(|range| format!("Real-time priority {priority} was refused: {range}."))?;
    let fifo = ThreadSchedulePolicy::Realtime(RealtimeThreadSchedulePolicy::Fifo);
    set_thread_priority_and_policy(thread_native_id(), ThreadPriority::Crossplatform(value), fifo)
        .map_err(|error| advice(priority, &error))
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
    use RealtimeThreadSchedulePolicy::{Fifo, RoundRobin};
    match thread_schedule_policy_param(thread_native_id()) {
        Ok((ThreadSchedulePolicy::Realtime(Fifo), params)) => {
            format!("SCHED_FIFO {}", params.sched_priority)
        }
        Ok((ThreadSchedulePolicy::Realtime(RoundRobin), params)) => {
            format!("SCHED_RR {}", params.sched_priority)
        }
        Ok((ThreadSchedulePolicy::Realtime(other), _)) => format!("{other:?}"),
        Ok((ThreadSchedulePolicy::Normal(_), _)) => "SCHED_OTHER".to_owned(),
        Err(error) => format!("unknown ({error})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_asks_for_nothing_gets_no_advice() {
        assert_eq!(ask_for_fifo(None).note, None);
    }

    #[test]
    fn the_answer_is_either_what_was_asked_for_or_says_what_to_do() {
        // On a thread of its own: it may really become a real-time thread.
        let standing = std::thread::spawn(|| ask_for_fifo(Some(7))).join().unwrap();
        match standing.note {
            None => assert_eq!(standing.policy, "SCHED_FIFO 7"),
            Some(note) => assert!(note.contains("ulimit -r") && note.contains("setcap"), "{note}"),
        }
    }

    #[test]
    fn a_priority_that_does_not_exist_is_refused() {
        for priority in [0, 100] {
            let standing = std::thread::spawn(move || ask_for_fifo(Some(priority))).join().unwrap();
            assert!(standing.note.is_some() && !standing.policy.starts_with("SCHED_FIFO"));
        }
    }
}
