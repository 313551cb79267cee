use super::{Argument, Instruction, Tape, TapeSlot};
use crate::expressions::graph::UnaryFunction;

/// Number of arguments of each kind that a tape reads.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct ArgumentCounts {
    pub constants: usize,
    pub state: usize,
    pub input: usize,
    pub extra: usize,
}

/// Sine and cosine of one angle, where a tape contains them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AngleValues {
    pub angle: TapeSlot,
    pub sine: Option<TapeSlot>,
    pub cosine: Option<TapeSlot>,
}

impl AngleValues {
    fn first(&self) -> usize {
        let index = |slot: Option<TapeSlot>| slot.map_or(usize::MAX, TapeSlot::index);
        index(self.sine).min(index(self.cosine))
    }
}

/// Sines and cosines computed by one call.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AngleGroup {
    One(AngleValues),
    Two([AngleValues; 2]),
}

impl Tape {
    pub fn uses(&self) -> Vec<u32> {
        let mut uses = vec![0_u32; self.instructions.len()];
        for output in &self.outputs {
            uses[output.index()] += 1;
        }
        for (at, instruction) in self.instructions.iter().enumerate().rev() {
            if uses[at] > 0 {
                instruction.operands(|slot| uses[slot.index()] += 1);
            }
        }
        uses
    }

    /// Returns `true` if every operand and output is computed before its use.
    pub fn is_ordered(&self) -> bool {
        let mut is_ordered = self.outputs.iter().all(|it| it.index() < self.instructions.len());
        for (at, instruction) in self.instructions.iter().enumerate() {
            instruction.operands(|slot| is_ordered &= slot.index() < at);
        }
        is_ordered
    }

    pub fn argument_counts(&self) -> ArgumentCounts {
        let mut counts = ArgumentCounts::default();
        for instruction in &self.instructions {
            let Instruction::Argument(argument) = instruction else { continue };
            let (count, index) = match *argument {
                Argument::Constant(index) => (&mut counts.constants, index),
                Argument::State(index) => (&mut counts.state, index),
                Argument::Input(index) => (&mut counts.input, index.into()),
                Argument::Extra(index) => (&mut counts.extra, index),
            };
            *count = (*count).max(usize::from(index) + 1);
        }
        counts
    }

    /// Returns the groups of sines and cosines, each with the instruction before which it is
    /// computed: two angles together where both are known by then.
    pub fn angle_groups(&self) -> Vec<(usize, AngleGroup)> {
        let mut single = self.angles();
        single.reverse();
        let mut groups = Vec::new();
        while let Some(first) = single.pop() {
            let at = first.first();
            let partner = single.iter().rposition(|it| it.angle.index() < at);
            let group = match partner {
                Some(partner) => AngleGroup::Two([first, single.remove(partner)]),
                None => AngleGroup::One(first),
            };
            groups.push((at, group));
        }
        groups
    }

    fn angles(&self) -> Vec<AngleValues> {
        let uses = self.uses();
        let mut angles: Vec<AngleValues> = Vec::new();
        let mut known = std::collections::HashMap::new();
        for (at, instruction) in self.instructions.iter().enumerate() {
            let Instruction::Unary(function, angle) = *instruction else { continue };
            if !matches!(function, UnaryFunction::Sin | UnaryFunction::Cos) || uses[at] == 0 {
                continue;
            }
            let entry = *known.entry(angle).or_insert_with(|| {
                angles.push(AngleValues { angle, sine: None, cosine: None });
                angles.len() - 1
            });
            let slot = Some(TapeSlot(u32::try_from(at).unwrap_or(u32::MAX)));
            let values = &mut angles[entry];
            if function == UnaryFunction::Sin {
                values.sine = values.sine.or(slot);
            } else {
                values.cosine = values.cosine.or(slot);
            }
        }
        angles
    }
}

impl Instruction {
    #[must_use]
    pub fn moved(&self, place: impl Fn(TapeSlot) -> TapeSlot) -> Self {
        match *self {
            Self::Number(_) | Self::Argument(_) => *self,
            Self::Add(x, y) => Self::Add(place(x), place(y)),
            Self::Subtract(x, y) => Self::Subtract(place(x), place(y)),
            Self::Multiply(x, y) => Self::Multiply(place(x), place(y)),
            Self::Divide(x, y) => Self::Divide(place(x), place(y)),
            Self::Negate(x) => Self::Negate(place(x)),
            Self::Unary(function, x) => Self::Unary(function, place(x)),
            Self::Binary(function, x, y) => Self::Binary(function, place(x), place(y)),
            Self::Select(x, y, z) => Self::Select(place(x), place(y), place(z)),
        }
    }

    pub fn operands(&self, mut see: impl FnMut(TapeSlot)) {
        match *self {
            Self::Number(_) | Self::Argument(_) => {}
            Self::Negate(x) | Self::Unary(_, x) => see(x),
            Self::Add(x, y)
            | Self::Subtract(x, y)
            | Self::Multiply(x, y)
            | Self::Divide(x, y)
            | Self::Binary(_, x, y) => [x, y].into_iter().for_each(see),
            Self::Select(x, y, z) => [x, y, z].into_iter().for_each(see),
        }
    }
}
