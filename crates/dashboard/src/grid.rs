//! Grid lines at round numbers, and labels that distinguish them at every zoom.

use eframe::egui::{Color32, TextStyle, Ui};

use crate::number;

/// Smallest width of a vertical axis with its labels (points).
pub(crate) const GUTTER: f32 = 64.0;

/// Steps of the width of a vertical axis (points), so that it seldom changes while values do.
const STEP: f32 = 8.0;

/// Magnitudes that are written without a power of ten.
const PLAIN: std::ops::Range<f64> = 1e-3..1e6;

/// Returns the number of grid lines on a horizontal axis of `points`, with room for labels.
pub(crate) fn lines_across(points: f32) -> f64 {
    f64::from(points / 160.0).clamp(1.0, 4.0)
}

pub(crate) fn lines_up(points: f32) -> f64 {
    f64::from(points / 60.0).clamp(1.5, 3.0)
}

/// Returns the distance of about `lines` grid lines between two values.
pub(crate) fn step((low, high): (f64, f64), lines: f64) -> f64 {
    number::round((high - low) / lines)
}

/// Returns the label of a grid line: all labels of an axis have the digits of its step.
pub(crate) fn label(value: f64, (low, high): (f64, f64), lines: f64) -> String {
    let step = step((low, high), lines);
    let count = (value / step).round();
    if !count.is_finite() || count.abs() < 0.5 {
        return "0".to_owned();
    }
    let value = count * step;
    let power = |of: f64| (of.abs().log10() + 1e-9).floor();
    if PLAIN.contains(&low.abs().max(high.abs())) {
        let places = number::index(-power(step));
        format!("{value:.places$}")
    } else {
        let places = number::index(power(value) - power(step));
        format!("{value:.places$e}")
    }
}

/// Returns the width of a vertical axis (points) for several ranges, each with its number of lines.
pub(crate) fn gutter(ui: &Ui, axes: impl Iterator<Item = ((f64, f64), f64)>) -> f32 {
    let font = TextStyle::Body.resolve(ui.style());
    let width =
        |text: String| ui.painter().layout_no_wrap(text, font.clone(), Color32::WHITE).size().x;
    let widest = |((low, high), lines): ((f64, f64), f64)| {
        let step = step((low, high), lines);
        let values = [low, low + step, high - step, high];
        values.map(|it| width(label(it, (low, high), lines))).into_iter().fold(0.0, f32::max)
    };
    // The plot adds a margin at each side, and the unit at a quarter of a line from the labels.
    let beside = 8.0 + 1.25 * ui.text_style_height(&TextStyle::Body);
    let needed = axes.map(widest).fold(0.0, f32::max) + beside;
    ((needed / STEP).ceil() * STEP).max(GUTTER)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn labels_of_an_axis_differ_at_every_zoom() {
        let middles = [0.0, 0.02, 77.77, -312.5, 599_999.0, 4.2e9, 3e-7];
        let widths = || (0..240_i32).map(|zoom| 1000.0 * 0.9_f64.powi(zoom));
        let zooms = middles.into_iter().flat_map(|middle| widths().map(move |it| (middle, it)));
        let is_wide = |(middle, width): &(f64, f64)| 1e-11 * middle.abs() <= *width;
        for (middle, width) in zooms.filter(is_wide) {
            let range = (middle - 0.4 * width, middle + 0.6 * width);
            for lines in [1.0, 1.5, 2.2, 4.0] {
                let step = step(range, lines);
                let first = (range.0 / step).ceil();
                let marks: Vec<f64> = (0..20)
                    .map(|i| (first + f64::from(i)) * step)
                    .take_while(|it| *it <= range.1)
                    .collect();
                let labels: BTreeSet<String> =
                    marks.iter().map(|it| label(*it, range, lines)).collect();
                assert_eq!(labels.len(), marks.len(), "{labels:?} for {marks:?}");
                let is_near = |text: &String| {
                    let read: f64 = text.parse().expect("a number");
                    marks.iter().any(|mark| (read - mark).abs() < 0.01 * step)
                };
                assert!(labels.iter().all(is_near), "{labels:?} of {marks:?}");
            }
        }
    }
}
