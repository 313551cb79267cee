mod coefficients;
mod motion;

use std::path::PathBuf;

use instruments::equations::ModeNumber;
use mechanism::kane::assemble::Program;
use mechanism::kane::derive_model;
use pode::series::{Expansion, INPUT_TERMS};
use pode::{Guarded as _, Model as _, Motion};

use crate::kane::evaluation::Numbers;
use crate::kane::runnable::{Runnable, ShippedModel};
use crate::kane::shipped::{Folder, files};

fn program(file: &PathBuf) -> Program {
    let text = std::fs::read_to_string(file).expect("a description");
    let model = derive_model(&file.display().to_string(), &text, &Folder);
    model.unwrap_or_else(|mistakes| panic!("{mistakes}")).program
}

fn named(name: &str) -> Program {
    let all = files().iter().map(program).find(|program| program.table.name == name);
    all.expect("a description of that name")
}

fn model<const N: usize>(program: &Program, preset: usize) -> Runnable<N> {
    let model = ShippedModel::of(program.clone());
    model.valued(&model.values(preset, 44))
}

/// Mode of a model near its rest, under a moving input, and its series.
struct Case<const N: usize> {
    model: Runnable<N>,
    mode: ModeNumber,
    index: usize,
    input: [Motion; INPUT_TERMS],
    series: Expansion<[f64; N]>,
}

const ORDER: usize = 16;

impl<const N: usize> Case<N> {
    /// Returns `None` where the mode has no series.
    fn new(model: Runnable<N>, index: usize, numbers: &mut Numbers) -> Option<Self> {
        let table = model.table();
        table.modes[index].series?;
        let mode = ModeNumber(u8::try_from(index).expect("a few modes"));
        // An eighth of a radian of the fastest motion at rest.
        let rate = model.nature(mode).rate.clamp(1.0, 1e6);
        let scale = 0.125 / rate;
        let mut input = [Motion::default(); INPUT_TERMS];
        let mut size = 0.02;
        for motion in input.iter_mut().take(5) {
            motion.position = size * numbers.next();
            size *= 0.3;
        }
        let now = motion_at(&input, scale, 0.0);
        let mut x = model.rest_pose(&now).state;
        for (at, entry) in x.iter_mut().enumerate().take(table.states.len()) {
            let size = if at < table.coordinates { 0.01 } else { 0.5 };
            *entry += size * numbers.next();
        }
        for _ in 0..4 {
            x = model.constrain(mode, &x, &now);
        }
        let mut series = Expansion::of(&x, ORDER, scale);
        assert!(model.series(mode, &input, &mut series), "{} has a series", table.name);
        Some(Self { model, mode, index, input, series })
    }

    fn states(&self) -> usize {
        self.model.table().states.len()
    }

    fn name(&self) -> String {
        let table = self.model.table();
        format!("{} {}", table.name, table.modes[self.index].name)
    }

    fn at(&self, tau: f64) -> [[f64; N]; 2] {
        let series = &self.series;
        let terms = |entry: usize| (0..=ORDER).map(move |k| series.terms[k][entry]);
        let value = |entry| terms(entry).rev().fold(0.0, |sum, term| term + tau * sum);
        let rate = |entry| {
            let terms = terms(entry).enumerate().skip(1).map(|(k, term)| k as f64 * term);
            let terms: Vec<f64> = terms.collect();
            terms.iter().rev().fold(0.0, |sum, term| term + tau * sum) / series.scale
        };
        [std::array::from_fn(value), std::array::from_fn(rate)]
    }
}

fn motion_at(input: &[Motion; INPUT_TERMS], scale: f64, tau: f64) -> Motion {
    let mut terms: Vec<f64> = input.iter().map(|it| it.position).collect();
    let mut next = || {
        let value = terms.iter().rev().fold(0.0, |sum, term| term + tau * sum);
        let rates = terms.iter().enumerate().skip(1).map(|(k, term)| k as f64 * term / scale);
        terms = rates.collect();
        value
    };
    Motion { position: next(), rate: next(), acceleration: next(), jerk: next() }
}

/// Calls `check` with a few cases of every mode of every description with a series.
fn each(mut check: impl FnMut(&Program, &Case<12>)) -> usize {
    let mut numbers = Numbers::new(16);
    let mut modes = 0;
    for program in files().iter().map(program).filter(|it| it.table.contacts.is_empty()) {
        for preset in 0..program.table.presets.len() {
            let model = model::<12>(&program, preset);
            for index in 0..program.table.modes.len() {
                let of_mode = (0..3).filter_map(|_| Case::new(model, index, &mut numbers));
                let count = of_mode.inspect(|case| check(&program, case)).count();
                modes += usize::from(count > 0 && preset == 0);
            }
        }
    }
    modes
}
