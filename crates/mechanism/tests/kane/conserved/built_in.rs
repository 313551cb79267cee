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

#[test]
fn without_losses_no_mode_of_model_c_dissipates() {
    let mut derived = Derived::built_in("reduced_grand", 0);
    for loss in ["b1", "ck", "ch", "Fc", "ab", "ar", "nu", "cr", "mus"] {
        derived.set(loss, 0.0);
    }
    let mut numbers = Numbers::new(32);
    for (number, mode) in derived.system.modes.iter().enumerate() {
        for _ in 0..10 {
            let (state, input) = somewhere(&derived, number, &mut numbers);
            let lost = derived.one(mode.balance.dissipated.expect("a power"), &state, input);
            close(lost, 0.0, 1e-12, &format!("mode {number}"));
        }
    }
}
