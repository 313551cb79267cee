//! Aligns the zeros of two axes of different units.

/// Room above and below the curves, as a fraction of their range.
const ROOM: f64 = 0.06;

/// Returns the ends of an axis for each of `extents`, with all zeros at one height.
pub fn level<const N: usize>(extents: [Option<(f64, f64)>; N]) -> [(f64, f64); N] {
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
        (-(below + room) * size, (above + room) * size)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zero((low, high): (f64, f64)) -> f64 {
        -low / (high - low)
    }

    #[test]
    fn zeros_are_level_and_everything_is_inside() {
        let extents = [(-2.0, 1.0), (0.1, 0.4)];
        let ranges = level(extents.map(Some));
        assert!((zero(ranges[0]) - zero(ranges[1])).abs() < 1e-12);
        for (range, (low, high)) in ranges.iter().zip(extents) {
            assert!(range.0 < low && high < range.1, "{range:?}");
        }
    }

    #[test]
    fn nothing_and_zero_have_a_range_too() {
        for [range] in [level([None]), level([Some((0.0, 0.0))])] {
            assert!(range.0 < 0.0 && range.1 > 0.0, "{range:?}");
        }
    }
}
