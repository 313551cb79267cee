//! An allocator that counts forbidden calls: the only unsafe code here.
#![expect(unsafe_code, reason = "a global allocator cannot be written without it")]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, MutexGuard, PoisonError};

struct Trap;

#[global_allocator]
static TRAP: Trap = Trap;

static ALLOCATED: AtomicU64 = AtomicU64::new(0);
static FREED: AtomicU64 = AtomicU64::new(0);

thread_local! {
    /// Without a destructor and constant, so that reading it never allocates.
    static IN_TICK: Cell<bool> = const { Cell::new(false) };
}

fn count(counter: &AtomicU64) {
    if IN_TICK.get() {
        counter.fetch_add(1, Relaxed);
    }
}

// SAFETY: every call passes its arguments to `System` and returns its result; counting touches no
// memory of the heap.
unsafe impl GlobalAlloc for Trap {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(&ALLOCATED);
        // SAFETY: the caller vouches for `layout` as `System` asks for it.
        unsafe { System.alloc(layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        count(&ALLOCATED);
        // SAFETY: as in `alloc`.
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(&ALLOCATED);
        count(&FREED);
        // SAFETY: `place` came from `System` through this allocator with `layout`.
        unsafe { System.realloc(place, layout, size) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        count(&FREED);
        // SAFETY: `place` came from `System` through this allocator with `layout`.
        unsafe { System.dealloc(place, layout) }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Zone {
    Tick,
    Elsewhere,
}

pub(crate) fn enter(zone: Zone) {
    IN_TICK.set(zone == Zone::Tick);
}

pub(crate) fn within<T>(work: impl FnOnce() -> T) -> T {
    /// Leaves the tick even if an assertion fails.
    struct Leave;
    impl Drop for Leave {
        fn drop(&mut self) {
            enter(Zone::Elsewhere);
        }
    }
    let _leave = Leave;
    enter(Zone::Tick);
    work()
}

/// The right to use the trap, which exists once: tests of this program run in turn.
#[derive(Debug)]
pub(crate) struct Watch {
    _turn: MutexGuard<'static, ()>,
    before: (u64, u64),
}

pub(crate) fn watch() -> Watch {
    static TURN: Mutex<()> = Mutex::new(());
    let turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    Watch { _turn: turn, before: counts() }
}

impl Watch {
    pub(crate) fn caught(&self) -> (u64, u64) {
        let (allocated, freed) = counts();
        (allocated - self.before.0, freed - self.before.1)
    }
}

fn counts() -> (u64, u64) {
    (ALLOCATED.load(Relaxed), FREED.load(Relaxed))
}

#[test]
fn the_trap_catches_an_allocation_a_free_and_a_growth() {
    let watch = watch();
    let kept = within(|| vec![1_u8]);
    assert_eq!(watch.caught(), (1, 0));
    within(|| drop(kept));
    assert_eq!(watch.caught(), (1, 1));
    let mut growing = Vec::with_capacity(1);
    growing.push(1_u8);
    within(|| growing.reserve_exact(100));
    assert_eq!(watch.caught(), (2, 2));
}

#[test]
fn what_is_not_marked_may_allocate() {
    let watch = watch();
    drop(vec![1_u8]);
    within(|| std::hint::black_box(1));
    drop(vec![1_u8]);
    assert_eq!(watch.caught(), (0, 0));
}
