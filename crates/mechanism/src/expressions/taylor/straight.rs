//! A recursion as two straight lines: where a series begins, and from order to order.

use super::carried::{CarriedValue, write};
use super::lanes::{LaneFactor, SeriesLane, lanes};
use super::recursion::Recursion;
use super::step_terms::StepTerms;
use crate::expressions::tape::{Tape, TapeSlot, TapeWriter};

/// A recursion as two tapes: what runs them keeps the lanes and sums over them.
///
/// A lane is a pair of factors a and b; its sum for the order k is Σ a(j) b(k − j) for j from 1 to
/// k − 1.
#[derive(Clone, PartialEq, Debug)]
pub struct SeriesTapes {
    /// From constants, state and input to the outputs, the conditions, and what is carried.
    pub start: Tape,
    /// From constants, the coefficients of order k of state and input, and in `extra` k, 1/k, what
    /// is carried and the lanes' sums: to the coefficients of order k of outputs and conditions,
    /// then the first factors of all lanes, and the second ones.
    pub step: Tape,
    /// How many numbers the steps are given of the start.
    pub carried: usize,
    pub lanes: usize,
    /// How many values there are at whose zeros the series ends, since a branch does.
    pub conditions: usize,
}

impl Recursion {
    /// Returns the recursion as two tapes.
    pub fn tapes(&self) -> SeriesTapes {
        let outputs = [self.tape.outputs.as_slice(), &self.conditions].concat();
        let is_live = self.live(&outputs);
        let lanes = self.moving_lanes(&is_live);
        // How many numbers are carried is known when all is written once.
        let (_, carried) = StepTerms::new(self, &lanes, 0).finish(&is_live, &outputs);
        let (step, carried) =
            StepTerms::new(self, &lanes, carried.len()).finish(&is_live, &outputs);
        SeriesTapes {
            start: self.start(&outputs, &carried),
            step,
            carried: carried.len(),
            lanes: lanes.len(),
            conditions: self.conditions.len(),
        }
    }

    /// Each sum once, of factors that both move.
    fn moving_lanes(&self, is_live: &[bool]) -> Vec<SeriesLane> {
        let mut all: Vec<SeriesLane> = Vec::new();
        for lane in lanes(self, is_live) {
            let is_moving = [lane.first, lane.second].iter().all(|it| !self.is_constant(it.slot()));
            if is_moving && !all.iter().any(|it| it.is_sum_of(lane.first, lane.second)) {
                all.push(lane);
            }
        }
        all
    }

    /// The values at the start of `outputs`, and what is carried.
    fn start(&self, outputs: &[TapeSlot], carried: &[CarriedValue]) -> Tape {
        let instructions = &self.tape.instructions;
        let mut is_read = vec![false; instructions.len()];
        for slot in outputs.iter().copied().chain(carried.iter().map(|it| it.slot())) {
            is_read[slot.index()] = true;
        }
        // Operands stand before what is made of them.
        for (at, instruction) in instructions.iter().enumerate().rev() {
            if is_read[at] {
                instruction.operands(|it| is_read[it.index()] = true);
            }
        }
        let mut writer = TapeWriter::default();
        let mut places = vec![TapeSlot::default(); is_read.len()];
        for at in (0..is_read.len()).filter(|at| is_read[*at]) {
            places[at] = writer.push(instructions[at].moved(|it| places[it.index()]));
        }
        let mut all: Vec<_> = outputs.iter().map(|it| places[it.index()]).collect();
        for it in carried {
            let place = places[it.slot().index()];
            all.push(write(&mut writer, *it, place));
        }
        Tape { instructions: writer.finish(), outputs: all }
    }
}

impl SeriesLane {
    /// Whether its sum is that of these factors.
    pub(super) fn is_sum_of(&self, a: LaneFactor, b: LaneFactor) -> bool {
        (self.first, self.second) == (a, b) || (self.second, self.first) == (a, b)
    }
}
