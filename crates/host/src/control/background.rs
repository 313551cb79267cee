//! Long work off the tick, which ends early once no client waits for it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::FingerOwner;

/// Refusal of a load whose client has disconnected.
const CANCELLED: &str =
    "nothing was loaded: its client has disconnected, or the host stops; load it again";

/// Loads of descriptions, one at a time, and a run's rehearsal; each polls a flag to end early.
#[derive(Debug, Default)]
pub struct BackgroundWork {
    /// Held while a description is loaded; others wait.
    turn: Mutex<()>,
    /// Running and waiting loads, each with the connection that asked for it.
    loads: Mutex<Vec<(FingerOwner, Arc<AtomicBool>)>>,
    is_over: Arc<AtomicBool>,
}

impl BackgroundWork {
    pub fn is_over(&self) -> &Arc<AtomicBool> {
        &self.is_over
    }

    /// Loads a description for the client of connection `by`, after other loads; `load` ends early
    /// when its flag is set.
    ///
    /// # Errors
    /// If the client has disconnected, or the run ends; a sentence.
    pub fn load<T>(
        &self,
        by: FingerOwner,
        load: impl FnOnce(&Arc<AtomicBool>) -> T,
    ) -> Result<T, String> {
        let is_cancelled = Arc::new(AtomicBool::new(false));
        self.loads().push((by, Arc::clone(&is_cancelled)));
        let turn = self.turn.lock().unwrap_or_else(PoisonError::into_inner);
        let is_wanted = || {
            let flags = [&is_cancelled, &self.is_over];
            !flags.into_iter().any(|it| it.load(Ordering::Acquire))
        };
        let loaded = is_wanted().then(|| load(&is_cancelled));
        drop(turn);
        self.loads().retain(|(_, flag)| !Arc::ptr_eq(flag, &is_cancelled));
        loaded.filter(|_| is_wanted()).ok_or_else(|| CANCELLED.to_owned())
    }

    pub fn cancel(&self, connection: u64) {
        for (_, flag) in self.loads().iter().filter(|(by, _)| *by == Some(connection)) {
            flag.store(true, Ordering::Release);
        }
    }

    /// Cancels all loads, present and future, at the end of the run.
    pub fn cancel_all(&self) {
        self.is_over.store(true, Ordering::Release);
        for (_, flag) in self.loads().iter() {
            flag.store(true, Ordering::Release);
        }
    }

    fn loads(&self) -> MutexGuard<'_, Vec<(FingerOwner, Arc<AtomicBool>)>> {
        self.loads.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use super::*;

    fn wait_for(work: &BackgroundWork, n: usize) {
        while work.loads().len() < n {
            std::thread::yield_now();
        }
    }

    fn until_cancelled(flag: &Arc<AtomicBool>) {
        while !flag.load(Ordering::Acquire) {
            std::thread::yield_now();
        }
    }

    #[test]
    fn descriptions_are_loaded_one_after_the_other() {
        let work = BackgroundWork::default();
        let under_way = AtomicBool::new(false);
        let (release, released) = mpsc::channel::<()>();
        let flag = &under_way;
        let first = move |_flag: &Arc<AtomicBool>| {
            flag.store(true, Ordering::Release);
            released.recv().unwrap();
            flag.store(false, Ordering::Release);
        };
        std::thread::scope(|scope| {
            let (work, under_way) = (&work, &under_way);
            scope.spawn(move || work.load(Some(1), first));
            while !under_way.load(Ordering::Acquire) {
                std::thread::yield_now();
            }
            let next =
                scope.spawn(|| work.load(Some(2), |_flag| under_way.load(Ordering::Acquire)));
            wait_for(work, 2);
            release.send(()).unwrap();
            assert_eq!(next.join().unwrap(), Ok(false));
        });
    }

    #[test]
    fn nothing_is_loaded_for_a_client_that_has_disconnected() {
        let work = BackgroundWork::default();
        std::thread::scope(|scope| {
            let first = scope.spawn(|| work.load(Some(1), until_cancelled));
            wait_for(&work, 1);
            let second = scope.spawn(|| work.load(Some(2), |_| unreachable!("it was cancelled")));
            wait_for(&work, 2);
            work.cancel(2);
            work.cancel(1);
            assert_eq!(first.join().unwrap(), Err(CANCELLED.to_owned()));
            assert_eq!(second.join().unwrap(), Err(CANCELLED.to_owned()));
        });
        assert_eq!(work.load(Some(3), |_| 3), Ok(3));
    }

    #[test]
    fn a_run_that_ends_cancels_what_is_under_way_and_what_comes() {
        let work = BackgroundWork::default();
        std::thread::scope(|scope| {
            let first = scope.spawn(|| work.load(None, until_cancelled));
            wait_for(&work, 1);
            work.cancel_all();
            assert!(first.join().unwrap().is_err());
        });
        assert!(work.load(Some(1), |_| ()).is_err());
    }
}
