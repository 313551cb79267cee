//! Highest rates of 88 keys on 8 boards over CAN, every key up and every force down.

use super::hertz;
use ForcePacking::{Force16, Multicast16};
use SamplePacking::{Position16, Position16Velocity, Position24, Position24Velocity};
use boards::plan::{BusPlan, Extras, ForcePacking, Medium, SamplePacking, standard};

pub(crate) const CLASSIC: Medium = Medium::ClassicCan { bitrate: 1_000_000 };
pub(crate) const FD5: Medium = Medium::CanFd { nominal: 1_000_000, data: 5_000_000 };
pub(crate) const FD8: Medium = Medium::CanFd { nominal: 1_000_000, data: 8_000_000 };

/// Returns the fullest of these buses for eight boards: each has as many of them, and the one of
/// board 2 has keys of two groups of thirty, unless it has all three.
pub(crate) fn plan(medium: Medium, buses: usize, up: SamplePacking, down: ForcePacking) -> BusPlan {
    let first = [0, 0, 0, 0, 2, 0, 0, 0, 2][buses];
    BusPlan {
        name: "can0".to_owned(),
        medium,
        boards: standard(first..first + 8 / buses),
        samples: up,
        forces: down,
        sample_rate: 1_000.0,
        force_rate: 1_000.0,
        extras: Extras::NONE,
    }
}

/// Asserts the highest rates with 1, 2, 4 and 8 buses (Hz).
#[track_caller]
fn check(medium: Medium, up: SamplePacking, down: ForcePacking, rates: [u32; 4]) {
    let got = [1, 2, 4, 8].map(|buses| hertz(plan(medium, buses, up, down).max_rate()));
    assert_eq!(got, rates, "{up:?} and {down:?} over {medium}");
}

#[test]
fn forces_for_each_board_over_can_fd_reach_the_rates_of_the_table() {
    check(FD5, Position16, Force16, [477, 954, 1_908, 3_817]);
    check(FD5, Position24, Force16, [414, 828, 1_656, 3_311]);
    check(FD5, Position16Velocity, Force16, [414, 828, 1_656, 3_311]);
    check(FD5, Position24Velocity, Force16, [365, 731, 1_462, 2_924]);
    check(FD8, Position16, Force16, [642, 1_284, 2_568, 5_136]);
    check(FD8, Position24, Force16, [569, 1_138, 2_276, 4_552]);
    check(FD8, Position16Velocity, Force16, [569, 1_138, 2_276, 4_552]);
    check(FD8, Position24Velocity, Force16, [511, 1_022, 2_043, 4_087]);
}

/// The table has one bus for all 88 keys; for more it cuts frames off behind the last key, unlike
/// any real system. By hand: half of the boards have keys of two groups, as has board 2 alone.
#[test]
fn forces_for_all_boards_reach_the_rates_of_the_table_on_one_bus_and_take_whole_frames_on_more() {
    let check = |medium, up, sample: f64, whole: f64, table| {
        let hand = |boards: f64, groups: f64| hertz(0.8e6 / (boards * sample + groups * whole));
        let more = [(4.0, 2.0), (2.0, 2.0), (1.0, 2.0)].map(|(n, groups)| hand(n, groups));
        check(medium, up, Multicast16, [table, more[0], more[1], more[2]]);
    };
    check(FD5, Position16, 104.8, 168.8, 595);
    check(FD5, Position24, 136.8, 168.8, 500);
    check(FD5, Position16Velocity, 136.8, 168.8, 500);
    check(FD5, Position24Velocity, 168.8, 168.8, 431);
    check(FD8, Position16, 77.875, 117.875, 819);
    check(FD8, Position16Velocity, 97.875, 117.875, 704);
    check(FD8, Position24Velocity, 117.875, 117.875, 617);
}

#[test]
fn classic_can_carries_whole_frames_in_pieces_of_seven_bytes() {
    // By hand, for one board: 26 bytes are 3 frames of 135 us and one of 6 bytes, 115 us;
    // 37 are 5 and 85 us; 48 are 6 and 125 us; 59 are 8 and 95 us.
    let hand = |up: f64| [8.0, 4.0, 2.0, 1.0].map(|boards| hertz(0.8e6 / (boards * (up + 520.0))));
    check(CLASSIC, Position16, Force16, hand(520.0));
    check(CLASSIC, Position24, Force16, hand(5.0 * 135.0 + 85.0));
    check(CLASSIC, Position16Velocity, Force16, hand(6.0 * 135.0 + 125.0));
    check(CLASSIC, Position24Velocity, Force16, hand(8.0 * 135.0 + 95.0));
}
