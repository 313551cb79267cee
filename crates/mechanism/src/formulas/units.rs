//! Names of units with SI prefixes, and compound units.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "a language has many pieces, and each place takes few of them"
)]

use documents::{choice, quoted};

use super::dimension::raised;
use super::lexer::{Lexeme, LexemeKind, lex};
use super::{Dimension, TextError};

/// Unit with its conversion to SI.
#[derive(Clone, PartialEq, Debug)]
pub struct PhysicalUnit {
    factor: f64,
    /// Power of ten on top of the factor, kept apart so that 5 mm is 5/1000 exactly.
    tens: i32,
    pub dimension: Dimension,
    /// SI unit without prefixes: `N·m/rad`.
    pub si: String,
}

impl PhysicalUnit {
    pub fn to_si(&self, number: f64) -> f64 {
        let scaled = number * self.factor;
        if self.tens < 0 { scaled / 10f64.powi(-self.tens) } else { scaled * 10f64.powi(self.tens) }
    }

    /// Returns `true` if a number of this unit is unchanged in SI.
    pub fn is_si(&self) -> bool {
        (self.to_si(1.0) - 1.0).abs() < f64::EPSILON
    }
}

/// Unit name: factor, power of ten, powers of m, kg, s, name in SI, and allowed prefixes.
type NamedUnit = (&'static str, f64, i32, [i8; 3], &'static str, Prefixes);

#[derive(Clone, Copy, PartialEq, Eq)]
enum Prefixes {
    Usual,
    None,
}

use Prefixes::{None as Plain, Usual};

const UNITS: [NamedUnit; 19] = [
    ("m", 1.0, 0, [1, 0, 0], "m", Usual),
    ("g", 1.0, -3, [0, 1, 0], "kg", Usual),
    ("s", 1.0, 0, [0, 0, 1], "s", Usual),
    ("rad", 1.0, 0, [0, 0, 0], "rad", Usual),
    ("deg", std::f64::consts::PI / 180.0, 0, [0, 0, 0], "rad", Plain),
    ("rev", std::f64::consts::TAU, 0, [0, 0, 0], "rad", Plain),
    ("N", 1.0, 0, [1, 1, -2], "N", Usual),
    ("gf", 9.80665, -3, [1, 1, -2], "N", Plain),
    ("kgf", 9.80665, 0, [1, 1, -2], "N", Plain),
    ("J", 1.0, 0, [2, 1, -2], "J", Usual),
    ("W", 1.0, 0, [2, 1, -3], "W", Usual),
    ("Pa", 1.0, 0, [-1, 1, -2], "Pa", Usual),
    ("Hz", 1.0, 0, [0, 0, -1], "1/s", Usual),
    ("hz", 1.0, 0, [0, 0, -1], "1/s", Usual),
    ("min", 60.0, 0, [0, 0, 1], "s", Plain),
    ("h", 3600.0, 0, [0, 0, 1], "s", Plain),
    ("inch", 0.0254, 0, [1, 0, 0], "m", Plain),
    ("t", 1.0, 3, [0, 1, 0], "kg", Plain),
    ("percent", 1.0, -2, [0, 0, 0], "1", Plain),
];

/// Base units that mechanics seldom needs, by their number.
const OTHERS: [(&str, usize); 4] = [("A", 3), ("K", 4), ("mol", 5), ("cd", 6)];

const PREFIXES: [(&str, i32); 11] = [
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("d", -1),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("n", -9),
    ("p", -12),
];

pub(super) fn named(name: &str) -> Option<PhysicalUnit> {
    exact(name).map(|(unit, _)| unit).or_else(|| {
        let (prefix, tens) = PREFIXES.iter().find(|(prefix, _)| name.starts_with(prefix))?;
        let (mut unit, prefixes) = exact(name.strip_prefix(prefix)?)?;
        unit.tens += tens;
        (prefixes == Usual).then_some(unit)
    })
}

fn exact(name: &str) -> Option<(PhysicalUnit, Prefixes)> {
    if let Some((_, index)) = OTHERS.iter().find(|(known, _)| *known == name) {
        let dimension = Dimension::base(*index);
        return Some((
            PhysicalUnit { factor: 1.0, tens: 0, dimension, si: name.to_owned() },
            Usual,
        ));
    }
    let (_, factor, tens, [m, kg, s], si, prefixes) =
        *UNITS.iter().find(|(known, ..)| *known == name)?;
    let dimension = Dimension::mechanical(m.into(), kg.into(), s.into());
    Some((PhysicalUnit { factor, tens, dimension, si: si.to_owned() }, prefixes))
}

pub(super) fn unit_help(name: &str) -> String {
    choice(name, UNITS.iter().map(|(known, ..)| *known))
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Joint {
    Times,
    Over,
}

pub(super) struct UnitReader<'a> {
    pub(super) lexemes: &'a [Lexeme],
    pub(super) at: usize,
    /// In an expression a unit has no spaces about its `*` and `/`, so that ` * ` multiplies.
    pub(super) within: UnitPlace,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum UnitPlace {
    Expression,
    Alone,
}

impl UnitReader<'_> {
    fn kind(&self, ahead: usize) -> Option<&LexemeKind> {
        self.lexemes.get(self.at + ahead).map(|it| &it.kind)
    }

    pub(super) fn read(&mut self) -> Result<PhysicalUnit, TextError> {
        let mut unit = self.factor()?;
        while let Some(joint) = self.goes_on() {
            let right = self.factor()?;
            unit = combined(&unit, &right, joint);
        }
        Ok(unit)
    }

    /// Consumes `*` or `/` if another factor follows; in a unit alone, `N m` is a product too.
    fn goes_on(&mut self) -> Option<Joint> {
        let is_alone = self.within == UnitPlace::Alone;
        let Some(joint) = self.joint() else {
            let is_name = matches!(self.kind(0), Some(LexemeKind::Name(_, 0)));
            return (is_alone && is_name).then_some(Joint::Times);
        };
        if is_alone {
            self.at += 1;
            return Some(joint);
        }
        let next = self.lexemes.get(self.at + 1)?;
        let is_tight = !self.lexemes.get(self.at)?.is_after_space && !next.is_after_space;
        let is_unit = match &next.kind {
            LexemeKind::Name(name, 0) => named(name).is_some(),
            LexemeKind::Open => self.is_group(),
            _ => false,
        };
        if !(is_tight && is_unit) {
            return None;
        }
        self.at += 1;
        Some(joint)
    }

    fn joint(&self) -> Option<Joint> {
        match self.kind(0)? {
            LexemeKind::Star => Some(Joint::Times),
            LexemeKind::Slash => Some(Joint::Over),
            _ => None,
        }
    }

    /// Returns `true` if `(…)` after the next sign contains only units, as in `N/(kg*m)`.
    fn is_group(&self) -> bool {
        let rest = self.lexemes.get(self.at + 2..).unwrap_or(&[]);
        for lexeme in rest {
            match &lexeme.kind {
                LexemeKind::Close => return true,
                LexemeKind::Name(name, 0) if named(name).is_some() => {}
                LexemeKind::Star
                | LexemeKind::Slash
                | LexemeKind::Caret
                | LexemeKind::Number(_) => {}
                _ => return false,
            }
        }
        false
    }

    fn factor(&mut self) -> Result<PhysicalUnit, TextError> {
        let Some(lexeme) = self.lexemes.get(self.at) else {
            return Err(TextError::new(0..0, "a unit is missing", "write one, as m"));
        };
        self.at += 1;
        let unit = match &lexeme.kind {
            LexemeKind::Name(name, 0) => {
                named(name).or_else(|| self.raised(name)).ok_or_else(|| {
                    let message = format!("there is no unit {}", quoted(name));
                    TextError::new(lexeme.span.clone(), message, unit_help(name))
                })?
            }
            LexemeKind::Number(1.0) => PhysicalUnit {
                factor: 1.0,
                tens: 0,
                dimension: Dimension::NONE,
                si: "1".to_owned(),
            },
            LexemeKind::Open => return self.group(),
            _ => {
                let help = "write one, as m or N*m/rad; 1 for a ratio";
                return Err(TextError::new(lexeme.span.clone(), "a unit is missing here", help));
            }
        };
        Ok(self.exponent().map_or(unit.clone(), |exponent| powered(&unit, exponent)))
    }

    /// Returns the unit `name` with its power, as `m2`; in an expression that is a name.
    fn raised(&self, name: &str) -> Option<PhysicalUnit> {
        let base = name.trim_end_matches(|it: char| it.is_ascii_digit());
        let power: u8 = name.get(base.len()..)?.parse().ok()?;
        let unit = named(base).filter(|_| self.within == UnitPlace::Alone)?;
        Some(powered(&unit, power.into()))
    }

    /// Reads factors in parentheses, one level deep.
    fn group(&mut self) -> Result<PhysicalUnit, TextError> {
        let mut unit = self.flat()?;
        while let Some(joint) = self.joint() {
            self.at += 1;
            let right = self.flat()?;
            unit = combined(&unit, &right, joint);
        }
        let span = self.lexemes.get(self.at).map_or(0..0, |it| it.span.clone());
        if !matches!(self.kind(0), Some(LexemeKind::Close)) {
            return Err(TextError::new(span, "a unit's ( is not closed", "write )"));
        }
        self.at += 1;
        if unit.si.contains(['·', '/']) {
            unit.si = format!("({})", unit.si);
        }
        Ok(unit)
    }

    fn flat(&mut self) -> Result<PhysicalUnit, TextError> {
        if let (Some(LexemeKind::Open), Some(lexeme)) = (self.kind(0), self.lexemes.get(self.at)) {
            let help = "write the unit with fewer parentheses";
            return Err(TextError::new(
                lexeme.span.clone(),
                "too many parentheses in a unit",
                help,
            ));
        }
        self.factor()
    }

    fn exponent(&mut self) -> Option<f64> {
        if self.kind(0) != Some(&LexemeKind::Caret) {
            return None;
        }
        let (sign, ahead) =
            if self.kind(1) == Some(&LexemeKind::Minus) { (-1.0, 2) } else { (1.0, 1) };
        let Some(LexemeKind::Number(number)) = self.kind(ahead) else { return None };
        let exponent = sign * number;
        self.at += ahead + 1;
        Some(exponent)
    }
}

fn powered(unit: &PhysicalUnit, exponent: f64) -> PhysicalUnit {
    let (factor, tens) = if exponent.fract() == 0.0 && exponent.abs() < 10.0 {
        #[expect(clippy::cast_possible_truncation, reason = "a small whole number")]
        let whole = exponent as i32;
        (unit.factor.powi(whole), unit.tens * whole)
    } else {
        (unit.to_si(1.0).powf(exponent), 0)
    };
    let si = if unit.si == "1" { unit.si.clone() } else { raised(&unit.si, exponent) };
    PhysicalUnit { factor, tens, dimension: unit.dimension.to(exponent), si }
}

fn combined(left: &PhysicalUnit, right: &PhysicalUnit, joint: Joint) -> PhysicalUnit {
    let (factor, tens, dimension) = if joint == Joint::Over {
        (left.factor / right.factor, left.tens - right.tens, left.dimension.over(right.dimension))
    } else {
        (left.factor * right.factor, left.tens + right.tens, left.dimension.times(right.dimension))
    };
    let si = match (joint, left.si.as_str(), right.si.as_str()) {
        (_, left, "1") => left.to_owned(),
        (Joint::Times, "1", right) => right.to_owned(),
        (Joint::Times, left, right) => format!("{left}·{right}"),
        (Joint::Over, left, right) => format!("{left}/{right}"),
    };
    PhysicalUnit { factor, tens, dimension, si }
}

/// Returns the unit of `text`, as `kg*m^2` or `1`.
///
/// # Errors
/// The first unknown name or syntax error.
pub fn unit(text: &str) -> Result<PhysicalUnit, TextError> {
    let lexemes = lex(text)?;
    let mut reader = UnitReader { lexemes: &lexemes, at: 0, within: UnitPlace::Alone };
    let unit = reader.read()?;
    match lexemes.get(reader.at) {
        Some(lexeme) if lexeme.kind != LexemeKind::End => Err(TextError::new(
            lexeme.span.clone(),
            format!("{} is no unit", quoted(text)),
            "write it as N*m/rad, without numbers",
        )),
        _ => Ok(unit),
    }
}

/// Returns the number at the start of `text`, and the rest.
pub fn number_and_unit(text: &str) -> Option<(f64, &str)> {
    /// Longest number (bytes).
    const MAX_NUMBER: usize = 40;
    let text = text.trim();
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let len = text.find(|c: char| !is_part(c)).unwrap_or(text.len());
    // All of these are ASCII, so every split is between characters; "2eV" is 2 of "eV".
    (1..=len.min(MAX_NUMBER)).rev().find_map(|len| {
        let (digits, rest) = text.split_at(len);
        digits.parse().ok().map(|number| (number, rest.trim()))
    })
}

/// Converts `number` of the unit `given` to the SI unit `wanted`; `None` if they differ in kind.
///
/// An angle is not a ratio here: revolutions per second are not hertz.
pub fn converted(number: f64, given: &str, wanted: &str) -> Option<f64> {
    if given == wanted {
        return Some(number);
    }
    let (given, wanted) = (unit(given).ok()?, unit(wanted).ok().filter(PhysicalUnit::is_si)?);
    let is_angle = |it: &PhysicalUnit| it.si.contains("rad");
    let fits = given.dimension.fits(wanted.dimension) && is_angle(&given) == is_angle(&wanted);
    fits.then(|| given.to_si(number))
}
