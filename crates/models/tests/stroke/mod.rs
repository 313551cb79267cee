//! Runs a model under an exact input, and keeps its books.
#![allow(
    dead_code,
    unreachable_pub,
    clippy::disallowed_methods,
    clippy::expect_used,
    reason = "each test file uses its own part, on the heap"
)]

use models::{Described, Preset};
use pode::stepper::Rk4;
use pode::{
    Advance, EnergyAudit, Event, EventCause, Limits, Motion, Piece, Signal, Simulator, Watch,
};

/// s(t) = Σ A exp(−((t − tc)/w)²) with its derivatives.
pub fn bells(bells: &[[f64; 3]], t: f64) -> Motion {
    let mut motion = Motion::default();
    for [a, tc, w] in bells {
        let z = (t - tc) / w;
        let bell = a * (-z * z).exp();
        motion.position += bell;
        motion.rate += bell * (-2.0 * z) / w;
        motion.acceleration += bell * (4.0 * z * z - 2.0) / (w * w);
        motion.jerk += bell * (12.0 * z - 8.0 * z * z * z) / (w * w * w);
    }
    motion
}

/// s(t) = Σ A (1 + tanh((t − tc)/w))/2 with its derivatives.
pub fn presses(presses: &[[f64; 3]], t: f64) -> Motion {
    let mut motion = Motion::default();
    for [a, tc, w] in presses {
        let tanh = ((t - tc) / w).tanh();
        let slope = 0.5 * a * (1.0 - tanh * tanh) / w;
        motion.position += 0.5 * a * (1.0 + tanh);
        motion.rate += slope;
        motion.acceleration += slope * (-2.0 * tanh) / w;
        motion.jerk += slope * (6.0 * tanh * tanh - 2.0) / (w * w);
    }
    motion
}

/// s(t) = A sin ωt with its derivatives.
pub fn sine(amplitude: f64, omega: f64, t: f64) -> Motion {
    let (sin, cos) = (omega * t).sin_cos();
    Motion {
        position: amplitude * sin,
        rate: amplitude * omega * cos,
        acceleration: -amplitude * omega * omega * sin,
        jerk: -amplitude * omega.powi(3) * cos,
    }
}

/// An input that does not move.
pub fn still(position: f64) -> Motion {
    Motion { position, ..Motion::default() }
}

/// What happened at one event.
#[derive(Clone, Debug)]
pub struct Seen<M: Described> {
    pub t: f64,
    pub name: &'static str,
    pub before: (M::Mode, M::State),
    pub after: (M::Mode, M::State),
    pub input: Motion,
    pub impulse: f64,
}

/// The events and the energy of a run.
#[derive(Debug)]
pub struct Books<M: Described> {
    h: f64,
    pub events: Vec<Seen<M>>,
    pub audit: EnergyAudit,
    /// Σ impulse × s': work of the impulses on the input (J).
    pub impulsive: f64,
    /// Largest energy (J) that an event made beyond its impulse's work.
    pub made: f64,
    /// The same for moves over many impacts, which take time, and what corrects them.
    pub made_settling: f64,
    /// ∫ |supplied| dt: the energy that went through (J).
    pub throughput: f64,
    /// Largest and smallest energy at the ends of pieces (J).
    pub energies: (f64, f64),
    pub ticks: Vec<pode::Tick>,
}

impl<M: Described> Books<M> {
    pub fn new(h: f64) -> Self {
        Self {
            h,
            events: Vec::new(),
            audit: EnergyAudit::default(),
            impulsive: 0.0,
            made: f64::NEG_INFINITY,
            made_settling: f64::NEG_INFINITY,
            throughput: 0.0,
            energies: (f64::NEG_INFINITY, f64::INFINITY),
            ticks: Vec::new(),
        }
    }

    pub fn names(&self) -> Vec<&'static str> {
        self.events.iter().map(|event| event.name).collect()
    }

    /// Spread of the energy over the run (J).
    pub fn spread(&self) -> f64 {
        self.energies.0 - self.energies.1
    }
}

impl<M: Described> Watch<M> for Books<M> {
    fn piece<S: Signal<Motion>>(&mut self, model: &M, piece: &Piece<'_, M, S>) {
        self.audit.piece(model, piece);
        let (x, s) = piece.at(0.5);
        self.throughput += piece.duration() * model.supplied(piece.mode, &x, &s).abs();
        let energy = model.energy(piece.mode, &piece.end, &piece.at(1.0).1);
        self.energies = (self.energies.0.max(energy), self.energies.1.min(energy));
    }

    fn event(&mut self, model: &M, event: &Event<'_, M>) {
        self.audit.event(model, event);
        let energy = |it: &(M::Mode, M::State)| model.energy(it.0, &it.1, &event.input);
        let work = event.impulse * event.input.rate;
        self.impulsive += work;
        let t = (event.tick as f64 + event.theta) * self.h;
        let moved = self.events.last().is_some_and(|it| it.name == "impacts" && it.t >= t);
        let made = match event.cause {
            EventCause::Guard(_) if !moved => &mut self.made,
            EventCause::Guard(_) | EventCause::Impacts(_) | EventCause::Settled => {
                &mut self.made_settling
            }
        };
        *made = made.max(energy(&event.after) - energy(&event.before) - work);
        self.events.push(Seen {
            t,
            name: event.cause.name(),
            before: event.before,
            after: event.after,
            input: event.input,
            impulse: event.impulse,
        });
    }
}

/// Runs `model` from `start` until `until` (s) with ticks of `h` under `input`.
#[track_caller]
pub fn run<M: Described>(
    model: M,
    start: (M::Mode, M::State),
    (h, until): (f64, f64),
    input: impl Fn(f64) -> Motion,
) -> (Books<M>, Simulator<M, Rk4>) {
    run_any(model, start, (h, until), &input)
}

/// As [`run`]; a simulator is compiled for each model, not for each input.
#[track_caller]
fn run_any<M: Described>(
    model: M,
    start: (M::Mode, M::State),
    (h, until): (f64, f64),
    input: &dyn Fn(f64) -> Motion,
) -> (Books<M>, Simulator<M, Rk4>) {
    let mut simulator = Simulator::new(model, Rk4, Limits::default(), start.0, start.1);
    let mut books = Books::new(h);
    let ticks = (0_u32..).map(f64::from).take_while(|tick| (tick + 0.5) * h < until);
    for tick in ticks {
        let signal = |theta: f64| input((tick + theta) * h);
        let done = simulator.advance(h, &signal, &mut books);
        assert_eq!(done.advance, Advance::Completed, "tick {tick}, {:?}", simulator.mode());
        books.ticks.push(done);
    }
    (books, simulator)
}

/// The model with preset `preset` of `key`, and some values replaced by name.
#[track_caller]
pub fn preset<M: Described + Default>(preset: &str, key: u8, changes: &[(&str, f64)]) -> M {
    tuned(&M::default(), preset, key, changes)
}

/// `model` with preset `preset` of `key`, and some values replaced by name.
#[track_caller]
pub fn tuned<M: Described>(model: &M, preset: &str, key: u8, changes: &[(&str, f64)]) -> M {
    let entry = model.entry();
    let found = entry.presets.iter().find(|it| it.name == preset).expect("a preset");
    let mut values = values(found, entry.parameters.len(), key);
    for (name, value) in changes {
        let index = entry.parameters.iter().position(|it| it.name == *name).expect("a parameter");
        values[index] = *value;
    }
    model.with_values(&values)
}

/// The value of a parameter in preset `preset` of `key`.
#[track_caller]
pub fn parameter<M: Described>(model: &M, (preset, key): (&str, u8), name: &str) -> f64 {
    let entry = model.entry();
    let found = entry.presets.iter().find(|it| it.name == preset).expect("a preset");
    let index = entry.parameters.iter().position(|it| it.name == name).expect("a parameter");
    found.value(index, key)
}

/// One value per parameter of `preset` for `key`.
pub fn values(preset: &Preset, parameters: usize, key: u8) -> Vec<f64> {
    preset.values(key).split_at(parameters).0.to_vec()
}
