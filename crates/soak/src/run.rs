//! Plays a plan, and the same music without faults.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use host::control::{Folders, RequestHandler, RunHandle};
use host::report::RunReport;
use host::session::{FoundKeys, RunOptions, RunSession, SessionError};
use midi::{ReconnectingPort, Unavailable};
use telemetry::recording::RecordingLimits;

use crate::actions::{Actor, RecordingPaths};
use crate::host_files::HostFiles;
use crate::judge::judge;
use crate::killed::{KilledFindings, kill_at_random};
use crate::plan::SoakPlan;
use crate::recordings;
use crate::report::SoakReport;
use crate::strangers::Strangers;
use crate::synthesizer::Synthesizer;
use crate::telling::Telling;
use crate::trial::{PlayedTrial, SoakChoice, SoakTime};
use crate::watch::KeyWatch;

/// Why a trial could not be made.
#[derive(Debug, thiserror::Error)]
pub enum SoakError {
    #[error(transparent)]
    Session(#[from] SessionError),
    #[error("the synthesizer cannot be connected: {0}")]
    Synthesizer(#[from] Unavailable),
    #[error("the system refused a thread or a port: {0}")]
    System(#[from] std::io::Error),
    /// The run was stopped before its end.
    #[error("the trial was stopped: nothing is said of it")]
    Stopped,
}

/// Tries the host, until the end or `stop`.
///
/// # Errors
/// If it could not be tried; what broke is in the report.
#[expect(clippy::large_stack_frames, reason = "once, at set-up")]
pub fn soak(choice: &SoakChoice, stop: &AtomicBool) -> Result<SoakReport, SoakError> {
    let plan = SoakPlan::new(choice.seed, choice.seconds, choice.scene.tick_hz);
    let paths = RecordingPaths::in_folder(&choice.folder);
    let undisturbed = match choice.time {
        SoakTime::Virtual => Some(play(choice, &plan.undisturbed(), None, stop)?),
        SoakTime::Real => None,
    };
    let played = play(choice, &plan, Some(&paths), stop)?;
    Ok(SoakReport::new(choice, &plan, &played, judge(choice, &plan, &played, undisturbed.as_ref())))
}

#[expect(clippy::large_stack_frames, reason = "once, at set-up")]
fn play(
    choice: &SoakChoice,
    plan: &SoakPlan,
    recordings: Option<&RecordingPaths>,
    stop: &AtomicBool,
) -> Result<PlayedTrial, SoakError> {
    let plan = Arc::new(plan.clone());
    let handle = Arc::new(RunHandle::default());
    let limits = RecordingLimits { lowest_free: 0, ..RecordingLimits::default() };
    let folders = Folders { limits, ..Folders::default() };
    let requests = RequestHandler::new(choice.scene.clone(), Arc::clone(&handle), folders);
    let requests = Arc::new(requests);
    let virtual_time = choice.time == SoakTime::Virtual;
    let options = RunOptions { duration: Some(choice.seconds), virtual_time };
    let its_handle = Arc::clone(&handle);
    let found = FoundKeys::find(&choice.scene, options)?;
    let mut session = RunSession::prepare_behind(its_handle, found, options, &|_progress| {})?;
    let (now, synthesizer) = (Arc::new(AtomicU64::new(0)), Synthesizer::new());
    let port = synthesizer.port(plan.away.clone(), Arc::clone(&now));
    session.send_midi_to(Box::new(ReconnectingPort::connect(port, "synthesizer".to_owned())?));
    let telling = Telling::default();
    session.observe(telling.counter());
    session.observe(telling.log());
    let its_requests = Arc::clone(&requests);
    let (actor, acted) = Actor::new((&choice.scene, &plan), handle, its_requests, recordings);
    let failing = actor.failing();
    let (inside, beside) = if virtual_time { (Some(actor), None) } else { (None, Some(actor)) };
    let limit = (choice.scene.render.force_limit, choice.scene.tick_hz);
    let (watch, seen) = KeyWatch::new(&plan, (inside, failing), &now, limit);
    session.try_keys(
        |keybed| {
            plan.music.iter().for_each(|(key, strokes)| keybed.play(*key, strokes.clone()));
            plan.wires.iter().for_each(|(board, wire)| keybed.disturb(*board, wire.clone()));
        },
        Box::new(watch),
    );
    let strangers = beside.is_some().then(|| Strangers::start(&session, requests)).transpose()?;
    let (report, killed) = run_beside(session, beside, (choice, &now), stop)?;
    let strangers = strangers.map_or_else(Vec::new, Strangers::stop);
    let seen = seen.lock().map_or(None, |mut seen| seen.take()).ok_or(SoakError::Stopped)?;
    if seen.ticks + report.skipped < plan.ticks {
        return Err(SoakError::Stopped);
    }
    let recordings = recordings.map_or_else(Vec::new, recordings::look_at);
    let (sounds, told) = (synthesizer.sounds().clone(), telling.told().clone());
    let acted = acted.get().clone();
    Ok(PlayedTrial { report, seen, sounds, told, acted, strangers, killed, recordings })
}

/// Runs `session` to its end, with `actor` on a thread beside it, and in real time with the host that
/// is killed.
fn run_beside(
    session: RunSession,
    actor: Option<Actor>,
    (choice, now): (&SoakChoice, &AtomicU64),
    stop: &AtomicBool,
) -> Result<(RunReport, Option<KilledFindings>), SoakError> {
    let is_over = AtomicBool::new(false);
    let supervised = choice.supervised.as_ref().filter(|_| actor.is_some());
    let files = HostFiles::in_folder(&choice.folder);
    std::thread::scope(|scope| {
        if let Some(actor) = actor {
            scope.spawn(|| act_in_time(actor, now, &is_over));
        }
        let killing = supervised
            .map(|program| scope.spawn(|| kill_at_random(program, &files, choice.seed, &is_over)));
        let report = session.run(stop);
        is_over.store(true, Ordering::Release);
        let panicked = || std::io::Error::other("the thread that kills has panicked");
        let killed = killing.map(|thread| thread.join().unwrap_or_else(|_panic| Err(panicked())));
        Ok((report?, killed.transpose()?))
    })
}

/// Acts when the tick of each action has come, until the run is over.
fn act_in_time(mut actor: Actor, now: &AtomicU64, is_over: &AtomicBool) {
    while !is_over.load(Ordering::Acquire) && !actor.is_done() {
        actor.act_until(now.load(Ordering::Acquire));
        links::pause(Duration::from_millis(1));
    }
}
