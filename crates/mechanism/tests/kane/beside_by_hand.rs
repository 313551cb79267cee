//! Models A, B and C against their equations by hand: every mode, guard and reset.

use std::collections::BTreeMap;

use instruments::equations::ModeNumber;
use pode::{Energetic as _, Fires, GuardSpec, Guarded as _, Model as _, Motion, Resets as _};

use crate::kane::by_hand_models::{ByHand, Grand, Rigid, Springs, Values};
use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{
    self, GRAND, RIGID, Runnable, SPRINGS, ShippedModel, mode_name, modes,
};

/// Allowed difference, relative to the value and to the terms of its sum.
const AGREEMENT: f64 = 1e-12;
/// Random states in each mode, for each set of values.
const PLACES: usize = 200;

/// Middle and half width of each entry of random states; half widths of the input and its rates.
struct Span<const N: usize> {
    state: [(f64, f64); N],
    input: [(f64, f64); 4],
}

impl<const N: usize> Span<N> {
    fn random(&self, numbers: &mut Numbers) -> ([f64; N], Motion) {
        let mut draw = |(middle, half): (f64, f64)| middle + half * numbers.next();
        let x = self.state.map(&mut draw);
        let [position, rate, acceleration, jerk] = self.input.map(draw);
        (x, Motion { position, rate, acceleration, jerk })
    }
}

struct Pair<W, const N: usize> {
    label: String,
    described: Runnable<N>,
    by_hand: W,
    span: fn(&str) -> Span<N>,
}

#[track_caller]
fn close(found: f64, expected: f64, size: f64, what: std::fmt::Arguments<'_>) {
    let bound = AGREEMENT * size.max(expected.abs()).max(1.0);
    assert!((found - expected).abs() <= bound, "{what}: {found} is not {expected}");
}

impl<W: ByHand<N>, const N: usize> Pair<W, N> {
    fn compare_all(&self, numbers: &mut Numbers) {
        for (mode, name) in modes(&self.described) {
            for _ in 0..PLACES {
                let (x, s) = (self.span)(name).random(numbers);
                let x = self.placed(mode, &x, &s);
                self.compare(mode, &x, &s);
                self.compare_guards(mode, &x, &s);
            }
            self.compare_resets(mode, numbers);
        }
    }

    /// Compares entries that the mode slaves, and returns the state with them.
    fn placed(&self, mode: ModeNumber, x: &[f64; N], s: &Motion) -> [f64; N] {
        let name = mode_name(&self.described, mode);
        let placed = self.described.constrain(mode, x, s);
        for (i, expected) in self.by_hand.constrain(name, x, s).into_iter().enumerate() {
            let what = format_args!("{} {name}: entry {i} in its place", self.label);
            close(placed[i], expected, x[i], what);
        }
        placed
    }

    fn compare(&self, mode: ModeNumber, x: &[f64; N], s: &Motion) {
        let name = mode_name(&self.described, mode);
        let (found, expected) = (&self.described, &self.by_hand);
        let check = |a: f64, b: f64, of: &str| {
            close(a, b, 1.0, format_args!("{of} of {} {name} at {x:?}, {s:?}", self.label));
        };
        let [rates, wanted] = [found.derivative(mode, x, s), expected.derivative(name, x, s)];
        let moves = |entry| found.parts(mode).iter().any(|part| part.has(entry));
        for i in (0..N).filter(|i| moves(*i)) {
            check(rates[i], wanted[i], &format!("derivative {i}"));
        }
        check(found.readout(mode, x, s), expected.readout(name, x, s), "readout");
        let balance = expected.balance(name, x, s);
        check(found.energy(mode, x, s), balance.energy, "energy");
        check(found.supplied(mode, x, s), balance.supplied, "supplied");
        check(found.dissipated(mode, x, s), balance.dissipated, "dissipated");
        for (output, value) in expected.outputs(name, x, s) {
            check(runnable::output(found, mode, (x, s), output), value, output);
        }
    }

    fn compare_guards(&self, mode: ModeNumber, x: &[f64; N], s: &Motion) {
        let name = mode_name(&self.described, mode);
        let mut specs = self.described.guards(mode).to_vec();
        specs.sort_by_key(|it| it.priority);
        let wanted = self.by_hand.guards(name, x, s);
        let names: Vec<_> = specs.iter().map(|it| it.name).collect();
        let in_order: Vec<_> = wanted.iter().map(|it| it.0).collect();
        assert_eq!(names, in_order, "{} {name}: those that fire at once", self.label);
        for (spec, (_, expected)) in specs.iter().zip(wanted) {
            let is_crossing = ["string", "check"].contains(&spec.name);
            assert_eq!(spec.fires == Fires::OnCrossing, is_crossing, "{} {name}", self.label);
            let found = self.described.guard(mode, spec.id, x, s);
            let what = format_args!("{} {name} {} at {x:?}, {s:?}", self.label, spec.name);
            let sum = expected.value.abs().max(spec.scale);
            close(found.value, expected.value, sum, what);
            close(found.rate, expected.rate, sum.max(expected.rate.abs()), what);
        }
    }

    fn compare_resets(&self, mode: ModeNumber, numbers: &mut Numbers) {
        let name = mode_name(&self.described, mode);
        let span = (self.span)(name);
        for guard in self.described.guards(mode) {
            let pairs = (0..PLACES).map(|_| [span.random(numbers), span.random(numbers)]);
            let zeros: Vec<_> = pairs.filter_map(|pair| self.zero(mode, guard, pair)).collect();
            for (x, s) in &zeros {
                self.compare_reset(mode, guard, x, s);
            }
            assert!(!zeros.is_empty(), "{} {name}: {} never fires", self.label, guard.name);
        }
    }

    fn zero(
        &self,
        mode: ModeNumber,
        guard: &GuardSpec,
        [a, b]: [([f64; N], Motion); 2],
    ) -> Option<([f64; N], Motion)> {
        let between = |t: f64| {
            let mix = |a: f64, b: f64| a + t * (b - a);
            let x = std::array::from_fn(|i| mix(a.0[i], b.0[i]));
            let s = Motion {
                position: mix(a.1.position, b.1.position),
                rate: mix(a.1.rate, b.1.rate),
                acceleration: mix(a.1.acceleration, b.1.acceleration),
                jerk: mix(a.1.jerk, b.1.jerk),
            };
            (self.described.constrain(mode, &x, &s), s)
        };
        let value = |t: f64| {
            let (x, s) = between(t);
            self.described.guard(mode, guard.id, &x, &s).value
        };
        let (mut above, mut below) = if value(0.0) > 0.0 { (0.0, 1.0) } else { (1.0, 0.0) };
        if value(above) <= 0.0 || value(below) > 0.0 {
            return None;
        }
        for _ in 0..100 {
            let middle = 0.5 * (above + below);
            *(if value(middle) > 0.0 { &mut above } else { &mut below }) = middle;
        }
        let (x, s) = between(below);
        (self.described.guard(mode, guard.id, &x, &s).rate < 0.0).then_some((x, s))
    }

    fn compare_reset(&self, mode: ModeNumber, guard: &GuardSpec, x: &[f64; N], s: &Motion) {
        let (model, name) = (&self.described, mode_name(&self.described, mode));
        let what = format!("{} {name} {} at {x:?}, {s:?}", self.label, guard.name);
        let found = model.reset(mode, guard.id, x, s);
        let expected = self.by_hand.reset(name, guard.name, x, s);
        assert_eq!(mode_name(model, found.mode), expected.mode, "{what}");
        // The next mode sets its slaved entries.
        let placed = model.constrain(found.mode, &found.state, s);
        let wanted = self.by_hand.constrain(expected.mode, &expected.state, s);
        for (found, expected) in placed.iter().zip(wanted) {
            close(*found, expected, 1.0, format_args!("{what} resets"));
        }
        close(found.impulse, expected.impulse, 1.0, format_args!("{what} gives"));
        let sounds = model.sounding(guard.id, x);
        assert_eq!(sounds.is_some(), expected.sounds.is_some(), "{what} sounds");
        let (sounds, wanted) = (sounds.unwrap_or(0.0), expected.sounds.unwrap_or(0.0));
        close(sounds, wanted, 1.0, format_args!("{what} sounds"));
    }
}

fn unlike_any_preset(name: &str, value: f64) -> f64 {
    match name {
        "b1" => value + 0.3,
        "c2" => value + 0.2,
        "restitution" => 0.6,
        _ => value,
    }
}

fn check<W: ByHand<N>, const N: usize>(shipped: &ShippedModel, span: fn(&str) -> Span<N>) {
    let mut numbers = Numbers::new(17);
    let table = shipped.table;
    for (index, preset) in table.presets.iter().enumerate() {
        for key in [0, 44, 87] {
            let mut values = shipped.values(index, key);
            let names = || table.parameters.iter().map(|it| it.name);
            // Losses unlike those of any preset, for a key in the middle.
            for (name, value) in names().zip(&mut values).filter(|_| key == 44) {
                *value = unlike_any_preset(name, *value);
            }
            let described = shipped.valued(&values);
            let by_name: BTreeMap<_, _> = names().zip(values).collect();
            let by_hand = W::new(Values(by_name));
            let label = format!("{} {} {key}", table.name, preset.name);
            Pair { label, described, by_hand, span }.compare_all(&mut numbers);
        }
    }
}

#[test]
fn the_described_model_a_has_the_equations_by_hand() {
    check::<Rigid, 2>(&RIGID, |_| Span {
        state: [(0.1, 0.4), (0.0, 5.0)],
        input: [(0.02, 0.03), (0.0, 0.5), (-9.0, 30.0), (0.0, 10.0)],
    });
}

#[test]
fn the_described_model_b_has_the_equations_by_hand() {
    check::<Springs, 4>(&SPRINGS, |_| Span {
        state: [(0.1, 0.4), (0.05, 0.3), (0.0, 5.0), (0.0, 3.0)],
        input: [(0.05, 0.3), (0.0, 2.0), (0.0, 10.0), (0.0, 10.0)],
    });
}

#[test]
fn the_described_model_c_has_the_equations_by_hand() {
    check::<Grand, 4>(&GRAND, |mode| Span {
        // Let-off ends at 8.9 mm, beyond which its polynomials are invalid.
        state: [
            if mode == "LO" { (0.0085, 0.0008) } else { (0.005, 0.007) },
            (0.025, 0.03),
            (0.0, 0.5),
            (0.0, 4.0),
        ],
        input: [(0.005, 0.01), (0.0, 0.5), (0.0, 10.0), (0.0, 10.0)],
    });
}
