//! The picture: names of events, a band of modes, three panels over one time axis.
//!
//! ```text
//!                                         title
//!   events' names, upright                modes
//!  ▐B1▌▐▌▐  B2  ▌▐ ...     band of modes
//!  forces        |           | [N·m]       legend
//!  guards        |           |             legend
//!  coordinates   |           |             legend
//!              t [s]
//! ```

mod canvas;
mod legend;
mod panel;
mod scale;
mod strip;

use plotters::prelude::{IntoDrawingArea as _, RGBColor, SVGBackend, WHITE};

use self::canvas::{Anchor, DrawError, FINE, fine_size, write};
use super::Picture;
use super::curve::PanelKind;

/// Width of the time axis (pixels).
pub(super) const COLUMNS: usize = 890;

/// Places in the picture (pixels).
mod place {
    pub(super) const WIDTH: f64 = 1200.0;
    pub(super) const HEIGHT: f64 = 900.0;
    /// Where the time axis begins and ends.
    pub(super) const LEFT: f64 = 80.0;
    pub(super) const RIGHT: f64 = LEFT + super::COLUMNS as f64;
    /// Where the legends begin, and what is free before them.
    pub(super) const LEGEND: f64 = 1040.0;
    pub(super) const GAP: f64 = 10.0;
    /// Where the titles of the axes stand, left and right.
    pub(super) const TITLES: [f64; 2] = [24.0, 1018.0];
    /// Where the names of events stand.
    pub(super) const NAMES: f64 = 180.0;
    /// Where the band of modes begins and ends.
    pub(super) const BAND: (f64, f64) = (192.0, 211.0);
    /// Where each panel begins and ends.
    pub(super) const PANELS: [(f64, f64); 3] = [(216.0, 388.0), (398.0, 558.0), (568.0, 846.0)];
}

/// Colours that differ for every eye (Okabe and Ito).
const CURVES: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

/// The modes' shades.
const MODES: [RGBColor; 5] = [
    RGBColor(253, 236, 205),
    RGBColor(222, 235, 247),
    RGBColor(226, 243, 222),
    RGBColor(243, 228, 243),
    RGBColor(235, 235, 235),
];

/// The picture as SVG text.
pub(super) fn svg(picture: &Picture) -> Result<String, DrawError> {
    let mut text = String::new();
    let [width, height] = [place::WIDTH, place::HEIGHT].map(fine_size);
    draw(picture, SVGBackend::with_string(&mut text, (width, height)))?;
    // Drawn finely, shown in pixels; round joins, as pointed ones overshoot a spike.
    let size = |width: u32, height: u32| format!("width=\"{width}\" height=\"{height}\"");
    let shown = size(width / FINE, height / FINE) + " stroke-linejoin=\"round\"";
    Ok(text.replacen(&size(width, height), &shown, 1))
}

fn draw(picture: &Picture, backend: SVGBackend<'_>) -> Result<(), DrawError> {
    let canvas = backend.into_drawing_area();
    canvas.fill(&WHITE)?;
    for (row, text) in picture.title.iter().enumerate() {
        write(&canvas, text, (place::LEGEND, 20.0 * row as f64 + 18.0), 14.0, Anchor::Start)?;
    }
    let kinds = [PanelKind::Forces, PanelKind::Guards, PanelKind::Coordinates];
    for (kind, span) in kinds.into_iter().zip(place::PANELS) {
        let panel = panel::SignalPanel::new(picture, kind);
        panel.draw(&canvas, span)?;
        legend::draw(&canvas, &panel, span.0)?;
    }
    strip::draw(&canvas, picture)?;
    canvas.present()
}

/// Where `t` (s) is on the time axis (pixels).
fn across(picture: &Picture, t: f64) -> f64 {
    place::LEFT + t / picture.axis.until * COLUMNS as f64
}

/// The shade of a mode.
fn shade(mode: usize) -> RGBColor {
    MODES[mode % MODES.len()]
}
