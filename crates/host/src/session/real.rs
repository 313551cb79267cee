//! A run in real time: the tick, MIDI and a bare timer on their own threads.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::key_source::KeySource;
use super::key_transport::KeyTransport;
use super::measured::MeasuredRun;
use super::observed::{ObservedOutputs, RunningTelemetry};
use super::{LEAD, PreparedRun, SessionError};
use crate::adapters::observer::LiveCounters;
use crate::midi_thread::{MidiDispatcher, MidiThread, NoteEnding};
use crate::observe::Pulses;
use crate::report::RunReport;
use ::scheduler::time::Nanos;
use engine::realtime::baseline::Baseline;
use engine::realtime::run::{Assembly, TickTiming, Timings, Until, histogram, ramp_down};
use engine::realtime::thread::{SchedulingPolicy, WantedPolicy};
use engine::realtime::wake_latency::HeldLatency;
use engine::realtime::{memory, run as ticks};
use telemetry::HostState;

/// Runs until its end or `stop`, ramps all forces down, and reports.
pub(super) fn run(
    mut prepared: Box<PreparedRun>,
    keys: KeySource,
    dispatcher: Box<MidiDispatcher>,
    observed: ObservedOutputs,
    stop: &AtomicBool,
) -> Result<RunReport, SessionError> {
    let locked = memory::lock();
    let latency = match prepared.plan.threads.policy {
        WantedPolicy::Ordinary => HeldLatency::default(),
        WantedPolicy::Fifo(_) | WantedPolicy::Deadline { .. } => HeldLatency::hold(),
    };
    let handle = Arc::clone(&prepared.handle);
    let emergency = &handle.emergency;
    handle.status.enter(HostState::Starting);
    let (mut bus, start) = emergency.while_arming(|| keys.arm(&prepared, LEAD))?;
    if emergency.is_asked() {
        // No tick is run; boards that were just armed are stopped below.
        stop.store(true, Ordering::Release);
    }
    let handover = histogram().map_err(std::io::Error::other)?;
    let (pulses, thread) = observed.begin(since_1970(start));
    let telemetry = RunningTelemetry::start(thread)?;
    let midi = MidiThread::start(
        dispatcher,
        &prepared.plan.threads,
        Arc::clone(&prepared.wake),
        start,
        handover,
    )?;
    let timetable = prepared.timetable()?.moved(0, start);
    let baseline = Baseline::start(timetable, prepared.plan.threads.for_timer())?;
    // The scope joins the tick's thread in every case, so a panic there ends here.
    let ticked = std::thread::scope(|scope| {
        let named = std::thread::Builder::new().name("letoff-tick".into());
        let tick = named.spawn_scoped(scope, || tick(&mut prepared, &mut bus, pulses, start, stop));
        tick.map(std::thread::ScopedJoinHandle::join)
    });
    handle.status.enter(HostState::Ending);
    let baseline = baseline.stop();
    let ending = if emergency.is_asked() { NoteEnding::Emergency } else { NoteEnding::Regular };
    let played = midi.finish(ending).map_err(|_panic| SessionError::Panicked("MIDI"))?;
    // Also after a panic, and for an alarm after the last tick.
    if !emergency.is_asked() {
        bus.disarm();
    } else if emergency.answered().is_none() {
        emergency.answer(bus.stop());
    }
    telemetry.finish().map_err(|_panic| SessionError::Panicked("telemetry"))?;
    let (timings, standing) = ticked?.map_err(|_panic| SessionError::Panicked("tick"))??;
    let measured = MeasuredRun::new(&timings, standing, (locked, latency), baseline.as_ref());
    Ok(prepared.report(timings.counters().ticks, played, measured, &bus))
}

/// Runs the tick's thread, from setting its priority to the final ramp.
fn tick(
    prepared: &mut PreparedRun,
    bus: &mut KeyTransport,
    mut pulses: Pulses,
    start: Nanos,
    stop: &AtomicBool,
) -> Result<(Box<Timings>, SchedulingPolicy), SessionError> {
    let mut standing = prepared.plan.threads.ask(0);
    memory::prefault_stack();
    let (mut lanes, swaps) = prepared.start_lanes()?;
    standing.advice.extend(lanes.standings().flat_map(|it| it.advice.iter().cloned()));
    standing.advice.dedup();
    prepared.handle.open(swaps);
    let mut scheduler = prepared.scheduler()?;
    let mut timings = Box::new(Timings::new().map_err(std::io::Error::other)?);
    let until = Until { stop, ticks: prepared.plan.ticks };
    let counters = Arc::clone(&prepared.counters);
    bus.attend_until_start();
    let mut assembly = Assembly {
        scheduler: &mut scheduler,
        bus,
        lanes: &mut lanes,
        observer: &mut prepared.watchers,
    };
    let handle = Arc::clone(&prepared.handle);
    ticks::run(&mut assembly, start, until, &mut timings, |pulse| {
        count(&counters, pulse);
        pulses.take(pulse);
        if handle.emergency.is_asked() {
            stop.store(true, Ordering::Release);
        }
    });
    if handle.emergency.is_asked() {
        handle.emergency.answer(assembly.bus.stop());
    } else {
        ramp_down(&mut assembly);
    }
    prepared.handle.close();
    Ok((timings, standing))
}

/// Converts `start` to wall-clock time (ns since 1970).
fn since_1970(start: Nanos) -> u64 {
    let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
    let now = now.map_or(0, |it| u64::try_from(it.as_nanos()).unwrap_or(u64::MAX));
    now.saturating_add(start.since(engine::realtime::clock::monotonic()).as_u64())
}

/// Smooths the tick's work and counts misses, for the live line.
fn count(counters: &LiveCounters, pulse: &TickTiming) {
    let before = counters.work_ns.load(Ordering::Relaxed);
    let smoothed = (15 * before + pulse.times.work.as_u64()) / 16;
    counters.work_ns.store(smoothed, Ordering::Relaxed);
    let too_late = u64::from(pulse.outcome != ::scheduler::deadline::Outcome::Met);
    counters.missed.fetch_add(too_late + pulse.report.skipped, Ordering::Relaxed);
    counters.overload.starved.fetch_add(u64::from(pulse.is_starved), Ordering::Relaxed);
}
