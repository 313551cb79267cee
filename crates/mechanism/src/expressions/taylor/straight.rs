//! A recursion as two straight-line tapes: the start of a series, and the step from order to order.

use super::carried::{CarriedValue, write};
use super::lanes::{LaneFactor, SeriesLane, lanes};
use super::recursion::Recursion;
use super::step_terms::StepTerms;
use crate::expressions::tape::{Tape, TapeSlot, TapeWriter};

/// Recursion as two tapes; their caller keeps the lanes and their sums.
///
/// A lane is a pair of factors a and b; its sum for the order k is Σ a(j) b(k − j), 0 < j < k.
#[derive(Clone, PartialEq, Debug)]
pub struct SeriesTapes {
    /// Maps constants, state and input to the outputs, the conditions, and the carried values.
    pub start: Tape,
    /// Maps constants, the coefficients of order k of state and input, and `extra` with k, 1/k, the
    /// carried values and the lanes' sums, to the coefficients of order k of outputs and
    /// conditions, then the first factors of all lanes, and the second ones.
    pub step: Tape,
    pub carried: usize,
    pub lanes: usize,
    pub conditions: usize,
}

impl Recursion {
    pub fn tapes(&self) -> SeriesTapes {
        let outputs = [self.tape.outputs.as_slice(), &self.conditions].concat();
        let is_live = self.live(&outputs);
        let lanes = self.moving_lanes(&is_live);
        // The number of carried values is known once all is written.
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

    /// Returns each sum once, of factors that both change.
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

    fn start(&self, outputs: &[TapeSlot], carried: &[CarriedValue]) -> Tape {
        let instructions = &self.tape.instructions;
        let mut is_read = vec![false; instructions.len()];
        for slot in outputs.iter().copied().chain(carried.iter().map(|it| it.slot())) {
            is_read[slot.index()] = true;
        }
        // Operands precede their operation.
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
    pub(super) fn is_sum_of(&self, a: LaneFactor, b: LaneFactor) -> bool {
        (self.first, self.second) == (a, b) || (self.second, self.first) == (a, b)
    }
}
