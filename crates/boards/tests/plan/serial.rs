//! Highest rates over serial lines and USB.

use boards::plan::uart::{Wiring, wire_bytes};
use boards::plan::{BusPlan, Extras, ForcePacking, Medium, SamplePacking, standard, usb::UsbRate};
use keyboard::KeyRange;

use super::hertz;
use SamplePacking::{Position16, Position16Velocity, Position24, Position24Velocity};

const PACKINGS: [SamplePacking; 4] =
    [Position16, Position24, Position16Velocity, Position24Velocity];

/// Returns the highest rates with these boards, for each packing (Hz).
fn rates(medium: Medium, boards: &[KeyRange]) -> [u32; 4] {
    PACKINGS.map(|samples| {
        let plan = BusPlan {
            name: "port".to_owned(),
            medium,
            boards: boards.to_vec(),
            samples,
            forces: ForcePacking::Force16,
            sample_rate: 1_000.0,
            force_rate: 1_000.0,
            extras: Extras::NONE,
        };
        hertz(plan.max_rate())
    })
}

#[test]
fn frames_on_the_wire_have_the_lengths_of_the_table() {
    let up = |n_keys| PACKINGS.map(|packing| wire_bytes(packing.frame_len(n_keys)));
    let down = |n_keys| wire_bytes(ForcePacking::Force16.frame_len(n_keys));
    assert_eq!((up(11), down(11)), ([30, 41, 52, 63], 30));
    assert_eq!((up(88), down(88)), ([184, 273, 361, 449], 184));
}

const HUB: [KeyRange; 1] = [KeyRange::ALL];

/// Rate (Mbaud); rates of a board's own link, one for all 88 keys, a line for eight boards (Hz).
type Row = (u32, [u32; 4], [u32; 4], [u32; 4]);

#[rustfmt::skip]
const UART: [Row; 5] = [
    (1, [2_667, 1_951, 1_538, 1_270], [435, 293, 222, 178], [167, 141, 122, 108]),
    (2, [5_333, 3_902, 3_077, 2_540], [870, 586, 443, 356], [333, 282, 244, 215]),
    (3, [8_000, 5_854, 4_615, 3_810], [1_304, 879, 665, 535], [500, 423, 366, 323]),
    (4, [10_667, 7_805, 6_154, 5_079], [1_739, 1_172, 886, 713], [667, 563, 488, 430]),
    (12, [32_000, 23_415, 18_462, 15_238], [5_217, 3_516, 2_659, 2_138], [2_000, 1_690, 1_463, 1_290]),
];

#[test]
fn serial_lines_reach_the_rates_of_the_table() {
    for (mbaud, own, hub, shared) in UART {
        let baud = mbaud * 1_000_000;
        let link = Medium::Uart { baud, wiring: Wiring::FullDuplex };
        let line = Medium::Uart { baud, wiring: Wiring::HalfDuplex { turnaround: 0 } };
        assert_eq!(rates(link, &standard(0..1)), own, "own link at {mbaud} Mbaud");
        assert_eq!(rates(link, &HUB), hub, "hub at {mbaud} Mbaud");
        assert_eq!(rates(line, &standard(0..8)), shared, "RS-485 at {mbaud} Mbaud");
    }
}

#[test]
fn a_frame_of_usb_has_room_for_as_many_transactions_as_its_standard_says() {
    let full = [(1, 107), (2, 100), (4, 88), (8, 71), (16, 51), (32, 33), (64, 19)];
    for (bytes, transactions) in full {
        assert_eq!(UsbRate::Full.transactions_per_frame(bytes), transactions, "{bytes} bytes");
    }
    let high = [
        (1, 133),
        (2, 131),
        (4, 127),
        (8, 119),
        (16, 105),
        (32, 86),
        (64, 63),
        (128, 40),
        (256, 24),
        (512, 13),
    ];
    for (bytes, transactions) in high {
        assert_eq!(UsbRate::High.transactions_per_frame(bytes), transactions, "{bytes} bytes");
    }
}

#[test]
fn usb_reaches_the_rates_of_the_table() {
    let full = Medium::UsbFullSpeed;
    assert_eq!(rates(full, &standard(0..8)), [1_744, 1_546, 1_389, 1_261]);
    assert_eq!(rates(full, &HUB), [2_691, 2_139, 1_813, 1_546]);
    // The table is rounded to a kilohertz.
    let high = rates(Medium::UsbHighSpeed, &standard(0..8)).map(|rate| (rate + 500) / 1_000);
    assert_eq!(high, [35, 33, 31, 30]);
}
