//! Units that people type: products and quotients of named ones, with prefixes.

/// Named units: name, factor, power of ten, powers of m, kg, s and rad, `true` with prefixes.
const NAMED: [(&str, f64, i32, [i32; 4], bool); 14] = [
    ("m", 1.0, 0, [1, 0, 0, 0], true),
    ("g", 1.0, -3, [0, 1, 0, 0], true),
    ("s", 1.0, 0, [0, 0, 1, 0], true),
    ("rad", 1.0, 0, [0, 0, 0, 1], true),
    ("deg", std::f64::consts::PI / 180.0, 0, [0, 0, 0, 1], false),
    ("°", std::f64::consts::PI / 180.0, 0, [0, 0, 0, 1], false),
    ("N", 1.0, 0, [1, 1, -2, 0], true),
    ("gf", 9.806_65, -3, [1, 1, -2, 0], false),
    ("kgf", 9.806_65, 0, [1, 1, -2, 0], false),
    ("J", 1.0, 0, [2, 1, -2, 0], true),
    ("Hz", 1.0, 0, [0, 0, -1, 0], true),
    ("min", 60.0, 0, [0, 0, 1, 0], false),
    ("%", 1.0, -2, [0; 4], false),
    ("1", 1.0, 0, [0; 4], false),
];

const PREFIXES: [(&str, i32); 9] = [
    ("G", 9),
    ("M", 6),
    ("k", 3),
    ("c", -2),
    ("m", -3),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("n", -9),
];

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct TypedUnit {
    factor: f64,
    /// Power of ten on top of the factor, kept apart so that 62 mm are 62/1000 exactly.
    tens: i32,
    powers: [i32; 4],
}

impl TypedUnit {
    pub(super) fn is_like(&self, other: &Self) -> bool {
        self.powers == other.powers
    }

    /// Converts `number` of this unit to `other`, which is of its dimension.
    pub(super) fn number_in(&self, number: f64, other: &Self) -> f64 {
        let (scaled, tens) = (number * self.factor / other.factor, self.tens - other.tens);
        if tens < 0 { scaled / 10_f64.powi(-tens) } else { scaled * 10_f64.powi(tens) }
    }
}

pub(super) fn unit_of(text: &str) -> Option<TypedUnit> {
    let mut product = TypedUnit { factor: 1.0, tens: 0, powers: [0; 4] };
    let (mut rest, mut sign) = (if text.is_empty() { "1" } else { text }, 1);
    loop {
        let end = rest.find(['·', '*', ' ', '/']);
        let unit = powered(rest.get(..end.unwrap_or(rest.len()))?)?;
        product.factor *= if sign < 0 { 1.0 / unit.factor } else { unit.factor };
        product.tens += sign * unit.tens;
        for (sum, power) in product.powers.iter_mut().zip(unit.powers) {
            *sum += sign * power;
        }
        let Some(end) = end else { return Some(product) };
        let joint = rest.get(end..)?.chars().next()?;
        sign = if joint == '/' { -1 } else { 1 };
        rest = rest.get(end + joint.len_utf8()..)?;
    }
}

fn powered(text: &str) -> Option<TypedUnit> {
    let (name, power) = [("²", 2), ("³", 3), ("^2", 2), ("^3", 3), ("2", 2), ("3", 3)]
        .into_iter()
        .find_map(|(suffix, power)| Some((text.strip_suffix(suffix)?, power)))
        .unwrap_or((text, 1));
    let TypedUnit { factor, tens, powers } = named(name)?;
    Some(TypedUnit {
        factor: factor.powi(power),
        tens: tens * power,
        powers: powers.map(|it| it * power),
    })
}

fn named(name: &str) -> Option<TypedUnit> {
    let find = |name: &str| NAMED.iter().find(|it| it.0 == name);
    let unit = |&(_, factor, tens, powers, _): &(&str, f64, i32, [i32; 4], bool), more: i32| {
        TypedUnit { factor, tens: tens + more, powers }
    };
    find(name).map(|it| unit(it, 0)).or_else(|| {
        PREFIXES.iter().find_map(|(prefix, more)| {
            let named = find(name.strip_prefix(prefix)?).filter(|it| it.4)?;
            Some(unit(named, *more))
        })
    })
}

/// Returns the number at the start of `text`, with a decimal point or comma, and the rest.
pub(super) fn number_and_unit(text: &str) -> Option<(f64, String)> {
    /// Longest number (bytes).
    const MAX_NUMBER: usize = 40;
    let text = text.trim().replace(',', ".").replace('\u{2212}', "-");
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let len = text.find(|c: char| !is_part(c)).unwrap_or(text.len());
    (1..=len.min(MAX_NUMBER)).rev().find_map(|len| {
        let (digits, rest) = text.split_at_checked(len)?;
        Some((digits.parse().ok()?, rest.trim().to_owned()))
    })
}
