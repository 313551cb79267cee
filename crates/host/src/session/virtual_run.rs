//! A run in virtual time: the same ticks, as fast as they go, the same bits every time.
//!
//! Boards take part behind programs in lockstep, which live by the host's virtual clock.

use std::sync::atomic::AtomicBool;

use super::key_source::KeySource;
use super::measured::MeasuredRun;
use super::observed::ObservedOutputs;
use super::{LEAD, PreparedRun, SessionError, no_clock};
use crate::midi_thread::{MidiDispatcher, NoteEnding};
use crate::report::RunReport;
use engine::realtime::run::{Assembly, Until};
use engine::realtime::virtual_time;

const TICKS_PER_LOOK: u64 = 16;

/// Runs all ticks; MIDI follows after each tick, on this thread.
pub(super) fn run(
    mut prepared: Box<PreparedRun>,
    keys: KeySource,
    mut dispatcher: Box<MidiDispatcher>,
    observed: ObservedOutputs,
    stop: &AtomicBool,
) -> Result<RunReport, SessionError> {
    let (mut lanes, swaps) = prepared.start_lanes()?;
    prepared.handle.open(swaps);
    let mut scheduler = prepared.scheduler()?;
    let until = Until { stop, ticks: prepared.plan.ticks };
    let (mut ticks, mut skipped) = (0, 0);
    let (mut bus, _start) = keys.arm(&prepared, LEAD)?;
    bus.attend_until_start();
    // No clock decides: time begins at 0.
    let (_no_clock, mut telemetry) = observed.begin(0);
    let mut assembly = Assembly {
        scheduler: &mut scheduler,
        bus: &mut bus,
        lanes: &mut lanes,
        observer: &mut prepared.watchers,
    };
    virtual_time::run(&mut assembly, until, |report| {
        dispatcher.drain();
        ticks += 1;
        skipped += report.skipped;
        if ticks % TICKS_PER_LOOK == 0 {
            telemetry.pump();
        }
    });
    if assembly.bus.outlives_the_run() {
        virtual_time::ramp_down(&mut assembly);
    }
    prepared.handle.close();
    bus.disarm();
    drop(lanes);
    let (realtime, deadline) = no_clock();
    let played = dispatcher.close(NoteEnding::Regular, None);
    telemetry.pump();
    drop(telemetry);
    Ok(prepared.report(
        ticks,
        played,
        MeasuredRun { realtime, deadline, skipped, pauses: Vec::new() },
        &bus,
    ))
}
