//! Observed load of a line, compared with the plan.

use std::time::Duration;

use boards::keybed::{Keybed, NamedLink, Terms, WantedBoards};
use boards::plan::{BusPlan, Extras, Medium, standard};
use scheduler::motion::{KEYS, KeySample, KeySlope};
use scheduler::port::KeyBus as _;

use crate::common::{Living, board, clock, nominal, pair};

#[test]
fn a_line_is_as_full_as_the_frames_that_it_carried_make_it() {
    let medium = Medium::CanFd { nominal: 1_000_000, data: 5_000_000 };
    let (host, away) = pair();
    let (other_host, other_away) = pair();
    let _boards = [Living::start(board(1), away), Living::start(board(2), other_away)];
    let lines = vec![
        NamedLink { medium: Some(medium), ..NamedLink::new("known", Box::new(host)) },
        NamedLink::new("not known", Box::new(other_host)),
    ];
    let identified = Keybed::new(lines, clock()).identify(5_000_000).unwrap();
    let calibrated = identified
        .calibrate(&WantedBoards { hz: 1_000, ..WantedBoards::default() }, nominal)
        .unwrap();
    let WantedBoards { samples, forces, .. } = WantedBoards::default();
    let terms = Terms { period_us: 1_000, samples, forces, valid_ms: 100 };
    let mut keybed = calibrated.arm(terms, 5_000_000).unwrap();
    let mut readings = [KeySample::default(); KEYS];
    for tick in 0..1_000 {
        keybed.receive(tick, &mut readings);
        keybed.send(tick, &[0.0; KEYS], &[KeySlope::HELD; KEYS]);
        std::thread::sleep(Duration::from_millis(1));
    }
    let lines = keybed.line_reports();
    assert_eq!((lines[1].medium, lines[1].load), (None, None));
    let load = lines[0].load.unwrap();
    // The same frames by the planner, at the rates that came.
    let statistics = keybed.board_reports()[0].statistics;
    let seconds = load.frames as f64 / load.rate;
    let plan = BusPlan {
        name: "known".into(),
        medium,
        boards: standard(1..2),
        samples,
        forces,
        sample_rate: statistics.samples.frames as f64 / seconds,
        force_rate: statistics.sent as f64 / seconds,
        extras: Extras::NONE,
    };
    let beside = load.most - plan.load();
    let asked = BusPlan { extras: Extras::default(), ..plan.clone() }.load() - plan.load();
    assert!((0.8..4.0).contains(&(beside / asked)), "seen {load:?}, planned {}", plan.load());
    assert!(0.05 < load.most && load.least < load.most, "{load:?}");
    let bytes = lines[0].statistics.bytes;
    let cyclic = 37 * statistics.samples.frames + 26 * statistics.sent;
    assert!(cyclic <= bytes && bytes < cyclic + 20_000, "{bytes} of {cyclic}");
}
