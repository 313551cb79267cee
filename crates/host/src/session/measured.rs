use crate::report::{Deadline, Quantiles, Realtime};
use engine::realtime::baseline;
use engine::realtime::memory::Locked;
use engine::realtime::run::{Pause, Timings};
use engine::realtime::thread::SchedulingPolicy;
use engine::realtime::wake_latency::HeldLatency;

#[derive(Debug)]
pub(super) struct MeasuredRun {
    pub(super) realtime: Realtime,
    pub(super) deadline: Deadline,
    pub(super) skipped: u64,
    pub(super) pauses: Vec<Pause>,
}

impl MeasuredRun {
    pub(super) fn new(
        timings: &Timings,
        standing: SchedulingPolicy,
        (locked, latency): (Locked, HeldLatency),
        baseline: Option<&baseline::BaselineTiming>,
    ) -> Self {
        let counters = timings.counters();
        let advice = standing.advice.into_iter().chain(locked.note);
        let deadline = Deadline {
            missed: counters.missed,
            missed_own_work: counters.missed_own_work,
            own_work_unexplained: timings.unexplained(),
            by_simulated_keys: timings.by_simulated_keys,
            missed_woken_late: counters.missed_woken_late,
            missed_preempted: counters.missed_preempted,
            timer_stops: baseline.map(|it| it.stops(&timings.work)),
            stolen_s: baseline.and_then(|it| it.stolen),
            lateness_us: Quantiles::of(&timings.lateness),
            work_us: Quantiles::of(&timings.work),
            turnaround_us: Quantiles::of(&timings.turnaround),
            timer_baseline_us: baseline
                .map_or_else(Quantiles::default, |it| Quantiles::of(&it.lateness)),
        };
        let realtime = Realtime {
            policy: standing.policy,
            memory_locked: locked.current,
            latency_held: latency.is_held(),
            advice: advice.chain(latency.advice).collect(),
        };
        Self { realtime, deadline, skipped: counters.skipped, pauses: timings.pauses.clone() }
    }
}
