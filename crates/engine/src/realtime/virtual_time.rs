//! Ticks without waiting: each runs at its due time in virtual time.
//!
//! Lanes are awaited without limit: the same bits whatever the clock and the number of lanes.

use scheduler::port::{KeyBus, TickObserver};
use scheduler::safety::FADE;
use scheduler::tick::TickReport;

use super::pool::WaitLimit;
use super::run::{Assembly, Until};

/// Runs ticks, each at its due time, and passes each report to `watch`.
pub fn run<B: KeyBus, O: TickObserver>(
    assembly: &mut Assembly<'_, B, O>,
    until: Until<'_>,
    mut watch: impl FnMut(&TickReport),
) {
    assembly.lanes.set_patience(WaitLimit::Endless);
    let mut ticks = 0;
    while !until.reached(ticks) {
        if let Some(report) = tick(assembly) {
            watch(&report);
        }
        ticks += 1;
    }
}

/// Disarms all keys and runs ticks until they feel the safe force.
pub fn ramp_down<B: KeyBus, O: TickObserver>(assembly: &mut Assembly<'_, B, O>) {
    assembly.scheduler.disarm();
    let fade_ticks = assembly.scheduler.timetable().period().ticks_in(FADE);
    // One more than the fade: its first tick holds.
    for _ in 0..=fade_ticks {
        let _report = tick(assembly);
    }
}

fn tick<B: KeyBus, O: TickObserver>(assembly: &mut Assembly<'_, B, O>) -> Option<TickReport> {
    let Assembly { scheduler, bus, lanes, observer } = assembly;
    let due = scheduler.next_due();
    scheduler.poll(due, *bus, *lanes, *observer)
}
