//! A performance as bytes: numbers of eight bytes, little-endian, lists behind their lengths.

use haptics::plant::{Gesture, Touch};
use keyboard::KEYS;
use midi::{Pedal, PedalMove};

use crate::assess::{ExpectedNote, Struck};
use crate::pianist::{CutNote, Performance, ShortStroke};
use crate::rehearse::Shortfall;

/// Number in place of one that does not exist.
const NONE: f64 = -1.0;

impl Performance {
    /// Returns the performance as bytes. It equals [`Self::from_bytes`] of them, bit by bit.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::new();
        for gestures in &self.gestures {
            put(&mut out, gestures, |it| {
                let touch = f64::from(u8::from(it.touch == Touch::Struck));
                [it.start, it.release, touch, it.from, it.speed, it.hold, it.lift]
            });
        }
        put(&mut out, &self.expected, |it| {
            let release = it.release.map_or(NONE, f64::from);
            [it.key.into(), it.onset, it.speed, it.velocity.into(), it.end, release]
        });
        put(&mut out, &self.predicted, |it| [it.key.into(), it.at, it.velocity.into()]);
        put(&mut out, &self.shortfalls, |it| {
            let [kind, one, other] = numbers(it.why);
            [it.key.into(), it.onset, kind, one, other]
        });
        put(&mut out, &self.cuts, |it| [it.key.into(), it.onset, it.by, it.next]);
        put(&mut out, self.range.as_slice(), |it| [it.0, it.1]);
        put(&mut out, &self.pedals, |it| [f64::from(it.pedal as u8), it.at, it.depth]);
        put(&mut out, self.repeat.as_slice(), |it| [*it]);
        out.iter().flat_map(|number| number.to_le_bytes()).collect()
    }

    /// Returns the performance of `bytes`; `None` unless [`Self::to_bytes`] made them.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (numbers, []) = bytes.as_chunks::<8>() else { return None };
        let input = &mut &numbers.iter().map(|it| f64::from_le_bytes(*it)).collect::<Vec<_>>()[..];
        let gesture = |[start, release, touch, from, speed, hold, lift]: [f64; 7]| {
            let touch = if touch == 0.0 { Touch::Pressed } else { Touch::Struck };
            Some(Gesture { start, release, touch, from, speed, hold, lift })
        };
        let gestures = (0..KEYS).map(|_| take(input, gesture)).collect::<Option<Vec<_>>>()?;
        let expected = take(input, |[key, onset, speed, velocity, end, release]| {
            let release = if release < 0.0 { None } else { Some(small(release)?) };
            let (key, velocity) = (small(key)?, small(velocity)?);
            Some(ExpectedNote { key, onset, speed, velocity, end, release })
        })?;
        let predicted = take(input, |[key, at, velocity]| {
            Some(Struck { key: small(key)?, at, velocity: small(velocity)? })
        })?;
        let shortfalls = take(input, |[key, onset, kind, one, other]| {
            Some(ShortStroke { key: small(key)?, onset, why: shortfall([kind, one, other])? })
        })?;
        let cuts = take(input, |[key, onset, by, next]| {
            Some(CutNote { key: small(key)?, onset, by, next })
        })?;
        let range = take(input, |[softest, loudest]| Some((softest, loudest)))?.pop();
        let pedals = take(input, |[pedal, at, depth]| {
            Some(PedalMove { pedal: *Pedal::ALL.get(usize::from(small(pedal)?))?, at, depth })
        })?;
        let repeat = take(input, |[length]| Some(length))?.pop();
        let found = Self { gestures, expected, predicted, shortfalls, cuts, range, pedals, repeat };
        input.is_empty().then_some(found)
    }
}

fn numbers(why: Shortfall) -> [f64; 3] {
    match why {
        Shortfall::TooSoon { late } => {
            [0.0, f64::from(u8::from(late.is_some())), late.unwrap_or(0.0)]
        }
        Shortfall::TooLoud { speed, wanted } => [1.0, speed, wanted],
        Shortfall::Silent => [2.0, 0.0, 0.0],
        Shortfall::Late { by } => [3.0, by, 0.0],
        Shortfall::Level { speed, wanted } => [4.0, speed, wanted],
        Shortfall::Repeated => [5.0, 0.0, 0.0],
    }
}

fn shortfall([kind, one, other]: [f64; 3]) -> Option<Shortfall> {
    Some(match small(kind)? {
        0 => Shortfall::TooSoon { late: (one != 0.0).then_some(other) },
        1 => Shortfall::TooLoud { speed: one, wanted: other },
        2 => Shortfall::Silent,
        3 => Shortfall::Late { by: one },
        4 => Shortfall::Level { speed: one, wanted: other },
        5 => Shortfall::Repeated,
        _ => return None,
    })
}

fn put<T, const N: usize>(out: &mut Vec<f64>, rows: &[T], row: impl Fn(&T) -> [f64; N]) {
    out.push(rows.len() as f64);
    out.extend(rows.iter().flat_map(row));
}

/// Reads a list of rows of `N` numbers; `None` if it is longer than `input`, or a row is invalid.
fn take<T, const N: usize>(
    input: &mut &[f64],
    row: impl Fn([f64; N]) -> Option<T>,
) -> Option<Vec<T>> {
    let (length, rest) = input.split_first()?;
    let end = (0.0..=rest.len() as f64).contains(length).then_some(*length)?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in the range")]
    let (rows, rest) = rest.split_at_checked(N * end as usize)?;
    *input = rest;
    rows.as_chunks::<N>().0.iter().map(|it| row(*it)).collect()
}

/// Returns a number that is a whole one, 0 ..= 255.
fn small(number: f64) -> Option<u8> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "compared")]
    let small = number as u8;
    (f64::from(small).to_bits() == number.to_bits()).then_some(small)
}
