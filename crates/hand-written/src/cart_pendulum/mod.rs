//! A cart with a pendulum between two walls, pulled by a spring. See README.md.

mod equations;

use models::{
    Described, GuardEntry, ModeCode, ModeEntry, ModelEntry, Parameter, Playable, Preset, Sounding,
};
use pode::{GuardId, Model as _, Motion};

use crate::entry;
use crate::parameter;

use crate::values::{filled, write};

/// The cart between the walls (`free`) or held against one (`left`, `right`).
///
/// State: x (m), θ (rad), x', θ'. Input: the spring's other end s (m).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CartPendulum {
    /// Mass of the cart (kg).
    pub cart_mass: f64,
    /// Mass of the bob (kg).
    pub bob_mass: f64,
    /// Pivot to the bob's mass centre (m).
    pub length: f64,
    /// Inertia of the bob about its mass centre (kg·m²).
    pub inertia: f64,
    /// Gravity (m/s²).
    pub g: f64,
    /// Spring between s and the cart (N/m).
    pub k: f64,
    /// Damper beside it (N·s/m).
    pub b: f64,
    /// Where the cart meets the left wall (m).
    pub left: f64,
    /// Where the cart meets the right wall (m).
    pub right: f64,
    /// Speed of the cart after a wall over its speed before.
    pub restitution: f64,
    /// Metres of s per metre of key-front travel; positive is to the right.
    pub scale: f64,
}

/// Which wall, if any, holds the cart.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// The cart is between the walls.
    Free,
    /// The cart is held against the left wall.
    Left,
    /// The cart is held against the right wall.
    Right,
}

const PARAMETERS: [Parameter; 11] = [
    parameter::positive("cart_mass", "kg", "mass of the cart"),
    parameter::positive("bob_mass", "kg", "mass of the bob"),
    parameter::positive("length", "m", "pivot to the bob's mass centre"),
    parameter::not_negative("inertia", "kg·m²", "inertia of the bob about its mass centre"),
    parameter::gravity(),
    parameter::not_negative("k", "N/m", "spring between the input and the cart"),
    parameter::not_negative("b", "N·s/m", "damper beside the spring"),
    parameter::length("left", "where the cart meets the left wall"),
    parameter::length("right", "where the cart meets the right wall; right of the left one"),
    parameter::restitution("speed of the cart after a wall over its speed before"),
    parameter::scale("input per key travel; positive pulls the cart to the right"),
];

const DEFAULT: [f64; 11] = [1.0, 0.3, 0.25, 0.0, 9.81, 200.0, 0.0, -0.05, 0.05, 0.7, 1.0];

/// A toy of 60 g in all: 1.5 kN/m at the finger, and 3 N of push at the right wall when
/// the key is at its bottom (E).
const KEY: [f64; 11] = [0.04, 0.02, 0.1, 0.0, 9.81, 60.0, 0.3, -0.005, 0.04, 0.6, 5.0];

/// All modes, in the order of their numbers.
const MODES: [Mode; 3] = [Mode::Free, Mode::Left, Mode::Right];

/// The wall pulls no more.
const OFF: GuardEntry = entry::guard("off", "N", &["free"]);

const MODE_ENTRIES: [ModeEntry; 3] = [
    entry::mode(
        "free",
        (2, 0),
        &[
            entry::guard("left", "m", &["free", "left"]),
            entry::guard("right", "m", &["free", "right"]),
        ],
    ),
    entry::mode("left", (2, 1), &[OFF]),
    entry::mode("right", (2, 1), &[OFF]),
];

/// What is known of the model without building one.
pub static ENTRY: ModelEntry = ModelEntry {
    name: "cart-pendulum",
    summary: "a cart with a pendulum between two walls, pulled by a spring",
    file: None,
    parameters: &PARAMETERS,
    presets: &[
        Preset {
            name: "default",
            doc: "1 kg of cart, 0.3 kg of pendulum, walls at ±5 cm",
            value: &|parameter, _key| DEFAULT[parameter],
        },
        Preset {
            name: "key",
            doc: "60 g in all on a rubber band, pulled 5 times the key's travel",
            value: &|parameter, _key| KEY[parameter],
        },
    ],
    input: "s",
    input_unit: "m",
    states: &["x", "theta", "x_dot", "theta_dot"],
    state_units: &["m", "rad", "m/s", "rad/s"],
    coordinates: CartPendulum::COORDS,
    modes: &MODE_ENTRIES,
    outputs: &["F", "N"],
    output_units: &["N", "N"],
};

impl CartPendulum {
    /// The model with one value per parameter, in their order.
    fn from_array(values: &[f64; 11]) -> Self {
        let [cart_mass, bob_mass, length, inertia, g, k, b, left, right, restitution, scale] =
            *values;
        Self { cart_mass, bob_mass, length, inertia, g, k, b, left, right, restitution, scale }
    }
}

impl Default for CartPendulum {
    /// The model with the values of its first preset.
    fn default() -> Self {
        Self::from_array(&filled(&ENTRY, &[]))
    }
}

impl Described for CartPendulum {
    fn entry(&self) -> &'static ModelEntry {
        &ENTRY
    }

    fn with_values(&self, values: &[f64]) -> Self {
        Self::from_array(&filled(&ENTRY, values))
    }

    fn mode_code(&self, mode: Mode) -> ModeCode {
        ModeCode::structural(mode as u8)
    }

    fn mode(&self, number: ModeCode) -> Option<Mode> {
        number.of(&MODES)
    }

    fn outputs(&self, mode: Mode, x: &[f64; 4], s: &Motion, out: &mut [f64]) {
        let wall = self.side(mode).map_or(0.0, |side| self.push(side, x, s).value);
        write(out, [self.pull(x, s), wall]);
    }

    fn at_rest(&self, s: &Motion) -> (Mode, [f64; 4]) {
        let mode = if s.position > self.right {
            Mode::Right
        } else if s.position < self.left {
            Mode::Left
        } else {
            Mode::Free
        };
        (mode, [s.position.max(self.left).min(self.right), 0.0, 0.0, 0.0])
    }
}

impl Playable for CartPendulum {
    fn input_per_metre(&self) -> f64 {
        self.scale
    }

    /// Returns the speed of the cart, since both walls sound.
    fn sounding(&self, guard: GuardId, before: &[f64; 4]) -> Option<Sounding> {
        equations::is_wall(guard).then(|| Sounding { speed: before[2].abs() })
    }
}
