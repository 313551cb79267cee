use svg::node::element::{Circle, Polygon, Polyline, Rectangle, Text};
use svg::{Document, Node};

use super::color::{Color, INK, PAPER, Stroke};

/// A position in pixels, from the upper left corner.
pub type Pixel = (f64, f64);

/// Alignment of text; its height is always centred.
#[derive(Clone, Copy, Debug)]
pub enum Anchor {
    Start,
    Middle,
    End,
    /// Text that starts at its position and runs upward.
    Rising,
    /// Text that runs upward, centred on its position.
    Upright,
}

/// An SVG picture under construction.
#[derive(Debug)]
pub struct Canvas {
    document: Document,
}

impl Canvas {
    /// Returns an empty picture of a size (pixels); it is never wider than its page.
    pub fn new((width, height): Pixel) -> Self {
        let document = Document::new()
            .set("width", width.round())
            .set("height", height.round())
            .set("viewBox", (0, 0, width.round(), height.round()))
            .set("style", "max-width:100%;height:auto")
            .set("font-family", "sans-serif")
            // Pointed joins overshoot a spike of a curve.
            .set("stroke-linejoin", "round");
        let mut canvas = Self { document };
        canvas.fill([(0.0, 0.0), (width, height)], PAPER);
        canvas
    }

    pub fn into_svg(self) -> String {
        self.document.to_string() + "\n"
    }

    pub fn line(&mut self, places: &[Pixel], stroke: Stroke) {
        /// A dash and a gap (pixels).
        const DASHES: &str = "4.2 2.8";
        let mut line = Polyline::new().set("points", points(places)).set("fill", "none");
        outline(&mut line, stroke);
        let line = if stroke.is_dashed { line.set("stroke-dasharray", DASHES) } else { line };
        self.document.append(line);
    }

    pub fn fill(&mut self, [a, b]: [Pixel; 2], color: Color) {
        let rectangle = Rectangle::new()
            .set("x", rounded(a.0.min(b.0)))
            .set("y", rounded(a.1.min(b.1)))
            .set("width", rounded((b.0 - a.0).abs()))
            .set("height", rounded((b.1 - a.1).abs()))
            .set("fill", color.hex());
        self.document.append(rectangle);
    }

    pub fn circle(&mut self, at: Pixel, radius: f64, fill: Color, edge: Stroke) {
        let mut circle = Circle::new()
            .set("cx", rounded(at.0))
            .set("cy", rounded(at.1))
            .set("r", radius)
            .set("fill", fill.hex());
        outline(&mut circle, edge);
        self.document.append(circle);
    }

    pub fn polygon(&mut self, corners: &[Pixel], fill: Color, edge: Stroke) {
        let mut polygon = Polygon::new().set("points", points(corners)).set("fill", fill.hex());
        outline(&mut polygon, edge);
        self.document.append(polygon);
    }

    /// Writes `text` of `size` (pixels).
    pub fn text(&mut self, text: &str, at: Pixel, size: f64, anchor: Anchor) {
        let (x, y) = (rounded(at.0), rounded(at.1));
        let (along, is_upward) = match anchor {
            Anchor::Start => ("start", false),
            Anchor::Middle => ("middle", false),
            Anchor::End => ("end", false),
            Anchor::Rising => ("start", true),
            Anchor::Upright => ("middle", true),
        };
        let written = Text::new(text)
            .set("x", x)
            .set("y", y)
            // From the middle of the letters to their baseline.
            .set("dy", "0.35em")
            .set("font-size", size)
            .set("text-anchor", along)
            .set("fill", INK.hex());
        let turn = || format!("rotate(-90 {x} {y})");
        self.document.append(if is_upward { written.set("transform", turn()) } else { written });
    }
}

fn outline(element: &mut impl Node, stroke: Stroke) {
    element.assign("stroke", stroke.color.hex());
    element.assign("stroke-width", stroke.width);
    if stroke.opacity < 1.0 {
        element.assign("stroke-opacity", rounded(stroke.opacity));
    }
}

fn points(places: &[Pixel]) -> String {
    let places: Vec<_> =
        places.iter().map(|(x, y)| format!("{},{}", rounded(*x), rounded(*y))).collect();
    places.join(" ")
}

/// Rounds to a hundredth of a pixel, which is invisible.
fn rounded(pixels: f64) -> f64 {
    (pixels * 100.0).round() / 100.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_text_and_places_are_short() {
        let mut canvas = Canvas::new((100.0, 50.0));
        canvas.text("a<b & c", (1.0 / 3.0, 2.0), 11.0, Anchor::Upright);
        canvas.line(&[(0.0, 0.1 + 0.2), (1e3, 2.0)], Stroke::new(INK, 1.0).faint(0.5));
        let svg = canvas.into_svg();
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{svg}");
        assert!(svg.contains("a&lt;b &amp; c") && svg.contains("rotate(-90 0.33 2)"), "{svg}");
        assert!(svg.contains("points=\"0,0.3 1000,2\" stroke=\"#282828\""), "{svg}");
    }
}
