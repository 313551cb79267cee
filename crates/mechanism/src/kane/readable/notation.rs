use super::words;
use crate::kane::graph::{BinaryFunction, UnaryFunction};

/// Notation of written equations.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Notation {
    /// Notation of descriptions: `k1*(s - theta_k)`.
    Text,
    Latex,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Tightness {
    Sum,
    Product,
    Power,
    Atom,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct WrittenPart {
    pub(super) text: String,
    pub(super) tightness: Tightness,
}

impl WrittenPart {
    pub(super) const fn atom(text: String) -> Self {
        Self { text, tightness: Tightness::Atom }
    }
}

/// Returns numerator and denominator of a small ratio without a short decimal form, as of 1/3.
fn ratio(value: f64) -> Option<(u16, u16)> {
    let is_long = format!("{value}").len() > 12;
    let below = (2..=99).filter(|_| is_long).find(|below| {
        let above = (value * f64::from(*below)).round();
        (1.0..1000.0).contains(&above) && (above / f64::from(*below) - value).abs() == 0.0
    })?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 999")]
    let above = (value * f64::from(below)).round() as u16;
    Some((above, below))
}

impl Notation {
    pub(super) fn name(self, name: &str) -> WrittenPart {
        WrittenPart::atom(match self {
            Self::Text => name.to_owned(),
            Self::Latex => words::latex(name),
        })
    }

    pub(super) fn number(self, value: f64) -> WrittenPart {
        if let Some((above, below)) = ratio(value) {
            let [above, below] = [above, below].map(|it| WrittenPart::atom(it.to_string()));
            return self.fraction(&above, &below);
        }
        let scientific = format!("{value:e}");
        let plain = format!("{value}");
        let short = if scientific.len() + 3 < plain.len() { scientific } else { plain };
        match (self, short.split_once('e')) {
            (Self::Latex, Some((mantissa, exponent))) => WrittenPart {
                text: format!("{mantissa} \\cdot 10^{{{exponent}}}"),
                tightness: Tightness::Product,
            },
            _ => WrittenPart::atom(short),
        }
    }

    /// Returns the text, in brackets where it binds less tightly than `tightness`.
    pub(super) fn within(self, written: &WrittenPart, tightness: Tightness) -> String {
        if written.tightness >= tightness {
            written.text.clone()
        } else {
            self.bracketed(&written.text)
        }
    }

    fn bracketed(self, text: &str) -> String {
        match self {
            Self::Text => format!("({text})"),
            Self::Latex => format!("\\left({text}\\right)"),
        }
    }

    /// Returns factors side by side; 1 without factors.
    pub(super) fn product(self, factors: &[WrittenPart]) -> WrittenPart {
        match factors {
            [] => WrittenPart::atom("1".to_owned()),
            [only] => only.clone(),
            _ => {
                let factors: Vec<String> =
                    factors.iter().map(|it| self.within(it, Tightness::Product)).collect();
                let sign = match self {
                    Self::Text => "*",
                    Self::Latex => " \\, ",
                };
                WrittenPart { text: factors.join(sign), tightness: Tightness::Product }
            }
        }
    }

    pub(super) fn fraction(self, above: &WrittenPart, below: &WrittenPart) -> WrittenPart {
        match self {
            Self::Text => {
                let above = self.within(above, Tightness::Product);
                let below = self.within(below, Tightness::Power);
                WrittenPart { text: format!("{above}/{below}"), tightness: Tightness::Product }
            }
            Self::Latex => WrittenPart {
                text: format!("\\frac{{{}}}{{{}}}", above.text, below.text),
                tightness: Tightness::Product,
            },
        }
    }

    pub(super) fn power(self, base: &WrittenPart, exponent: &WrittenPart) -> WrittenPart {
        let base = self.within(base, Tightness::Atom);
        let text = match self {
            Self::Text => format!("{base}^{}", self.within(exponent, Tightness::Atom)),
            Self::Latex => format!("{{{base}}}^{{{}}}", exponent.text),
        };
        WrittenPart { text, tightness: Tightness::Power }
    }

    pub(super) fn unary(self, function: UnaryFunction, x: &WrittenPart) -> WrittenPart {
        let name = unary_name(function);
        WrittenPart::atom(match (self, function) {
            (Self::Text, _) => format!("{name}({})", x.text),
            (Self::Latex, UnaryFunction::Sqrt) => format!("\\sqrt{{{}}}", x.text),
            (Self::Latex, UnaryFunction::Abs) => format!("\\left|{}\\right|", x.text),
            (
                Self::Latex,
                UnaryFunction::Sin
                | UnaryFunction::Cos
                | UnaryFunction::Tanh
                | UnaryFunction::Exp
                | UnaryFunction::Ln,
            ) => format!("\\{name}{}", self.bracketed(&x.text)),
            (Self::Latex, _) => {
                format!("\\operatorname{{{}}}{}", words::escaped(name), self.bracketed(&x.text))
            }
        })
    }

    pub(super) fn binary(
        self,
        function: BinaryFunction,
        x: &WrittenPart,
        y: &WrittenPart,
    ) -> WrittenPart {
        let name = match function {
            BinaryFunction::Power => return self.power(x, y),
            BinaryFunction::Atan2 => "atan2",
            BinaryFunction::Hypot => "hypot",
            BinaryFunction::Min => "min",
            BinaryFunction::Max => "max",
        };
        let list = format!("{}, {}", x.text, y.text);
        WrittenPart::atom(match (self, function) {
            (Self::Text, _) => format!("{name}({list})"),
            (Self::Latex, BinaryFunction::Min | BinaryFunction::Max) => {
                format!("\\{name}{}", self.bracketed(&list))
            }
            (Self::Latex, _) => format!("\\operatorname{{{name}}}{}", self.bracketed(&list)),
        })
    }

    pub(super) fn select(self, [condition, positive, other]: [&WrittenPart; 3]) -> WrittenPart {
        let (condition, positive, other) = (&condition.text, &positive.text, &other.text);
        WrittenPart::atom(match self {
            Self::Text => format!("if({condition} > 0, {positive}, {other})"),
            Self::Latex => format!(
                "\\begin{{cases}} {positive} & {condition} > 0 \\\\ {other} & \\text{{otherwise}} \
                 \\end{{cases}}"
            ),
        })
    }
}

const fn unary_name(function: UnaryFunction) -> &'static str {
    match function {
        UnaryFunction::Sin => "sin",
        UnaryFunction::Cos => "cos",
        UnaryFunction::Tanh => "tanh",
        UnaryFunction::Exp => "exp",
        UnaryFunction::Ln => "ln",
        UnaryFunction::Sqrt => "sqrt",
        UnaryFunction::Abs => "abs",
        UnaryFunction::Sign => "sign",
        UnaryFunction::Softplus => "softplus",
        UnaryFunction::Logistic => "logistic",
        UnaryFunction::SoftplusArea => "softplus_area",
        UnaryFunction::SoftplusSquareArea => "softplus_square_area",
        UnaryFunction::Asin => "asin",
        UnaryFunction::Acos => "acos",
    }
}
