//! Numbers as Rust writes them: the same bits when they are read again.

use core::f64::consts;

/// Named numbers: a literal close to one of them looks like a mistake.
const NAMED: [(f64, &str); 19] = [
    (consts::E, "E"),
    (consts::FRAC_1_PI, "FRAC_1_PI"),
    (consts::FRAC_1_SQRT_2, "FRAC_1_SQRT_2"),
    (consts::FRAC_2_PI, "FRAC_2_PI"),
    (consts::FRAC_2_SQRT_PI, "FRAC_2_SQRT_PI"),
    (consts::FRAC_PI_2, "FRAC_PI_2"),
    (consts::FRAC_PI_3, "FRAC_PI_3"),
    (consts::FRAC_PI_4, "FRAC_PI_4"),
    (consts::FRAC_PI_6, "FRAC_PI_6"),
    (consts::FRAC_PI_8, "FRAC_PI_8"),
    (consts::LN_2, "LN_2"),
    (consts::LN_10, "LN_10"),
    (consts::LOG2_10, "LOG2_10"),
    (consts::LOG2_E, "LOG2_E"),
    (consts::LOG10_2, "LOG10_2"),
    (consts::LOG10_E, "LOG10_E"),
    (consts::PI, "PI"),
    (consts::SQRT_2, "SQRT_2"),
    (consts::TAU, "TAU"),
];

/// Returns an expression of type `f64` with the bits of `value`.
pub(super) fn literal(value: f64) -> String {
    if value.is_nan() {
        return "f64::NAN".to_owned();
    }
    if value.is_infinite() {
        return if value > 0.0 { "f64::INFINITY" } else { "f64::NEG_INFINITY" }.to_owned();
    }
    let sign = if value.is_sign_negative() { "-" } else { "" };
    format!("{sign}{}", magnitude(value.abs()))
}

fn magnitude(value: f64) -> String {
    for (constant, name) in NAMED {
        if constant.to_bits() == value.to_bits() {
            return format!("core::f64::consts::{name}");
        }
        // A rounded π was meant as it is written: by its bits it is no mistake for π.
        if ((value - constant) / constant).abs() < 1e-2 {
            return format!("f64::from_bits({})", hexadecimal(value.to_bits()));
        }
    }
    let text = format!("{value:?}");
    let (mantissa, exponent) =
        text.split_once('e').map_or((text.as_str(), None), |(m, e)| (m, Some(e)));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let mut literal = from_the_right(whole);
    if !fraction.is_empty() {
        literal.push('.');
        literal.push_str(&from_the_left(fraction));
    }
    if let Some(exponent) = exponent {
        literal.push('e');
        literal.push_str(exponent);
    }
    literal
}

/// All sixteen digits, in groups of four.
pub(super) fn hexadecimal(bits: u64) -> String {
    let text = format!("{bits:016x}");
    let groups: Vec<&str> = (0..4).filter_map(|at| text.get(4 * at..4 * at + 4)).collect();
    format!("0x{}", groups.join("_"))
}

/// Fewer digits than this stay together.
const TOGETHER: usize = 5;

fn from_the_left(digits: &str) -> String {
    if digits.len() <= TOGETHER {
        return digits.to_owned();
    }
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && at.is_multiple_of(3) {
            text.push('_');
        }
        text.push(digit);
    }
    text
}

fn from_the_right(digits: &str) -> String {
    if digits.len() <= TOGETHER {
        return digits.to_owned();
    }
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push('_');
        }
        text.push(digit);
    }
    text
}
