//! Cost of a unit of work, measured before the first tick to keep deadlines from the start.

use std::collections::BTreeMap;

use engine::realtime::clock;
use engine::voice::AnyVoice;
use scheduler::motion::KeySample;
use scheduler::time::Period;
use scheduler::voice::{TurnRules, VoiceOutput};
use scheduler::work::{TurnLimit, VoiceKind};

/// Voices of each kind to try; the cheapest counts.
const TRIED: usize = 3;

/// Ticks of a trial, in which the key goes down.
const TICKS: u64 = 40;

/// Displacement of the key per tick of the trial (m).
const STEP: f64 = 0.2e-3;

/// Largest units of a trial's turn: a model that fails takes a millisecond or two.
const LIMIT: u32 = 2000;

/// Costs of a unit by kind of voice (ns), from copies of some voices.
#[derive(Debug, Default)]
pub(super) struct UnitCosts {
    known: BTreeMap<u32, (f64, usize)>,
}

impl UnitCosts {
    /// Tries a copy of `voice` in ticks of `period`, unless enough of its kind were tried.
    pub(super) fn try_voice(&mut self, voice: &AnyVoice, period: Period) {
        let (cost, n_tried) =
            self.known.entry(voice.internals().kind.0).or_insert((f64::INFINITY, 0));
        if *n_tried < TRIED {
            *n_tried += 1;
            *cost = cost.min(measured(voice, period).unwrap_or(f64::INFINITY));
        }
    }

    /// Returns the cost of each kind that worked (ns).
    pub(super) fn costs(&self) -> impl Iterator<Item = (VoiceKind, f64)> {
        let known = self.known.iter().map(|(kind, (cost, _))| (VoiceKind(*kind), *cost));
        known.filter(|(_, cost)| cost.is_finite())
    }
}

/// Returns the cost of a unit (ns), if the voice did any work.
fn measured(voice: &AnyVoice, period: Period) -> Option<f64> {
    let mut voice = voice.copy();
    voice.restrict(TurnRules { limit: TurnLimit::of(LIMIT), ..TurnRules::FREE });
    voice.reset(&KeySample::fresh(0.0));
    let step = STEP * 1000.0 * period.as_secs_f64();
    let (mut units, mut turn) = (0, VoiceOutput::default());
    let before = clock::thread_cpu();
    for tick in 0..TICKS {
        turn.begin();
        voice.tick(tick, &KeySample::fresh(step * tick as f64), &mut turn);
        units += turn.work.units;
        if turn.fault.is_some() {
            break;
        }
    }
    let time = clock::thread_cpu().since(before).as_u64() as f64;
    (0 < units).then(|| time / f64::from(units))
}
