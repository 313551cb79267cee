//! State of a run, for `letoff status`, metrics and service managers.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, SystemTime, UNIX_EPOCH};
use std::{collections::VecDeque, sync::atomic::Ordering::Relaxed, thread};

use telemetry::event::Kind;
use telemetry::{
    Board, BoardState, DeadlineStatus, Deadlines, Event, HostState, HostStatus, Links,
};
use telemetry::{RunProgress, Spread, Status, Topic, Update, key_name};

use super::BoardsTold;

use crate::adapters::observer::LiveCounters;
use crate::observe::{MessageSink, RecordingHandle};

/// State of a run, from its preparation to its end, off the tick.
#[derive(Debug, Default)]
pub struct RunStatus(Mutex<StatusParts>);

#[derive(Debug, Default)]
struct StatusParts {
    state: HostState,
    /// Begin of the state (s since 1970).
    since: u64,
    rehearsed: [u64; 2],
    scene: String,
    run: Option<RunDescription>,
    deadlines: Deadlines,
    links: Links,
    clients: u32,
    recording: Option<RecordingHandle>,
    /// Begin of the recording (s since 1970).
    recording_since: u64,
    report: String,
    stopped: Option<BoardsTold>,
    last_faults: VecDeque<String>,
}

/// Facts about a run once it is prepared.
#[derive(Clone, Debug)]
pub struct RunDescription {
    pub tick_hz: u32,
    /// Ticks of a pass, if the play list repeats.
    pub pass: Option<u64>,
    pub voices: u32,
    /// Name of the MIDI output, or the reason for its absence.
    pub midi: String,
    /// Keys of the scene that no board carries.
    pub absent: Vec<u32>,
    pub counters: Arc<LiveCounters>,
}

const KEPT: usize = 8;

/// Longest time without a tick before a host counts as hanging: ten ticks of the slowest rate.
const STALL: Duration = Duration::from_millis(250);

impl RunStatus {
    pub fn prepare(&self, scene: &str) {
        scene.clone_into(&mut self.lock().scene);
        self.enter(HostState::Preparing);
    }

    pub fn enter(&self, state: HostState) {
        let mut parts = self.lock();
        (parts.state, parts.since) = (state, seconds_now());
    }

    /// Sets the number of rehearsed strokes, `done` of `total`.
    pub fn rehearse(&self, done: usize, total: usize) {
        let mut parts = self.lock();
        if parts.state != HostState::Rehearsing {
            (parts.state, parts.since) = (HostState::Rehearsing, seconds_now());
        }
        parts.rehearsed = [done, total].map(|it| u64::try_from(it).unwrap_or(u64::MAX));
    }

    pub fn describe(&self, run: RunDescription) {
        self.lock().run = Some(run);
    }

    pub fn records(&self, recording: Option<RecordingHandle>) {
        let mut parts = self.lock();
        (parts.recording, parts.recording_since) = (recording, seconds_now());
    }

    pub fn finish(&self, report: String) {
        self.lock().report = report;
        self.enter(HostState::Over);
    }

    /// Notes that a stop removed all forces.
    pub fn stop(&self, told: BoardsTold) {
        self.lock().stopped = Some(told);
        self.enter(HostState::Stopped);
    }

    pub fn client_came(&self) {
        self.lock().clients += 1;
    }

    pub fn client_left(&self) {
        let mut parts = self.lock();
        parts.clients = parts.clients.saturating_sub(1);
    }

    pub(super) fn counters(&self) -> Option<Arc<LiveCounters>> {
        self.lock().run.as_ref().map(|run| Arc::clone(&run.counters))
    }

    pub fn read(&self) -> HostStatus {
        self.lock().status()
    }

    /// Returns the message of the topic `/status`.
    pub fn message(&self) -> Status {
        let parts = self.lock();
        let Links { lines, boards } = &parts.links;
        // Counters would make each message another one.
        let board = |it: &Board| Board {
            line: it.line,
            id: it.id,
            first_key: it.first_key,
            keys: it.keys,
            state: it.state.clone(),
            muted: it.muted.clone(),
            ..Board::default()
        };
        let names = lines.iter().map(|line| line.name.clone()).collect();
        parts.status().message(boards.iter().map(board).collect(), names)
    }

    /// Like [`Self::read`], after checking for at most 0.25 s that ticks continue.
    pub fn examine(&self) -> HostStatus {
        const LOOKS: u32 = 50;
        let first = self.read();
        if first.state != HostState::Playing {
            return first;
        }
        for _ in 0..LOOKS {
            thread::sleep(STALL / LOOKS);
            let now = self.read();
            if now.run.deadlines.ticks != first.run.deadlines.ticks
                || now.state != HostState::Playing
            {
                return now;
            }
        }
        HostStatus { state: HostState::Stalled, ..first }
    }

    fn lock(&self) -> MutexGuard<'_, StatusParts> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl StatusParts {
    fn status(&self) -> HostStatus {
        let recording = self.recording.as_ref().map(RecordingHandle::report);
        let mut status = HostStatus {
            process: std::process::id(),
            scene: self.scene.clone(),
            state: self.state,
            since: self.since,
            rehearsed: self.rehearsed,
            run: RunProgress { deadlines: deadlines(&self.deadlines), ..RunProgress::default() },
            boards: boards(&self.links),
            clients: self.clients,
            recording: recording.filter(|it| it.trouble.is_none()).map(|it| it.file),
            recording_since: self.recording_since,
            report: self.report.clone(),
            stopped: self.stopped.map(BoardsTold::counts).unwrap_or_default(),
            last_faults: self.last_faults.iter().cloned().collect(),
            ..HostStatus::default()
        };
        let Some(run) = &self.run else { return status };
        let counters = &run.counters;
        status.midi.clone_from(&run.midi);
        status.absent.clone_from(&run.absent);
        let (ticks, overload) = (counters.ticks.load(Relaxed), &counters.overload);
        status.run = RunProgress {
            tick_hz: run.tick_hz,
            pass: run.pass.map(|length| passes(ticks, length)),
            voices: run.voices,
            asleep: run.voices.saturating_sub(counters.active.load(Relaxed)),
            deadlines: DeadlineStatus { ticks, ..status.run.deadlines },
            strikes: counters.strikes.load(Relaxed),
            faults: counters.faults.load(Relaxed),
            dropped: counters.dropped.load(Relaxed),
            muted: counters.muted.keys().map(|key| key_name(key.into())).collect(),
            muted_keys: counters.muted.keys().map(u32::from).collect(),
            left_out: overload.now().iter().map(|one| one.name().to_owned()).collect(),
            waited: overload.waited().0,
            starved: overload.starved.load(Relaxed),
        };
        if self.state == HostState::Starting && 0 < ticks {
            status.state = HostState::Playing;
        }
        status
    }
}

fn deadlines(it: &Deadlines) -> DeadlineStatus {
    let Deadlines { own_work, woken_late, preempted, skipped, .. } = *it;
    let quantiles = |spread: &Spread| [spread.p50, spread.p99, spread.p999, spread.max];
    let lateness_us = it.lateness.as_ref().map(quantiles);
    DeadlineStatus { own_work, woken_late, preempted, skipped, lateness_us, ticks: 0 }
}

fn boards(links: &Links) -> Vec<BoardState> {
    let board = |it: &Board| {
        let line = usize::try_from(it.line).ok().and_then(|line| links.lines.get(line));
        BoardState {
            link: line.map_or_else(String::new, |line| line.name.clone()),
            number: it.id,
            first_key: it.first_key,
            keys: it.keys,
            state: it.state.clone(),
            gaps: it.gaps,
            round_trip_us: Some(it.round_trip).filter(|it| it.is_finite()),
        }
    };
    links.boards.iter().map(board).collect()
}

/// A sink that updates a run's status.
#[derive(Debug)]
pub struct StatusSink(Arc<RunStatus>);

impl StatusSink {
    pub const fn new(status: Arc<RunStatus>) -> Self {
        Self(status)
    }

    fn event(&self, event: &Event) {
        let text = match event.kind() {
            Kind::Fault => format!("tick {}, {}: {}", event.tick, key_name(event.key), event.text),
            Kind::Board => format!("tick {}, {}", event.tick, event.text),
            Kind::Unknown
            | Kind::Switch
            | Kind::Strike
            | Kind::DamperLift
            | Kind::DamperFall
            | Kind::Recovery
            | Kind::Miss
            | Kind::Skip
            | Kind::Change
            | Kind::Disarm
            | Kind::Arm
            | Kind::Pedal
            | Kind::Pressure
            | Kind::Starved
            | Kind::Overload => return,
        };
        let mut parts = self.0.lock();
        if parts.last_faults.len() == KEPT {
            parts.last_faults.pop_front();
        }
        parts.last_faults.push_back(text);
    }
}

impl MessageSink for StatusSink {
    fn take(&mut self, _at: u64, update: &Update) {
        match update {
            Update::Event(event) => self.event(event),
            Update::Deadlines(deadlines) => self.0.lock().deadlines = deadlines.clone(),
            Update::Links(links) => self.0.lock().links = links.clone(),
            Update::Catalogue(_)
            | Update::Voice(_)
            | Update::Overview(_)
            | Update::Block(_)
            | Update::State(..)
            | Update::Ticks(_)
            | Update::Midi(_)
            | Update::Log(_)
            | Update::Status(_) => {}
        }
    }

    fn wants(&self, topic: Topic) -> bool {
        [Topic::Events, Topic::Deadlines, Topic::Links].contains(&topic)
    }

    fn followed_keys(&self) -> u128 {
        // Changes of mode are not kept.
        0
    }
}

/// Returns how many passes of `length` ticks have begun within `ticks`.
pub(crate) fn passes(ticks: u64, length: u64) -> u64 {
    1 + ticks.saturating_sub(1) / length
}

/// Returns the time (s since 1970).
fn seconds_now() -> u64 {
    nanos_now() / 1_000_000_000
}

pub(super) fn nanos_now() -> u64 {
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    now.map_or(0, |it| u64::try_from(it.as_nanos()).unwrap_or(u64::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn playing() -> (Arc<RunStatus>, Arc<LiveCounters>) {
        let (status, counters) = (Arc::<RunStatus>::default(), Arc::<LiveCounters>::default());
        status.prepare("default");
        let midi = "none".to_owned();
        let its_counters = Arc::clone(&counters);
        let (tick_hz, pass, voices) = (1000, Some(5), 88);
        let absent = Vec::new();
        let run = RunDescription { tick_hz, pass, voices, midi, absent, counters: its_counters };
        status.describe(run);
        status.enter(HostState::Starting);
        (status, counters)
    }

    #[test]
    fn a_host_plays_from_its_first_tick_on_and_hangs_where_ticks_do_not_go_on() {
        let (status, counters) = playing();
        assert_eq!(status.examine().state, HostState::Starting);
        counters.ticks.store(7, Relaxed);
        counters.active.store(3, Relaxed);
        let read = status.read();
        assert_eq!((read.state, read.run.voices, read.run.asleep), (HostState::Playing, 88, 85));
        assert_eq!(read.run.pass, Some(2), "seven ticks of passes of five");
        assert_eq!(status.examine().state, HostState::Stalled);
    }

    #[test]
    fn the_last_faults_are_kept_and_no_more() {
        let (status, _counters) = playing();
        let mut sink = StatusSink::new(Arc::clone(&status));
        for tick in 0..100 {
            let kind = Kind::Fault.into();
            let fault = Event { kind, tick, key: 39, text: "it failed".into(), ..Event::default() };
            sink.take(0, &Update::Event(fault));
        }
        let kept = status.read().last_faults;
        assert_eq!(kept.len(), KEPT);
        assert_eq!(kept.last().map(String::as_str), Some("tick 99, C4: it failed"));
    }
}
