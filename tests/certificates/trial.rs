//! One system, from its start to its end.

use pode::stepper::Any;
use pode::{Advance, Cap, Limits, Simulator, Tick};

use super::input::{Input, InputKind};
use super::orbit::{NegativePlace, OrbitWatch, SeenPiece};
use super::system::OscillatorSystem;
use super::{CertificateChoice, CertificateReport, CertificateViolation, MAX_DESCRIBED};
use lab::random::SeededRandom;

const TICKS: u64 = 40;
const MOST_PARTS: u32 = 64;
/// Size at which an orbit ends: rounding is as large as its guards.
const FAR: f64 = 1e6;

#[derive(Debug)]
pub(super) struct Trial {
    number: u64,
    model: OscillatorSystem,
    kind: InputKind,
    input: Input,
    method: Any,
    /// `true` if each advance stops after one piece, so that each piece has its own verdict.
    is_single: bool,
    h: f64,
}

impl Trial {
    pub(super) fn new(choice: &CertificateChoice, number: u64) -> Self {
        let mut random = SeededRandom::new(choice.seed, number);
        let h = random.spread(1e-3, 1.0);
        let name = Any::NAMES[random.below(Any::NAMES.len())];
        let named = Any::named(name).unwrap_or_default();
        let tolerance = random.spread(1e-9, 1e-2);
        let is_single = random.once_in(2);
        let tolerant = named.with_tolerance(tolerance, h).filter(|_| !is_single);
        let method = tolerant.filter(|_| random.once_in(2)).unwrap_or(named);
        if number == 0 {
            let (model, kind, h) =
                (OscillatorSystem::fast_wave(choice.bound_factor), InputKind::Rest, 0.05);
            let input = Input::new(kind, random, h);
            return Self { number, model, kind, input, method: Any::default(), is_single: true, h };
        }
        let model = OscillatorSystem::random(&mut random, h, choice.bound_factor);
        let kind = InputKind::random(&mut random, h);
        let input = Input::new(kind, random, h);
        Self { number, model, kind, input, method, is_single, h }
    }

    #[expect(
        clippy::large_stack_frames,
        reason = "a simulator of any method has room for the largest dense output; offline"
    )]
    pub(super) fn run(mut self, report: &mut CertificateReport) {
        let limits = Limits::default();
        let limits = if self.is_single { Limits { pieces: 1, ..limits } } else { limits };
        let start = self.model.start();
        let simulator = Simulator::new(self.model, self.method, limits, (), start);
        let mut simulator = simulator.without_readout();
        for tick in 0..TICKS {
            self.input.next();
            let is_near = simulator.state().iter().all(|entry| entry.abs() < FAR);
            if !is_near || !self.tick(tick, &mut simulator, report) {
                break;
            }
        }
    }

    fn tick(
        &self,
        tick: u64,
        simulator: &mut Simulator<OscillatorSystem, Any>,
        report: &mut CertificateReport,
    ) -> bool {
        let mut theta = 0.0;
        for _part in 0..MOST_PARTS {
            let signal = self.input.part(tick as f64 * self.h, self.h, theta);
            let rest = 1.0 - theta;
            let mut watch = OrbitWatch::new(TICKS as f64 * self.h);
            let done = simulator.advance(rest * self.h, &signal, &mut watch);
            self.judge(tick, &done, &watch.pieces, report);
            match done.advance {
                Advance::Completed => return true,
                Advance::Capped(Cap::Pieces) if self.is_single => {}
                Advance::Capped(_) | Advance::Faulty(_) => return false,
            }
            theta += rest * watch.pieces.last().map_or(0.0, |piece| piece.theta_end);
        }
        false
    }

    fn judge(&self, tick: u64, done: &Tick, pieces: &[SeenPiece], report: &mut CertificateReport) {
        let [certain, unknown] = [done.work.certain, done.work.unknown].map(u64::from);
        report.steps += certain + unknown;
        report.certain += certain;
        report.unknown += unknown;
        report.events += u64::from(done.work.events);
        let negative: Vec<_> = pieces.iter().filter_map(SeenPiece::negative).collect();
        report.negative += negative.len() as u64;
        // The certain step among several is unknown: assume as many valid ones as possible.
        let wrong = (negative.len() as u64).saturating_sub(unknown);
        report.violations += wrong;
        if wrong > 0 && report.described.len() < MAX_DESCRIBED {
            report.described.extend(negative.first().map(|place| self.describe(tick, place)));
        }
    }

    fn describe(&self, tick: u64, place: &NegativePlace) -> CertificateViolation {
        let guard = self.model.guard_at(place.guard);
        CertificateViolation {
            system: self.number,
            method: self.method.name(),
            tick,
            theta: place.theta,
            value: place.value,
            system_text: format!(
                "h {:?}, single {}, guard {guard:?}, input {:?}, oscillators {}",
                self.h,
                self.is_single,
                self.kind,
                self.model.describe()
            ),
        }
    }
}
