//! Simplifications while a tick has more work than time: their savings and costs, and no key feels
//! another one's work.

use std::sync::Arc;

use engine::realtime::pool::BoxedVoice;
use engine::voice::VoiceBuilder;
use scene::Scene;
use scheduler::motion::{KEYS, KeyEvent, KeySample, KeySlope};
use scheduler::overload::{Simplification, Simplifications};
use scheduler::port::{FinishedTick, KeyBus, TickObserver};
use scheduler::voice::{VoiceFault, VoiceWork};

use crate::stage::{Stage, keybed, play_all, scene, voices};

const END: f64 = 1.2;
const TICKS: u64 = 1200;

#[derive(Default)]
struct Played {
    /// Key and time (s) of each strike.
    strikes: Vec<(usize, f64)>,
    work: VoiceWork,
    /// Force on each key in each tick (N).
    forces: Vec<[f64; KEYS]>,
    samples: Vec<[KeySample; KEYS]>,
    waited: u64,
}

impl TickObserver for &mut Played {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        for (key, turn) in seen.turns.iter().enumerate() {
            let strikes = turn.events.as_slice().iter().filter_map(|(at, event)| {
                let is_strike = matches!(event, KeyEvent::Strike { .. });
                is_strike.then(|| (key, at.seconds(1e-3)))
            });
            // At the end of the run one more or less may be in time.
            self.strikes.extend(strikes.filter(|(_, at)| *at < END - 0.05));
            self.work = self.work.plus(turn.work);
            self.waited += u64::from(turn.waited);
        }
        self.forces.push(*seen.forces);
        self.samples.push(*seen.samples);
    }
}

/// Keys that move as in another run, whatever their forces.
struct SameMotion<'a>(&'a [[KeySample; KEYS]]);

impl KeyBus for SameMotion<'_> {
    fn receive(&mut self, tick: u64, samples: &mut [KeySample; KEYS]) {
        *samples = self.0[usize::try_from(tick).expect("few ticks")];
    }

    fn send(&mut self, _tick: u64, _forces: &[f64; KEYS], _slopes: &[KeySlope; KEYS]) {}
}

fn run<B: KeyBus>(
    stage: Stage<B, crate::stage::Nobody>,
    simplified: impl Fn(u64) -> Simplifications,
) -> Played {
    let mut played = Played::default();
    let mut stage = stage.watched_by(&mut played);
    for tick in 0..TICKS {
        stage.scheduler.simplify(simplified(tick));
        stage.tick();
    }
    drop(stage);
    played.strikes.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    played
}

fn played(scene: &Scene, simplified: impl Fn(u64) -> Simplifications) -> Played {
    let mut keybed = keybed(scene);
    play_all(&mut keybed, END);
    run(Stage::new(scene, keybed), simplified)
}

fn difference(one: &Played, other: &Played) -> f64 {
    let pairs = one.forces.iter().flatten().zip(other.forces.iter().flatten());
    let (sum, n) = pairs.fold((0.0, 0.0), |(sum, n), (a, b)| (sum + (a - b) * (a - b), n + 1.0));
    f64::sqrt(sum / n)
}

fn shift(one: &Played, other: &Played) -> f64 {
    let keys = |it: &Played| it.strikes.iter().map(|(key, _)| *key).collect::<Vec<_>>();
    assert_eq!(keys(one), keys(other), "the same keys sound equally often");
    let pairs = one.strikes.iter().zip(&other.strikes);
    pairs.map(|((_, a), (_, b))| (a - b).abs()).fold(0.0, f64::max)
}

fn all(simplified: &[Simplification]) -> Simplifications {
    simplified.iter().fold(Simplifications::NONE, |all, one| all.with(*one))
}

/// Default instrument, each key played about twice a second; strikes move by less than 1 ms.
#[test]
fn what_is_left_out_saves_work_and_every_note_sounds_in_time() {
    let scene = scene("default", &[]);
    let whole = played(&scene, |_| Simplifications::NONE);
    let usual = f64::from(whole.work.derivatives);
    for (simplified, saved, off) in [
        (
            &[Simplification::Telemetry, Simplification::Slopes, Simplification::Fidelity][..],
            0.0,
            0.0,
        ),
        (&[Simplification::Rest], 0.005, 0.03),
        (&[Simplification::Steps], 0.1, 0.3),
    ] {
        let simplified = all(simplified);
        let less = played(&scene, |_| simplified);
        let same = run(Stage::new(&scene, SameMotion(&whole.samples)), |_| simplified);
        let part = 1.0 - f64::from(less.work.derivatives) / usual;
        let (off_by, shift) = (difference(&whole, &same), shift(&whole, &less));
        assert!(saved <= part && part < saved + 0.1, "{simplified:?} saves {part}");
        assert!(off_by <= off, "{simplified:?}: the same motion feels other by {off_by} N");
        assert!(shift < 1e-3, "{simplified:?}: strikes come {shift} s off");
    }
}

/// A force may change more in one tick than with everything, since contacts come some microseconds
/// earlier or later; but not more where something is left out or restored.
#[test]
fn no_force_steps_where_something_is_left_out_or_taken_back() {
    const SPAN: u64 = 50;
    let everything = all(&Simplification::ALL);
    for name in ["default", "springs"] {
        let scene = scene(name, &[]);
        let whole = played(&scene, |_| Simplifications::NONE);
        let is_whole = |tick: u64| (tick / SPAN).is_multiple_of(2);
        let simplified = |tick| if is_whole(tick) { Simplifications::NONE } else { everything };
        let changing = run(Stage::new(&scene, SameMotion(&whole.samples)), simplified);
        assert_eq!(changing.strikes.len(), whole.strikes.len());
        let (mut at_changes, mut elsewhere) = (0.0_f64, 0.0_f64);
        let pairs = whole.forces.windows(2).zip(changing.forces.windows(2));
        for (tick, (usual, changed)) in (1..).zip(pairs) {
            let worst =
                if is_whole(tick - 1) == is_whole(tick) { &mut elsewhere } else { &mut at_changes };
            for key in 0..KEYS {
                let step = |pair: &[[f64; KEYS]]| (pair[1][key] - pair[0][key]).abs();
                *worst = worst.max(step(changed) - step(usual));
            }
        }
        assert!(at_changes <= elsewhere, "{name}: {at_changes} N, elsewhere {elsewhere} N");
    }
}

/// Valid values with which turns fail: all, most while the key moves, and one in eight.
const HOSTILE: [&str; 3] = [
    "g=100 front=0.5 drop=0.015 shank=0.16 ms=0.0005 leads=0 t_lever=0 k_knuckle=1e7 \
     k_lever_pad=0 wind_k=1e-6 b_jack=1",
    "g=0 front=0.5 dip=0.02 string_height=0.035 button=0.07 jw=1e-7 jl=1e-8 t_jack=0 \
     k_knuckle=100 b_knuckle=0 loss_string=20 Ks=1000 wind_k=1e-6 lag=1e-6 b_hammer=0 \
     cap_pre=0.002",
    "front=0.1 js=1e-7 leads=0 jw=1e-7 jl=0.0001 k_knuckle=1e7 k_lever_pad=0 k_screw=1e12 \
     k_bed=0 k_check=0 Ks=1000 wind_c=0.01 b_lever=0 rail_pre=0.002 cap_pre=-0.002",
];

const HOSTILE_KEY: usize = 39;

fn hostile(scene: &Scene, values: &str) -> BoxedVoice {
    let mut voice = scene.keys[HOSTILE_KEY].clone().expect("a voice");
    let parameters = &voice.model.parameters;
    for (name, value) in values.split(' ').filter_map(|it| it.split_once('=')) {
        let value: f64 = value.parse().expect("a number");
        let index = parameters.iter().position(|it| it.name == name).expect("a parameter");
        let (min, max) = parameters[index].range;
        assert!((min..=max).contains(&value), "{name} = {value}");
        voice.values[index] = value;
    }
    VoiceBuilder::new(scene).expect("a rate").voice(&voice, Arc::default()).expect("a voice")
}

#[derive(Default)]
struct TurnLog(Vec<[(u64, VoiceWork, Option<VoiceFault>); KEYS]>);

impl TickObserver for &mut TurnLog {
    fn observe(&mut self, seen: &FinishedTick<'_>) {
        let turn = |key: usize| {
            let turn = &seen.turns[key];
            (turn.force.to_bits(), turn.work, turn.fault)
        };
        self.0.push(std::array::from_fn(turn));
    }
}

fn turns(scene: &Scene, unit: f64, values: &str) -> TurnLog {
    let mut keybed = keybed(scene);
    play_all(&mut keybed, END);
    let mut playing = voices(scene);
    playing[HOSTILE_KEY].1 = hostile(scene, values);
    let mut log = TurnLog::default();
    let mut stage = Stage::playing(scene, playing, keybed, 1).watched_by(&mut log);
    stage.lanes.set_constant_cost(unit);
    for _ in 0..TICKS * u64::from(scene.tick_hz) / 1000 {
        stage.tick();
    }
    drop(stage);
    log
}

/// A key with failing turns costs at most a tenth of its lane's time, and is muted.
#[test]
fn a_failing_voice_gets_a_tenth_of_its_lane_and_its_neighbours_notice_nothing() {
    /// Cost of a unit on a usual processor (ns), and units in a lane's time of a tick.
    const UNIT: f64 = 500.0;
    const LANE: u32 = 1800;
    // RK4 takes as many steps as the values ask for.
    let scene = scene("default", &[("render.stepper", "rk4")]);
    let whole = turns(&scene, UNIT, "");
    let healthy = whole.0.iter().flatten();
    assert!(healthy.clone().all(|(.., fault)| fault.is_none()), "a voice of ours was cut off");
    let most = healthy.map(|(_, work, _)| work.units).max().expect("turns");
    assert!((30..LANE / 10).contains(&most), "the default instrument takes {most} units in a tick");
    for values in HOSTILE {
        let beside = turns(&scene, UNIT, values);
        let of_key: Vec<_> = beside.0.iter().map(|turns| turns[HOSTILE_KEY]).collect();
        let is_failed = |at: usize| !matches!(of_key[at].2, None | Some(VoiceFault::Muted));
        let failed: Vec<_> = (0..of_key.len()).filter(|at| is_failed(*at)).collect();
        let muted = of_key.iter().position(|(.., fault)| *fault == Some(VoiceFault::Muted));
        let muted = muted.expect("it keeps failing");
        // A turn that gets through a quarter of its tick within a tenth of the time may be an
        // impact, so it gets a quarter of the time, once.
        let units = |at: &usize| of_key[*at].1.units;
        let first = units(failed.first().expect("it keeps failing"));
        let allowed = if values == HOSTILE[0] { LANE / 10 } else { LANE / 4 };
        let is_cut_off = values != HOSTILE[0] || 100 < first;
        assert!(is_cut_off && first <= allowed, "{first} of {LANE} units");
        let most = failed.iter().skip(1).map(units).max().expect("it keeps failing");
        assert!(most <= LANE / 10, "{most} of {LANE} units");
        assert!(failed.len() <= 4 && muted - failed[0] <= 50, "{failed:?}, muted in tick {muted}");
        for (tick, (expected, found)) in whole.0.iter().zip(&beside.0).enumerate() {
            for key in (0..KEYS).filter(|key| *key != HOSTILE_KEY) {
                assert_eq!(expected[key], found[key], "key {key} in tick {tick}");
            }
        }
    }
}

/// A processor half as quick as usual cuts off no voice of ours.
#[test]
fn a_hard_stroke_is_not_taken_for_a_failing_voice_on_a_slow_processor() {
    for hz in ["1000", "2000", "4000"] {
        let scene = scene("default", &[("tick_hz", hz)]);
        let log = turns(&scene, 1000.0, "");
        let failed = log.0.iter().flatten().filter(|(.., fault)| fault.is_some()).count();
        assert_eq!(failed, 0, "{hz} Hz");
    }
}
