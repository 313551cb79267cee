//! Guards of state and input, with their bounds over an enclosed orbit.

use pode::{Enclosure, GuardBound, GuardValue, Motion};

use lab::random::SeededRandom;

pub(super) const ENTRIES: usize = 8;

pub(super) type OscillatorState = [f64; ENTRIES];

type Orbit = Enclosure<OscillatorState, Motion>;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum GuardTerm {
    /// Σ wᵢ xᵢ
    Linear { weights: OscillatorState },
    /// −w x²
    Square { entry: usize, weight: f64 },
    /// −a sin(k x); k may be large.
    Wave { entry: usize, amplitude: f64, k: f64 },
    /// −w s
    Position { weight: f64 },
    /// −w s'
    Rate { weight: f64 },
    /// x − w s
    Distance { entry: usize, weight: f64 },
    /// −w x s
    Product { entry: usize, weight: f64 },
}

impl GuardTerm {
    pub(super) fn random(random: &mut SeededRandom, moving: &[usize], h: f64) -> Self {
        let entry = moving[random.below(moving.len())];
        let weight = random.between(-1.0, 1.0);
        match random.below(8) {
            0 | 1 => {
                let mut weights = OscillatorState::default();
                for entry in moving {
                    weights[*entry] = random.between(-1.0, 1.0);
                }
                Self::Linear { weights }
            }
            2 => Self::Square { entry, weight },
            3 => Self::Wave { entry, amplitude: weight, k: random.spread(0.5, 100.0) },
            4 => Self::Position { weight },
            5 => Self::Rate { weight: weight * h },
            6 => Self::Distance { entry, weight },
            _ => Self::Product { entry, weight },
        }
    }

    pub(super) fn at(&self, x: &OscillatorState, dx: &OscillatorState, s: &Motion) -> GuardValue {
        match *self {
            Self::Linear { weights } => {
                let sum = |x: &OscillatorState| weights.iter().zip(x).map(|(w, x)| w * x).sum();
                GuardValue::new(sum(x), sum(dx))
            }
            Self::Square { entry, weight } => {
                GuardValue::new(-weight * x[entry].powi(2), -2.0 * weight * x[entry] * dx[entry])
            }
            Self::Wave { entry, amplitude, k } => {
                let (sin, cos) = (k * x[entry]).sin_cos();
                GuardValue::new(-amplitude * sin, -amplitude * k * cos * dx[entry])
            }
            Self::Position { weight } => GuardValue::new(-weight * s.position, -weight * s.rate),
            Self::Rate { weight } => GuardValue::new(-weight * s.rate, -weight * s.acceleration),
            Self::Distance { entry, weight } => {
                GuardValue::new(x[entry] - weight * s.position, dx[entry] - weight * s.rate)
            }
            Self::Product { entry, weight } => GuardValue::new(
                -weight * x[entry] * s.position,
                -weight * (dx[entry] * s.position + x[entry] * s.rate),
            ),
        }
    }

    pub(super) fn size(&self, x: &OscillatorState, s: &Motion) -> f64 {
        match *self {
            Self::Linear { weights } => weights.iter().zip(x).map(|(w, x)| (w * x).abs()).sum(),
            Self::Square { entry, weight } => weight.abs() * x[entry].powi(2),
            // The argument's own rounding is multiplied by the amplitude.
            Self::Wave { entry, amplitude, k } => amplitude.abs() * (1.0 + (k * x[entry]).abs()),
            Self::Position { weight } => (weight * s.position).abs(),
            Self::Rate { weight } => (weight * s.rate).abs(),
            Self::Distance { entry, weight } => x[entry].abs() + (weight * s.position).abs(),
            Self::Product { entry, weight } => (weight * x[entry] * s.position).abs(),
        }
    }

    pub(super) fn bound(&self, over: &Orbit) -> GuardBound {
        match *self {
            Self::Linear { weights } => {
                let terms = weights.iter().enumerate().filter(|(_, weight)| **weight != 0.0);
                terms.fold(GuardBound::STILL, |sum, (entry, weight)| {
                    sum.plus(over.entry(entry).times(*weight))
                })
            }
            Self::Square { entry, weight } => square(over, entry).times(weight),
            Self::Wave { entry, amplitude, k } => wave(over, entry, k).times(amplitude),
            Self::Position { weight } => over.position().times(weight),
            Self::Rate { weight } => over.rate().times(weight),
            Self::Distance { entry, weight } => {
                over.entry(entry).plus(over.position().times(weight))
            }
            Self::Product { entry, weight } => product(over, entry).times(weight),
        }
    }
}

/// f(x) moves by |f'| as far as x does, and bends by |f'| bends + |f''| speeds².
fn square(over: &Orbit, entry: usize) -> GuardBound {
    let GuardBound { moves, bend } = over.entry(entry);
    let start = over.start[entry].abs();
    let speed = over.speeds[entry];
    GuardBound::new(
        moves * (2.0 * start + moves),
        2.0 * (start + moves) * bend + 2.0 * speed * speed,
    )
}

fn wave(over: &Orbit, entry: usize, k: f64) -> GuardBound {
    let (GuardBound { moves, bend }, speed) = (over.entry(entry), over.speeds[entry]);
    GuardBound::new((k * moves).min(2.0), k * bend + k * k * speed * speed)
}

/// x s bends by |x| s'' + 2 |x'| |s'| + |x''| |s|.
fn product(over: &Orbit, entry: usize) -> GuardBound {
    let Some(input) = over.input else { return GuardBound::UNKNOWN };
    let (x, s) = (over.entry(entry), over.position());
    let (most_x, most_s) = (over.start[entry].abs() + x.moves, input.position);
    GuardBound::new(
        most_x * s.moves + most_s * x.moves,
        most_x * s.bend + 2.0 * over.speeds[entry] * s.moves + most_s * x.bend,
    )
}
