//! Motion of a mode between its events: equations and statements about them, sound or not.

use pode::{EquationKind, Matrix, Motion, Nature, State};

use super::STATE;
use super::bytes::Bytes;

#[derive(Clone, Copy, Debug)]
enum Field {
    Falls,
    /// Rate (1/s), of decay or growth.
    Linear(f64),
    /// Rate (rad/s).
    Swings(f64),
    Explodes,
    Driven,
    /// Size and time (s) of the jump.
    Jumps(f64, f64),
    Becomes(f64, f64),
    Frozen,
    GoesBack,
}

impl Field {
    fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        let time = |bytes: &mut Bytes<'_>| bytes.sized(1e-5, 0.05);
        match bytes.byte() % 16 {
            0..=3 => Self::Falls,
            4..=5 => Self::Linear(bytes.signed(1.0, 1e7)),
            6..=7 => Self::Swings(bytes.sized(1.0, 1e5)),
            8 => Self::Explodes,
            9..=10 => Self::Driven,
            11 => Self::Jumps(time(bytes), bytes.odd(|it| it.signed(1.0, 1e12))),
            12 => Self::Becomes(time(bytes), bytes.odd(|_| f64::NAN)),
            13 => Self::Becomes(time(bytes), bytes.odd(|it| it.signed(1e300, f64::MAX))),
            14 => Self::Frozen,
            _ => Self::GoesBack,
        }
    }

    fn derivative(self, x: &[f64; STATE], input: &Motion) -> [f64; STATE] {
        let [t, _, z, w] = *x;
        match self {
            Self::Falls => [1.0, 0.0, w, -9.81],
            Self::Linear(k) => [1.0, 0.0, -k * z, -k * w],
            Self::Swings(k) => [1.0, 0.0, w, -k * k * z],
            Self::Explodes => [1.0, 0.0, z * z * 1e3 + 1.0, w * w * w + 1.0],
            Self::Driven => [1.0, 0.0, 1e3 * (input.position - z), 1e3 * (input.rate - w)],
            Self::Jumps(t0, by) => [1.0, 0.0, w, if t < t0 { 0.0 } else { by }],
            Self::Becomes(t0, value) if t >= t0 => [value; STATE],
            Self::Becomes(..) => [1.0, 0.0, w, 0.0],
            Self::Frozen => [0.0; STATE],
            Self::GoesBack => [-1.0, 0.0, w, 0.0],
        }
    }
}

/// Replacement of a number that a model returns.
#[derive(Clone, Copy, Debug)]
struct Lie {
    /// Start (s); infinite if never.
    from: f64,
    value: f64,
}

impl Lie {
    fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        let from = if bytes.is_one_in(6) { bytes.sized(1e-5, 0.05) } else { f64::INFINITY };
        Self { from, value: bytes.odd(|it| it.signed(1e-3, f64::MAX)) }
    }

    fn or(self, t: f64, truth: f64) -> f64 {
        if t >= self.from { self.value } else { truth }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct ModePart {
    field: Field,
    jacobian: Lie,
    readout: Lie,
    /// Slaves the last coordinate to the input, or to a lie.
    slaved: Option<Lie>,
    pub nature: Nature,
    pub longest_step: f64,
    pub is_negated: bool,
}

impl ModePart {
    pub fn from_bytes(bytes: &mut Bytes<'_>) -> Self {
        const KINDS: [EquationKind; 5] = [
            EquationKind::Affine,
            EquationKind::Linear,
            EquationKind::Smooth,
            EquationKind::Conservative,
            EquationKind::Stiff,
        ];
        Self {
            field: Field::from_bytes(bytes),
            jacobian: Lie::from_bytes(bytes),
            readout: Lie::from_bytes(bytes),
            slaved: bytes.is_one_in(4).then(|| Lie::from_bytes(bytes)),
            nature: Nature::new(
                bytes.pick(&KINDS),
                bytes.odd(|it| if it.is_true() { 0.0 } else { it.sized(1.0, 1e7) }),
            ),
            longest_step: match bytes.byte() % 4 {
                0..=1 => f64::INFINITY,
                _ => bytes.odd(|it| it.sized(1e-5, 1e-2)),
            },
            is_negated: bytes.is_one_in(4),
        }
    }

    pub const fn fall() -> Self {
        const NEVER: Lie = Lie { from: f64::INFINITY, value: 0.0 };
        Self {
            field: Field::Falls,
            jacobian: NEVER,
            readout: NEVER,
            slaved: None,
            nature: Nature::new(EquationKind::Affine, 0.0),
            longest_step: f64::INFINITY,
            is_negated: false,
        }
    }

    pub fn derivative(&self, x: &[f64; STATE], input: &Motion) -> [f64; STATE] {
        self.field.derivative(x, input)
    }

    /// By forward differences, without lies.
    pub fn jacobian(&self, x: &[f64; STATE], input: &Motion) -> <[f64; STATE] as State>::Matrix {
        let origin = self.derivative(x, input);
        Matrix::from_columns(|index| {
            let step = 1e-6 * (1.0 + x[index].abs());
            let moved = self.derivative(&x.with_entry(index, x[index] + step), input);
            let column = moved.plus(-1.0, &origin).times(1.0 / step);
            column.map(|entry| self.jacobian.or(x[0], entry))
        })
    }

    pub fn readout(&self, x: &[f64; STATE], input: &Motion) -> f64 {
        self.readout.or(x[0], x[2] - input.position)
    }

    pub fn constrain(&self, x: &[f64; STATE], input: &Motion) -> [f64; STATE] {
        match self.slaved {
            // The state is replaced whole, so it cannot show a NaN of the step.
            Some(lie) if lie.value < 0.0 => [1e-3, 0.0, 1.0, lie.or(1e-3, input.position)],
            Some(lie) => x.with_entry(3, lie.or(x[0], input.position)),
            None => *x,
        }
    }
}
