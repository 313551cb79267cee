//! Trials of nonces, the watchdog, recovery, and the emergency stop.

use firmware_protocol::Nothing;
use firmware_protocol::acyclic::arm::{Arm, Disarmed, FADE_MS, SHORTEST_VALID_MS};
use firmware_protocol::acyclic::{Operation, Status, counters::Counters};
use firmware_protocol::frame::hello::{Hello, safe_reason};
use firmware_protocol::frame::{Header, key_samples::KeySamples};

use super::{ConformanceItem, MOST_FORCE_MN, TestedBoard, tested_board::TimedSamples};
use crate::{refusal::reason_words, untaken::UntakenForces};

/// Validity of forces in these trials (ms): the longest, since this machine may be busy.
const VALID_MS: u8 = firmware_protocol::acyclic::arm::LONGEST_VALID_MS;
/// Length of a stream of forces (us).
const FORCES_US: u64 = 400_000;
/// Longest time between the end of forces and the first samples that report it (us), beside their
/// validity: two periods, or a delay of the board.
const TRIP_US: u64 = 20_000;

pub(super) fn items(board: &mut TestedBoard<'_>) -> Vec<ConformanceItem> {
    vec![
        ConformanceItem::new("Arm without a Disarm is refused", without_disarm(board)),
        ConformanceItem::new("Arm with another nonce is refused", other_nonce(board)),
        ConformanceItem::new("forces cannot be valid for less than 5 ms", short_validity(board)),
        ConformanceItem::new("an armed board says so in its samples", says_so(board)),
        ConformanceItem::new("nothing expires before the first force", waits(board)),
        ConformanceItem::new("forces that answer samples are taken", takes(board)),
        ConformanceItem::new("forces that answer no samples are dropped", drops(board)),
        ConformanceItem::new("silence takes the forces away", watchdog(board)),
        ConformanceItem::new("forces do not arm it again", stays(board)),
        ConformanceItem::new("Disarm and Arm bring it back", recovers(board)),
        ConformanceItem::new("Disarm takes the forces away", disarms(board)),
    ]
}

#[expect(clippy::unnecessary_wraps, reason = "what listen takes")]
const fn answer(samples: &KeySamples) -> Option<(Header, i32)> {
    Some((samples.header, MOST_FORCE_MN))
}

fn flag(heard: &[TimedSamples]) -> Result<bool, String> {
    heard.last().map(|it| it.samples.header.flag).ok_or_else(|| "no samples came".to_owned())
}

fn reason(board: &mut TestedBoard<'_>) -> Result<u8, String> {
    Ok(board.get::<Hello>(Operation::Hello)?.safe_reason)
}

fn expect_flag(heard: &[TimedSamples], flag_up: u8) -> Result<(), String> {
    let up = u8::from(flag(heard)?);
    let words = ["that it renders forces", "that it renders none"];
    if up == flag_up { Ok(()) } else { Err(format!("its samples say {}", words[usize::from(up)])) }
}

fn expect_status(
    asked: Result<Status, String>,
    expected: Status,
    seen: &str,
) -> Result<String, String> {
    match asked? {
        status if status == expected => Ok(seen.to_owned()),
        status => Err(format!("it was answered with {status:?}")),
    }
}

fn without_disarm(board: &mut TestedBoard<'_>) -> Result<String, String> {
    // A used nonce is invalid, too.
    let Disarmed { nonce } = board.get(Operation::Disarm)?;
    let wanted = Arm { nonce, packing: 0, valid_ms: VALID_MS };
    let _armed: Nothing = board.get_with(Operation::Arm, &wanted)?;
    let again = board.status(Operation::Arm, &wanted);
    expect_status(again, Status::WrongState, "a nonce serves once")
}

fn other_nonce(board: &mut TestedBoard<'_>) -> Result<String, String> {
    let Disarmed { nonce } = board.get(Operation::Disarm)?;
    let wanted = Arm { nonce: !nonce, packing: 0, valid_ms: VALID_MS };
    let status = board.status(Operation::Arm, &wanted);
    let seen = expect_status(status, Status::WrongNonce, "it stays disarmed")?;
    expect_flag(&board.listen(50_000, |_samples| None), 1)?;
    Ok(seen)
}

fn short_validity(board: &mut TestedBoard<'_>) -> Result<String, String> {
    let Disarmed { nonce } = board.get(Operation::Disarm)?;
    let wanted = Arm { nonce, packing: 0, valid_ms: SHORTEST_VALID_MS - 1 };
    expect_status(board.status(Operation::Arm, &wanted), Status::BadValue, "4 ms are refused")
}

fn says_so(board: &mut TestedBoard<'_>) -> Result<String, String> {
    board.arm(VALID_MS)?;
    expect_flag(&board.listen(50_000, |_samples| None), 0)?;
    match reason(board)? {
        safe_reason::NONE => Ok("its flag is down, and its hello gives no reason".into()),
        other => Err(format!("its hello says: {}", reason_words(other))),
    }
}

fn waits(board: &mut TestedBoard<'_>) -> Result<String, String> {
    expect_flag(&board.listen(2_000 * u64::from(VALID_MS), |_samples| None), 0)?;
    Ok(format!("armed for {} ms without a force", 2 * u16::from(VALID_MS)))
}

fn takes(board: &mut TestedBoard<'_>) -> Result<String, String> {
    let before = board.get::<Counters>(Operation::Counters);
    let sent = board.listen(FORCES_US, answer);
    let after = board.get::<Counters>(Operation::Counters);
    expect_flag(&sent, 0)?;
    let n = u32::try_from(sent.len()).unwrap_or(u32::MAX);
    match (before, after) {
        (Ok(before), Ok(after)) => {
            let taken = after.forces.saturating_sub(before.forces);
            let seen = format!("{taken} of {n} were taken");
            let [refused, stale] = [(after.refused, before.refused), (after.stale, before.stale)]
                .map(|(after, before)| after.saturating_sub(before));
            let untaken = UntakenForces { sent: n.into(), refused, stale };
            if n / 2 < taken { Ok(seen) } else { Err(format!("{seen}{untaken}")) }
        }
        _ => Ok("it is still armed; it does not count forces".into()),
    }
}

fn drops(board: &mut TestedBoard<'_>) -> Result<String, String> {
    // It may have tripped since, and then nothing is stale.
    board.arm(VALID_MS)?;
    let Ok(before) = board.get::<Counters>(Operation::Counters) else {
        return Ok("not seen: it does not count forces".into());
    };
    let false_time = |samples: &KeySamples| {
        let stamp_us = samples.header.stamp_us.wrapping_add(7);
        Some((Header { stamp_us, ..samples.header }, MOST_FORCE_MN))
    };
    let sent = board.listen(FORCES_US / 4, false_time);
    let after = board.get::<Counters>(Operation::Counters)?;
    let taken = after.forces.saturating_sub(before.forces);
    let stale = after.stale.saturating_sub(before.stale);
    let seen = format!("of {} with a false time {taken} were taken, {stale} stale", sent.len());
    if taken == 0 && 0 < stale { Ok(seen) } else { Err(seen) }
}

/// Answers for some time, then stops, and measures when the flag is raised.
fn watchdog(board: &mut TestedBoard<'_>) -> Result<String, String> {
    board.arm(VALID_MS)?;
    expect_flag(&board.listen(FORCES_US / 4, answer), 0)?;
    let end = board.listen(20_000, answer);
    let last = end.last().ok_or("no samples came")?.samples.header.stamp_us;
    let after = board.listen(2_000 * u64::from(VALID_MS) + 10 * TRIP_US, |_samples| None);
    let tripped = after.iter().find(|it| it.samples.header.flag);
    let tripped = tripped.ok_or("its samples never say that it renders no force")?;
    // Time on the wire has 16 bits, and forces are valid for longer: counted along all samples.
    let (mut passed, mut from) = (0_u64, last);
    for it in &after {
        let stamp_us = it.samples.header.stamp_us;
        passed += u64::from(stamp_us.wrapping_sub(from));
        from = stamp_us;
        if it.heard_us == tripped.heard_us {
            break;
        }
    }
    let valid_us = u64::from(VALID_MS) * 1_000;
    let seen = format!("{:.0} ms after the last answer", passed as f64 * 1e-3);
    if !(valid_us - TRIP_US..=valid_us + TRIP_US).contains(&passed) {
        return Err(format!("{seen}, and forces were valid for {VALID_MS} ms"));
    }
    match reason(board)? {
        safe_reason::SILENCE => Ok(seen),
        other => Err(format!("its hello says: {}", reason_words(other))),
    }
}

fn stays(board: &mut TestedBoard<'_>) -> Result<String, String> {
    expect_flag(&board.listen(FORCES_US / 4, answer), 1)?;
    Ok("it stays safe".into())
}

fn recovers(board: &mut TestedBoard<'_>) -> Result<String, String> {
    board.arm(VALID_MS)?;
    expect_flag(&board.listen(FORCES_US / 4, answer), 0)?;
    Ok("it takes forces again".into())
}

fn disarms(board: &mut TestedBoard<'_>) -> Result<String, String> {
    let _nonce: Disarmed = board.get(Operation::Disarm)?;
    expect_flag(&board.listen(2_000 * u64::from(FADE_MS), |_samples| None), 1)?;
    match reason(board)? {
        safe_reason::DISARMED => Ok("its flag is up".into()),
        other => Err(format!("its hello says: {}", reason_words(other))),
    }
}

pub(super) fn stop(board: &mut TestedBoard<'_>) -> ConformanceItem {
    const ITEM: &str = "a stop is for good";
    ConformanceItem::new(ITEM, stopped(board))
}

fn stopped(board: &mut TestedBoard<'_>) -> Result<String, String> {
    board.arm(VALID_MS)?;
    expect_flag(&board.listen(FORCES_US / 4, answer), 0)?;
    (0..3).for_each(|_| board.stop());
    expect_flag(&board.listen(4_000 * u64::from(FADE_MS), answer), 1)?;
    let disarm = board.status(Operation::Disarm, &Nothing);
    expect_status(disarm, Status::WrongState, "")?;
    match reason(board)? {
        safe_reason::EMERGENCY_STOP => Ok("Disarm is refused; start the board anew".into()),
        other => Err(format!("its hello says: {}", reason_words(other))),
    }
}
