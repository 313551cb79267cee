//! Observed load of a line, compared with the plan.

use boards::keybed::{Keybed, NamedLink};
use boards::plan::{BusPlan, Extras, Medium, standard};

use crate::common::{Living, armed, board, clock, exchange, pair, terms};

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
    let mut keybed = armed(Keybed::new(lines, clock()));
    exchange(&mut keybed, 0, 1_000, 0.0);
    let lines = keybed.line_reports();
    assert_eq!((lines[1].medium, lines[1].load), (None, None));
    let load = lines[0].load.unwrap();
    let statistics = keybed.board_reports()[0].statistics;
    let seconds = load.frames as f64 / load.rate;
    let plan = BusPlan {
        name: "known".into(),
        medium,
        boards: standard(1..2),
        samples: terms().samples,
        forces: terms().forces,
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
