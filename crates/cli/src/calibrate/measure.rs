use boards::calibrate::{Bench, CalibrationFault, Ending, Rested, calibrated};
use boards::calibration::KeyCalibration;
use boards::keybed::{Armed, Keybed};
use boards::refusal::Refusal;
use firmware_protocol::key::KeyIndex;
use indicatif::ProgressBar;

use super::bring_up::MeasuredBoard;
use super::operator::Operator;
use super::write::{CalibrationRecord, MeasureOutcome};
use crate::live::KeyProgress;

/// Maximum repetitions of an interrupted measurement.
const TRIES: usize = 3;

enum KeyFailure {
    Fault(CalibrationFault),
    Stopped,
}

impl From<CalibrationFault> for KeyFailure {
    fn from(fault: CalibrationFault) -> Self {
        if fault == CalibrationFault::Stopped { Self::Stopped } else { Self::Fault(fault) }
    }
}

/// Measures all keys and stores each board at once, until a stop; returns the boards without
/// forces, and the kind of stop, if any.
pub(super) fn all(
    boards: &[MeasuredBoard],
    mut bench: Box<Bench>,
    grams: Option<f64>,
    record: &mut CalibrationRecord,
) -> (Keybed<Armed>, Option<Ending>) {
    let n_keys: usize = boards.iter().map(|it| keys(it).len()).sum();
    let progress = KeyProgress::new(n_keys);
    for board in boards {
        let outcome = self::board(board, &mut bench, grams, &progress);
        let is_over = outcome.is_stopped;
        // A disk may be slow, and boards that receive nothing meanwhile would trip.
        std::thread::scope(|scope| {
            let writer = scope.spawn(|| record.keep(board, outcome));
            bench.wait(|| writer.is_finished());
        });
        if is_over {
            break;
        }
    }
    progress.finish();
    let ending = bench.ending();
    (bench.release(), ending)
}

fn keys(board: &MeasuredBoard) -> Vec<KeyIndex> {
    let keys = board.found.keys();
    (keys.first..keys.first.saturating_add(keys.n)).map_while(KeyIndex::new).collect()
}

fn board(
    board: &MeasuredBoard,
    bench: &mut Bench,
    grams: Option<f64>,
    progress: &KeyProgress,
) -> MeasureOutcome {
    let keys = keys(board);
    progress.show(&format!("{}: rest", board.name));
    let rests = bench.rests(&keys);
    let mut outcome = MeasureOutcome::default();
    for (key, rested) in keys.into_iter().zip(rests) {
        progress.show(&format!("{}: {}", board.name, key));
        let rested = rested.map_err(KeyFailure::from);
        let measured =
            rested.and_then(|rested| self::key(board, bench, key, &rested, grams, progress.bar()));
        let measured = match measured {
            Ok(calibration) => Some(calibration),
            Err(KeyFailure::Stopped) => {
                outcome.is_stopped = true;
                None
            }
            Err(KeyFailure::Fault(fault)) => {
                let board = board.name.clone();
                outcome.refusals.push(Refusal::Key { board, key, fault });
                None
            }
        };
        outcome.keys.push((key, measured));
        if !outcome.is_stopped {
            progress.next();
        }
    }
    outcome
}

fn key(
    board: &MeasuredBoard,
    bench: &mut Bench,
    key: KeyIndex,
    rested: &Rested,
    grams: Option<f64>,
    bar: &ProgressBar,
) -> Result<KeyCalibration, KeyFailure> {
    let travelled = again(|| bench.trip(key, rested))?;
    let gain = match grams {
        None => 1.0,
        Some(grams) => {
            let ask = |bench: &mut Bench, what: &str| {
                let goes_on = bar.suspend(|| Operator::wait_for(bench, what));
                if goes_on { Ok(()) } else { Err(KeyFailure::Stopped) }
            };
            ask(bench, &format!("put {grams} g on the front of {key}"))?;
            let gain = again(|| bench.balance(key, rested, &travelled, grams * 1e-3));
            ask(bench, &format!("take it off {key}"))?;
            gain?
        }
    };
    Ok(calibrated(&board.found.nominal(), rested, &travelled, gain))
}

/// Repeats an interrupted measurement.
pub(super) fn again<T>(
    mut measure: impl FnMut() -> Result<T, CalibrationFault>,
) -> Result<T, CalibrationFault> {
    let mut outcome = measure();
    for _ in 1..TRIES {
        if !matches!(outcome, Err(CalibrationFault::Interrupted)) {
            break;
        }
        outcome = measure();
    }
    outcome
}
