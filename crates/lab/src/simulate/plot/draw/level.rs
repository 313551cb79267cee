//! How curves of different units share a panel: two axes with their zeros level.

use std::ops::Range;

/// Room above and below the curves, as a part of their range.
const ROOM: f64 = 0.06;

/// A range for each of `extents`, so that all have their zero at the same height.
pub(super) fn level<const N: usize>(extents: [Option<(f64, f64)>; N]) -> [Range<f64>; N] {
    let sizes = extents.map(|extent| extent.map_or(0.0, |(low, high)| low.abs().max(high.abs())));
    let (mut below, mut above) = (0.0_f64, 0.0_f64);
    for (extent, size) in extents.iter().zip(sizes) {
        if let Some((low, high)) = extent
            && size > 0.0
        {
            below = below.max(-low / size);
            above = above.max(high / size);
        }
    }
    if below + above == 0.0 {
        (below, above) = (1.0, 1.0);
    }
    let room = ROOM * (below + above);
    sizes.map(|size| {
        let size = if size > 0.0 { size } else { 1.0 };
        -(below + room) * size..(above + room) * size
    })
}

/// Three digits of `value`.
pub(super) fn short(value: f64) -> String {
    let decimals = match value.abs() {
        ..1e-3 => return format!("{value:.2e}"),
        ..1e-2 => 5,
        ..1e-1 => 4,
        ..1.0 => 3,
        ..10.0 => 2,
        ..100.0 => 1,
        ..1e5 => 0,
        _ => return format!("{value:.2e}"),
    };
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where zero is in a range, 0 to 1.
    fn zero(range: &Range<f64>) -> f64 {
        -range.start / (range.end - range.start)
    }

    #[test]
    fn zeros_are_level_and_everything_is_inside() {
        let extents = [(-2.0, 1.0), (0.1, 0.4)];
        let ranges = level(extents.map(Some));
        assert!((zero(&ranges[0]) - zero(&ranges[1])).abs() < 1e-12);
        for (range, (low, high)) in ranges.iter().zip(extents) {
            assert!(range.start < low && high < range.end, "{range:?}");
        }
    }

    #[test]
    fn nothing_and_zero_have_a_range_too() {
        for [range] in [level([None]), level([Some((0.0, 0.0))])] {
            assert!(range.start < 0.0 && range.end > 0.0, "{range:?}");
        }
    }

    #[test]
    fn peaks_have_three_digits() {
        let shorts = [0.123_45, 12.3, 1234.0, 1e-5, 3e9].map(short);
        assert_eq!(shorts, ["0.123", "12.3", "1234", "1.00e-5", "3.00e9"]);
    }
}
