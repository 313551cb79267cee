//! Exact inputs, and audited runs of a model under them.
#![allow(dead_code, unreachable_pub, reason = "other crates' tests use a part of it")]

use pode::stepper::Rk4;
use pode::{
    Advance, Energetic, EnergyAudit, Event, EventCause, Limits, Motion, Piece, Resets, Signal,
    Simulator, Watch,
};

/// Strokes of figure 6: height (rad), middle (s) and width (s) of each bell.
pub const FIGURE_6: [[f64; 3]; 3] =
    [[0.099, 0.514, 0.079], [0.181, 1.095, 0.109], [0.186, 1.573, 0.059]];

/// Returns s(t) = Σ A exp(−((t − tc)/w)²) with its derivatives.
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

/// Returns s(t) = Σ A (1 + tanh((t − tc)/w))/2 with its derivatives.
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

pub fn sine(amplitude: f64, omega: f64, t: f64) -> Motion {
    let (sin, cos) = (omega * t).sin_cos();
    Motion {
        position: amplitude * sin,
        rate: amplitude * omega * cos,
        acceleration: -amplitude * omega * omega * sin,
        jerk: -amplitude * omega.powi(3) * cos,
    }
}

pub fn still(position: f64) -> Motion {
    Motion { position, ..Motion::default() }
}

#[derive(Clone, Debug)]
pub struct Seen<M: Resets> {
    pub t: f64,
    pub name: &'static str,
    pub before: (M::Mode, M::State),
    pub after: (M::Mode, M::State),
    pub input: Motion,
    pub impulse: f64,
}

#[derive(Debug)]
pub struct AuditedRun<M: Resets> {
    h: f64,
    pub events: Vec<Seen<M>>,
    pub audit: EnergyAudit,
    /// Work of the impulses on the input, Σ impulse × s' (J).
    pub impulsive: f64,
    /// Largest energy (J) that an event generated beyond its impulse's work.
    pub generated: f64,
    /// Like `generated`, for moves over many impacts, which take time, and for their corrections.
    pub generated_settling: f64,
    /// Energy put through, ∫ |supplied| dt (J).
    pub throughput: f64,
    /// Largest and smallest energy at the ends of pieces (J).
    pub energies: (f64, f64),
    pub ticks: Vec<pode::Tick>,
}

impl<M: Resets> AuditedRun<M> {
    pub fn new(h: f64) -> Self {
        Self {
            h,
            events: Vec::new(),
            audit: EnergyAudit::default(),
            impulsive: 0.0,
            generated: f64::NEG_INFINITY,
            generated_settling: f64::NEG_INFINITY,
            throughput: 0.0,
            energies: (f64::NEG_INFINITY, f64::INFINITY),
            ticks: Vec::new(),
        }
    }

    pub fn names(&self) -> Vec<&'static str> {
        self.events.iter().map(|event| event.name).collect()
    }
}

impl<M: Resets<Input = Motion> + Energetic> Watch<M> for AuditedRun<M> {
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
        let generated = match event.cause {
            EventCause::Guard(_) if !moved => &mut self.generated,
            EventCause::Guard(_) | EventCause::Impacts(_) | EventCause::Settled => {
                &mut self.generated_settling
            }
        };
        *generated = generated.max(energy(&event.after) - energy(&event.before) - work);
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

#[track_caller]
pub fn run<M>(
    model: &M,
    start: (M::Mode, M::State),
    (h, until): (f64, f64),
    input: impl Fn(f64) -> Motion,
) -> (AuditedRun<M>, Simulator<M, Rk4>)
where
    M: Resets<Input = Motion> + Energetic + Clone,
{
    // A simulator is compiled for each model, not for each input.
    let input: &dyn Fn(f64) -> Motion = &input;
    let mut simulator = Simulator::new(model.clone(), Rk4, Limits::default(), start.0, start.1);
    let mut run = AuditedRun::new(h);
    let ticks = (0_u32..).map(f64::from).take_while(|tick| (tick + 0.5) * h < until);
    for tick in ticks {
        let signal = |theta: f64| input((tick + theta) * h);
        let done = simulator.advance(h, &signal, &mut run);
        assert_eq!(done.advance, Advance::Completed, "tick {tick}, {:?}", simulator.mode());
        run.ticks.push(done);
    }
    (run, simulator)
}
