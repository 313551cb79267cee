use std::sync::atomic::{AtomicBool, Ordering};
use std::{io, sync::Arc, thread, time::Duration};

/// A thread that polls repeatedly until it is dropped.
#[derive(Debug)]
pub struct RepeatedLook {
    stop: Arc<AtomicBool>,
}

impl RepeatedLook {
    /// Calls `look` on a thread called `name`, with a `pause` before each call.
    pub(super) fn start(
        name: &str,
        pause: Duration,
        mut look: impl FnMut() + Send + 'static,
    ) -> io::Result<Self> {
        let stop = Arc::new(AtomicBool::new(false));
        let its_stop = Arc::clone(&stop);
        thread::Builder::new().name(name.into()).spawn(move || {
            while !its_stop.load(Ordering::Acquire) {
                thread::sleep(pause);
                look();
            }
        })?;
        Ok(Self { stop })
    }
}

impl Drop for RepeatedLook {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Release);
    }
}
