//! The descriptions that come with the program.

macro_rules! shipped {
    ($($name:literal),+ $(,)?) => {
        &[$(($name, include_str!(concat!(
            env!("CARGO_MANIFEST_DIR"), "/../../configs/models/", $name, ".toml"
        )))),+]
    };
}

/// Name and text of each description that is derived and compiled when it is asked for: everything
/// in `configs/models`.
pub(crate) const SHIPPED: &[(&str, &str)] = shipped![
    "grand",
    "grand-two-mass",
    "grand-map",
    "upright",
    "viennese",
    "harpsichord",
    "organ",
    "clavichord",
    "celesta",
    "rhodes",
    "hammond",
    "synth",
    "spring",
    "dashpot",
    "mass",
    "double-pendulum",
    "linkage",
    "rolling-disk",
];

/// Returns the description of the model called `name`, if the program has one.
pub fn description(name: &str) -> Option<&'static str> {
    let shipped = SHIPPED.iter().find(|(known, _text)| *known == name).map(|(_name, text)| *text);
    models::descriptions::description(name).or(shipped)
}
