//! Loads of plans with different rates up and down, and of additional traffic.

use ForcePacking::{Force16, Multicast16};
use SamplePacking::{Position16, Position16Velocity, Position24Velocity};
use boards::plan::{BusPlan, BusVerdict, Extras, ForcePacking, Medium, SamplePacking};

use super::rates::{CLASSIC, FD5, FD8, plan};

#[track_caller]
fn check(plan: &BusPlan, [sample_rate, force_rate]: [f64; 2], percent: f64) {
    let plan = BusPlan { sample_rate, force_rate, ..plan.clone() };
    let got = 100.0 * plan.load();
    assert!((got - percent).abs() < 0.051, "{got} %, not {percent}");
    assert_eq!(plan.verdict(), BusVerdict::Fits);
}

#[test]
fn plans_with_different_rates_have_the_loads_of_the_table() {
    check(&plan(FD5, 1, Position16, Force16), [500.0, 250.0], 62.9);
    check(&plan(FD5, 1, Position16Velocity, Multicast16), [500.0, 250.0], 67.4);
    check(&plan(FD8, 1, Position16Velocity, Multicast16), [500.0, 500.0], 56.8);
}

/// By hand, at 1/5 and 1/8 Mbit/s: requests of 3 bytes take 45.8 and 41 us, a time of 8 bytes
/// 55.8 and 47.2, counts of 44 in 48 bytes 136.8 and 97.9, the bus's time in 6 bytes 51.8 and 44.8.
#[test]
fn what_is_asked_beside_takes_two_hundredths_of_can_fd() {
    let check = |medium, forces, percent: f64| {
        let cyclic = plan(medium, 1, Position16, forces);
        let all = BusPlan { extras: Extras::default(), ..cyclic.clone() };
        let got = 100.0 * (all.load() - cyclic.load());
        assert!((got - percent).abs() < 0.001, "{got} % of {medium}, not {percent}");
    };
    // Two requests for the health of board and key count as if they were for counts.
    let asked = |ping: f64, counts: f64| 100e-6 * (8.0 * 20.0 * ping + 3.0 * 8.0 * counts);
    check(FD5, Force16, asked(45.8 + 55.8, 45.8 + 136.8));
    check(FD8, Force16, asked(41.0 + 47.25, 41.0 + 97.875));
    check(FD5, Multicast16, asked(45.8 + 55.8, 45.8 + 136.8) + 100e-6 * 50.0 * 51.8);
}

#[test]
fn the_longest_frame_blocks_as_long_as_the_table_says() {
    let blocking = |medium: Medium| plan(medium, 1, Position24Velocity, Multicast16).blocking();
    assert!((blocking(FD5) - 168.8).abs() < 1e-9);
    assert!((blocking(CLASSIC) - 135.0).abs() < 1e-9);
    assert!((blocking(Medium::UsbFullSpeed) - 1_000.0).abs() < 1e-9);
}
