//! Follows what is computed, and looks at the guards in many places of it.

use pode::{Event, GuardId, Guarded as _, Motion, Piece, Signal, Watch};

use super::guard::OscillatorState;
use super::system::{MOST_GUARDS, OscillatorSystem};

/// Places of a piece in which each guard is looked at.
pub(super) const LOOKS: u32 = 200;

/// More places between the two neighbours of the lowest.
const NEAR: u32 = 32;
/// What is not told from zero, in parts of a guard's size: rounding of the orbit and the guard.
const ROUNDING: f64 = 1e-11;

/// Rounding of a time, in parts of it: of its product with a rate, and where it is put together.
const TIME_ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A place in which a guard was negative.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct NegativePlace {
    pub(super) guard: usize,
    /// Where in the advanced time, 0 ..= 1.
    pub(super) theta: f64,
    /// The guard in parts of its size.
    pub(super) value: f64,
}

/// One piece that was kept.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SeenPiece {
    /// Where it ends in the advanced time, 0 ..= 1.
    pub(super) theta_end: f64,
    /// The first guard that was negative inside, before whatever ended the piece.
    pub(super) inside: Option<NegativePlace>,
    /// A guard that is negative at its end; right if an event ended it there.
    at_end: Option<NegativePlace>,
    has_event: bool,
}

impl SeenPiece {
    /// Where a guard was negative without an event.
    pub(super) fn negative(&self) -> Option<NegativePlace> {
        self.inside.or_else(|| self.at_end.filter(|_| !self.has_event))
    }
}

/// The pieces of one advance.
#[derive(Debug)]
pub(super) struct OrbitWatch {
    pub(super) pieces: Vec<SeenPiece>,
    /// The latest time (s) that is looked at, whose rounding the input has in it.
    until: f64,
}

impl OrbitWatch {
    /// A watch over a time until `until` (s).
    pub(super) const fn new(until: f64) -> Self {
        Self { pieces: Vec::new(), until }
    }
}

impl Watch<OscillatorSystem> for OrbitWatch {
    fn piece<S: Signal<Motion>>(
        &mut self,
        model: &OscillatorSystem,
        piece: &Piece<'_, OscillatorSystem, S>,
    ) {
        let looks = (0..MOST_GUARDS).filter_map(|index| GuardLook::new(model, index, self.until));
        let (mut inside, mut at_end) = (None, None);
        for look in looks {
            inside = inside.or_else(|| look.inside(piece));
            at_end = at_end.or_else(|| look.negative(piece, 1.0));
        }
        let theta_end = piece.theta_end();
        self.pieces.push(SeenPiece { theta_end, inside, at_end, has_event: false });
    }

    fn event(&mut self, _model: &OscillatorSystem, event: &Event<'_, OscillatorSystem>) {
        let ends = self.pieces.last_mut().filter(|piece| piece.theta_end >= event.theta);
        if let Some(piece) = ends {
            piece.has_event = true;
        }
    }
}

/// One guard to look at.
struct GuardLook<'a> {
    model: &'a OscillatorSystem,
    index: usize,
    id: GuardId,
    scale: f64,
    until: f64,
}

impl<'a> GuardLook<'a> {
    fn new(model: &'a OscillatorSystem, index: usize, until: f64) -> Option<Self> {
        let spec = model.guards(()).get(index)?;
        Some(Self { model, index, id: spec.id, scale: spec.scale, until })
    }

    /// The guard at the fraction `part` of the piece, in parts of its size.
    fn at<S: Signal<Motion>>(&self, piece: &Piece<'_, OscillatorSystem, S>, part: f64) -> f64 {
        let (x, input) = piece.at(part);
        let value = self.model.guard((), self.id, &x, &input).value;
        value / self.size(piece, &x, &input)
    }

    /// The size of what is rounded: the guard's terms, and the moves that the orbit adds up.
    fn size<S: Signal<Motion>>(
        &self,
        piece: &Piece<'_, OscillatorSystem, S>,
        x: &OscillatorState,
        input: &Motion,
    ) -> f64 {
        let Some((level, term)) = self.model.guard_at(self.index) else { return self.scale };
        let moves = piece.dense.bounds().map_or(*x, |bounds| bounds.moves);
        let moved: OscillatorState = std::array::from_fn(|entry| x[entry].abs() + moves[entry]);
        let late = Motion {
            position: input.rate * self.until,
            rate: input.acceleration * self.until,
            ..Motion::default()
        };
        let rounded = TIME_ROUNDING / ROUNDING * term.size(&moved, &late);
        self.scale + level.abs() + term.size(&moved, input) + rounded
    }

    /// The place `part` of the piece, if the guard is negative there.
    fn negative<S: Signal<Motion>>(
        &self,
        piece: &Piece<'_, OscillatorSystem, S>,
        part: f64,
    ) -> Option<NegativePlace> {
        let value = self.at(piece, part);
        let (start, end) = (piece.theta.0, piece.theta_end());
        let theta = start + part * (end - start);
        (value < -ROUNDING).then_some(NegativePlace { guard: self.index, theta, value })
    }

    /// A place inside the piece where the guard is negative, before its end.
    fn inside<S: Signal<Motion>>(
        &self,
        piece: &Piece<'_, OscillatorSystem, S>,
    ) -> Option<NegativePlace> {
        let part = |n: u32| f64::from(n) / f64::from(LOOKS);
        let values: Vec<f64> = (1..LOOKS).map(|n| self.at(piece, part(n))).collect();
        let (lowest, _) = (1..LOOKS).zip(values).min_by(|a, b| a.1.total_cmp(&b.1))?;
        let near = (0..=NEAR).map(|n| {
            let between = 2.0 * f64::from(n) / f64::from(NEAR) - 1.0;
            part(lowest) + between / f64::from(LOOKS)
        });
        near.filter(|part| *part > 0.0 && *part < 1.0 - 1e-6)
            .find_map(|part| self.negative(piece, part))
    }
}
