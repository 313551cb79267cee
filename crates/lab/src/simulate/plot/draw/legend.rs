//! Which line is what, beside each panel.

use super::canvas::{Anchor, Canvas, DrawError, line, write};
use super::panel::SignalPanel;
use super::place;

/// Size of the text (pixels).
const TEXT: f64 = 12.0;
/// From one line to the next (pixels).
const ROW: f64 = 19.0;

/// Draws the legend of a panel that begins at `top` (pixels).
pub(super) fn draw(
    canvas: &Canvas<'_>,
    panel: &SignalPanel<'_>,
    top: f64,
) -> Result<(), DrawError> {
    let left = place::LEGEND;
    for (row, curve) in panel.lines.iter().enumerate() {
        let y = ROW * row as f64 + top + 12.0;
        line(canvas, &[(left, y), (left + 24.0, y)], curve.color, curve.width)?;
        write(canvas, &curve.text, (left + 32.0, y), TEXT, Anchor::Start)?;
    }
    Ok(())
}
