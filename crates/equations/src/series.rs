//! The Taylor series of a mode, by the two functions of its table.
//!
//! What is not arithmetic of the model is done here, once for all models: the orders one after
//! another, and the sums over the orders before.

use pode::Motion;
use pode::series::lanes::{SeriesLanes, SeriesPair};
use pode::series::rows::PER_ORDER;
use pode::series::{INPUT_TERMS, Expansion, MOST_CONDITIONS, MOST_GUARDS, MOST_ORDER, TERMS};

use crate::model::EquationModel;
use crate::table::{Arguments, Functions, SeriesTable};

/// Pairs of lanes that are summed up at a time: as many as a common processor has registers for.
const PAIRS: usize = 8;
/// Lanes of a block.
const LANES: usize = 2 * PAIRS;
/// Numbers that a step is given and gives, for each block.
const ROOM: usize = 96;
/// Most blocks of a mode.
const MOST_BLOCKS: usize = 4;
/// Where the sums begin in what a step is given: k and 1/k stand before.
const SUMS: usize = 2;

impl SeriesTable {
    /// How many numbers each order of a state of `states` entries has: rates, slaved entries,
    /// guards and conditions.
    const fn outputs(&self, states: usize) -> usize {
        states + self.guards + self.conditions
    }

    /// How many blocks of lanes it takes; none if it takes too many.
    fn blocks(&self, states: usize) -> Option<usize> {
        let given = SUMS + self.lanes + self.carried;
        let made = self.outputs(states) + self.carried.max(2 * self.lanes);
        [1, 2, MOST_BLOCKS].into_iter().find(|blocks| {
            self.lanes <= blocks * LANES && given <= blocks * ROOM && made <= blocks * ROOM
        })
    }

    /// Whether a mode of so many states can be expanded by it: at most 64 lanes and as many numbers
    /// as there is room for, and no more guards and conditions than an expansion keeps.
    pub fn fits(&self, states: usize) -> bool {
        let counts = self.guards <= MOST_GUARDS && self.conditions <= MOST_CONDITIONS;
        counts && self.blocks(states).is_some()
    }
}

impl<F: Functions + Copy, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Expands the motion of a mode by the functions of its series.
    ///
    /// # Real-time
    /// Bounded: one call per order, and sums over at most 64 lanes.
    pub(crate) fn expand(
        &self,
        table: &SeriesTable,
        input: &[Motion; INPUT_TERMS],
        out: &mut Expansion<[f64; N]>,
    ) -> bool {
        let states = self.table().states.len();
        (out.known_guards, out.known_conditions) = (table.guards, table.conditions);
        let mut writer = SeriesWriter {
            functions: self.functions(),
            constants: self.constants(),
            table,
            states,
            input,
            order: out.order.min(MOST_ORDER),
            scale: out.scale,
            terms: out.terms.as_flattened_mut(),
            width: N,
            guards: &mut out.guards,
            conditions: &mut out.conditions,
        };
        match table.blocks(states) {
            Some(1) => writer.expand::<1>(),
            Some(2) => writer.expand::<2>(),
            Some(MOST_BLOCKS) => writer.expand::<MOST_BLOCKS>(),
            _ => return false,
        }
        true
    }
}

/// What a series is written with, whatever the model's type is.
struct SeriesWriter<'a> {
    functions: &'a dyn Functions,
    constants: &'a [f64],
    table: &'a SeriesTable,
    states: usize,
    input: &'a [Motion; INPUT_TERMS],
    order: usize,
    scale: f64,
    /// The state's coefficients, `width` of each order.
    terms: &'a mut [f64],
    width: usize,
    guards: &'a mut [[f64; TERMS]; MOST_GUARDS],
    conditions: &'a mut [[f64; TERMS]; MOST_CONDITIONS],
}

impl SeriesWriter<'_> {
    /// Writes all orders.
    fn expand<const BLOCKS: usize>(&mut self) {
        let mut lanes = [SeriesLanes::<PAIRS>::ZERO; BLOCKS];
        let (mut given, mut made) = ([[0.0; ROOM]; BLOCKS], [[0.0; ROOM]; BLOCKS]);
        let (given, made) = (given.as_flattened_mut(), made.as_flattened_mut());
        let SeriesTable { lanes: count, carried, start, step, .. } = *self.table;
        let outputs = self.table.outputs(self.states);
        self.call(start, 0, &[], made);
        let behind = given.get_mut(SUMS + count..).unwrap_or_default();
        let kept = made.get(outputs..outputs + carried).unwrap_or_default();
        behind.iter_mut().zip(kept).for_each(|(place, value)| *place = *value);
        self.keep(0, made);
        // Guards, conditions and slaved entries go as far as the state.
        let last = if outputs > self.entries() { self.order } else { self.order - 1 };
        for k in 1..=last {
            let [order, per_order, sums @ ..] = &mut *given else { return };
            (*order, *per_order) = (k as f64, PER_ORDER[k]);
            let sums = sums.get_mut(..count).unwrap_or_default();
            for (block, sums) in lanes.iter().zip(sums.chunks_mut(LANES)) {
                write_sums(&block.inner(k), sums);
            }
            self.call(step, k, given, made);
            self.keep(k, made);
            let factors = made.get(outputs..outputs + 2 * count).unwrap_or_default();
            let (first, second) = factors.split_at(factors.len() / 2);
            let factors = first.chunks(LANES).zip(second.chunks(LANES));
            for (block, (first, second)) in lanes.iter_mut().zip(factors) {
                block.enter(k, pairs(first), pairs(second));
            }
        }
    }

    /// How many entries of the state move by equations.
    const fn entries(&self) -> usize {
        self.table.entries.count_ones() as usize
    }

    /// Calls a function with the coefficients of order `k`.
    fn call(&self, function: u16, k: usize, extra: &[f64], out: &mut [f64]) {
        let state = self.terms.get(k * self.width..(k + 1) * self.width).unwrap_or_default();
        let input = core::array::from_fn(|rate| self.input(rate, k));
        let arguments = Arguments { constants: self.constants, state, input: &input, extra };
        self.functions.call(function, &arguments, out);
    }

    /// The coefficient `k` of the rate number `rate` of the input.
    fn input(&self, rate: usize, k: usize) -> f64 {
        let position = self.input.get(k + rate).map_or(0.0, |motion| motion.position);
        (1..=rate).fold(position, |value, n| value * (k + n) as f64 / self.scale)
    }

    /// Enters the outputs of order `k`: rates make the state's next coefficients.
    fn keep(&mut self, k: usize, outputs: &[f64]) {
        let (rates, others) = outputs.split_at(self.entries().min(outputs.len()));
        let (slaved, others) = others.split_at((self.states - self.entries()).min(others.len()));
        let (mut rates, mut slaved) = (rates.iter(), slaved.iter());
        let by = self.scale * PER_ORDER[k + 1];
        for entry in 0..self.states {
            let is_free = self.table.entries >> entry & 1 == 1;
            let (order, value) = if is_free {
                (k + 1, rates.next().map(|rate| by * rate))
            } else {
                (k, slaved.next().copied())
            };
            // The state itself is given, and nobody asks for more than the last.
            let is_wanted = order > 0 && order <= self.order;
            let place = self.terms.get_mut(order * self.width + entry).filter(|_| is_wanted);
            if let (Some(place), Some(value)) = (place, value) {
                *place = value;
            }
        }
        let (guards, conditions) = others.split_at(self.table.guards.min(others.len()));
        for (row, value) in self.guards.iter_mut().zip(guards) {
            row[k] = *value;
        }
        for (row, value) in self.conditions.iter_mut().zip(conditions).take(self.table.conditions) {
            row[k] = *value;
        }
    }
}

/// Writes the sums of two lanes each.
#[inline]
fn write_sums(pairs: &[SeriesPair; PAIRS], sums: &mut [f64]) {
    for (pair, sums) in pairs.iter().zip(sums.chunks_mut(2)) {
        for (place, sum) in sums.iter_mut().zip(pair.both()) {
            *place = sum;
        }
    }
}

/// Factors of a block of lanes, two by two; lanes without any have zeros.
#[inline]
fn pairs(factors: &[f64]) -> [SeriesPair; PAIRS] {
    let at = |index: usize| factors.get(index).copied().unwrap_or(0.0);
    core::array::from_fn(|pair| SeriesPair::new(at(2 * pair), at(2 * pair + 1)))
}
