//! scratch
use haptics::*;
use hardware::sim::key::SimulatedKey;
use host::adapters::{input::*, voice::*};
use host::rehearsal::RehearsedKey;
use models::*;
use performance::*;
use scheduler::time::Period;
use std::sync::Arc;
fn main() {
    let hz: u32 = std::env::args().nth(1).map_or(1000, |s| s.parse().unwrap());
    let sets: Vec<String> = std::env::args().skip(2).collect();
    let period = Period::from_hz(hz).unwrap();
    let h = period.as_secs_f64();
    let mut v: Vec<f64> = (0..17).map(|i| (KeyHammerSprings::PRESETS[2].value)(i, std::env::var("KEY").map_or(39, |s| s.parse().unwrap()))).collect();
    for s in sets { let (a, b) = s.split_once('=').unwrap(); let i = KeyHammerSprings::PARAMETERS.iter().position(|p| p.name == a).unwrap(); v[i] = b.parse().unwrap(); }
    let m = KeyHammerSprings::with_values(&v);
    println!("longest {:?}", pode::Model::longest_step(&m, key_hammer_springs::Mode::B1));
    let rig = RigParameters::default();
    let key = SimulatedKey::new(h, rig).unwrap();
    let voice = RenderedKey::new(m, pode::stepper::Rk4, Fittings {
        input: InputPath::new(AnyEstimator::Kalman(Kalman::new(h, 1e-6, Kalman::KEY_JERK_DENSITY)), None, m.input_per_metre(), h),
        gate: ForceGate::new(30.0, 2e4).unwrap(), limits: pode::Limits::default(), cell: Arc::default(), h });
    let k0 = RehearsedKey::new(39, key, Box::new(voice), period);
    for touch in [Touch::Pressed, Touch::Struck] {
    for i in 0..22 {
        let speed = 0.02 * 1.3f64.powi(i);
        let g = Gesture { start: 0.1, release: 1.0, touch, speed, hold: Gesture::HOLD };
        let mut k = k0.clone();
        let o = k.play(&[g], 2.0);
        print!("{touch:?} {speed:.3}: ");
        for s in &o.strikes { print!("({:.4} {:.3}) ", s.at, s.speed); }
        println!(" fall {:?}", o.damper_fall);
    }}
}
