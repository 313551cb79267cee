//! All keys of all boards, one after the other.

use firmware_protocol::key::KeyIndex;
use hardware::calibrate::{Bench, Fault, Rested, calibrated};
use hardware::calibration::KeyCalibration;
use hardware::keybed::{Armed, Keybed};
use hardware::refusal::{KeyName, Refusal};
use indicatif::ProgressBar;

use super::bring_up::Board;
use super::operator::Operator;
use crate::command::{Failure, live};

/// Times that a key is measured again which was interrupted.
const TRIES: usize = 3;

/// What was measured of one board.
#[derive(Debug)]
pub(super) struct Measured {
    pub(super) board: Board,
    /// Its keys in the order of slots, or why not all of them could be measured.
    pub(super) keys: Result<Vec<(KeyIndex, KeyCalibration)>, Vec<Refusal>>,
}

/// Measures all keys; returns the boards without forces.
pub(super) fn all(
    boards: &[Board],
    mut bench: Box<Bench>,
    grams: Option<f64>,
    operator: &Operator,
) -> Result<(Vec<Measured>, Keybed<Armed>), Failure> {
    if grams.is_some() {
        operator.must_be_there("--weight")?;
    }
    let n_keys: usize = boards.iter().map(|it| keys(it).len()).sum();
    let bar = live::keys(n_keys);
    let measured = boards.iter().map(|board| Measured {
        board: board.clone(),
        keys: self::board(board, &mut bench, grams, &bar),
    });
    let measured = measured.collect();
    bar.finish_and_clear();
    Ok((measured, bench.release()))
}

/// The keys of a board.
fn keys(board: &Board) -> Vec<KeyIndex> {
    let keys = board.found.keys();
    (keys.first..keys.first.saturating_add(keys.n)).map_while(KeyIndex::new).collect()
}

/// Measures the keys of one board.
fn board(
    board: &Board,
    bench: &mut Bench,
    grams: Option<f64>,
    bar: &ProgressBar,
) -> Result<Vec<(KeyIndex, KeyCalibration)>, Vec<Refusal>> {
    let keys = keys(board);
    bar.set_message(format!("{}: rest", board.name));
    let rests = bench.rests(&keys);
    let (mut measured, mut refusals) = (Vec::new(), Vec::new());
    for (key, rested) in keys.into_iter().zip(rests) {
        bar.set_message(format!("{}: {}", board.name, KeyName(key)));
        match rested.and_then(|rested| self::key(board, bench, key, &rested, grams, bar)) {
            Ok(calibration) => measured.push((key, calibration)),
            Err(fault) => {
                let (board, key) = (board.name.clone(), KeyName(key));
                refusals.push(Refusal::Key { board, key, fault });
            }
        }
        bar.inc(1);
    }
    if refusals.is_empty() { Ok(measured) } else { Err(refusals) }
}

/// Measures one key that rests there.
fn key(
    board: &Board,
    bench: &mut Bench,
    key: KeyIndex,
    rested: &Rested,
    grams: Option<f64>,
    bar: &ProgressBar,
) -> Result<KeyCalibration, Fault> {
    let travelled = again(|| bench.trip(key, rested))?;
    let gain = match grams {
        None => 1.0,
        Some(grams) => {
            let name = KeyName(key);
            let put = format!("put {grams} g on the front of {name}");
            bar.suspend(|| Operator::wait_for(bench, &put));
            let gain = again(|| bench.balance(key, rested, &travelled, grams * 1e-3));
            bar.suspend(|| Operator::wait_for(bench, &format!("take it off {name}")));
            gain?
        }
    };
    Ok(calibrated(&board.found.nominal(), rested, &travelled, gain))
}

/// Measures again what was interrupted.
fn again<T>(mut measure: impl FnMut() -> Result<T, Fault>) -> Result<T, Fault> {
    let mut outcome = measure();
    for _ in 1..TRIES {
        if !matches!(outcome, Err(Fault::Interrupted)) {
            break;
        }
        outcome = measure();
    }
    outcome
}
