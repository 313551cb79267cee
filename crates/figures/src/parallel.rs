use std::sync::atomic::{AtomicUsize, Ordering};
use std::{sync::Mutex, sync::PoisonError, thread};

/// Applies `work` to all jobs on all processors; returns the results in their order.
pub fn in_parallel<J: Sync, O: Send>(jobs: &[J], work: &(dyn Fn(&J) -> O + Sync)) -> Vec<O> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::new());
    let take = || {
        let place = next.fetch_add(1, Ordering::Relaxed);
        jobs.get(place).map(|job| (place, job))
    };
    let help = || {
        while let Some((place, job)) = take() {
            let outcome = work(job);
            done.lock().unwrap_or_else(PoisonError::into_inner).push((place, outcome));
        }
    };
    let processors = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| (0..processors).for_each(|_| drop(scope.spawn(help))));
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, done)| done).collect()
}
