//! Simulated boards on a bench: the measurements match their construction.

use boards::calibrate::{
    self, Bench, CalibrationFault, RangeMeasurement, RangeTerms, RangedObject, Rested, Travelled,
};
use boards::keybed::{Keybed, NamedLink};
use boards::sim::board::{BoardMake, SimulatedBoard};
use boards::{calibrate::range::MOST_FORCE, calibration::KeyCalibration};
use firmware_protocol::acyclic::calibration::{KeyCalibration as Kept, ReadCalibration};
use firmware_protocol::key::{BoardId, KeyIndex};
use firmware_protocol::{Nothing, acyclic::Operation};
use haptics::{AnyEstimator, BackwardDifference, SampledWall, plant::RigParameters};

use crate::common::{Living, armed, clock, pair};

const TRIES: usize = 5;

fn make(n_keys: usize) -> BoardMake {
    let id = BoardId::new(3).expect("a board");
    BoardMake { n_keys, ..BoardMake::standard(id, 100e-6, RigParameters::default()) }
}

fn bench(make: BoardMake) -> (Bench, Living) {
    let (host, away) = pair();
    let board = Living::start(SimulatedBoard::new(make).expect("a possible board"), away);
    let lines = vec![NamedLink::new("socket 3", Box::new(host))];
    (Bench::new(armed(Keybed::new(lines, clock()))), board)
}

fn key(slot: u8) -> KeyIndex {
    KeyIndex::new(33 + slot).expect("a key")
}

fn tried<T>(
    mut measure: impl FnMut() -> Result<T, CalibrationFault>,
) -> Result<T, CalibrationFault> {
    let mut outcome = measure();
    for _ in 1..TRIES {
        if !matches!(outcome, Err(CalibrationFault::Interrupted | CalibrationFault::Silent { .. }))
        {
            break;
        }
        outcome = measure();
    }
    outcome
}

fn rested(bench: &mut Bench, key: KeyIndex) -> Rested {
    tried(|| bench.rests(&[key]).remove(0)).expect("a key at rest")
}

fn measured(bench: &mut Bench, nominal: &KeyCalibration, slot: u8) -> KeyCalibration {
    let rested = rested(bench, key(slot));
    let travelled = tried(|| bench.trip(key(slot), &rested)).expect("a key that moves");
    calibrate::calibrated(nominal, &rested, &travelled, 1.0)
}

#[test]
fn an_encoder_of_another_scale_and_offset_is_known_after_the_trip() {
    let rig = RigParameters { quantum: 2.5e-6, ..RigParameters::default() };
    let (mut bench, _board) = bench(BoardMake { rig, offset: -1_234, ..make(1) });
    let key = measured(&mut bench, &KeyCalibration::nominal(2.5e-6), 0);
    assert!((key.rest.get() + 1_234).abs() <= 2, "{key:?}");
    assert!((key.travel() - 10.17e-3).abs() < 20e-6, "{} m", key.travel());
}

#[test]
fn a_weak_motor_is_known_by_a_weight_and_the_board_is_told() {
    let mut rig = RigParameters::default();
    rig.key.mass += 0.05;
    // 50 g lie on the key from the start, so supply the trip without them.
    rig.key.weight = -0.05 * calibrate::G;
    let (mut bench, _board) = bench(BoardMake { rig, strength: 0.8, ..make(1) });
    let rested = Rested { position: 0.0, spread: 0.0 };
    let empty = Travelled { bottom: 10.16e-3, friction: 0.12 / 0.8, float: 0.0 };
    let gain = tried(|| bench.balance(key(0), &rested, &empty, 0.05)).expect("a balance");
    assert!((gain - 1.25).abs() < 0.03, "{gain}");
    let calibration = calibrate::calibrated(&KeyCalibration::nominal(1e-6), &rested, &empty, gain);
    assert!((calibration.friction - 0.12).abs() < 0.01, "{calibration:?}");
    let mut keybed = bench.release();
    let board = BoardId::new(3).expect("a board");
    let mut asker = keybed.asker(0, board);
    let record = calibrate::record(0, &calibration);
    let written: Result<Nothing, _> = keybed.ask(&mut asker, Operation::WriteCalibration, &record);
    written.expect("it was written");
    let wanted = ReadCalibration { slot: 0 };
    let kept: Kept = keybed.ask(&mut asker, Operation::ReadCalibration, &wanted).expect("a record");
    assert_eq!(kept, record);
    assert!((785..=815).contains(&kept.gain_permille), "{kept:?}");
}

#[test]
fn a_key_that_jams_is_refused_and_its_neighbour_is_not_felt() {
    let mut rig = RigParameters::default();
    rig.key.stiction = 3.0;
    let (mut bench, board) = bench(BoardMake { rig, ..make(2) });
    let rested = rested(&mut bench, key(1));
    let fault = tried(|| bench.trip(key(1), &rested)).expect_err("it jams");
    assert!(matches!(fault, CalibrationFault::Stuck { .. }), "{fault}");
    assert!(fault.to_string().contains("does not move under 1.5 N"), "{fault}");
    drop(bench.release());
    assert!(board.stop().rig(0).expect("a key").position().abs() < 1e-6);
}

#[test]
fn a_spring_is_raised_on_a_board_s_key_and_its_force_is_gone_afterwards() {
    let (mut bench, board) = bench(make(1));
    let rested = rested(&mut bench, key(0));
    let travelled = Travelled { bottom: 10.16e-3, friction: 0.12, float: 0.3 };
    let estimator = AnyEstimator::BackwardDifference(BackwardDifference::new(1e-3));
    let terms = RangeTerms { period: 1e-3, limit: MOST_FORCE, estimator };
    let spring = RangeMeasurement::new(RangedObject::Spring, terms, &rested, &travelled);
    let found = tried(|| bench.range(key(0), spring)).expect("a range");
    // A link and a busy host add delay, which only reduces it: 2 b / T, and friction.
    let free = SampledWall { stiffness: 0.0, damping: 0.0, period: 1e-3, delay: 0.0 };
    let most = 1.6 * free.linear_stiffness(1.0);
    assert!(found.good.is_some_and(|it| (20.0..most).contains(&it)), "{found:?}");
    drop(bench.release());
    std::thread::sleep(std::time::Duration::from_millis(150));
    let board = board.stop();
    assert!(board.is_safe() && board.rig(0).expect("a key").position() < 0.5e-3);
}

#[test]
fn a_board_that_goes_is_missed() {
    let (mut bench, board) = bench(make(1));
    let rested = rested(&mut bench, key(0));
    drop(board);
    let fault = bench.trip(key(0), &rested).expect_err("nobody is there");
    assert!(
        matches!(fault, CalibrationFault::Interrupted | CalibrationFault::Silent { .. }),
        "{fault}"
    );
    let fault = bench.rests(&[key(0)]).remove(0).expect_err("nobody is there");
    assert!(matches!(fault, CalibrationFault::Silent { .. }), "{fault}");
    let mut keybed = bench.release();
    let mut asker = keybed.asker(0, BoardId::new(3).expect("a board"));
    let refused = keybed.ask::<_, Nothing>(&mut asker, Operation::Counters, &Nothing);
    assert!(refused.expect_err("silence").to_string().contains("did not answer"));
}
