//! A mechanism from the side, to scale: x to the right, y up (m).
//!
//! A model states its parts and what moves each of them; the viewer needs only the signals.

pub use crate::equations::table::Material;

/// Motion of a part: `offset + scale · signal`.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Follow {
    /// Value at signal 0 (m) or (rad).
    pub offset: f64,
    /// Change per unit of the signal.
    pub scale: f64,
    /// Name of a state or output; "position" is the key's front (m, down); `None` is fixed.
    pub signal: Option<&'static str>,
}

impl Follow {
    pub const fn fixed(offset: f64) -> Self {
        Self { offset, scale: 0.0, signal: None }
    }

    pub const fn of(offset: f64, scale: f64, signal: &'static str) -> Self {
        Self { offset, scale, signal: Some(signal) }
    }
}

/// A rigid body: its point p is drawn at (x, y) + R(angle) p.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Body<'a> {
    pub name: &'static str,
    /// Position of the body's origin (m).
    pub x: Follow,
    pub y: Follow,
    /// Rotation, anticlockwise (rad).
    pub angle: Follow,
    /// Modes that show the body, by their number in the model's list; empty for all.
    pub modes: &'a [u8],
}

/// A spring between points of two bodies.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Coil<'a> {
    pub name: &'static str,
    /// Number of a body, in the order of [`Sketch::body`], and a point of it (m).
    pub from: (u32, [f64; 2]),
    pub to: (u32, [f64; 2]),
    /// Modes that show the spring; empty for all.
    pub modes: &'a [u8],
}

/// A canvas on which a model draws itself.
pub trait Sketch {
    /// Sets the visible range: left, bottom, right, top (m).
    fn view(&mut self, edges: [f64; 4]);

    fn body(&mut self, body: Body<'_>);

    /// Adds a line to the newest body, through `points` in its axes (m); closed lines are filled.
    fn outline(&mut self, material: Material, points: &[[f64; 2]], ends: Ends);

    fn coil(&mut self, coil: Coil<'_>);
}

/// Form of a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ends {
    Open,
    /// Returns to its start, and is filled.
    Closed,
}
