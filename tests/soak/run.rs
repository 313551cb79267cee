//! Plays a plan, and the same music without faults.

use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use host::control::{Folders, RequestHandler, RunHandle};
use host::report::RunReport;
use host::session::{FoundKeys, RunOptions, RunSession, SessionError};
use midi::ReconnectingPort;
use telemetry::recording::RecordingLimits;

use crate::actions::{Actor, RecordingPaths};
use crate::judge::judge;
use crate::plan::SoakPlan;
use crate::recordings;
use crate::report::{self, PromiseVerdict};
use crate::strangers::Strangers;
use crate::synthesizer::Synthesizer;
use crate::telling::Telling;
use crate::trial::{PlayedTrial, SoakChoice, SoakTime};
use crate::watch::KeyWatch;

/// Tries the host until the end. Returns the trial in words, and the verdicts.
///
/// # Errors
/// If the host could not be tried; a broken promise is no error.
#[expect(clippy::large_stack_frames, reason = "once, at set-up")]
pub(crate) fn soak(choice: &SoakChoice) -> Result<(String, Vec<PromiseVerdict>), Box<dyn Error>> {
    let plan = SoakPlan::new(choice.seed, choice.seconds, choice.scene.tick_hz);
    let paths = RecordingPaths::in_folder(&choice.folder);
    let undisturbed = match choice.time {
        SoakTime::Virtual => Some(play(choice, &plan.undisturbed(), None)?),
        SoakTime::Real => None,
    };
    let played = play(choice, &plan, Some(&paths))?;
    let verdicts = judge(choice, &plan, &played, undisturbed.as_ref());
    Ok((report::text(choice, &plan, &played, &verdicts), verdicts))
}

#[expect(clippy::large_stack_frames, reason = "once, at set-up")]
fn play(
    choice: &SoakChoice,
    plan: &SoakPlan,
    recordings: Option<&RecordingPaths>,
) -> Result<PlayedTrial, Box<dyn Error>> {
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
    let report = run_beside(session, beside, &now)?;
    let strangers = strangers.map_or_else(Vec::new, Strangers::stop);
    let seen = seen.lock().map_or(None, |mut seen| seen.take());
    let seen = seen.filter(|seen| plan.ticks <= seen.ticks + report.extent.skipped);
    let seen = seen.ok_or("the run ended before its time: there is no verdict")?;
    let recordings = recordings.map_or_else(Vec::new, recordings::look_at);
    let (sounds, told) = (synthesizer.sounds().clone(), telling.told().clone());
    let acted = acted.get().clone();
    Ok(PlayedTrial { report, seen, sounds, told, acted, strangers, recordings })
}

fn run_beside(
    session: RunSession,
    actor: Option<Actor>,
    now: &AtomicU64,
) -> Result<RunReport, SessionError> {
    let is_over = AtomicBool::new(false);
    std::thread::scope(|scope| {
        if let Some(actor) = actor {
            scope.spawn(|| act_in_time(actor, now, &is_over));
        }
        let report = session.run(&AtomicBool::new(false));
        is_over.store(true, Ordering::Release);
        report
    })
}

fn act_in_time(mut actor: Actor, now: &AtomicU64, is_over: &AtomicBool) {
    while !is_over.load(Ordering::Acquire) && !actor.is_done() {
        actor.act_until(now.load(Ordering::Acquire));
        boards::links::pause(Duration::from_millis(1));
    }
}
