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
//!
//! `panel` which curves share a panel, `level` how curves of different units share it, `frame`
//! its axes, `band` what stands above the panels.

mod band;
mod frame;
mod level;
mod panel;

use self::frame::Frame;
use self::panel::SignalPanel;
use super::curve::PanelKind;
use super::picture::Picture;
use crate::plot::axis::Axis;
use crate::plot::canvas::{Anchor, Canvas};
use crate::plot::color::Color;
use crate::plot::legend::{ROW, draw_row};

/// Width of the time axis (pixels).
pub(super) const COLUMNS: usize = 890;

/// Places in the picture (pixels).
mod place {
    pub(super) const WIDTH: f64 = 1200.0;
    pub(super) const HEIGHT: f64 = 900.0;
    /// Where the time axis begins and ends.
    pub(super) const LEFT: f64 = 80.0;
    pub(super) const RIGHT: f64 = LEFT + super::COLUMNS as f64;
    /// Where the legends begin.
    pub(super) const LEGEND: f64 = 1040.0;
    /// Where the titles of the axes stand, left and right.
    pub(super) const TITLES: [f64; 2] = [24.0, 1018.0];
    /// Where the title of the time axis stands.
    pub(super) const BELOW: f64 = 885.0;
    /// Where the names of events stand.
    pub(super) const NAMES: f64 = 180.0;
    /// Where the band of modes begins and ends.
    pub(super) const BAND: (f64, f64) = (192.0, 211.0);
    /// Where each panel begins and ends.
    pub(super) const PANELS: [(f64, f64); 3] = [(216.0, 388.0), (398.0, 558.0), (568.0, 846.0)];
}

/// The modes' shades.
const MODES: [Color; 5] = [
    Color(253, 236, 205),
    Color(222, 235, 247),
    Color(226, 243, 222),
    Color(243, 228, 243),
    Color(235, 235, 235),
];

/// Returns the picture as SVG text.
pub(super) fn svg(picture: &Picture) -> String {
    let mut canvas = Canvas::new((place::WIDTH, place::HEIGHT));
    for (row, text) in picture.title.iter().enumerate() {
        canvas.text(text, (place::LEGEND, 20.0 * row as f64 + 18.0), 14.0, Anchor::Start);
    }
    let kinds = [PanelKind::Forces, PanelKind::Guards, PanelKind::Coordinates];
    for (kind, span) in kinds.into_iter().zip(place::PANELS) {
        let panel = SignalPanel::new(picture, kind);
        Frame::new(&panel, span).draw(&mut canvas);
        draw_legend(&mut canvas, &panel, span.0);
    }
    band::draw(&mut canvas, picture);
    canvas.into_svg()
}

/// Draws beside a panel that begins at `top` (pixels) which line is what.
fn draw_legend(canvas: &mut Canvas, panel: &SignalPanel<'_>, top: f64) {
    for (row, line) in panel.lines.iter().enumerate() {
        let at = (place::LEGEND, ROW * row as f64 + top + 12.0);
        draw_row(canvas, at, line.stroke, &line.text);
    }
}

/// Returns the axis of time, shared by all panels.
fn time(picture: &Picture) -> Axis {
    Axis::linear(&(0.0..picture.axis.until), (place::LEFT, place::RIGHT))
}

/// The shade of a mode.
fn shade(mode: usize) -> Color {
    MODES[mode % MODES.len()]
}
