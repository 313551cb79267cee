//! Model B, a grand's size, one tick of 1 ms: every method, with and without an event, and one of
//! several; and the root finder alone.
#![expect(
    clippy::expect_used,
    clippy::large_stack_frames,
    reason = "a bench may stop here, and copies simulators"
)]

#[path = "setting/mod.rs"]
mod setting;

use std::f64::consts::TAU;
use std::hint::black_box;
use std::sync::Arc;

use criterion::Criterion;
use instruments::{Described, LoadedModel, SmallModel};
use pode::input::Cubic;
use pode::stepper::{
    AdamsBashforth2, AdamsBashforth3, Any, BogackiShampine, Heun, LinearImplicitMidpoint, Rk4,
    Rodas3, SemiImplicitEuler, Tsitouras5, VelocityVerlet,
};
use pode::{Bracket, Event, Limits, Model, Motion, Resets, Simulator, Stepper, Watch, locate};
use scene::Library;
use setting::TICKS;

const H: f64 = 1e-3;

/// 2⁻²⁰ of a tick: events are located to 1 ns.
const NANOSECOND: f64 = 1.0 / ((1_u64 << 20) as f64);

fn main() {
    let mut criterion = setting::criterion();
    quiet(&mut criterion, SemiImplicitEuler);
    quiet(&mut criterion, Heun);
    quiet(&mut criterion, VelocityVerlet);
    quiet(&mut criterion, AdamsBashforth2);
    quiet(&mut criterion, AdamsBashforth3);
    quiet(&mut criterion, BogackiShampine);
    quiet(&mut criterion, Rk4);
    quiet(&mut criterion, Tsitouras5);
    quiet(&mut criterion, LinearImplicitMidpoint);
    quiet(&mut criterion, Rodas3);
    tick(&mut criterion, "rk4/any", at_rest(model(), Any::Rk4(Rk4)));
    eventful(&mut criterion);
    roots(&mut criterion);
    criterion.final_summary();
}

const NAME: &str = "key-hammer-springs";

fn model() -> SmallModel {
    let model: Arc<LoadedModel> = Library::default().find(NAME, "".as_ref()).expect("model B");
    let preset = model.presets.iter().find(|preset| preset.name == "playable");
    let values = preset.expect("the preset").values(39);
    model.small().expect("a small model").with_values(&values)
}

fn at_rest<M: Described, T: Stepper>(model: M, stepper: T) -> Simulator<M, T> {
    let (mode, state) = model.at_rest(&Motion::default());
    simulator(model, stepper, (mode, state))
}

fn simulator<M: Model + Resets, T: Stepper>(
    model: M,
    stepper: T,
    (mode, state): (M::Mode, M::State),
) -> Simulator<M, T> {
    let limits = Limits { event_tolerance: NANOSECOND, ..Limits::default() };
    Simulator::new(model, stepper, limits, mode, state)
}

fn quiet<T: Stepper>(criterion: &mut Criterion, stepper: T) {
    tick(criterion, T::NAME, at_rest(model(), stepper));
}

fn tick<M, T>(criterion: &mut Criterion, name: &str, mut simulator: Simulator<M, T>)
where
    M: Model<Input = Motion> + Resets,
    T: Stepper,
{
    let scale = model().input_per_metre();
    let w = TAU / (TICKS as f64 * H);
    let signal = |tick: usize| {
        let (sin, cos) = (w * tick as f64 * H).sin_cos();
        let [s, v, a] = [1.0 - cos, w * sin, w * w * cos].map(|it| 1.5e-3 * scale * it);
        Cubic::ballistic(s, v, a, H)
    };
    let signals: Vec<Cubic> = (0..TICKS).map(signal).collect();
    let mut tick = 0;
    let mut next = || {
        let done = simulator.advance(H, &signals[tick % TICKS], &mut pode::Silent);
        tick += 1;
        (done.mean_readout, done.work.events, done.work.pieces)
    };
    for _ in 0..2 * TICKS {
        let (_, events, pieces) = next();
        assert_eq!((events, pieces), (0, 1), "a tick in one step, without an event");
    }
    let name = format!("pode/model_b_tick/{name}");
    criterion.bench_function(&name, |bencher| bencher.iter(&mut next));
}

fn eventful(criterion: &mut Criterion) {
    for guard in ["string", "land"] {
        let (before, signal) = just_before(guard);
        let name = format!("pode/model_b_tick_event_to_1_ns/{guard}");
        criterion.bench_function(&name, |bencher| {
            bencher.iter(|| {
                let mut simulator = black_box(&before).clone();
                let done = simulator.advance(H, black_box(&signal), &mut pode::Silent);
                (simulator, done)
            });
        });
    }
}

#[derive(Default)]
struct Fired(Vec<&'static str>);

impl<M: Model> Watch<M> for Fired {
    fn event(&mut self, _model: &M, event: &Event<'_, M>) {
        self.0.push(event.cause.name());
    }
}

fn just_before(guard: &str) -> (Simulator<SmallModel, Rk4>, Cubic) {
    let mut simulator = at_rest(model(), Rk4);
    for tick in 0..1000 {
        let signal = pressed(f64::from(tick) * H);
        let (before, mut fired) = (simulator.clone(), Fired::default());
        let _done = simulator.advance(H, &signal, &mut fired);
        if fired.0 == [guard] {
            return (before, signal);
        }
    }
    unreachable!("no tick of a stroke has `{guard}` for its only event")
}

/// Returns the key's motion from rest to bottom in 40 ms, over the tick that begins at `t` (s).
fn pressed(t: f64) -> Cubic {
    const DIP: f64 = 10e-3;
    let w = 0.5 * TAU / 40e-3;
    let scale = model().input_per_metre();
    let (sin, cos) = (w * t.min(40e-3)).sin_cos();
    let moving = if t < 40e-3 { 1.0 } else { 0.0 };
    let (s, v, a) = (1.0 - cos, moving * w * sin, moving * w * w * cos);
    let half = 0.5 * DIP * scale;
    Cubic::ballistic(half * s, half * v, half * a, H)
}

type Guard = fn(f64) -> f64;

/// Guards that fall through zero at a given place; some are hard on root finders.
const FAMILIES: [(&str, Guard); 7] = [
    ("line", |d| -d),
    ("parabola", |d| -d * (d + 1.5)),
    ("three_halves", |d| -d.abs().sqrt() * d),
    ("square_root", |d| -d.abs().sqrt().copysign(d)),
    ("ninth_power", |d| -d.powi(9)),
    ("step", |d| if d < 0.0 { 1.0 } else { -1.0 }),
    ("exponential", |d| 1.0 - (30.0 * d).exp()),
];

fn roots(criterion: &mut Criterion) {
    for (name, guard) in FAMILIES {
        let guard = |tau: f64| guard(tau - black_box(0.618_034));
        let bracket = Bracket { lo: 0.0, at_lo: guard(0.0), hi: 1.0, at_hi: guard(1.0) };
        criterion.bench_function(&format!("pode/locate/{name}"), |bencher| {
            bencher.iter(|| locate(guard, black_box(bracket), None, NANOSECOND));
        });
    }
}
