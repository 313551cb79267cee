//! Locked memory: no page is fetched while forces are on.

use rustix::mm::{MlockAllFlags, mlockall};
use rustix::process::{Resource, getrlimit};
use rustix::thread::{CapabilitySet, capabilities};

/// Stack that a tick may use, touched once so that it never faults.
const STACK_BYTES: usize = 256 * 1024;

/// Memory locks granted by the system.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Locked {
    /// `true` if pages present now stay in memory.
    pub current: bool,
    /// `true` if pages mapped from now on stay in memory.
    pub future: bool,
    /// Remedy if not everything is locked.
    pub note: Option<String>,
}

/// Locks all memory of the process and touches the calling thread's stack. Future memory is locked
/// only where no limit applies: with one, a later allocation of any thread would fail.
pub fn lock() -> Locked {
    let locked = if may_lock_without_limit() { lock_everything() } else { lock_current() };
    prefault_stack();
    locked
}

fn lock_everything() -> Locked {
    match mlockall(MlockAllFlags::CURRENT | MlockAllFlags::FUTURE) {
        Ok(()) => Locked { current: true, future: true, note: None },
        Err(error) => Locked { current: false, future: false, note: Some(refused(error)) },
    }
}

fn lock_current() -> Locked {
    match mlockall(MlockAllFlags::CURRENT) {
        Ok(()) => Locked {
            current: true,
            future: false,
            note: Some(advice("Memory is locked, but not what is allocated from now on")),
        },
        Err(error) => Locked { current: false, future: false, note: Some(refused(error)) },
    }
}

fn refused(error: rustix::io::Errno) -> String {
    advice(&format!("Memory could not be locked ({error})"))
}

fn advice(what: &str) -> String {
    format!(
        "{what}, so a page fault may delay a tick; raise the limit \
         (`@realtime - memlock unlimited` in /etc/security/limits.d, then log in again; \
         `ulimit -l` shows it), or give the program the capability: \
         `sudo setcap cap_sys_nice,cap_ipc_lock+ep <letoff>`."
    )
}

fn may_lock_without_limit() -> bool {
    let unlimited = getrlimit(Resource::Memlock).current.is_none();
    let capable =
        capabilities(None).is_ok_and(|sets| sets.effective.contains(CapabilitySet::IPC_LOCK));
    unlimited || capable
}

/// Touches 256 KiB of stack below the caller, once in each thread that ticks: locked pages stay.
#[inline(never)]
#[expect(
    clippy::large_stack_frames,
    clippy::large_stack_arrays,
    reason = "the large frame is the purpose"
)]
pub fn prefault_stack() {
    let mut stack = [0_u8; STACK_BYTES];
    // The optimiser would otherwise remove the array, which is not read.
    std::hint::black_box(&mut stack);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_granted_comes_with_advice() {
        let locked = lock();
        assert_eq!(locked.note.is_none(), locked.current && locked.future);
        let now = lock_current();
        let note = now.note.unwrap_or_default();
        assert_eq!(note.starts_with("Memory is locked, but"), now.current, "{note}");
        // Other tests of this process must not run with locked memory.
        rustix::mm::munlockall().unwrap();
    }
}
