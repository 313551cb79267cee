//! Loads of plans whose rates differ up and down, and of what goes besides.

use ForcePacking::{Force16, Multicast16};
use SamplePacking::{Position16, Position16Velocity, Position24Velocity};
use hardware::plan::{BusPlan, Extras, ForcePacking, Medium, SamplePacking, Verdict};

use super::rates::{CLASSIC, FD5, FD8, plan};

/// Asserts the load of the fullest of so many buses [%].
#[track_caller]
fn check(plan: &BusPlan, [sample_rate, force_rate]: [f64; 2], percent: f64) {
    let plan = BusPlan { sample_rate, force_rate, ..plan.clone() };
    let got = 100.0 * plan.load();
    // The table is rounded to a tenth.
    assert!((got - percent).abs() < 0.051, "{got} %, not {percent}");
    assert_eq!(plan.verdict(), Verdict::Fits);
}

#[test]
fn plans_with_different_rates_have_the_loads_of_the_table() {
    check(&plan(FD5, 1, Position16, Force16), [500.0, 250.0], 62.9);
    check(&plan(FD5, 1, Position16Velocity, Multicast16), [500.0, 250.0], 67.4);
    check(&plan(FD8, 1, Position16Velocity, Multicast16), [500.0, 500.0], 56.8);
    check(&plan(FD5, 2, Position16Velocity, Multicast16), [1_000.0, 500.0], 68.4);
    check(&plan(FD8, 2, Position16Velocity, Multicast16), [1_000.0, 1_000.0], 58.7);
    // The table does not say so, but its forces are for all boards here, too.
    check(&plan(FD5, 4, Position16Velocity, Multicast16), [1_000.0, 1_000.0], 41.0);
    check(&plan(FD8, 4, Position24Velocity, Multicast16), [2_000.0, 2_000.0], 66.7);
}

#[test]
fn clock_and_status_take_less_than_a_hundredth_of_can_fd() {
    for (medium, percent) in [(FD5, 0.9), (FD8, 0.7)] {
        let cyclic = plan(medium, 1, Position16, Force16);
        let all = BusPlan { extras: Extras::default(), ..cyclic.clone() };
        let got = 100.0 * (all.load() - cyclic.load());
        assert!((got - percent).abs() < 0.051, "{got} % of {medium}, not {percent}");
    }
}

#[test]
fn the_longest_frame_blocks_as_long_as_the_table_says() {
    let blocking = |medium: Medium| plan(medium, 1, Position24Velocity, Multicast16).blocking();
    assert!((blocking(FD5) - 168.8).abs() < 1e-9);
    assert!((blocking(CLASSIC) - 135.0).abs() < 1e-9);
}
