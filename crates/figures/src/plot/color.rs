/// A colour: red, green and blue, 0 ..= 255.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Color(pub u8, pub u8, pub u8);

/// Colour of text and axes.
pub const INK: Color = Color(40, 40, 40);
pub const PAPER: Color = Color(255, 255, 255);

/// Colours of curves that most eyes distinguish, after Okabe and Ito, without the yellow.
pub const CURVES: [Color; 7] = [
    Color(0, 114, 178),
    Color(213, 94, 0),
    Color(0, 158, 115),
    Color(204, 121, 167),
    Color(230, 159, 0),
    Color(86, 180, 233),
    Color(118, 76, 36),
];

/// Colours behind the epochs of a run, by the index of their mode in the model's list.
pub const MODES: [Color; 5] = [
    Color(253, 236, 205),
    Color(222, 235, 247),
    Color(226, 243, 222),
    Color(243, 228, 243),
    Color(235, 235, 235),
];

impl Color {
    /// Returns the colour in SVG notation, `#28D0FF`.
    pub fn hex(self) -> String {
        let Self(red, green, blue) = self;
        format!("#{red:02X}{green:02X}{blue:02X}")
    }
}

/// Style of a line.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Stroke {
    pub color: Color,
    /// Width of the line (pixels).
    pub width: f64,
    /// Opacity, 0 to 1.
    pub opacity: f64,
    pub is_dashed: bool,
}

impl Stroke {
    /// Returns a line without gaps of `width` (pixels).
    pub const fn new(color: Color, width: f64) -> Self {
        Self { color, width, opacity: 1.0, is_dashed: false }
    }

    #[must_use]
    pub const fn faint(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }
}
