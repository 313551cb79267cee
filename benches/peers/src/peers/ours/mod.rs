//! `pode` with model B as it ships, and with models written for it, as a user writes them.
//!
//! **To add a method**: a line in [`by_tick`] if its step is the tick or a part of it, in
//! [`by_tolerance`] if it chooses its steps and the tick is the whole run. A method with its own
//! loop: a file in this folder and a line in [`entries`].

mod shipped;
mod ticks;
mod written;

pub(crate) use shipped::shipped;
pub(crate) use written::Written;

use std::hint::black_box;

use pode::stepper::{BogackiShampine, Controlled, Dop853, Exact, Rk4, Stepper, Tolerance};
use pode::{Limits, Model, Resets};

use crate::entry::{Entry, Run, STEPS, Setting, tolerances};

const CODE: &str = "pode";

/// A model of `pode` on a problem; the peers receive the same equations.
#[derive(Clone)]
pub(crate) struct Ours<M: Model, I> {
    pub(crate) model: M,
    pub(crate) input: I,
    pub(crate) start: (M::Mode, M::State),
}

pub(crate) fn entries<const N: usize, M, I>(ours: &Ours<M, I>, t_end: f64) -> Vec<Entry>
where
    M: Resets<State = [f64; N]> + Clone + 'static,
    I: Fn(f64) -> M::Input + Clone + 'static,
{
    let ticks = STEPS.into_iter().flat_map(|h| by_tick(ours, t_end, h));
    let tolerances = tolerances(13).flat_map(|tolerance| by_tolerance(ours, t_end, tolerance));
    let (mode, _) = ours.start;
    let nature = ours.model.nature(mode);
    let is_resolved = nature.longest_step.is_finite() || nature.is_linear();
    let whole = is_resolved.then(|| one_tick(ours, t_end)).into_iter().flatten();
    ticks.chain(tolerances).chain(whole).collect()
}

/// Runs in ticks of `h` (s), as a key does; 1 ms is the default.
fn by_tick<const N: usize, M, I>(ours: &Ours<M, I>, t_end: f64, h: f64) -> Vec<Entry>
where
    M: Resets<State = [f64; N]> + Clone + 'static,
    I: Fn(f64) -> M::Input + Clone + 'static,
{
    let entry = |method, run| Entry {
        code: CODE,
        method,
        setting: Setting::Best("sweep"),
        knob: h,
        note: "the knob is the tick; the exact input at the stages",
        run,
    };
    let limits = Limits::default();
    let mut rows = vec![
        entry("RK4", run(ours, Rk4, limits, h, t_end)),
        entry("Bogacki–Shampine", run(ours, BogackiShampine, limits, h, t_end)),
        entry("exact flow", run(ours, Exact, limits, h, t_end)),
    ];
    if (h - 1e-3).abs() < 1e-12 {
        let run = run(ours, Rk4, limits, h, t_end);
        rows.push(Entry { setting: Setting::Default, ..entry("RK4", run) });
    }
    rows
}

/// Runs in one tick from start to end, with steps as long as `tolerance` allows.
fn by_tolerance<const N: usize, M, I>(ours: &Ours<M, I>, t_end: f64, tolerance: f64) -> Vec<Entry>
where
    M: Resets<State = [f64; N]> + Clone + 'static,
    I: Fn(f64) -> M::Input + Clone + 'static,
{
    let method = Controlled { method: Dop853, tolerance: Tolerance::both(tolerance) };
    vec![Entry {
        code: CODE,
        method: "Dormand–Prince 8(5,3)",
        setting: Setting::Best("sweep"),
        knob: tolerance,
        note: "one tick, steps by the tolerance",
        run: run(ours, method, offline(), t_end, t_end),
    }]
}

/// Runs in one tick: with the exact flow where a mode is linear, and with RK4 (exact on parabolas).
fn one_tick<const N: usize, M, I>(ours: &Ours<M, I>, t_end: f64) -> [Entry; 2]
where
    M: Resets<State = [f64; N]> + Clone + 'static,
    I: Fn(f64) -> M::Input + Clone + 'static,
{
    let entry = |method, note, run| Entry {
        code: CODE,
        method,
        setting: Setting::Best("one tick"),
        knob: t_end,
        note,
        run,
    };
    let exact = run(ours, Exact, offline(), t_end, t_end);
    let rk4 = run(ours, Rk4, offline(), t_end, t_end);
    let note = "one tick; RK4 in steps of the model's longest where a mode is not linear";
    let longest = "one tick, in steps of the model's longest";
    [entry("exact flow", note, exact), entry("RK4", longest, rk4)]
}

fn offline() -> Limits {
    Limits {
        events: u32::MAX,
        followed: u32::MAX,
        guards: u32::MAX,
        pieces: u32::MAX,
        ..Limits::default()
    }
}

fn run<const N: usize, M, I, T>(
    ours: &Ours<M, I>,
    stepper: T,
    limits: Limits,
    h: f64,
    t_end: f64,
) -> Run
where
    M: Resets<State = [f64; N]> + Clone + 'static,
    I: Fn(f64) -> M::Input + Clone + 'static,
    T: Stepper + 'static,
{
    let ours = ours.clone();
    Box::new(move |log| ticks::run(black_box(&ours), (stepper, limits), h, black_box(t_end), log))
}
