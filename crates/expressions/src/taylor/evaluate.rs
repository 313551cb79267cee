//! A recursion followed step by step, for tests and for descriptions that are not compiled.

use pode::series::rows::{self, Falling, Rising};
use pode::series::{INPUT_TERMS, MOST_ORDER};

use super::recursion::Recursion;
use super::rules::SeriesRule;
use crate::tape::{Tape, TapeArguments, TapeSlot};

/// The recursion of a tape, as a function.
#[derive(Clone, PartialEq, Debug)]
pub struct TapeSeries {
    recursion: Recursion,
    /// All values at the start of a step.
    start: Tape,
}

/// What a series is about.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SeriesStart<'a> {
    pub constants: &'a [f64],
    pub state: &'a [f64],
    /// Coefficients of the input's position in units of `scale`; those that are missing are zero.
    pub input: &'a [f64],
    /// The time (s) of one unit.
    pub scale: f64,
}

impl SeriesStart<'_> {
    /// The coefficient `k` of the rate number `rate` of the input.
    fn input(&self, rate: usize, k: usize) -> f64 {
        let position = self.input.get(k + rate).copied().unwrap_or(0.0);
        (1..=rate).fold(position, |value, n| value * (k + n) as f64 / self.scale)
    }

    /// Input and rates where the series begins.
    fn inputs(&self) -> [f64; 4] {
        std::array::from_fn(|rate| self.input(rate, 0))
    }
}

/// Coefficients of all values, as far as they are known.
struct Coefficients {
    order: Vec<f64>,
    rising: Vec<Rising>,
    falling: Vec<Falling>,
    rate: Vec<Rising>,
}

impl Coefficients {
    fn enter(&mut self, slot: usize, k: usize, value: f64) {
        self.order[slot] = value;
        self.rising[slot].set(k, value);
        self.falling[slot].set(k, value);
        self.rate[slot].set(k, k as f64 * value);
    }
}

impl TapeSeries {
    /// Returns the series of a `tape` whose first `entries` outputs are the derivative.
    pub fn new(tape: &Tape, entries: usize) -> Self {
        let recursion = Recursion::new(tape, entries);
        let outputs =
            (0..recursion.rules.len()).filter_map(|at| u32::try_from(at).ok()).map(TapeSlot);
        let instructions = recursion.tape.instructions.clone();
        let start = Tape { instructions, outputs: outputs.collect() };
        Self { recursion, start }
    }

    /// Returns the coefficients up to `order`: by entry of the state, then by guard.
    pub fn expand(&self, start: &SeriesStart<'_>, order: usize) -> Vec<Vec<f64>> {
        let order = order.min(MOST_ORDER).min(INPUT_TERMS - 4);
        let (entries, guards) = self.recursion.outputs();
        let mut out: Vec<Vec<f64>> = start.state.iter().map(|it| vec![*it]).collect();
        out.extend(guards.iter().map(|_| Vec::new()));
        let mut known = self.begin(start);
        for k in 0..=order {
            if k > 0 {
                self.advance(start, &out, &mut known, k);
            }
            for (at, slot) in guards.iter().enumerate() {
                out[start.state.len() + at].push(self.output(&known, *slot, k));
            }
            for (at, slot) in entries.iter().enumerate().filter(|_| k < order) {
                let rate = self.output(&known, *slot, k);
                out[at].push(start.scale * rate * rows::PER_ORDER[k + 1]);
            }
        }
        out
    }

    fn output(&self, known: &Coefficients, slot: TapeSlot, k: usize) -> f64 {
        if k > 0 && self.recursion.is_constant(slot) { 0.0 } else { known.order[slot.index()] }
    }

    fn begin(&self, start: &SeriesStart<'_>) -> Coefficients {
        let SeriesStart { constants, state, .. } = *start;
        let arguments = TapeArguments { constants, state, input: start.inputs(), extra: &[] };
        let values = self.start.evaluate(&arguments);
        let count = values.len();
        let mut known = Coefficients {
            order: values.clone(),
            rising: vec![Rising::ZERO; count],
            falling: vec![Falling::ZERO; count],
            rate: vec![Rising::ZERO; count],
        };
        for (slot, value) in values.into_iter().enumerate() {
            known.enter(slot, 0, value);
        }
        known
    }

    /// The coefficients of order `k` of all values.
    fn advance(
        &self,
        start: &SeriesStart<'_>,
        state: &[Vec<f64>],
        known: &mut Coefficients,
        k: usize,
    ) {
        for (slot, rule) in self.recursion.rules.iter().enumerate() {
            let value = if let SeriesRule::State(index) = *rule {
                state[usize::from(index)][k]
            } else if let SeriesRule::Input(rate) = *rule {
                start.input(rate.into(), k)
            } else if *rule == SeriesRule::Constant {
                continue;
            } else {
                self.term(*rule, slot, known, k)
            };
            known.enter(slot, k, value);
        }
    }

    fn term(&self, rule: SeriesRule, slot: usize, known: &Coefficients, k: usize) -> f64 {
        let first = |it: TapeSlot| known.rising[it.index()].at(0);
        let now = |it: TapeSlot| self.output(known, it, k);
        let up = |it: TapeSlot| &known.rising[it.index()];
        let down = |it: TapeSlot| &known.falling[it.index()];
        match rule {
            SeriesRule::Constant | SeriesRule::State(_) | SeriesRule::Input(_) => 0.0,
            SeriesRule::Add(x, y) => now(x) + now(y),
            SeriesRule::Subtract(x, y) => now(x) - now(y),
            SeriesRule::Negate(x) => -now(x),
            SeriesRule::Scale(by, x) => first(by) * now(x),
            SeriesRule::Product(x, y) => rows::product(up(x), down(y), k),
            SeriesRule::Square(x) => rows::square(up(x), down(x), k),
            SeriesRule::Quotient(x, y) => {
                rows::quotient(now(x), up(y), &known.falling[slot], 1.0 / first(y), k)
            }
            SeriesRule::Over(x, by) => now(x) / first(by),
            SeriesRule::Driven { slope, of } => {
                rows::driven(&known.rate[of.index()], down(slope), k)
            }
            // What is zero and stays so is none of the points at which these are singular.
            SeriesRule::Root(x) | SeriesRule::Power(x, _)
                if first(x).abs().max(now(x).abs()) <= 0.0 =>
            {
                0.0
            }
            SeriesRule::Root(x) => {
                let (up, down) = (&known.rising[slot], &known.falling[slot]);
                rows::root(now(x), up, down, 0.5 / up.at(0), k)
            }
            SeriesRule::Power(x, exponent) => {
                let rows = (up(x), &known.rate[x.index()]);
                rows::power(first(exponent), rows, &known.falling[slot], 1.0 / first(x), k)
            }
            SeriesRule::Magnitude(x) => now(x) * equations::functions::sign(first(x)),
            SeriesRule::Choice(condition, x, y) => now(if first(condition) > 0.0 { x } else { y }),
        }
    }
}
