use std::fmt;

/// Dimension of a quantity as powers of m, kg, s, A, K, mol and cd; that of an angle is 1.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Dimension([f64; 7]);

const BASE: [&str; 7] = ["m", "kg", "s", "A", "K", "mol", "cd"];

/// Common units, by the powers of m, kg and s.
const KNOWN: [([i8; 3], &str); 22] = [
    ([0, 0, 0], "1"),
    ([0, 0, -1], "1/s"),
    ([0, 0, -2], "1/s²"),
    ([1, 0, -1], "m/s"),
    ([1, 0, -2], "m/s²"),
    ([1, 0, -3], "m/s³"),
    ([-1, 0, 1], "s/m"),
    ([-1, 0, 0], "1/m"),
    ([2, 1, 0], "kg·m²"),
    ([1, 1, 0], "kg·m"),
    ([1, 1, -1], "N·s"),
    ([1, 1, -2], "N"),
    ([2, 1, -2], "N·m"),
    ([2, 1, -1], "N·m·s"),
    ([2, 1, -3], "W"),
    ([0, 1, -2], "N/m"),
    ([-1, 1, -2], "N/m²"),
    ([0, 1, -1], "N·s/m"),
    ([-2, 1, -2], "N/m³"),
    ([-3, 1, 0], "kg/m³"),
    ([-1, 1, -1], "Pa·s"),
    ([1, 1, -3], "N/s"),
];

const SAME: f64 = 1e-9;

impl Dimension {
    pub const NONE: Self = Self([0.0; 7]);
    pub const LENGTH: Self = Self::mechanical(1.0, 0.0, 0.0);
    pub const MASS: Self = Self::mechanical(0.0, 1.0, 0.0);
    pub const TIME: Self = Self::mechanical(0.0, 0.0, 1.0);
    pub const RATE: Self = Self::mechanical(0.0, 0.0, -1.0);
    pub const SPEED: Self = Self::mechanical(1.0, 0.0, -1.0);
    pub const ACCELERATION: Self = Self::mechanical(1.0, 0.0, -2.0);
    pub const FORCE: Self = Self::mechanical(1.0, 1.0, -2.0);
    pub const ENERGY: Self = Self::mechanical(2.0, 1.0, -2.0);
    pub const POWER: Self = Self::mechanical(2.0, 1.0, -3.0);
    pub const INERTIA: Self = Self::mechanical(2.0, 1.0, 0.0);

    pub const fn mechanical(metre: f64, kilogram: f64, second: f64) -> Self {
        Self([metre, kilogram, second, 0.0, 0.0, 0.0, 0.0])
    }

    pub(super) fn base(index: usize) -> Self {
        let mut all = [0.0; 7];
        if let Some(exponent) = all.get_mut(index) {
            *exponent = 1.0;
        }
        Self(all)
    }

    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    #[must_use]
    pub fn over(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }

    #[must_use]
    pub fn to(self, exponent: f64) -> Self {
        Self(self.0.map(|it| it * exponent))
    }

    pub fn fits(self, other: Self) -> bool {
        self.0.iter().zip(other.0).all(|(a, b)| (a - b).abs() < SAME)
    }

    /// Returns `true` for a ratio or an angle.
    pub fn is_none(self) -> bool {
        self.fits(Self::NONE)
    }
}

impl fmt::Display for Dimension {
    /// Writes the SI unit, as `N·m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = KNOWN.iter().find(|([m, kg, s], _)| {
            self.fits(Self::mechanical((*m).into(), (*kg).into(), (*s).into()))
        });
        if let Some((_, unit)) = known {
            return f.write_str(unit);
        }
        let [metre, ..] = self.0;
        if self.fits(Self::mechanical(metre, 1.0, -2.0)) {
            let (sign, power) = if metre < 1.0 { ('/', 1.0 - metre) } else { ('·', metre - 1.0) };
            return write!(f, "N{sign}{}", raised("m", power));
        }
        let side = |sign: f64| {
            let factors = BASE.iter().zip(self.0).filter(|(_, power)| power * sign > SAME);
            factors.map(|(unit, power)| raised(unit, power * sign)).collect::<Vec<_>>().join("·")
        };
        let (above, below) = (side(1.0), side(-1.0));
        let above = if above.is_empty() { "1".to_owned() } else { above };
        match below.contains('·') {
            _ if below.is_empty() => f.write_str(&above),
            false => write!(f, "{above}/{below}"),
            true => write!(f, "{above}/({below})"),
        }
    }
}

pub(super) fn raised(unit: &str, power: f64) -> String {
    if (power - 1.0).abs() < SAME {
        unit.to_owned()
    } else if (power - 2.0).abs() < SAME {
        format!("{unit}²")
    } else if (power - 3.0).abs() < SAME {
        format!("{unit}³")
    } else {
        // Written exponents never have as many as 12 digits.
        let rounded = (power * 1e12).round() / 1e12;
        format!("{unit}^{rounded}")
    }
}
