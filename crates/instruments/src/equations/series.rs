//! The Taylor series of a mode, by the two functions of its table.
//!
//! Here is what all models share: the order of the coefficients, and the sums over lower orders.

use pode::Motion;
use pode::series::PER_ORDER;
use pode::series::lanes::{SeriesLanes, SeriesPair};
use pode::series::{Expansion, INPUT_TERMS, MOST_CONDITIONS, MOST_GUARDS, MOST_ORDER, TERMS};

use crate::equations::model::EquationModel;
use crate::equations::table::{Arguments, Equations, SeriesTable};

/// Maximum count of numbers that a step receives and returns, for each block of lanes.
const ROOM: usize = 96;
/// Index of the carried numbers in a step's arguments: k and 1/k precede them.
const CARRIED: usize = 2;
/// Pairs of lanes that are summed at once, at most as many as a common processor has registers,
/// and blocks of them; the first size with room for a mode's lanes counts.
const SIZES: [(usize, usize); 5] = [(4, 1), (8, 1), (7, 2), (8, 2), (8, 4)];

impl SeriesTable {
    const fn outputs(&self, states: usize) -> usize {
        states + self.guards + self.conditions
    }

    /// Returns pairs and blocks of lanes; `None` if there are too many.
    fn size(&self, states: usize) -> Option<(usize, usize)> {
        let outputs = self.outputs(states);
        SIZES.into_iter().find(|(pairs, blocks)| {
            let lanes = 2 * pairs * blocks;
            let given = CARRIED + self.carried + lanes;
            let made = outputs + self.carried.max(self.lanes + lanes);
            self.lanes <= lanes && given.max(made) <= blocks * ROOM
        })
    }

    /// Returns `true` if the series can expand a mode with `states` entries: at most 64 lanes, and
    /// room for its numbers, guards and conditions.
    pub fn fits(&self, states: usize) -> bool {
        let counts = self.guards <= MOST_GUARDS && self.conditions <= MOST_CONDITIONS;
        counts && self.size(states).is_some()
    }
}

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
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
            per_scale: 1.0 / out.scale,
            terms: out.terms.as_flattened_mut(),
            width: N,
            guards: &mut out.guards,
            conditions: &mut out.conditions,
        };
        match table.size(states) {
            Some((4, 1)) => writer.expand::<4, 1>(),
            Some((8, 1)) => writer.expand::<8, 1>(),
            Some((7, 2)) => writer.expand::<7, 2>(),
            Some((8, 2)) => writer.expand::<8, 2>(),
            Some((8, 4)) => writer.expand::<8, 4>(),
            _ => return false,
        }
        true
    }
}

struct SeriesWriter<'a> {
    functions: &'a dyn Equations,
    constants: &'a [f64],
    table: &'a SeriesTable,
    states: usize,
    input: &'a [Motion; INPUT_TERMS],
    order: usize,
    scale: f64,
    per_scale: f64,
    /// Coefficients of the state, `width` of each order.
    terms: &'a mut [f64],
    width: usize,
    guards: &'a mut [[f64; TERMS]; MOST_GUARDS],
    conditions: &'a mut [[f64; TERMS]; MOST_CONDITIONS],
}

impl SeriesWriter<'_> {
    fn expand<const PAIRS: usize, const BLOCKS: usize>(&mut self) {
        let mut lanes = [SeriesLanes::<PAIRS>::ZERO; BLOCKS];
        let (mut given, mut made) = ([[0.0; ROOM]; BLOCKS], [[0.0; ROOM]; BLOCKS]);
        let (given, made) = (given.as_flattened_mut(), made.as_flattened_mut());
        let SeriesTable { lanes: count, carried, start, step, .. } = *self.table;
        let outputs = self.table.outputs(self.states);
        self.call(start, 0, &[], made);
        let kept = made.get(outputs..outputs + carried).unwrap_or_default();
        let places = given.iter_mut().skip(CARRIED);
        places.zip(kept).for_each(|(place, value)| *place = *value);
        self.keep(0, made);
        // Guards, conditions and slaved entries go as far as the state.
        let last = if outputs > self.entries() { self.order } else { self.order - 1 };
        for (k, per_order) in PER_ORDER.iter().enumerate().take(last + 1).skip(1) {
            if let [order, per, ..] = given {
                (*order, *per) = (k as f64, *per_order);
            }
            let sums = given.get_mut(CARRIED + carried..).unwrap_or_default();
            for (block, sums) in lanes.iter().zip(sums.chunks_exact_mut(2 * PAIRS)) {
                write_sums(&block.inner(k), sums);
            }
            self.call(step, k, given, made);
            self.keep(k, made);
            for (at, block) in lanes.iter_mut().enumerate() {
                enter(block, k, made, [outputs, outputs + count].map(|from| from + 2 * PAIRS * at));
            }
        }
    }

    const fn entries(&self) -> usize {
        self.table.entries.count_ones() as usize
    }

    fn call(&self, function: u16, k: usize, extra: &[f64], out: &mut [f64]) {
        let state = self.terms.get(k * self.width..(k + 1) * self.width).unwrap_or_default();
        let input = self.input(k);
        let arguments = Arguments { constants: self.constants, state, input: &input, extra };
        self.functions.call(function, &arguments, out);
    }

    fn input(&self, k: usize) -> [f64; 4] {
        let mut by = 1.0;
        core::array::from_fn(|rate| {
            if rate > 0 {
                by *= (k + rate) as f64 * self.per_scale;
            }
            by * self.input.get(k + rate).map_or(0.0, |motion| motion.position)
        })
    }

    /// Stores the outputs of order `k`: rates determine the state's next coefficients.
    fn keep(&mut self, k: usize, outputs: &[f64]) {
        let (rates, others) = outputs.split_at(self.entries().min(outputs.len()));
        let (slaved, others) = others.split_at((self.states - self.entries()).min(others.len()));
        let (mut rates, mut slaved) = (rates.iter(), slaved.iter());
        let by = self.scale * PER_ORDER.get(k + 1).copied().unwrap_or(0.0);
        let rows = self.terms.get_mut(k * self.width..).unwrap_or_default();
        let (now, next) = rows.split_at_mut(self.width.min(rows.len()));
        // No caller needs more than the last order, and the state itself is given.
        let next = if k < self.order { next } else { &mut [] };
        let now = if k > 0 { now } else { &mut [] };
        for entry in 0..self.states {
            if self.table.entries >> entry & 1 == 1 {
                let rate = rates.next().copied().unwrap_or(f64::NAN);
                next.get_mut(entry).into_iter().for_each(|place| *place = by * rate);
            } else {
                let value = slaved.next().copied().unwrap_or(f64::NAN);
                now.get_mut(entry).into_iter().for_each(|place| *place = value);
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

/// Writes the sums of the lanes of a block; those of missing lanes are not read.
#[inline]
fn write_sums<const PAIRS: usize>(pairs: &[SeriesPair; PAIRS], sums: &mut [f64]) {
    for (pair, sums) in pairs.iter().zip(sums.as_chunks_mut::<2>().0) {
        *sums = pair.both();
    }
}

/// Stores the factors of order `k` of a block of lanes, in pairs of numbers.
#[inline]
fn enter<const PAIRS: usize>(
    block: &mut SeriesLanes<PAIRS>,
    k: usize,
    made: &[f64],
    from: [usize; 2],
) {
    if let [Some(first), Some(second)] = from.map(|from| pairs(made, from)) {
        block.enter(k, first, second);
    }
}

/// Returns the factors of a block of lanes from index `from`; missing lanes have any.
#[inline]
fn pairs<const PAIRS: usize>(made: &[f64], from: usize) -> Option<[SeriesPair; PAIRS]> {
    let factors = made.get(from..)?.as_chunks::<2>().0.first_chunk::<PAIRS>()?;
    Some(factors.map(|[one, other]| SeriesPair::new(one, other)))
}
