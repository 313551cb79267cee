//! A run in virtual time: the same ticks, as fast as they go, the same bits every time.

use std::sync::atomic::AtomicBool;

use super::bed::Bed;
use super::measured::Measured;
use super::{SessionError, Stage, no_clock};
use crate::desk::Desk;
use crate::realtime::run::{Assembly, Until, scheduler};
use crate::realtime::virtual_time;
use crate::report::Report;
use ::scheduler::time::Nanos;

/// Runs all ticks; the MIDI side follows after each tick, on this thread.
pub(super) fn run(
    mut stage: Stage,
    bed: Bed,
    mut desk: Desk,
    stop: &AtomicBool,
) -> Result<Report, SessionError> {
    let (mut lanes, _swaps) = stage.start_lanes()?;
    let mut scheduler = scheduler(stage.timetable()?);
    let until = Until { stop, ticks: stage.ticks };
    let (mut ticks, mut skipped) = (0, 0);
    let (mut bus, _start) = bed.arm(None, Nanos::ZERO)?;
    let mut assembly = Assembly {
        scheduler: &mut scheduler,
        bus: &mut bus,
        lanes: &mut lanes,
        observer: &mut stage.publisher,
    };
    virtual_time::run(&mut assembly, until, |report| {
        desk.drain();
        ticks += 1;
        skipped += report.skipped;
    });
    drop(lanes);
    let (realtime, deadline) = no_clock();
    let played = desk.close(None);
    Ok(stage.report(ticks, played, Measured { realtime, deadline, skipped }, &bus))
}
