macro_rules! shipped {
    ($($folder:literal / $file:literal = $name:literal),+ $(,)?) => {
        [$(($name, include_str!(concat!(
            env!("CARGO_MANIFEST_DIR"), "/../../", $folder, "/", $file, ".toml"
        )))),+]
    };
}

/// Name and text of each shipped description, which is derived and compiled on request.
pub(crate) const SHIPPED: [(&str, &str); 24] = shipped![
    "crates/instruments/src" / "key_hammer_springs/model" = "key-hammer-springs",
    "crates/instruments/src" / "key_hammer_rigid/model" = "key-hammer-rigid",
    "crates/instruments/src" / "reduced_grand/model" = "reduced-grand",
    "crates/instruments/src" / "bouncing_ball/model" = "bouncing-ball",
    "crates/instruments/src" / "cart_pendulum/model" = "cart-pendulum",
    "crates/instruments/src" / "spring_wall/model" = "spring-wall",
    "configs/models" / "grand" = "grand",
    "configs/models" / "grand-two-mass" = "grand-two-mass",
    "configs/models" / "grand-map" = "grand-map",
    "configs/models" / "upright" = "upright",
    "configs/models" / "viennese" = "viennese",
    "configs/models" / "harpsichord" = "harpsichord",
    "configs/models" / "organ" = "organ",
    "configs/models" / "clavichord" = "clavichord",
    "configs/models" / "celesta" = "celesta",
    "configs/models" / "rhodes" = "rhodes",
    "configs/models" / "hammond" = "hammond",
    "configs/models" / "synth" = "synth",
    "configs/models" / "spring" = "spring",
    "configs/models" / "dashpot" = "dashpot",
    "configs/models" / "mass" = "mass",
    "configs/models" / "double-pendulum" = "double-pendulum",
    "configs/models" / "linkage" = "linkage",
    "configs/models" / "rolling-disk" = "rolling-disk",
];

pub fn description(name: &str) -> Option<&'static str> {
    SHIPPED.iter().find(|(known, _text)| *known == name).map(|(_name, text)| *text)
}
