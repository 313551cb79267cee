//! Oscillators with guards, as a model.

use pode::{Enclosure, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded};
use pode::{Model, Motion, Nature, Reset, Resets};

use super::guard::{GuardTerm, OscillatorState};
use lab::random::SeededRandom;

const MOST_OSCILLATORS: usize = 4;
pub(super) const MOST_GUARDS: usize = 3;

/// One oscillator: x'' = −ω² f(x) − 2 d x' + b s.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
struct Oscillator {
    /// ω² (1/s²); 0 moves at constant speed.
    stiffness: f64,
    /// 2 d (1/s).
    damping: f64,
    /// b (1/s²).
    drive: f64,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct OscillatorSystem {
    oscillators: [Oscillator; MOST_OSCILLATORS],
    /// `true` if f(x) is sin x, `false` for x.
    is_pendulum: bool,
    /// Declared rate (rad/s); valid or 0.
    rate: f64,
    specs: [GuardSpec; MOST_GUARDS],
    guards: [(f64, GuardTerm); MOST_GUARDS],
    count: usize,
    start: OscillatorState,
    restarts: bool,
    /// Factor on every bound: 1 is valid.
    bound_factor: f64,
}

impl OscillatorSystem {
    pub(super) fn random(random: &mut SeededRandom, h: f64, bound_factor: f64) -> Self {
        let mut oscillators = [Oscillator::default(); MOST_OSCILLATORS];
        let mut start = OscillatorState::default();
        let mut moving = Vec::new();
        let (mut fastest, n) = (0.0_f64, 1 + random.below(MOST_OSCILLATORS));
        for (index, oscillator) in oscillators.iter_mut().enumerate().take(n) {
            let rate = if random.once_in(6) { 0.0 } else { random.spread(0.01, 3.0) / h };
            let drive = if random.once_in(3) { rate * rate } else { 0.0 };
            let damping = if random.once_in(2) { random.between(0.0, 1.0) * rate } else { 0.0 };
            *oscillator = Oscillator { stiffness: rate * rate, damping, drive };
            start[index] = random.between(-1.0, 1.0);
            start[index + MOST_OSCILLATORS] = random.between(-1.0, 1.0) * rate.max(1.0);
            moving.extend([index, index + MOST_OSCILLATORS]);
            fastest = fastest.max(rate);
        }
        let mut system = Self {
            oscillators,
            is_pendulum: random.once_in(4),
            rate: if random.once_in(3) { 0.0 } else { fastest },
            specs: [GuardSpec::new(0, "g0"), GuardSpec::new(1, "g1"), GuardSpec::new(2, "g2")]
                .map(GuardSpec::on_crossing),
            guards: [(0.0, GuardTerm::Position { weight: 0.0 }); MOST_GUARDS],
            count: 1 + random.below(MOST_GUARDS),
            start,
            restarts: random.once_in(2),
            bound_factor,
        };
        for index in 0..system.count {
            let term = GuardTerm::random(random, &moving, h);
            system.put_guard(index, term, random.spread(1e-3, 1.5));
        }
        system
    }

    /// Returns x' = 1 with the guard 0.999 − sin 200 x: a valid bound, and a declared rate of 0.
    pub(super) fn fast_wave(bound_factor: f64) -> Self {
        let mut system = Self::random(&mut SeededRandom::new(0, 0), 0.05, bound_factor);
        system.oscillators = [Oscillator::default(); MOST_OSCILLATORS];
        (system.is_pendulum, system.rate, system.count) = (false, 0.0, 1);
        system.start = OscillatorState::default();
        system.start[MOST_OSCILLATORS] = 1.0;
        system.put_guard(0, GuardTerm::Wave { entry: 0, amplitude: 1.0, k: 200.0 }, 0.999);
        system
    }

    fn put_guard(&mut self, index: usize, term: GuardTerm, room: f64) {
        let still = Motion::default();
        let value = term.at(&self.start, &OscillatorState::default(), &still).value;
        let size = term.size(&self.start, &still).max(1.0);
        self.specs[index].scale = 4.0 * size;
        self.guards[index] = (room - value, term);
    }

    pub(super) const fn start(&self) -> OscillatorState {
        self.start
    }

    pub(super) fn guard_at(&self, index: usize) -> Option<&(f64, GuardTerm)> {
        self.guards[..self.count].get(index)
    }

    pub(super) fn describe(&self) -> String {
        let moving = self.oscillators.iter().zip(self.start);
        format!("{:?}, pendulum {}", moving.collect::<Vec<_>>(), self.is_pendulum)
    }
}

impl Model for OscillatorSystem {
    type Mode = ();
    type State = OscillatorState;
    type Input = Motion;
    const COORDS: usize = MOST_OSCILLATORS;

    fn derivative(&self, (): (), x: &OscillatorState, s: &Motion) -> OscillatorState {
        let mut derivative = OscillatorState::default();
        for (index, oscillator) in self.oscillators.iter().enumerate() {
            let (place, rate) = (x[index], x[index + MOST_OSCILLATORS]);
            let bent = if self.is_pendulum { place.sin() } else { place };
            let Oscillator { stiffness, damping, drive } = oscillator;
            derivative[index] = rate;
            derivative[index + MOST_OSCILLATORS] =
                drive * s.position - stiffness * bent - damping * rate;
        }
        derivative
    }

    fn nature(&self, (): ()) -> Nature {
        let is_driven = self.oscillators.iter().any(|it| it.drive != 0.0);
        let kind = match (self.is_pendulum, is_driven) {
            (true, _) => EquationKind::Smooth,
            (false, true) => EquationKind::Linear,
            (false, false) => EquationKind::Affine,
        };
        Nature::new(kind, self.rate)
    }
}

impl Guarded for OscillatorSystem {
    fn guards(&self, (): ()) -> &[GuardSpec] {
        &self.specs[..self.count]
    }

    fn guard_bound(
        &self,
        (): (),
        guard: GuardId,
        over: &Enclosure<OscillatorState, Motion>,
    ) -> GuardBound {
        let known = self.guard_at(usize::from(guard.0));
        known.map_or(GuardBound::UNKNOWN, |(_, term)| term.bound(over).times(self.bound_factor))
    }

    fn guard(&self, (): (), guard: GuardId, x: &OscillatorState, s: &Motion) -> GuardValue {
        let Some((level, term)) = self.guard_at(usize::from(guard.0)) else {
            return GuardValue::default();
        };
        let GuardValue { value, rate } = term.at(x, &self.derivative((), x, s), s);
        GuardValue::new(level + value, rate)
    }
}

impl Resets for OscillatorSystem {
    fn reset(&self, (): (), _guard: GuardId, x: &OscillatorState, _s: &Motion) -> Reset<Self> {
        Reset::to((), if self.restarts { self.start } else { *x })
    }
}
