//! Small models with known solutions, and helpers of the event tests.

pub mod block;
pub mod head;
pub mod two_sided;

use pode::stepper::Rk4;
use pode::{
    Advance, Enclosure, EquationKind, GuardBound, GuardId, GuardSpec, GuardValue, Guarded, Limits,
    Model, Motion, Nature, Reset, Resets, RunRecorder, Settling, Simulator, Stepper, Tick,
};

pub const G: f64 = 9.81;

pub const STEPS: [f64; 3] = [1e-4, 1e-3, 7e-3];

/// Tick phases: shifts of the start, in ticks.
pub const PHASES: [f64; 3] = [0.0, 1.0 / 3.0, 0.999];

/// The input of a model without one. One function, since each closure compiles another simulator.
pub fn no_input(_: f64) {}

pub fn each_step_and_phase(mut check: impl FnMut(f64, f64)) {
    for h in STEPS {
        for phase in PHASES {
            check(h, phase);
        }
    }
}

#[track_caller]
pub fn close(what: impl std::fmt::Display, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "{what}: {found} is {error:e} from {expected}, over {tolerance:e}");
}

#[track_caller]
pub fn all_completed(ticks: &[Tick]) {
    let odd = ticks.iter().position(|tick| tick.advance != Advance::Completed);
    assert_eq!(odd, None, "{:?}", odd.map(|n| ticks[n]));
}

/// Runs a model without input until `until` (s) with ticks of `h`, the first one cut to `1 − phase`
/// of a tick; returns the events and every tick.
pub fn run<M: Resets<Input = ()>, T: Stepper>(
    simulator: &mut Simulator<M, T>,
    h: f64,
    phase: f64,
    until: f64,
) -> (RunRecorder<M>, Vec<Tick>) {
    let mut recorder = RunRecorder::new(h);
    let mut ticks = Vec::new();
    if phase > 0.0 {
        let first = (1.0 - phase) * h;
        recorder.place_tick(0, 0.0, first);
        ticks.push(simulator.advance(first, &no_input, &mut recorder));
        recorder.place_tick(1, first, h);
    }
    while recorder.time(simulator.tick(), 0.5) < until {
        ticks.push(simulator.advance(h, &no_input, &mut recorder));
    }
    (recorder, ticks)
}

/// A ball over a floor: y'' = −g, v⁺ = −e v⁻, at rest after infinitely many impacts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    pub restitution: f64,
    pub mass: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BallMode {
    Flight,
    Rest,
}

impl Ball {
    pub fn dropped(restitution: f64, height: f64, limits: Limits) -> Simulator<Self, Rk4> {
        let ball = Self { restitution, mass: 1.0 };
        Simulator::new(ball, Rk4, limits, BallMode::Flight, [height, 0.0])
    }
}

impl Model for Ball {
    type Mode = BallMode;
    type State = [f64; 2];
    type Input = ();
    const COORDS: usize = 1;

    fn derivative(&self, mode: BallMode, x: &[f64; 2], (): &()) -> [f64; 2] {
        match mode {
            BallMode::Flight => [x[1], -G],
            BallMode::Rest => [0.0, 0.0],
        }
    }

    fn nature(&self, _: BallMode) -> Nature {
        Nature::new(EquationKind::Affine, 0.0)
    }

    fn readout(&self, mode: BallMode, _: &[f64; 2], (): &()) -> f64 {
        match mode {
            BallMode::Flight => 0.0,
            BallMode::Rest => self.mass * G,
        }
    }
}

impl Guarded for Ball {
    fn guards(&self, mode: BallMode) -> &'static [GuardSpec] {
        const FLOOR: [GuardSpec; 1] = [GuardSpec::new(0, "floor")];
        match mode {
            BallMode::Flight => &FLOOR,
            BallMode::Rest => &[],
        }
    }

    fn guard(&self, _: BallMode, _: GuardId, x: &[f64; 2], (): &()) -> GuardValue {
        GuardValue::new(x[0], x[1])
    }
}

impl Resets for Ball {
    fn reset(&self, _: BallMode, _: GuardId, x: &[f64; 2], (): &()) -> Reset<Self> {
        let e = self.restitution;
        let after = -e * x[1];
        let reset =
            Reset::to(BallMode::Flight, [0.0, after]).with_impulse(self.mass * (1.0 + e) * -x[1]);
        if e >= 1.0 {
            return reset;
        }
        reset.settling(Settling {
            after: 2.0 * after / (G * (1.0 - e)),
            ratio: e,
            mode: BallMode::Rest,
            state: [0.0, 0.0],
            impulse: self.mass * after * (1.0 + e) / (1.0 - e),
        })
    }
}

/// A model of one mode without input, as functions of `of`; [`OneMode::new`] has no guards.
#[derive(Clone, Copy, Debug)]
pub struct OneMode<P, const N: usize> {
    pub of: P,
    pub derivative: fn(&P, &[f64; N]) -> [f64; N],
    pub readout: fn(&P, &[f64; N]) -> f64,
    pub nature: Nature,
    pub guards: &'static [GuardSpec],
    pub guard: fn(&P, GuardId, &[f64; N]) -> GuardValue,
    /// `true` if the guards move and bend as the first entry does, and say so.
    pub is_bounded: bool,
    pub reset: fn(&P, GuardId, &[f64; N]) -> [f64; N],
}

impl<P, const N: usize> OneMode<P, N> {
    pub fn new(of: P, derivative: fn(&P, &[f64; N]) -> [f64; N]) -> Self {
        Self {
            of,
            derivative,
            readout: |_, _| 0.0,
            nature: Nature::default(),
            guards: &[],
            guard: |_, _, _| unreachable!("no guards"),
            is_bounded: false,
            reset: |_, _, x| *x,
        }
    }

    pub fn start<T: Stepper>(self, stepper: T, x: [f64; N]) -> Simulator<Self, T> {
        Simulator::new(self, stepper, Limits::default(), (), x)
    }
}

impl<P, const N: usize> Model for OneMode<P, N> {
    type Mode = ();
    type State = [f64; N];
    type Input = ();
    const COORDS: usize = if N > 1 { N / 2 } else { N };

    fn derivative(&self, (): (), x: &[f64; N], (): &()) -> [f64; N] {
        (self.derivative)(&self.of, x)
    }

    fn readout(&self, (): (), x: &[f64; N], (): &()) -> f64 {
        (self.readout)(&self.of, x)
    }

    fn nature(&self, (): ()) -> Nature {
        self.nature
    }
}

impl<P, const N: usize> Guarded for OneMode<P, N> {
    fn guards(&self, (): ()) -> &'static [GuardSpec] {
        self.guards
    }

    fn guard(&self, (): (), id: GuardId, x: &[f64; N], (): &()) -> GuardValue {
        (self.guard)(&self.of, id, x)
    }

    fn guard_bound(&self, (): (), _: GuardId, over: &Enclosure<[f64; N], ()>) -> GuardBound {
        if self.is_bounded { over.entry(0) } else { GuardBound::UNKNOWN }
    }
}

impl<P, const N: usize> Resets for OneMode<P, N> {
    fn reset(&self, (): (), id: GuardId, x: &[f64; N], (): &()) -> Reset<Self> {
        Reset::to((), (self.reset)(&self.of, id, x))
    }
}

/// Time as the only state: x' = 1, with guards that are functions of it.
#[derive(Clone, Copy)]
pub struct Timed {
    pub guards: &'static [GuardSpec],
    pub guard: fn(GuardId, f64) -> GuardValue,
    /// Changes the second and third state; `true` leads to the other mode.
    pub effect: fn(GuardId, &mut [f64; 3]) -> bool,
}

impl std::fmt::Debug for Timed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Timed")
    }
}

impl PartialEq for Timed {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Timed {
    pub fn start(self) -> Simulator<Self, Rk4> {
        Simulator::new(self, Rk4, Limits::default(), true, [0.0; 3])
    }

    /// Asserts the times of the events of one second, in each of these numbers of ticks.
    #[track_caller]
    pub fn check_times(self, what: &str, ticks: [u32; 4], expected: &[f64], tolerance: f64) {
        for n in ticks {
            let h = 1.0 / f64::from(n);
            let (mut timed, mut recorder) = (self.start(), RunRecorder::new(h));
            for _ in 0..n {
                let tick = timed.advance(h, &no_input, &mut recorder);
                assert_eq!(tick.advance, Advance::Completed, "{what}, {n} ticks");
            }
            let times = recorder.times();
            assert_eq!(times.len(), expected.len(), "{what}, {n} ticks: {times:?}");
            for (t, expected) in times.iter().zip(expected) {
                close(format_args!("{what}, {n} ticks"), *t, *expected, tolerance);
            }
        }
    }
}

impl Model for Timed {
    /// `true`: guards as given; `false`: negated.
    type Mode = bool;
    type State = [f64; 3];
    type Input = ();
    const COORDS: usize = 3;

    fn derivative(&self, _: bool, _: &[f64; 3], (): &()) -> [f64; 3] {
        [1.0, 0.0, 0.0]
    }
}

impl Guarded for Timed {
    fn guards(&self, _: bool) -> &'static [GuardSpec] {
        self.guards
    }

    fn guard(&self, mode: bool, id: GuardId, x: &[f64; 3], (): &()) -> GuardValue {
        let it = (self.guard)(id, x[0]);
        if mode { it } else { GuardValue::new(-it.value, -it.rate) }
    }
}

impl Resets for Timed {
    fn reset(&self, mode: bool, id: GuardId, x: &[f64; 3], (): &()) -> Reset<Self> {
        let mut after = *x;
        let other = (self.effect)(id, &mut after);
        Reset::to(mode != other, after)
    }
}

pub fn count(_: GuardId, x: &mut [f64; 3]) -> bool {
    x[1] += 1.0;
    false
}

/// Counts in the second state and switches to the negated guard.
pub fn count_and_flip(_: GuardId, x: &mut [f64; 3]) -> bool {
    x[1] += 1.0;
    true
}

pub const ONE: [GuardSpec; 1] = [GuardSpec::new(0, "g")];

/// The same guard, fired by each fall; a rise resets it silently.
pub const ON_CROSSING: [GuardSpec; 1] = [ONE[0].on_crossing()];

/// Only the input moves; guarded by level − u, and then by u − level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    pub guards: &'static [GuardSpec],
    pub level: f64,
}

impl Model for Threshold {
    type Mode = bool;
    type State = [f64; 1];
    type Input = Motion;
    const COORDS: usize = 1;

    fn derivative(&self, _: bool, _: &[f64; 1], _: &Motion) -> [f64; 1] {
        [0.0]
    }
}

impl Guarded for Threshold {
    fn guards(&self, _: bool) -> &'static [GuardSpec] {
        self.guards
    }

    fn guard(&self, below: bool, _: GuardId, _: &[f64; 1], u: &Motion) -> GuardValue {
        let sign = if below { 1.0 } else { -1.0 };
        GuardValue::new(sign * (self.level - u.position), -sign * u.rate)
    }
}

impl Resets for Threshold {
    fn reset(&self, below: bool, _: GuardId, x: &[f64; 1], _: &Motion) -> Reset<Self> {
        Reset::to(!below, *x)
    }
}
