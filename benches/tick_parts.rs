//! Share of each part in a tick of 88 active keys (model B, playable, RK4).
//!
//! Each case adds one thing to the case before, so the difference is its cost. `tick_88_voices`
//! continues: `active_unwatched` adds lanes and safety, `active_untapped` the counters, `active`
//! the telemetry.
//!
//! | case | adds |
//! |---|---|
//! | estimate | the filter, and the input over the tick |
//! | step | RK4 and the guards |
//! | readout | the mean force |
//! | audit | the energy audit |
//! | voice | force limits, damper, passivity, events, rest |
//! | controlled | the passivity controller |
#![expect(clippy::expect_used, reason = "a bench may stop here")]

#[path = "setting/mod.rs"]
mod setting;

use std::sync::Arc;

use criterion::Criterion;
use engine::voice::input::InputPath;
use engine::voice::{AnyVoice, VoiceBuilder};
use haptics::{AnyEstimator, Kalman, RigParameters};
use instruments::SmallModel;
use pode::input::Cubic;
use pode::stepper::Rk4;
use pode::{Auditor, Limits, Signal as _, Silent, Simulator};
use scene::{Library, PassivityMode, Scene};
use scheduler::motion::{KEYS, KeySample};
use scheduler::voice::VoiceOutput;
use setting::{TICKS, swing};

const H: f64 = 1e-3;

fn main() {
    let mut criterion = setting::criterion();
    keys(&mut criterion, "estimate", |key, signal| key.felt += signal.at(1.0).position);
    keys(&mut criterion, "step", |key, signal| {
        key.felt += key.unread.advance(H, signal, &mut Silent).mean_readout;
    });
    keys(&mut criterion, "readout", |key, signal| {
        key.felt += key.simulator.advance(H, signal, &mut Silent).mean_readout;
    });
    keys(&mut criterion, "audit", |key, signal| {
        key.felt += key.simulator.advance(H, signal, &mut key.auditor).mean_readout;
    });
    voices(&mut criterion, "voice", PassivityMode::Observe);
    voices(&mut criterion, "controlled", PassivityMode::Control);
    criterion.final_summary();
}

struct Key {
    input: InputPath,
    simulator: Simulator<SmallModel, Rk4>,
    unread: Simulator<SmallModel, Rk4>,
    auditor: Auditor<SmallModel>,
    positions: [f64; TICKS],
    felt: f64,
}

impl Key {
    #[expect(clippy::large_stack_frames, reason = "once, at set-up")]
    fn new(number: u8) -> Self {
        let known = Library::default().find("key-hammer-springs", "".as_ref()).expect("model B");
        let preset = known.presets.iter().find(|preset| preset.name == "playable");
        let values = preset.expect("the preset").values(number);
        let model = known.small().expect("a small model").with_values(&values);
        let positions = swing_of(number.into());
        let kalman = Kalman::new(H, RigParameters::default().quantum, Kalman::KEY_JERK_DENSITY);
        let scale = model.input_per_metre();
        let mut input = InputPath::new(AnyEstimator::Kalman(kalman), None, scale, H);
        let (mode, state) = model.at_rest(&input.reset(positions[0]));
        let simulator = Simulator::new(model, Rk4, Limits::default(), mode, state);
        let unread = simulator.clone().without_readout();
        Self { input, simulator, unread, auditor: Auditor::default(), positions, felt: 0.0 }
    }
}

fn swing_of(key: usize) -> [f64; TICKS] {
    swing(key as f64 / KEYS as f64, RigParameters::default().quantum)
}

fn keys(criterion: &mut Criterion, name: &str, mut rest: impl FnMut(&mut Key, &Cubic)) {
    let mut keys: Vec<_> = (0..88).map(Key::new).collect();
    let (mut tick, mut place) = (0, 0);
    let mut next = || {
        for key in &mut keys {
            let sample = KeySample::fresh(key.positions[place]);
            let followed = key.input.follow(tick, &sample);
            rest(key, &followed.signal);
        }
        (tick, place) = (tick + 1, (place + 1) % TICKS);
    };
    (0..8 * TICKS).for_each(|_| next());
    criterion.bench_function(&format!("tick_parts/{name}"), |bencher| bencher.iter(&mut next));
}

fn voices(criterion: &mut Criterion, name: &str, passivity: PassivityMode) {
    let set = [("render.passivity".to_owned(), passivity.name().to_owned())];
    let scene = Scene::load(&Library::default(), "springs", &set).expect("a scene of ours");
    let assembler = VoiceBuilder::new(&scene).expect("a scene of ours");
    let voice = |(number, described)| {
        let positions = swing_of(number);
        let voice = assembler.voice(described, Arc::default()).expect("a model of ours");
        (voice, VoiceOutput::default(), positions)
    };
    let mut voices: Vec<(AnyVoice, VoiceOutput, _)> = assembler.keys().map(voice).collect();
    for (voice, _turn, positions) in &mut voices {
        voice.reset(&KeySample::fresh(positions[0]));
    }
    let (mut tick, mut place) = (0, 0);
    let mut next = || {
        for (voice, turn, positions) in &mut voices {
            voice.tick(tick, &KeySample::fresh(positions[place]), turn);
        }
        (tick, place) = (tick + 1, (place + 1) % TICKS);
    };
    (0..8 * TICKS).for_each(|_| next());
    criterion.bench_function(&format!("tick_parts/{name}"), |bencher| bencher.iter(&mut next));
}
