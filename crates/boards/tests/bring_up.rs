//! Bring-up of a keybed from links to arming, with its refusals.

use std::time::Duration;

use boards::keybed::{Keybed, NamedLink, Terms, WantedBoards};
use boards::rt::board_supervisor::{ArmLockout, ArmState};
use boards::rt::link_snapshot::LinkSnapshot;
use firmware_protocol::frame::key_forces::ForcePacking;

use crate::common::{PATIENCE, armed, clock, exchange, keybed, nominal, pair, terms, wanted};

#[test]
fn two_boards_are_found_armed_and_take_forces_of_their_own_and_for_all_boards() {
    for (forces, oldest_us) in
        [(ForcePacking::default(), 100_000), (ForcePacking::Multicast16, 32_000)]
    {
        let (offline, boards) = keybed(&[2, 5]);
        let identified = offline.identify(PATIENCE).expect("boards");
        let calibrated = identified.calibrate(&WantedBoards { forces, ..wanted() }, nominal);
        let calibrated = calibrated.expect("boards that take such forces");
        let mut keybed = calibrated.arm(Terms { forces, ..terms() }, PATIENCE).expect("armed");
        // Down: 1 N is more than the 0.12 N of stiction.
        let samples = exchange(&mut keybed, 0, 300, -1.0);
        for (key, sample) in samples.iter().enumerate() {
            let is_there = (22..33).contains(&key) || (55..66).contains(&key);
            assert_eq!(9e-3 < sample.position, is_there, "key {key}: {sample:?}");
        }
        let reports = keybed.board_reports();
        drop(keybed);
        for (report, living) in reports.iter().zip(boards) {
            let counts = living.stop().counts();
            let is_whole = counts.corrupt == 0 && counts.refused == 0;
            assert!(200 < counts.forces && is_whole, "{counts:?}");
            assert!(counts.oldest_us <= oldest_us, "{counts:?}");
            assert_eq!(report.condition.armings, 1, "{report:?}");
        }
    }
}

#[test]
fn one_board_shows_its_light_while_all_render_and_each_is_seen() {
    let (offline, mut boards) = keybed(&[2, 5]);
    let mut keybed = armed(offline);
    let (mut lights, mut samples) = (keybed.identify_requests(), keybed.monitor(1_000));
    exchange(&mut keybed, 0, 50, 0.0);
    lights.push(1).expect("room");
    exchange(&mut keybed, 50, 100, 0.0);
    let mut seen = std::iter::from_fn(|| samples.pop().ok());
    for line in [0, 1] {
        let (tick, snapshot) = seen.next().expect("a line");
        assert!(matches!(snapshot, LinkSnapshot::Line(it, _) if it == line), "{tick}");
    }
    for board in [0, 1] {
        let Some((_, LinkSnapshot::Board(index, it))) = seen.next() else { panic!("no board") };
        let status = it.status.expect("it is supervised");
        assert_eq!((index, status.state, status.armings), (board, ArmState::Armed, 1));
        assert!(status.round_trip_us.is_some_and(|it| 0 < it), "{status:?}");
    }
    assert_eq!(seen.next(), None, "they are shown once a second");
    let lit: Vec<_> = boards.drain(..).map(|board| board.stop().is_lit()).collect();
    assert_eq!(lit, [false, true]);
}

#[test]
fn a_board_that_was_stopped_shows_its_light_all_the_same() {
    let (offline, mut boards) = keybed(&[0]);
    let mut keybed = armed(offline);
    exchange(&mut keybed, 0, 50, 0.0);
    keybed.stop(1);
    exchange(&mut keybed, 50, 200, 0.0);
    keybed.request_light(0);
    exchange(&mut keybed, 250, 100, 0.0);
    let report = keybed.board_reports().remove(0);
    assert!(
        matches!(report.condition.state, ArmState::Barred(ArmLockout::Latched(_))),
        "{report:?}"
    );
    assert!(boards.remove(0).stop().is_lit());
}

#[test]
fn a_host_that_falls_silent_leaves_a_board_safe_and_one_that_comes_back_arms_it_again() {
    let (offline, mut boards) = keybed(&[0]);
    let mut keybed = armed(offline);
    exchange(&mut keybed, 0, 100, -1.0);
    std::thread::sleep(Duration::from_millis(300));
    exchange(&mut keybed, 400, 300, 0.0);
    let report = keybed.board_reports().remove(0);
    assert_eq!(report.condition.armings, 2, "{report:?}");
    let counts = boards.remove(0).stop().counts();
    assert_eq!((counts.trips, counts.armings), (1, 2), "{counts:?}");
}

#[test]
fn a_line_without_a_board_is_refused_by_its_name() {
    let (host, _nobody) = pair();
    let line = NamedLink::new("/dev/printer", Box::new(host));
    let refusals = Keybed::new(vec![line], clock()).identify(300_000).expect_err("nobody");
    let sentence = refusals.to_string();
    assert!(
        sentence.contains("/dev/printer") && sentence.contains("not a byte came"),
        "{sentence}"
    );
}
