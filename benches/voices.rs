//! One voice for one tick: estimate, equations, force limits, energy audit, of each model.
//!
//! The key swings slowly, so that hammers stay on their keys; bouncing models bounce.
#![expect(clippy::expect_used, reason = "a bench may stop here")]

#[path = "setting/mod.rs"]
mod setting;

use std::sync::Arc;

use criterion::Criterion;
use engine::voice::{AnyVoice, VoiceBuilder};
use haptics::RigParameters;
use scene::Scene;
use scheduler::motion::KeySample;
use scheduler::voice::VoiceOutput;
use setting::{TICKS, swing};

const MIDDLE: usize = 39;

fn main() {
    let mut criterion = setting::criterion();
    for instrument in scene::instruments() {
        let name = format!("voice/{}", instrument.name);
        let positions = swing(0.0, RigParameters::default().quantum);
        ticks(&mut criterion, &name, voice(&instrument.name), &positions);
    }
    ticks(&mut criterion, "voice/asleep", voice("grand-springs"), &[0.0; TICKS]);
    criterion.final_summary();
}

fn voice(instrument: &str) -> AnyVoice {
    // As a recording, which skips the check of stability: only the time matters.
    let text = format!("[[keys]]\nrange = \"A0..C8\"\ninstrument = \"{instrument}\"\n");
    let scene =
        Scene::from_text(&scene::Library::default(), instrument, text).expect("a good scene");
    let assembler = VoiceBuilder::new(&scene).expect("a scene of ours");
    let described = scene.keys[MIDDLE].as_ref().expect("a voice");
    assembler.voice(described, Arc::default()).expect("a model of ours")
}

fn ticks(criterion: &mut Criterion, name: &str, mut voice: AnyVoice, positions: &[f64; TICKS]) {
    let mut samples = positions.iter().map(|position| KeySample::fresh(*position)).cycle();
    voice.reset(&KeySample::fresh(positions[0]));
    let mut turn = VoiceOutput::default();
    let mut tick = 0;
    let mut next = || {
        let sample = samples.next().unwrap_or_default();
        turn.begin();
        voice.tick(tick, &sample, &mut turn);
        tick += 1;
        turn.force
    };
    (0..8 * TICKS).for_each(|_| _ = next());
    criterion.bench_function(name, |bencher| bencher.iter(&mut next));
}
