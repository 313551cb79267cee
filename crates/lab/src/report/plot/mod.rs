//! A scenario's pictures: error against cost, on logarithmic axes.
//!
//! ```text
//!   event error / ns per ms      event error / evaluations     legend
//!   state error / ns per ms      force error / ns per ms
//!   event error / ns of a tick without, with one, with the most events, of the worst tick
//! ```
//!
//! And, where other codes were run side by side with ours, the errors of all against cost.
//!
//! `curve` what is drawn, `quantity` which of its figures, `panel` one pair of axes, `marker` and
//! `legend` which curve is what.

mod curve;
mod legend;
mod marker;
mod panel;
mod quantity;

use self::curve::CostErrorCurve;
use self::panel::CostErrorPanel;
use self::quantity::Quantities;
use super::peers::Peer;
use crate::accuracy::MeasuredScenario;
use crate::plot::canvas::{Anchor, Canvas};

/// Places in the picture (pixels).
mod place {
    pub(super) const WIDTH: f64 = 1300.0;
    /// Left ends of the columns of panels.
    pub(super) const COLUMNS: [f64; 2] = [62.0, 542.0];
    /// Upper end of the first row of panels, and from one row to the next.
    pub(super) const TOP: f64 = 62.0;
    pub(super) const ROW: f64 = 330.0;
    /// Size of a panel.
    pub(super) const PANEL: (f64, f64) = (410.0, 250.0);
    /// Where the legend begins.
    pub(super) const LEGEND: f64 = 984.0;
    /// Where the title stands.
    pub(super) const TITLE: f64 = 20.0;
}

/// Draws all methods on a scenario.
pub(super) fn methods(measured: &MeasuredScenario) -> String {
    svg(&title(measured), &quantity::OURS, &curve::methods(measured))
}

/// Draws all codes that were run side by side on the same problem.
pub(super) fn peers(measured: &MeasuredScenario, peers: &[&Peer]) -> String {
    let title = format!("{}, side by side with other codes", title(measured));
    svg(&title, &quantity::THEIRS, &curve::peers(peers, measured.until))
}

fn title(measured: &MeasuredScenario) -> String {
    format!("{}: {}", measured.entry.name, measured.entry.title)
}

fn svg(title: &str, panels: &[Quantities], curves: &[CostErrorCurve]) -> String {
    let rows = panels.len().div_ceil(place::COLUMNS.len());
    let height = place::TOP + place::ROW * rows as f64;
    let mut canvas = Canvas::new((place::WIDTH, height.max(legend::bottom(curves))));
    canvas.text(title, (place::COLUMNS[0], place::TITLE), 15.0, Anchor::Start);
    for (index, quantities) in panels.iter().enumerate() {
        let (row, column) = (index / place::COLUMNS.len(), index % place::COLUMNS.len());
        let corner = (place::COLUMNS[column], place::TOP + place::ROW * row as f64);
        CostErrorPanel::new(quantities, curves, corner).draw(&mut canvas);
    }
    legend::draw(&mut canvas, curves);
    canvas.into_svg()
}
