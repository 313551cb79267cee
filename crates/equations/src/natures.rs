//! What the equations of each mode are like with these parameters: kinds, rates, longest steps.

use pode::{EquationKind, Model as _, Motion, Nature, Part};

use crate::model::{EquationModel, ModeNumber};
use crate::rates::{RADIANS, fastest_once};
use crate::table::{FunctionId, Functions, ModeTable, PartTable};

/// Most modes of one [`EquationModel`].
pub const MAX_MODES: usize = 32;

/// Most parts of all modes that have several; what is more has the nature of its mode.
const MAX_MODE_PARTS: usize = 24;

/// Travel of a key (m): at rest there and at rest above, rates are taken.
const TRAVEL: f64 = 0.01;

/// The natures of all modes, and the parts of those that have several.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct ModeNatures {
    modes: [ModeNature; MAX_MODES],
    parts: [Part; MAX_MODE_PARTS],
}

/// The nature of one mode.
#[derive(Clone, Copy, PartialEq, Debug)]
struct ModeNature {
    nature: Nature,
    /// Longest step (s).
    longest_step: f64,
    /// Where its parts begin; they are the table's own beyond the list.
    first: usize,
}

impl Default for ModeNatures {
    fn default() -> Self {
        let nature = Nature::new(EquationKind::Smooth, 0.0);
        let mode = ModeNature { nature, longest_step: f64::INFINITY, first: MAX_MODE_PARTS };
        Self { modes: [mode; MAX_MODES], parts: [Part::WHOLE; MAX_MODE_PARTS] }
    }
}

impl ModeNatures {
    /// Finds the natures of all modes of `model`, whose constants are known.
    pub(crate) fn of<F: Functions + Copy, const N: usize, const C: usize>(
        model: &EquationModel<F, N, C>,
    ) -> Self {
        let mut natures = Self::default();
        let mut next = 0;
        let poses = [0.0, TRAVEL].map(|travel| {
            let position = travel * model.input_per_metre();
            let input = Motion { position, ..Motion::default() };
            (model.at_rest(&input).1, input)
        });
        for ((number, table), mode) in (0..).zip(model.table().modes).zip(&mut natures.modes) {
            let rates = Rates::of(model, ModeNumber(number), &poses);
            mode.nature = Nature::new(model.kind(table.kind, table.loss), rates.whole);
            mode.longest_step = RADIANS / rates.whole;
            let end = next + table.parts.len();
            if table.parts.len() > 1 && end <= MAX_MODE_PARTS {
                mode.first = next;
                for (at, part) in table.parts.iter().enumerate() {
                    let given = table.part_list.get(at).copied().unwrap_or(Part::WHOLE);
                    natures.parts[next + at] = model.part(given, part, rates.of_part(at));
                }
                next = end;
            }
        }
        natures
    }

    fn mode(&self, mode: ModeNumber) -> &ModeNature {
        &self.modes[usize::from(mode.0) % MAX_MODES]
    }

    #[inline]
    pub(crate) fn nature(&self, mode: ModeNumber) -> Nature {
        self.mode(mode).nature
    }

    #[inline]
    pub(crate) fn longest_step(&self, mode: ModeNumber) -> f64 {
        self.mode(mode).longest_step
    }

    /// The parts of `mode`; the table's own where it has only one.
    #[inline]
    pub(crate) fn parts(&self, mode: ModeNumber, table: &'static ModeTable) -> &[Part] {
        let first = self.mode(mode).first;
        self.parts
            .get(first..first + table.parts.len())
            .filter(|_| first < MAX_MODE_PARTS)
            .unwrap_or(table.part_list)
    }
}

/// The fastest rates (rad/s) of a mode and of its parts.
struct Rates {
    whole: f64,
    parts: [f64; pode::MAX_PARTS],
}

impl Rates {
    /// The largest over the poses.
    fn of<F: Functions + Copy, const N: usize, const C: usize>(
        model: &EquationModel<F, N, C>,
        mode: ModeNumber,
        poses: &[([f64; N], Motion)],
    ) -> Self {
        let table = model.mode(mode);
        let mut rates = Self { whole: 0.0, parts: [0.0; pode::MAX_PARTS] };
        for (x, input) in poses {
            let x = model.constrain(mode, x, input);
            let rows = model.jacobian_rows(table.jacobian, &x, input);
            let moving = table.parts.iter().fold(0, |all, part| all | part.entries);
            rates.whole = rates.whole.max(fastest_once(&rows, moving));
            for (rate, part) in rates.parts.iter_mut().zip(table.parts) {
                *rate = rate.max(fastest_once(&rows, part.entries));
            }
        }
        rates
    }

    fn of_part(&self, index: usize) -> f64 {
        self.parts.get(index).copied().unwrap_or(self.whole)
    }
}

impl<F: Functions + Copy, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// The kind of equations with these values: conservative where nothing is lost.
    fn kind(&self, kind: EquationKind, loss: Option<FunctionId>) -> EquationKind {
        let lost = |loss| {
            let [lost] = self.values(loss, &[0.0; N], &Motion::default());
            lost
        };
        match (kind, loss) {
            (EquationKind::Smooth, Some(loss)) if lost(loss) == 0.0 => EquationKind::Conservative,
            _ => kind,
        }
    }

    /// The part with its own nature, and with its own longest step where it may go ahead.
    fn part(&self, part: Part, table: &PartTable, rate: f64) -> Part {
        let own = part.with_nature(Nature::new(self.kind(table.kind, table.loss), rate));
        match table.reads {
            pode::Reads::State => own.with_longest_step(RADIANS / rate),
            pode::Reads::StateAndInput => own,
        }
    }
}
