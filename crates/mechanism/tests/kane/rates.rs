//! Rates of guards and slopes of readouts against differences, in every mode of shipped models.

use instruments::equations::ModeNumber;
use pode::{Guarded as _, Model as _, Motion, Sloped as _, differenced_slopes};

use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{Runnable, ShippedModel, built_in, modes};

/// Random states in each mode, for each preset.
const PLACES: usize = 100;

/// Time between the five points of a difference (s).
const H: f64 = 1e-7;

/// Returns a state about 5 mm of the key around its rest, and an input that moves.
fn somewhere(model: &Runnable<4>, mode: ModeNumber, numbers: &mut Numbers) -> ([f64; 4], Motion) {
    let size = 5e-3 * model.input_per_metre();
    let [position, rate, acceleration, jerk] =
        [1.0, 100.0, 2e3, 2e3].map(|it| it * size * numbers.next());
    let input = Motion { position, rate, acceleration, jerk };
    let mut x = model.at_rest(&input).1;
    for (at, entry) in x.iter_mut().enumerate().take(model.table().states.len()) {
        *entry += size * numbers.next() * if at < model.coordinates() { 1.0 } else { 100.0 };
    }
    (model.constrain(mode, &x, &input), input)
}

/// Compares each guard's rate in `mode` with the change of its value along the motion.
fn check_rates(model: &Runnable<4>, mode: ModeNumber, (x, s): ([f64; 4], Motion)) {
    let dx = model.derivative(mode, &x, &s);
    for spec in model.guards(mode) {
        let value = |t: f64| {
            let there = core::array::from_fn(|i| x[i] + t * dx[i]);
            let input = Motion {
                position: s.position + t * s.rate,
                rate: s.rate + t * s.acceleration,
                acceleration: s.acceleration + t * s.jerk,
                ..s
            };
            model.guard(mode, spec.id, &model.constrain(mode, &there, &input), &input).value
        };
        let seen = (8.0 * (value(H) - value(-H)) - (value(2.0 * H) - value(-2.0 * H))) / (12.0 * H);
        let guard = model.guard(mode, spec.id, &x, &s);
        // Rounding of a value over H, and of its terms.
        let bound = 1e-6 * guard.rate.abs() + 1e-8 * (guard.value.abs() + spec.scale);
        let off = (seen - guard.rate).abs();
        assert!(off < bound, "{}: {} is not {seen}, {s:?}", spec.name, guard.rate);
    }
}

/// Compares the readout's slopes with its differences, which have six correct digits.
fn check_slopes(model: &Runnable<4>, mode: ModeNumber, (x, s): ([f64; 4], Motion)) {
    let found = model.slopes(mode, &x, &s);
    let rough = differenced_slopes(model, mode, &x, &s);
    let pairs = [(found.per_position, rough.per_position), (found.per_rate, rough.per_rate)];
    for (found, rough) in pairs {
        let bound = 1e-5 * rough.abs().max(1.0);
        assert!((found - rough).abs() < bound, "{mode:?}: {found}, not {rough}, {x:?} {s:?}");
    }
}

fn check(shipped: &ShippedModel) {
    let mut numbers = Numbers::new(17);
    for preset in 0..shipped.table.presets.len() {
        let model = shipped.valued::<4, 256>(&shipped.values(preset, 44));
        for (mode, _) in modes(&model) {
            for _ in 0..PLACES {
                let place = somewhere(&model, mode, &mut numbers);
                check_rates(&model, mode, place);
                check_slopes(&model, mode, place);
            }
        }
    }
}

#[test]
fn guards_change_at_their_rates_and_readouts_by_their_slopes() {
    built_in().into_iter().for_each(check);
}
