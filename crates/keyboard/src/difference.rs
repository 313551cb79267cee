/// Difference of a key's parameter from the value that an instrument has there.
#[derive(Clone, Copy, PartialEq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Difference {
    /// Added to the instrument's value (the parameter's unit).
    Offset(f64),
    /// Multiplies the instrument's value.
    Factor(f64),
    /// Replaces the instrument's value (the parameter's unit).
    Value(f64),
}

impl Difference {
    /// Returns the value of a parameter that is `base` in the instrument.
    pub fn applied_to(self, base: f64) -> f64 {
        match self {
            Self::Offset(offset) => base + offset,
            Self::Factor(factor) => base * factor,
            Self::Value(value) => value,
        }
    }

    /// Returns this difference if it turns `base` into `value` to the last bit, else the value.
    #[must_use]
    pub fn exactly(self, base: f64, value: f64) -> Self {
        let is_exact = self.applied_to(base).to_bits() == value.to_bits();
        if is_exact { self } else { Self::Value(value) }
    }

    /// Returns the difference from `base` of `after` laid over this one.
    #[must_use]
    pub fn then(self, after: Self, base: f64) -> Self {
        let value = after.applied_to(self.applied_to(base));
        let both = match (self, after) {
            (Self::Offset(a), Self::Offset(b)) => Self::Offset(a + b),
            (Self::Factor(a), Self::Factor(b)) => Self::Factor(a * b),
            _ => Self::Value(value),
        };
        // The sum may round otherwise than the two steps.
        both.exactly(base, value)
    }

    /// Returns the number of an offset, a factor or a value.
    pub const fn amount(self) -> f64 {
        match self {
            Self::Offset(amount) | Self::Factor(amount) | Self::Value(amount) => amount,
        }
    }

    /// Returns a difference of this kind with another number.
    #[must_use]
    pub const fn with_amount(self, amount: f64) -> Self {
        match self {
            Self::Offset(_) => Self::Offset(amount),
            Self::Factor(_) => Self::Factor(amount),
            Self::Value(_) => Self::Value(amount),
        }
    }

    /// Returns `true` if both are offsets, both factors or both values.
    pub fn is_like(self, other: Self) -> bool {
        core::mem::discriminant(&self) == core::mem::discriminant(&other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_differences_are_one_to_the_last_bit() {
        let base = 0.061_522;
        for (first, second) in [
            (Difference::Offset(1e-4), Difference::Offset(3.3e-5)),
            (Difference::Factor(1.1), Difference::Factor(0.7)),
            (Difference::Offset(1e-4), Difference::Factor(1.3)),
            (Difference::Value(0.05), Difference::Offset(1e-3)),
        ] {
            let value = second.applied_to(first.applied_to(base));
            let both = first.then(second, base);
            assert_eq!(both.applied_to(base).to_bits(), value.to_bits(), "{first:?} {second:?}");
        }
    }
}
