use std::num::NonZeroUsize;

use engine::realtime::affinity;
use engine::realtime::thread::{ThreadPlan, WantedPolicy};
use scene::{LaneCount, Scene, ThreadPolicy, ThreadRules};
use scheduler::time::Nanos;

use super::RunOptions;

const MOST_LANES: usize = 16;

const SECOND: u64 = 1_000_000_000;

/// Returns the thread plan of `scene`; empty in virtual time.
pub(super) fn plan(scene: &Scene, options: RunOptions) -> ThreadPlan {
    if options.virtual_time {
        return ThreadPlan::default();
    }
    let period = Nanos::new(SECOND / u64::from(scene.tick_hz.max(1)));
    let policy = match scene.realtime.policy {
        ThreadPolicy::Auto | ThreadPolicy::Fifo => WantedPolicy::FIFO,
        ThreadPolicy::Deadline => WantedPolicy::deadline(period),
        ThreadPolicy::Ordinary => WantedPolicy::Ordinary,
    };
    ThreadPlan { policy, cpus: cpus(&scene.realtime, affinity::isolated) }
}

/// Returns the processors of the lanes; empty for any.
fn cpus(rules: &ThreadRules, isolated: impl FnOnce() -> Vec<usize>) -> Vec<usize> {
    let is_free = rules.cpus.is_empty() && rules.policy == ThreadPolicy::Auto;
    if is_free { isolated() } else { rules.cpus.clone() }
}

pub(super) fn lanes(scene: &Scene) -> NonZeroUsize {
    // Respects the affinity of the process and the quota of its control group.
    let processors = || std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let count = count(scene, cpus(&scene.realtime, affinity::isolated).len(), processors);
    NonZeroUsize::new(count).unwrap_or(NonZeroUsize::MIN)
}

/// Like [`lanes`], with `n_cpus` reserved processors, if any, and `processors` otherwise.
fn count(scene: &Scene, n_cpus: usize, processors: impl FnOnce() -> usize) -> usize {
    match scene.realtime.lanes {
        LaneCount::Count(count) => count,
        // A thread with a deadline that yields to another lane is not run again in its period.
        LaneCount::Auto if scene.realtime.policy == ThreadPolicy::Deadline => 1,
        LaneCount::Auto if n_cpus != 0 => n_cpus.min(MOST_LANES),
        LaneCount::Auto => processors().min(MOST_LANES),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(overrides: &[(&str, &str)]) -> Scene {
        let all = overrides.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
        Scene::load(&scene::Library::default(), "springs", &all.collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn lanes_are_as_many_as_processors_that_they_may_use() {
        let count = |overrides: &[(&str, &str)], n_cpus| count(&scene(overrides), n_cpus, || 24);
        assert_eq!(count(&[], 0), 16);
        assert_eq!(count(&[], 3), 3);
        assert_eq!(count(&[("lanes", "5")], 3), 5);
        assert_eq!(count(&[("realtime.policy", "deadline")], 0), 1);
    }

    #[test]
    fn isolated_processors_are_taken_where_the_scene_leaves_it_to_us() {
        let cpus = |overrides: &[(&str, &str)]| cpus(&scene(overrides).realtime, || vec![2, 3]);
        assert_eq!(cpus(&[]), [2, 3]);
        assert_eq!(cpus(&[("realtime.cpus", "[1]")]), [1]);
        for policy in ["fifo", "deadline", "ordinary"] {
            assert_eq!(cpus(&[("realtime.policy", policy)]), [0; 0], "{policy}");
        }
    }

    #[test]
    fn a_deadline_is_the_ticks_period() {
        let overrides = [("realtime.policy", "deadline"), ("tick_hz", "4000")];
        let (runtime, period) = (Nanos::new(187_500), Nanos::new(250_000));
        let expected = WantedPolicy::Deadline { runtime, period };
        let policy = |virtual_time| {
            let options = RunOptions { virtual_time, ..RunOptions::default() };
            plan(&scene(&overrides), options).policy
        };
        assert_eq!([false, true].map(policy), [expected, WantedPolicy::Ordinary]);
    }
}
