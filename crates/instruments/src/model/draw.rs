//! How a mechanism looks from the side, to scale: x to the right, y up (m).
//!
//! A model says once, for its values, what it is made of and what moves each part; whoever draws
//! needs only the signals (states, guards, outputs) to move it.

pub use crate::equations::table::Material;

/// What moves a part: `offset + scale · signal`.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Follow {
    /// Where it is when the signal is 0 (m) or (rad).
    pub offset: f64,
    /// So much further for each unit of the signal.
    pub scale: f64,
    /// Name of a state or output; "position" is the key's front (m, down); none holds still.
    pub signal: Option<&'static str>,
}

impl Follow {
    /// Holds still at `offset`.
    pub const fn fixed(offset: f64) -> Self {
        Self { offset, scale: 0.0, signal: None }
    }

    /// Follows `signal`.
    pub const fn of(offset: f64, scale: f64, signal: &'static str) -> Self {
        Self { offset, scale, signal: Some(signal) }
    }
}

/// Something rigid: a point p of it is drawn at (x, y) + R(angle) p.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Body<'a> {
    pub name: &'static str,
    /// Where its own origin is (m).
    pub x: Follow,
    /// Where its own origin is (m).
    pub y: Follow,
    /// Turned by so much, anticlockwise (rad).
    pub angle: Follow,
    /// Shown only in these modes, by their number in the model's list; always if there are none.
    pub modes: &'a [u8],
}

/// A spring between points of two bodies, by the bodies' numbers.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Coil<'a> {
    pub name: &'static str,
    /// A body, in the order of [`Sketch::body`], and a point of it (m).
    pub from: (u32, [f64; 2]),
    /// The other body, and a point of it (m).
    pub to: (u32, [f64; 2]),
    /// Shown only in these modes; always if there are none.
    pub modes: &'a [u8],
}

/// A canvas on which a model draws itself.
pub trait Sketch {
    /// What is worth seeing: left, bottom, right, top (m).
    fn view(&mut self, edges: [f64; 4]);

    /// Adds a body to the drawing.
    fn body(&mut self, body: Body<'_>);

    /// A line of the newest body through `points` in its own axes (m); closed ones are filled.
    fn outline(&mut self, material: Material, points: &[[f64; 2]], ends: Ends);

    /// Adds a spring to the drawing.
    fn coil(&mut self, coil: Coil<'_>);
}

/// Whether a line comes back to where it began.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ends {
    Open,
    /// It does, and is filled.
    Closed,
}
