//! Observer of a computed orbit that samples the guards in many places.

use pode::{Event, GuardId, Guarded as _, Motion, Piece, Signal, Watch};

use super::guard::OscillatorState;
use super::system::{MOST_GUARDS, OscillatorSystem};

pub(super) const LOOKS: u32 = 200;

/// Additional samples between both neighbours of the lowest.
const NEAR: u32 = 32;
/// Rounding of the orbit and the guard, relative to the guard's size.
const ROUNDING: f64 = 1e-11;

/// Relative rounding of a time: of its product with a rate, and of its sum.
const TIME_ROUNDING: f64 = 8.0 * f64::EPSILON;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct NegativePlace {
    pub(super) guard: usize,
    /// Place in the advanced time, 0 ..= 1.
    pub(super) theta: f64,
    pub(super) value: f64,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct SeenPiece {
    pub(super) theta_end: f64,
    /// First negative guard inside, before the end of the piece.
    pub(super) inside: Option<NegativePlace>,
    /// Negative guard at its end; valid if an event ended it there.
    at_end: Option<NegativePlace>,
    has_event: bool,
}

impl SeenPiece {
    pub(super) fn negative(&self) -> Option<NegativePlace> {
        self.inside.or_else(|| self.at_end.filter(|_| !self.has_event))
    }
}

#[derive(Debug)]
pub(super) struct OrbitWatch {
    pub(super) pieces: Vec<SeenPiece>,
    /// End of the observed time (s); its rounding affects the input.
    until: f64,
}

impl OrbitWatch {
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

    fn at<S: Signal<Motion>>(&self, piece: &Piece<'_, OscillatorSystem, S>, part: f64) -> f64 {
        let (x, input) = piece.at(part);
        let value = self.model.guard((), self.id, &x, &input).value;
        value / self.size(piece, &x, &input)
    }

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
