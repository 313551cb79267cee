//! Embedded scenes, instruments and performances.

#[derive(Debug)]
pub(super) struct EmbeddedFiles {
    pub(super) what: &'static str,
    files: &'static [(&'static str, &'static str)],
}

impl EmbeddedFiles {
    pub(super) fn find(&self, name: &str) -> Option<&'static str> {
        self.files.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &'static str> {
        self.files.iter().map(|(name, _)| *name)
    }
}

macro_rules! configs {
    ($include:ident, $folder:literal, $ending:literal: $($name:literal),+ $(,)?) => {
        &[$(($name, $include!(concat!(
            env!("CARGO_MANIFEST_DIR"), "/../../configs/", $folder, "/", $name, $ending
        )))),+]
    };
}

pub(super) const SCENES: EmbeddedFiles = EmbeddedFiles {
    what: "scene",
    files: configs!(include_str, "scenes", ".toml": "default", "springs", "bach", "paper", "paper-rig", "mixed", "fast", "rigid"),
};

pub(super) const INSTRUMENTS: EmbeddedFiles = EmbeddedFiles {
    what: "instrument",
    files: configs!(
        include_str, "instruments", ".toml":
        "grand",
        "upright",
        "viennese",
        "harpsichord",
        "organ",
        "clavichord",
        "celesta",
        "rhodes",
        "hammond",
        "synth",
        "grand-two-mass",
        "grand-map",
        "grand-springs",
        "grand-rigid",
        "grand-reduced",
        "paper-springs",
        "paper-rigid",
        "bouncing-ball",
        "cart-pendulum",
        "spring-wall",
        "spring",
        "dashpot",
        "mass",
    ),
};

pub(super) const PERFORMANCES: &[(&str, &[u8])] = configs!(
    include_bytes, "performances", ".mid": "bach-bwv-846", "beethoven-ode-to-joy"
);

/// Returns the names of the embedded scenes.
pub fn scenes() -> impl Iterator<Item = &'static str> {
    SCENES.names()
}

pub fn performances() -> impl Iterator<Item = &'static str> {
    PERFORMANCES.iter().map(|(name, _)| *name)
}
