//! Formats numbers and times in sentences and tables.

use crate::accuracy::{MethodKind, StudyRow};
use figures::digits::trimmed;

/// Formats a positive number with two digits, as short as possible, without its unit.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    match value.abs() {
        0.01..0.1 => format!("{value:.3}"),
        0.1..10.0 => format!("{value:.2}"),
        10.0..100.0 => format!("{value:.1}"),
        100.0..100_000.0 => format!("{value:.0}"),
        _ => format!("{value:.1e}"),
    }
}

/// Formats a number with its power of ten, as `1e-9`, with one decimal if it is not a power.
pub(super) fn exponent(value: f64) -> String {
    let text = format!("{value:.1e}");
    text.replacen(".0e", "e", 1)
}

/// Formats a time (s) in the unit that suits it.
pub(crate) fn duration(seconds: f64) -> String {
    let (value, unit) = match seconds {
        ..1e-9 => (seconds * 1e12, "ps"),
        1e-9..1e-6 => (seconds * 1e9, "ns"),
        1e-6..1e-3 => (seconds * 1e6, "µs"),
        1e-3..1.0 => (seconds * 1e3, "ms"),
        _ => (seconds, "s"),
    };
    // Digits from the rounding of the multiplication are dropped.
    format!("{} {unit}", trimmed(&format!("{value:.3}")))
}

pub(super) fn setting(row: &StudyRow) -> String {
    let tolerance = row.setting.tolerance.unwrap_or(0.0);
    match row.method.kind {
        MethodKind::Fixed | MethodKind::Played => duration(row.setting.tick),
        MethodKind::Controlled => format!("tolerance {tolerance:e}"),
        MethodKind::Budgeted => format!("budget {tolerance:e}"),
    }
}
