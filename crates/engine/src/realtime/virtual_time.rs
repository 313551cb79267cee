//! The same ticks as fast as they will go: time is whatever the next tick is due at.
//!
//! Lanes are waited for without limit, so the outcome depends on no clock, and is the same
//! to the last bit with any number of lanes.

use scheduler::port::{KeyBus, TickObserver};
use scheduler::safety::FADE;
use scheduler::tick::TickReport;

use super::pool::WaitLimit;
use super::run::{Assembly, Until};

/// Runs ticks, each exactly when it is due, and hands each report to `watch`.
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

/// Disarms all keys and runs ticks on until they feel the safe force.
pub fn ramp_down<B: KeyBus, O: TickObserver>(assembly: &mut Assembly<'_, B, O>) {
    assembly.scheduler.disarm();
    let fade_ticks = assembly.scheduler.timetable().period().ticks_in(FADE);
    // One more than the fade: its first tick holds.
    for _ in 0..=fade_ticks {
        let _report = tick(assembly);
    }
}

/// Runs the next tick when it is due.
fn tick<B: KeyBus, O: TickObserver>(assembly: &mut Assembly<'_, B, O>) -> Option<TickReport> {
    let Assembly { scheduler, bus, lanes, observer } = assembly;
    let due = scheduler.next_due();
    scheduler.poll(due, *bus, *lanes, *observer)
}
