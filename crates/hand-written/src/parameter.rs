//! Parameters of the usual kinds.

use models::Parameter;

/// A value between `low` and `high`.
pub(crate) const fn within(
    name: &'static str,
    unit: &'static str,
    low: f64,
    high: f64,
    doc: &'static str,
) -> Parameter {
    Parameter { name, title: name, unit, range: (low, high), doc }
}

/// A value that something is divided by.
pub(crate) const fn positive(
    name: &'static str,
    unit: &'static str,
    doc: &'static str,
) -> Parameter {
    within(name, unit, 1e-9, 1e9, doc)
}

/// A value that may be zero.
pub(crate) const fn not_negative(
    name: &'static str,
    unit: &'static str,
    doc: &'static str,
) -> Parameter {
    within(name, unit, 0.0, 1e9, doc)
}

/// A place or a length with a sign (m).
pub(crate) const fn length(name: &'static str, doc: &'static str) -> Parameter {
    within(name, "m", -100.0, 100.0, doc)
}

/// Gravity (m/s²).
pub(crate) const fn gravity() -> Parameter {
    within("g", "m/s²", 0.0, 1000.0, "gravity")
}

/// Restitution of an impact on `doc`.
pub(crate) const fn restitution(doc: &'static str) -> Parameter {
    within("restitution", "1", 0.0, 1.0, doc)
}

/// Input per metre of key-front travel, for models whose input is a length.
pub(crate) const fn scale(doc: &'static str) -> Parameter {
    within("scale", "m/m", -1000.0, 1000.0, doc)
}
