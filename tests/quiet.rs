//! Untouched keys are quiet with every instrument that a scene accepts; a loop that generates
//! energy nevertheless is muted.

use std::sync::Arc;

use engine::realtime::pool::BoxedVoice;
use scene::{Scene, instruments};
use scheduler::motion::KEYS;
use scheduler::port::{FinishedTick, TickObserver};
use scheduler::voice::VoiceFault;

use crate::stage::{Stage, keybed, play_all, scene, try_scene};
use engine::voice::AuditCell;

/// Energy permitted in an untouched key's model (J).
const NOTHING: f64 = 1e-3;

/// Every eighth key has a voice: presets are graded over the compass, and a chord is as good.
const EVERY: usize = 8;

#[derive(Debug)]
struct Listener {
    from: u64,
    strikes: usize,
    loudest: f64,
    muted: Vec<usize>,
    faults: usize,
}

impl Listener {
    fn since(from: u64) -> Self {
        Self { from, strikes: 0, loudest: 0.0, muted: Vec::new(), faults: 0 }
    }
}

impl TickObserver for Listener {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for (key, turn) in seen.turns.iter().enumerate() {
            if turn.fault == Some(VoiceFault::MakesEnergy) {
                self.muted.push(key);
            }
            self.faults += usize::from(turn.fault.is_some());
            if self.from <= seen.tick {
                self.strikes += turn.events.strikes();
                self.loudest = self.loudest.max(seen.forces[key].abs());
            }
        }
    }
}

fn some_voices(scene: &Scene) -> (Vec<(usize, BoxedVoice)>, [Arc<AuditCell>; KEYS]) {
    let audits: [Arc<AuditCell>; KEYS] = std::array::from_fn(|_key| Arc::default());
    let voices = crate::stage::audited(scene, &audits).into_iter().step_by(EVERY).collect();
    (voices, audits)
}

fn ticks(scene: &Scene, seconds: u32) -> u64 {
    u64::from(scene.tick_hz * seconds)
}

fn with_instrument(instrument: &str, hz: &str, render: &[(&str, &str)]) -> Result<Scene, String> {
    let mut overrides = vec![("keys.instrument", instrument), ("tick_hz", hz)];
    overrides.extend(render);
    try_scene("springs", &overrides)
}

fn all_loops() -> Vec<(String, Result<Scene, String>)> {
    let mut loops = Vec::new();
    for instrument in instruments() {
        for hz in ["500", "1000", "4000"] {
            for render in [&[][..], &[("render.jerk_density", "10")]] {
                let what = format!("{} at {hz} Hz with {render:?}", instrument.name);
                loops.push((what, with_instrument(&instrument.name, hz, render)));
            }
        }
    }
    loops
}

#[test]
fn with_nobody_at_the_keys_nothing_is_struck_and_no_energy_is_made_or_the_scene_is_refused() {
    let mut accepted = 0;
    for (what, scene) in all_loops() {
        let scene = match scene {
            Ok(scene) => scene,
            Err(why) => {
                let known =
                    why.contains("when they are left alone") || why.contains("simulate only");
                assert!(known, "{what}: {why}");
                continue;
            }
        };
        accepted += 1;
        let (voices, audits) = some_voices(&scene);
        let stage = Stage::of(voices, scene.tick_hz, keybed(&scene), 1);
        let mut stage = stage.watched_by(Listener::since(0));
        let mut most = 0.0_f64;
        for _ in 0..ticks(&scene, 10) {
            stage.tick();
            for audit in &audits {
                let audit = audit.read();
                // Energy from impacts counts, too.
                most = most.max(audit.supplied.max(audit.supplied + audit.jumps));
            }
        }
        let Listener { strikes, faults, .. } = stage.observer;
        assert_eq!((strikes, faults), (0, 0), "{what}");
        assert!(most <= NOTHING, "{what}: {most} J");
    }
    // All but the rigid ones and the ball at two rates, and these at the third.
    assert!(20 <= accepted, "{accepted}");
}

#[test]
fn after_it_was_played_every_instrument_that_is_let_in_comes_to_rest() {
    for (what, scene) in all_loops() {
        let Ok(scene) = scene else { continue };
        let mut bus = keybed(&scene);
        play_all(&mut bus, 1.0);
        let (voices, _audits) = some_voices(&scene);
        let listener = Listener::since(ticks(&scene, 3));
        let mut stage = Stage::of(voices, scene.tick_hz, bus, 1).watched_by(listener);
        for _ in 0..ticks(&scene, 4) {
            stage.tick();
        }
        let Listener { strikes, faults, .. } = stage.observer;
        assert_eq!((strikes, faults), (0, 0), "{what}");
    }
}

#[test]
fn a_loop_that_makes_energy_with_nobody_on_its_keys_is_muted() {
    let text = "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-rigid\"\n";
    let scene = Scene::from_text(&scene::Library::default(), "rigid", text.to_owned())
        .expect("a good scene");
    let (voices, _audits) = some_voices(&scene);
    let n_voices = voices.len();
    let listener = Listener::since(ticks(&scene, 19));
    let mut stage = Stage::of(voices, scene.tick_hz, keybed(&scene), 1).watched_by(listener);
    for _ in 0..ticks(&scene, 20) {
        stage.tick();
    }
    let Listener { strikes, loudest, mut muted, .. } = stage.observer;
    muted.sort_unstable();
    muted.dedup();
    // A few come to rest by themselves, and press with their hammer's weight.
    assert!(n_voices / 2 < muted.len(), "muted: {muted:?} of {n_voices}");
    assert!(strikes == 0 && loudest < 1.0, "{strikes} strikes, {loudest} N at the end");
}

#[test]
fn a_scene_is_asked_for_what_its_instrument_needs_in_one_sentence() {
    let refused = |instrument, hz, render: &[_]| {
        with_instrument(instrument, hz, render).expect_err("refused")
    };
    let why = refused("grand-rigid", "1000", &[]);
    let expected = "grand-rigid needs a coupling_stiffness of at most 2000, not none, and a \
        coupling_damping of at least 20, not 0, or its keys make energy when they are left alone; \
        set render.coupling_stiffness=2000 and render.coupling_damping=20 for the whole scene, or \
        choose another instrument";
    assert!(why.contains(expected), "{why}");
    let why = refused("paper-rigid", "4000", &[]);
    assert!(why.contains("paper-rigid needs a coupling_stiffness of at most 200"), "{why}");
    assert!(with_instrument("grand-reduced", "4000", &[("render.jerk_density", "10")]).is_ok());
    let why = refused("grand-reduced", "1000", &[("render.jerk_density", "10")]);
    assert!(why.contains("jerk_density of at least 100"), "{why}");
    let model = [("keys.model", "key-hammer-rigid"), ("keys.preset", "playable")];
    let owned: Vec<_> = model.iter().map(|(a, b)| (String::from(*a), String::from(*b))).collect();
    let why = Scene::load(&scene::Library::default(), "springs", &owned)
        .expect_err("refused")
        .to_string();
    assert!(why.contains("grand-rigid needs"), "{why}");
    assert_eq!(scene("mixed", &[]).tick_hz, 4000);
}
