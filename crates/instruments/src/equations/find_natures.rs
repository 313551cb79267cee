//! Natures of modes, from Jacobians at rest poses.

use pode::{EquationKind, Guarded as _, Motion, Nature, Part};

use crate::equations::jacobian_bound::{RADIANS, fastest_once};
use crate::equations::mode_number::ModeNumber;
use crate::equations::model::EquationModel;
use crate::equations::natures::{MAX_MODE_PARTS, ModeNature, ModeNatures};
use crate::equations::table::{Equations, FunctionId, ModeTable, PartTable};

/// Travel of a key between the two rest poses at which rates are computed (m).
const TRAVEL: f64 = 0.01;

/// Number of poses between the two, both included: the rates count at those where the mode holds.
const ON_THE_WAY: u8 = 9;

/// Lead of the input over the pose, as fractions of the whole travel: the finger presses.
const AHEAD: [f64; 2] = [0.0, 0.1];

/// Least rate of a mode (rad/s).
const SLOWEST: f64 = 1e-100;

type Pose<const N: usize> = ([f64; N], Motion);

impl ModeNatures {
    pub(crate) fn of<F: Equations + Clone, const N: usize, const C: usize>(
        model: &EquationModel<F, N, C>,
    ) -> Self {
        let mut natures = Self::default();
        let mut next = 0;
        let poses = [0.0, TRAVEL].map(|travel| {
            let position = travel * model.input_per_metre();
            let input = Motion { position, ..Motion::default() };
            (model.own_rest(&input), input)
        });
        for (number, table) in (0..).zip(&model.table().modes) {
            let rates = Rates::of(model, ModeNumber(number), &poses);
            // A contact's motion is a multiple of it, even in a mode without a rate.
            let rate = rates.whole.max(SLOWEST);
            let nature = Nature {
                kind: model.kind(table.kind, table.loss),
                rate,
                longest_step: RADIANS / rate,
                longest_projection: table
                    .constraints
                    .longest_projection
                    .map_or(f64::INFINITY, |limit| model.of_constants(limit)),
            };
            let first = natures.add_parts(model, table, &rates, &mut next);
            if let Some(mode) = natures.modes.get_mut(usize::from(number)) {
                *mode = ModeNature { nature, first };
            }
        }
        natures
    }

    /// Appends the parts of a mode that has several; returns the index of the first.
    fn add_parts<F: Equations + Clone, const N: usize, const C: usize>(
        &mut self,
        model: &EquationModel<F, N, C>,
        table: &ModeTable,
        rates: &Rates,
        next: &mut usize,
    ) -> usize {
        let first = *next;
        let places = self.parts.get_mut(first..first + table.parts.len());
        let Some(places) = places.filter(|places| places.len() > 1) else { return MAX_MODE_PARTS };
        for (at, (place, part)) in places.iter_mut().zip(&table.parts).enumerate() {
            let given = table.part_list.get(at).copied().unwrap_or(Part::WHOLE);
            *place = model.part(given, part, rates.of_part(at));
        }
        *next = first + table.parts.len();
        first
    }
}

/// Fastest rates (rad/s) of a mode and of its parts.
struct Rates {
    whole: f64,
    parts: [f64; pode::MAX_PARTS],
}

impl Rates {
    /// Returns the largest rates over the poses between two at which the mode holds, with its
    /// guards positive; over these two if it holds at none.
    ///
    /// Other poses do not count: rubbing under a force that never occurs would be the fastest.
    fn of<F: Equations + Clone, const N: usize, const C: usize>(
        model: &EquationModel<F, N, C>,
        mode: ModeNumber,
        [first, last]: &[Pose<N>; 2],
    ) -> Self {
        let table = model.mode_table(mode);
        let mut rates = Self { whole: 0.0, parts: [0.0; pode::MAX_PARTS] };
        let on_the_way = |index: u8, ahead: f64| {
            let fraction = f64::from(index) / f64::from(ON_THE_WAY - 1);
            let (x, _) = between(first, last, fraction);
            let (_, input) = between(first, last, fraction + ahead);
            (model.constrain(mode, &x, &input), input)
        };
        let holds = |(x, input): &Pose<N>| {
            let guards = model.guards(mode).iter();
            guards.map(|it| model.guard(mode, it.id, x, input).value).all(|value| value >= 0.0)
        };
        let poses = || (0..ON_THE_WAY).flat_map(|index| AHEAD.map(|ahead| (index, ahead)));
        let is_met = poses().any(|(index, ahead)| holds(&on_the_way(index, ahead)));
        for (index, ahead) in poses() {
            let is_end = ahead == 0.0 && (index == 0 || index == ON_THE_WAY - 1);
            let (x, input) = on_the_way(index, ahead);
            let counts = if is_met { holds(&(x, input)) } else { is_end };
            if counts {
                rates.add(table, &model.mode_rows(table, &x, &input));
            }
        }
        rates
    }

    fn add<const N: usize>(&mut self, table: &ModeTable, rows: &[[f64; N]; N]) {
        let moving = table.parts.iter().fold(0, |all, part| all | part.entries);
        self.whole = self.whole.max(fastest_once(rows, moving));
        for (rate, part) in self.parts.iter_mut().zip(&table.parts) {
            *rate = rate.max(fastest_once(rows, part.entries));
        }
    }

    fn of_part(&self, index: usize) -> f64 {
        self.parts.get(index).copied().unwrap_or(self.whole)
    }
}

fn between<const N: usize>(first: &Pose<N>, last: &Pose<N>, fraction: f64) -> Pose<N> {
    let at = |from: f64, to: f64| from + fraction * (to - from);
    let x = core::array::from_fn(|i| at(first.0[i], last.0[i]));
    let position = at(first.1.position, last.1.position);
    (x, Motion { position, ..Motion::default() })
}

impl<F: Equations + Clone, const N: usize, const C: usize> EquationModel<F, N, C> {
    /// Returns the kind of equations with these values: conservative if nothing is lost.
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

    /// Returns the part with its own nature, and with its own longest step if it may go ahead.
    fn part(&self, part: Part, table: &PartTable, rate: f64) -> Part {
        let own = part.with_nature(Nature::new(self.kind(table.kind, table.loss), rate));
        match table.reads {
            pode::Reads::State => own.with_longest_step(RADIANS / rate),
            pode::Reads::StateAndInput => own,
        }
    }
}
