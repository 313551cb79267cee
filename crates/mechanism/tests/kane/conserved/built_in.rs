use super::{Conserved, conserved};
use crate::kane::evaluation::{Derived, Numbers, close, imbalance};
use crate::kane::shipped::files;

/// dE/dt is the supplied less the dissipated power, in each mode of each description.
#[test]
fn every_description_accounts_for_its_energy() {
    let mut numbers = Numbers::new(31);
    let mut modes = 0;
    for file in files() {
        let text = std::fs::read_to_string(&file).expect("a description");
        let mut derived = Derived::described(&text, 0);
        for mode in 0..derived.system.modes.len() {
            for _ in 0..5 {
                let (state, input) = somewhere(&derived, mode, &mut numbers);
                let lost = imbalance(&mut derived, mode, &state, input);
                close(lost, 0.0, 1e-9, &format!("{} in mode {mode}", file.display()));
            }
            modes += 1;
        }
    }
    assert!(modes > 20, "{modes} modes");
}

/// Returns a valid state of the mode, near the guess of its rest.
fn somewhere(derived: &Derived, mode: usize, numbers: &mut Numbers) -> (Vec<f64>, [f64; 4]) {
    for _ in 0..1000 {
        let input = numbers.list::<4>().map(|it| 0.01 * it);
        let count = derived.system.coordinates;
        let guess = (0..derived.system.state.len()).map(|i| {
            // The linkage closes about these values; all other states are about 0.
            let name = derived.system.mechanism.name.as_str();
            let about = match (name, i) {
                ("linkage", 1) => 0.6,
                ("linkage", 2) => 1.3,
                _ => 0.0,
            };
            about + numbers.next() * if i < count { 0.02 } else { 0.5 }
        });
        let guess: Vec<_> = guess.collect();
        if let Some(state) = derived.near(mode, &guess, input) {
            return (state, input);
        }
    }
    panic!("no state of mode {mode} was found");
}

fn without_losses(folder: &str) -> Derived {
    let mut derived = Derived::built_in(folder, 0);
    let names: Vec<_> =
        derived.system.mechanism.parameters.iter().map(|it| it.name.clone()).collect();
    for name in names {
        match name.as_str() {
            "b" | "b1" | "c2" | "ck" | "ch" | "Fc" | "ab" | "ar" | "nu" | "cr" | "mus" => {
                derived.set(&name, 0.0);
            }
            "restitution" => derived.set(&name, 1.0),
            _ => {}
        }
    }
    derived
}

#[test]
fn without_losses_no_mode_of_model_c_dissipates() {
    let derived = without_losses("reduced_grand");
    let mut numbers = Numbers::new(32);
    for (number, mode) in derived.system.modes.iter().enumerate() {
        for _ in 0..10 {
            let (state, input) = somewhere(&derived, number, &mut numbers);
            let lost = derived.one(mode.dissipated.expect("a power"), &state, input);
            close(lost, 0.0, 1e-12, &format!("mode {number}"));
        }
    }
}

#[test]
fn a_hammer_in_flight_keeps_its_energy() {
    let mut derived = without_losses("key_hammer_rigid");
    derived.set("string_angle", 0.6);
    let [m2, l2, jh] = ["M2", "L2", "JH"].map(|name| derived.value_of(name));
    let energy = |[h, u]: &[f64; 2]| 0.5 * jh * u * u + m2 * 9.81 * l2 * h.sin();
    let quantities: &[(&str, Conserved<'_, 2>)] = &[("energy", &energy)];
    conserved(&derived, (1, [0.3, 3.0]), (0.0, 0.3), quantities);
}
