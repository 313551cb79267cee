//! Direction of a motion that starts on the surface: the rule at zero, of `epoch`, for h.

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Heading {
    Up,
    Down,
    /// Along the surface, within rounding.
    Still,
}

/// Returns the heading by the rate h' (1/s) and its own `change` h'' (1/s²). A rate counts as zero
/// if it is within rounding, `rate_band`, or if its change turns it before it has moved h by
/// `height_band`, the rounding of h itself. No other threshold, step or time enters.
pub(super) fn heading(
    (rate, change): (f64, f64),
    height_band: f64,
    rate_band: f64,
    change_band: f64,
) -> Heading {
    // From h' = −r, a change c brings h down to −r²/2c.
    let is_turned = rate * change < 0.0 && rate * rate <= 2.0 * change.abs() * height_band;
    let is_zero = rate.abs() <= rate_band;
    let (motion, band) = if is_turned || is_zero { (change, change_band) } else { (rate, 0.0) };
    if is_zero && motion.abs() <= band {
        Heading::Still
    } else if motion > 0.0 {
        Heading::Up
    } else {
        Heading::Down
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(rate: f64, change: f64, expected: Heading) {
        let found = heading((rate, change), 1e-15, 1e-14, 1e-10);
        assert_eq!(found, expected, "rate {rate:e}, change {change:e}");
    }

    #[test]
    fn a_rate_decides() {
        check(1.0, -1e3, Heading::Up);
        check(-1.0, 1e3, Heading::Down);
        check(1e-13, 0.0, Heading::Up);
    }

    #[test]
    fn a_rate_within_rounding_leaves_it_to_its_change() {
        check(-1e-14, 1.0, Heading::Up);
        check(1e-14, -1.0, Heading::Down);
        check(0.0, 1e-9, Heading::Up);
    }

    #[test]
    fn a_dip_that_rounding_hides_is_none() {
        // 1e-8² / 2 = 5e-17, and 1e-7² / 2 = 5e-15.
        check(-1e-8, 1.0, Heading::Up);
        check(-1e-7, 1.0, Heading::Down);
        check(1e-8, -1.0, Heading::Down);
        check(1e-7, -1.0, Heading::Up);
    }

    #[test]
    fn what_moves_nowhere_is_still() {
        check(0.0, 0.0, Heading::Still);
        check(1e-15, -1e-11, Heading::Still);
    }
}
