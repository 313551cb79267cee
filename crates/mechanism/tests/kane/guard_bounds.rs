//! Bounds of the shipped models' guards over a step, against the guards along random steps.
//!
//! Steps are random cubics from random states: their properties hold for the dense output of any
//! method.

use instruments::equations::ModeNumber;
use pode::input::Cubic;
use pode::{GuardSpec, Guarded as _, Model as _, Signal as _};

use crate::kane::bounds::{Motions, SQUARE, seen};
use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{Runnable, ShippedModel, built_in, modes};
use crate::kane::stroke::still;

const N: usize = 4;

type Model = Runnable<N>;

#[derive(Clone, Copy)]
enum Steps {
    /// Anything within the ranges; every other term is left out, so that each is alone at times.
    Any,
    /// Steps as in playing: all entries move, none of them wildly.
    Played,
}

fn step(model: &Model, mode: ModeNumber, steps: Steps, numbers: &mut Numbers) -> Motions<N> {
    let (wildest, left_out) = match steps {
        Steps::Any => (0.7, 0.5),
        Steps::Played => (-0.5, 0.0),
    };
    let wild = 10.0_f64.powf(numbers.between(-2.0, wildest));
    let part = |numbers: &mut Numbers| {
        let part = numbers.between(-0.5, 1.0);
        if numbers.between(0.0, 1.0) < left_out { 0.0 } else { part }
    };
    let h = 10.0_f64.powf(numbers.between(-4.3, -2.7));
    let span = 0.01 * model.input_per_metre();
    let c = [1.0, 100.0 * h * wild, 1e4 * h * h * wild, 1e6 * h * h * h * wild];
    let driven = c.map(|c| span * c * part(numbers));
    let input = Cubic::new(driven, h);
    let mut x = model.at_rest(&still(input.at(0.0).position)).1;
    let states = model.table().states.len();
    for entry in &mut x[..states] {
        *entry += 0.05 * wild * numbers.next();
    }
    let x = model.constrain(mode, &x, &input.at(0.0));
    let mut terms = [x; 4];
    for (power, term) in (1..).zip(&mut terms[1..]) {
        for (index, entry) in term[..states].iter_mut().enumerate() {
            let fast = if index < model.coordinates() { 1.0 } else { 30.0 };
            *entry = fast * wild * (100.0 * h).powi(power) * 0.01 * part(numbers);
        }
    }
    Motions::new(h, terms, driven)
}

struct Found {
    seen: [f64; 2],
    allowed: [f64; 2],
    rounding: [f64; 2],
}

fn follow((model, mode): (&Model, ModeNumber), guard: &GuardSpec, step: &Motions<N>) -> Found {
    let bound = model.guard_bound(mode, guard.id, &step.enclosure());
    let [moved, bent, size] = seen(&step.values(model, mode, guard.id));
    let rounding = 1e-14 * (size + guard.scale);
    Found {
        seen: [moved, bent],
        allowed: [bound.moves, bound.bend],
        rounding: [rounding, rounding * 4.0 * SQUARE],
    }
}

/// Returns a preset's model with each value times a random factor; a spread of 0 keeps the preset.
fn varied(
    shipped: &ShippedModel,
    (preset, key, spread): (usize, u8, f64),
    numbers: &mut Numbers,
) -> Model {
    let mut values = shipped.values(preset, key);
    for (value, parameter) in values.iter_mut().zip(&shipped.table.parameters) {
        let (low, high) = parameter.range;
        let varied = *value * spread.mul_add(numbers.between(-0.9, 2.0), 1.0);
        *value = varied.max(low).min(high);
    }
    shipped.valued(&values)
}

fn every_guard(
    shipped: &ShippedModel,
    sample: (usize, Steps),
    spreads: &[f64],
    mut check: impl FnMut(&str, &Found),
) {
    let mut numbers = Numbers::new(71);
    for (preset, table) in shipped.table.presets.iter().enumerate() {
        let sets = [0, 87].into_iter().flat_map(|key| spreads.iter().map(move |it| (key, *it)));
        for (key, spread) in sets {
            let model = varied(shipped, (preset, key, spread), &mut numbers);
            every_step(&model, table.name, sample, &mut numbers, &mut check);
        }
    }
}

fn every_step(
    model: &Model,
    preset: &str,
    (n, steps): (usize, Steps),
    numbers: &mut Numbers,
    check: &mut impl FnMut(&str, &Found),
) {
    let guards = |(mode, name)| model.guards(mode).iter().map(move |guard| (mode, name, guard));
    for (mode, name, guard) in modes(model).flat_map(guards) {
        let label = format!("{} {preset} {name} {}", model.table().name, guard.name);
        for _ in 0..n {
            let step = step(model, mode, steps, numbers);
            check(&label, &follow((model, mode), guard, &step));
        }
    }
}

#[test]
fn no_guard_goes_or_bends_further_than_its_bound() {
    built_in().into_iter().for_each(bounds_hold);
}

fn bounds_hold(shipped: &ShippedModel) {
    let spreads = [0.0, 0.2, 1.0, 1.0, 1.0];
    every_guard(shipped, (200, Steps::Any), &spreads, |label, found| {
        for (what, i) in [("moves", 0), ("bend", 1)] {
            let (seen, allowed) = (found.seen[i], found.allowed[i]);
            // NaN makes no claim and passes.
            let breaks = seen > allowed * (1.0 + 1e-9) + found.rounding[i];
            assert!(!breaks, "{label}: {what} {seen:e}, allowed {allowed:e}");
        }
    });
}

#[test]
fn bounds_are_not_much_wider_than_what_guards_do() {
    built_in().into_iter().for_each(bounds_are_tight);
}

/// Guards that read the input's acceleration: their bend would need its second derivative.
const WITHOUT_BEND: [&str; 2] = ["key-hammer-rigid A1 release", "bouncing-ball rest lift"];

/// Most of the steps allow less than four times the observed bend: sums of magnitudes ignore
/// cancellation, and random motions cancel somewhat.
fn bounds_are_tight(shipped: &ShippedModel) {
    const FACTOR: f64 = 4.0;
    let mut ratios: Vec<(String, [Vec<f64>; 2])> = Vec::new();
    every_guard(shipped, (200, Steps::Played), &[0.0], |label, found| {
        if ratios.last().is_none_or(|it| it.0 != label) {
            ratios.push((label.to_owned(), [Vec::new(), Vec::new()]));
        }
        let (_, lists) = ratios.last_mut().expect("a guard");
        for (i, list) in lists.iter_mut().enumerate() {
            if found.seen[i] > found.rounding[i] {
                list.push(found.allowed[i] / found.seen[i]);
            }
        }
    });
    for (label, lists) in &mut ratios {
        let [moves, bend] = lists.each_mut().map(|list| median(list));
        assert!(moves < FACTOR, "{label}: moves {moves}");
        let mut parts = label.split(' ');
        let (model, _, rest) = (parts.next(), parts.next(), parts.collect::<Vec<_>>().join(" "));
        let named = format!("{} {rest}", model.expect("a name"));
        let is_free = WITHOUT_BEND.contains(&named.as_str());
        assert!(is_free || bend < FACTOR, "{label}: bend {bend}");
    }
}

fn median(list: &mut [f64]) -> f64 {
    list.sort_by(f64::total_cmp);
    list.get(list.len() / 2).copied().unwrap_or(0.0)
}
