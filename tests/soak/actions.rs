//! Actions of a tuner, failing models and a full disk, by tick.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use boards::links::random::Random;
use engine::realtime::pool::VoiceChange;
use host::control::{RequestHandler, RunHandle};
use rustix::process::{Resource, Rlimit, getrlimit, setrlimit};
use scene::{KeyVoice, Scene};
use scheduler::motion::KEYS;
use scheduler::values::ModelValues;
use telemetry::Request;
use telemetry::request::Change;

use crate::plan::{BadValues, SoakPlan};

/// Size limit of files while the disk is full (B).
const FULL: u64 = 64 << 10;

#[derive(Clone, Debug)]
enum PlannedAction {
    /// Sets these values of a voice, unchecked.
    Retune(usize, u64, Vec<f64>),
    Ask(Request),
    Fill,
    Clear,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct ActionCounts {
    pub(crate) retuned: u64,
    /// Requests with valid values, and the refused ones among them.
    pub(crate) asked: u64,
    pub(crate) refused: Vec<String>,
    /// Requests with invalid values, and the accepted ones among them.
    pub(crate) wrong: u64,
    pub(crate) wrong_taken: u64,
    pub(crate) failed: Vec<String>,
}

#[derive(Clone, Debug)]
pub(crate) struct FailingVoices(Arc<[AtomicBool; KEYS]>);

impl Default for FailingVoices {
    fn default() -> Self {
        Self(Arc::new(std::array::from_fn(|_key| AtomicBool::new(false))))
    }
}

impl FailingVoices {
    pub(crate) fn has(&self, key: usize) -> bool {
        self.0.get(key).is_some_and(|it| it.load(Ordering::Acquire))
    }

    fn note(&self, key: usize, values: &[f64]) {
        if let Some(it) = self.0.get(key) {
            it.store(Self::are_bad(values), Ordering::Release);
        }
    }

    fn are_bad(values: &[f64]) -> bool {
        values.iter().all(|value| value.is_nan())
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct SharedActed(Arc<Mutex<ActionCounts>>);

impl SharedActed {
    pub(crate) fn get(&self) -> MutexGuard<'_, ActionCounts> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[derive(Clone, Debug)]
pub(crate) struct RecordingPaths {
    pub(crate) cut_short: PathBuf,
    pub(crate) second: PathBuf,
}

impl RecordingPaths {
    pub(crate) fn in_folder(folder: &Path) -> Self {
        Self { cut_short: folder.join("full.mcap"), second: folder.join("second.mcap") }
    }
}

#[derive(Debug)]
pub(crate) struct Actor {
    run: Arc<RunHandle>,
    requests: Arc<RequestHandler>,
    coming: VecDeque<(u64, PlannedAction)>,
    acted: SharedActed,
    failing: FailingVoices,
    usual: Rlimit,
}

impl Actor {
    pub(crate) fn new(
        (scene, plan): (&Scene, &SoakPlan),
        run: Arc<RunHandle>,
        requests: Arc<RequestHandler>,
        recordings: Option<&RecordingPaths>,
    ) -> (Self, SharedActed) {
        let mut coming = voices(scene, plan);
        coming.extend(tunings(scene, plan));
        if let Some(paths) = recordings.filter(|_| !plan.full.is_empty()) {
            coming.extend(files(plan, paths));
        }
        coming.sort_by_key(|(tick, _)| *tick);
        let acted = SharedActed::default();
        let usual = getrlimit(Resource::Fsize);
        let (coming, failing) = (coming.into(), FailingVoices::default());
        let it = Self { run, requests, coming, acted: acted.clone(), failing, usual };
        (it, acted)
    }

    pub(crate) fn failing(&self) -> FailingVoices {
        self.failing.clone()
    }

    pub(crate) fn act_until(&mut self, tick: u64) {
        while self.coming.front().is_some_and(|(due, _)| *due < tick) {
            let Some((_, action)) = self.coming.pop_front() else { return };
            self.act(action);
        }
    }

    pub(crate) fn is_done(&self) -> bool {
        self.coming.is_empty()
    }

    fn act(&self, action: PlannedAction) {
        let mut acted = self.acted.get();
        let done = match action {
            PlannedAction::Retune(key, model, values) => {
                acted.retuned += 1;
                self.retune(key, model, &values)
            }
            PlannedAction::Ask(request) => {
                self.ask(&request, &mut acted);
                Ok(())
            }
            PlannedAction::Fill => self.limit_files(Some(FULL)),
            PlannedAction::Clear => self.limit_files(self.usual.current),
        };
        acted.failed.extend(done.err());
    }

    fn ask(&self, request: &Request, acted: &mut ActionCounts) {
        let is_wrong = matches!(request, Request::Set { changes }
            if changes.iter().any(|it| !it.value.is_finite() || it.value.abs() > WILD));
        let answer = self.requests.answer(request, "a tuner");
        if is_wrong {
            acted.wrong += 1;
            acted.wrong_taken += u64::from(answer.is_ok());
        } else {
            acted.asked += 1;
            acted.refused.extend(answer.err());
        }
    }

    fn retune(&self, key: usize, model: u64, values: &[f64]) -> Result<(), String> {
        let sent = ModelValues::new(model, self.run.new_revision(), values);
        let sent = sent.ok_or_else(|| format!("{model} has too many parameters"))?;
        if !FailingVoices::are_bad(values) {
            self.failing.note(key, values);
        }
        self.run.send(vec![(key, VoiceChange::Retune(sent))], Vec::new())?;
        self.failing.note(key, values);
        Ok(())
    }

    fn limit_files(&self, current: Option<u64>) -> Result<(), String> {
        let limit = Rlimit { current, maximum: self.usual.maximum };
        setrlimit(Resource::Fsize, limit).map_err(|error| format!("RLIMIT_FSIZE: {error}"))
    }
}

impl Drop for Actor {
    fn drop(&mut self) {
        if self.coming.iter().any(|(_, it)| matches!(it, PlannedAction::Clear)) {
            // A run that ended early must not leave the process without files.
            let _put_back = self.limit_files(self.usual.current);
        }
    }
}

/// Values beyond this are out of every parameter's range.
const WILD: f64 = 1e7;

fn voices(scene: &Scene, plan: &SoakPlan) -> Vec<(u64, PlannedAction)> {
    let mut actions = Vec::new();
    for trouble in &plan.voices {
        let Some(voice) = voice(scene, trouble.key) else { continue };
        let bad = match trouble.what {
            BadValues::NotANumber => vec![f64::NAN; voice.values.len()],
            BadValues::Wild(seed) => wild(&voice.values, seed),
        };
        let (key, model) = (trouble.key, voice.model.id());
        actions.push((trouble.ticks.start, PlannedAction::Retune(key, model, bad)));
        actions.push((trouble.ticks.end, PlannedAction::Retune(key, model, voice.values.clone())));
    }
    actions
}

fn wild(values: &[f64], seed: u64) -> Vec<f64> {
    const FACTORS: [f64; 6] = [0.0, -1.0, 1e3, 1e-3, 1e9, 1.0];
    let mut random = Random(seed);
    let mut factor = || FACTORS[usize::try_from(random.next() % 6).unwrap_or_default()];
    values.iter().map(|value| value * factor()).collect()
}

fn tunings(scene: &Scene, plan: &SoakPlan) -> Vec<(u64, PlannedAction)> {
    let action = |tuning: &crate::plan::Tuning| {
        let voice = voice(scene, tuning.key)?;
        let share = (tuning.parameter * voice.values.len() as f64).floor();
        let index = usize::try_from(engine::realtime::clock::nearest_integer(share)).ok()?;
        let (parameter, value) = (voice.model.parameters.get(index)?, *voice.values.get(index)?);
        let (low, high) = parameter.range;
        let value = match tuning.factor {
            factor if factor.is_nan() => factor,
            factor if WILD < factor => 10.0 * high.abs().max(WILD),
            factor => (value * factor).clamp(low, high),
        };
        let key = u8::try_from(tuning.key).ok()?;
        let change = Change { key, parameter: parameter.name.to_owned(), value };
        Some((tuning.tick, PlannedAction::Ask(Request::Set { changes: vec![change] })))
    };
    plan.tunings.iter().filter_map(action).collect()
}

fn files(plan: &SoakPlan, paths: &RecordingPaths) -> [(u64, PlannedAction); 4] {
    let record = |path: &Path| {
        PlannedAction::Ask(Request::Record { file: Some(path.display().to_string()) })
    };
    [
        (plan.full.start / 2, record(&paths.cut_short)),
        (plan.full.start, PlannedAction::Fill),
        (plan.full.end, PlannedAction::Clear),
        (plan.full.end + 1, record(&paths.second)),
    ]
}

fn voice(scene: &Scene, key: usize) -> Option<&KeyVoice> {
    scene.keys.get(key)?.as_ref()
}
