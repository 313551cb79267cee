//! The same ticks as fast as they will go: time is whatever the next tick is due at.
//!
//! Lanes are waited for without limit, so the outcome depends on no clock, and is the same
//! to the last bit with any number of lanes.

use scheduler::port::{KeyBus, TickObserver};
use scheduler::tick::TickReport;

use super::pool::WaitLimit;
use super::run::{Assembly, Until};

/// Runs ticks, each exactly when it is due, and hands each report to `watch`.
pub fn run<B: KeyBus, O: TickObserver>(
    assembly: &mut Assembly<'_, B, O>,
    until: Until<'_>,
    mut watch: impl FnMut(&TickReport),
) {
    let Assembly { scheduler, bus, lanes, observer } = assembly;
    lanes.set_patience(WaitLimit::Endless);
    let mut ticks = 0;
    while !until.reached(ticks) {
        let due = scheduler.next_due();
        if let Some(report) = scheduler.poll(due, *bus, *lanes, *observer) {
            watch(&report);
        }
        ticks += 1;
    }
}
