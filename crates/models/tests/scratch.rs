mod stroke;
use models::{Described as _, KeyHammerSprings};
use pode::Motion;
use stroke::{preset, run, still};
fn press(duration: f64, t: f64, over: f64) -> Motion {
    let z = (t / duration).clamp(0.0, 1.0);
    let bottom = 0.01016 / 0.2595*over;
    let powers = |a: f64, b: f64, c: f64| bottom * (a + z * (b + z * c));
    let r = 1.0 / duration;
    Motion { position: powers(10.0, -15.0, 6.0) * z * z * z, rate: powers(30.0, -60.0, 30.0) * z * z * r,
        acceleration: powers(60.0, -180.0, 120.0) * z * r * r, jerk: if z < 1.0 { powers(60.0, -360.0, 360.0) * r * r * r } else { 0.0 } }
}
#[test]
fn scratch() {
    for over in [1.0, 1.15] { for c2 in [1.0, 3.0, 10.0, 30.0] { for d in [0.12,0.05, 0.03] {
        let model: KeyHammerSprings = preset("playable", 39, &[("c2", c2)]);
        let (books, sim) = run(model, model.at_rest(&still(0.0)), (1e-3, 3.0), |t| press(d, t, over));
        let v = books.events.iter().find(|e| e.name=="string").map(|e| 0.13*e.before.1[2]);
        let peak = books.ticks.iter().map(|t| t.mean_readout/0.2595).fold(0.0, f64::max);
        println!("over {over} c2 {c2} d {d}: v {v:?} events {} last {:.3} peak {peak:.2} N  spread {:?} {:?}", books.events.len(), books.events.last().map_or(0.0, |e| e.t), sim.state(), &books.names()[..books.events.len().min(6)]);
    }}}
}
