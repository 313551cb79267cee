use instruments::equations::functions::{
    larger, logistic, sign, smaller, softplus, softplus_area, softplus_square_area,
};
use pode::math;

/// Function of one argument.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum UnaryFunction {
    Sin,
    Cos,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Abs,
    /// Sign of x: −1, 0 or 1.
    Sign,
    /// Value of ln(1 + eˣ), without overflow.
    Softplus,
    /// Slope of `Softplus`, 1/(1 + e⁻ˣ).
    Logistic,
    /// Integral ∫ softplus from −∞ to x.
    SoftplusArea,
    /// Integral ∫ softplus² from −∞ to x.
    SoftplusSquareArea,
    Asin,
    Acos,
}

/// Function of two arguments.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum BinaryFunction {
    Atan2,
    /// Value of √(x² + y²), without overflow.
    Hypot,
    /// Value of xʸ; NaN for a negative x unless y is whole.
    Power,
    Min,
    Max,
}

impl UnaryFunction {
    pub fn of(self, x: f64) -> f64 {
        match self {
            Self::Sin => math::sin_cos(x).0,
            Self::Cos => math::sin_cos(x).1,
            Self::Tanh => math::tanh(x),
            Self::Exp => math::exp(x),
            Self::Ln => math::ln(x),
            Self::Sqrt => math::sqrt(x),
            Self::Abs => x.abs(),
            Self::Sign => sign(x),
            Self::Softplus => softplus(x),
            Self::Logistic => logistic(x),
            Self::SoftplusArea => softplus_area(x),
            Self::SoftplusSquareArea => softplus_square_area(x),
            Self::Asin => math::asin(x),
            Self::Acos => math::acos(x),
        }
    }
}

impl BinaryFunction {
    /// Returns the function's value at `x` and `y`, in written order.
    pub fn of(self, x: f64, y: f64) -> f64 {
        match self {
            Self::Atan2 => math::atan2(x, y),
            Self::Hypot => math::hypot(x, y),
            Self::Power => math::powf(x, y),
            Self::Min => smaller(x, y),
            Self::Max => larger(x, y),
        }
    }
}
