//! The calibration feel has no body: its force in closed form.

use crate::evaluation::{Derived, Numbers, close};

/// K depth + B s' beyond the wall, never a pull; nothing before it.
#[test]
fn a_spring_behind_a_wall_pushes_by_its_law() {
    let derived = Derived::built_in("spring_wall", 0);
    let [k, b, wall] = ["K", "B", "wall"].map(|name| derived.value_of(name));
    let mut numbers = Numbers::new(41);
    let mut pulls = 0;
    for _ in 0..50 {
        let input = [wall + 0.002 * numbers.next(), 3.0 * numbers.next(), numbers.next(), 0.0];
        let law = k * (input[0] - wall) + b * input[1];
        pulls += usize::from(law < 0.0);
        for (mode, force) in [(0, 0.0), (1, law.max(0.0))] {
            let mode = &derived.system.modes[mode];
            let readout = derived.one(mode.readout.expect("a readout"), &[], input);
            close(readout, force, 1e-14, "readout");
            let outputs = derived.all(&mode.outputs[..2], &[], input);
            close(outputs[0], force, 1e-14, "F");
            close(outputs[1], input[0] - wall, 1e-14, "depth");
        }
    }
    assert!((5..45).contains(&pulls), "{pulls} of 50 would pull");
}
