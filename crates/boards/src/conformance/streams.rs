//! Trials of rate, numbers, times and age of samples, and of the clock.

use firmware_protocol::acyclic::{Operation, arm::VALID_MS, ping::Pong, stream::Stream};
use firmware_protocol::frame::{hello::Hello, key_samples::SamplePacking};
use firmware_protocol::{Nothing, sequence::FrameOrder};

use super::{ConformanceItem, TestedBoard, tested_board::TimedSamples};
use crate::clock::{ClockModel, MOST_DRIFT};

/// Highest rate of samples (1/s).
const MOST_HZ: u16 = 1_000;
/// Attempts until samples are right: a busy machine loses some, a faulty board always fails.
const TRIALS: u8 = 3;
/// Length of an observation (us).
const LISTEN_US: u64 = 700_000;
/// Share of lost or late samples that the host's machine may have caused.
const FEW: f64 = 0.05;
/// Pings for its clock, and the time between two (us).
const PINGS: u32 = 40;
const PING_US: u64 = 20_000;

pub(super) fn items(board: &mut TestedBoard<'_>, hello: &Hello) -> Vec<ConformanceItem> {
    const ITEMS: [&str; 4] = [
        "samples come at the rate that is asked for",
        "the numbers of samples count up by one",
        "the times of samples are a period apart",
        "samples are fresh when they come",
    ];
    let hz = hello.max_sample_hz.clamp(1, MOST_HZ);
    let law_us = 1_000_000 / u32::from(hello.law_hz.max(1));
    let period_us = (1_000_000 / u32::from(hz)).next_multiple_of(law_us.max(1));
    let Ok(period_us) = u16::try_from(period_us) else {
        let why = format!("a period of {period_us} us cannot be asked for");
        return ITEMS.map(|item| ConformanceItem::not_tried(item, &why)).into();
    };
    let (packing, phase_us) = (SamplePacking::Position24 as u8, 0);
    let wanted = Stream { period_us, packing, phase_us };
    if let Err(why) = board.get_with::<_, Nothing>(Operation::Stream, &wanted) {
        return ITEMS.map(|item| ConformanceItem::new(item, Err(why.clone()))).into();
    }
    let (mut rates, mut in_order, mut apart) = (untried(), untried(), untried());
    for _ in 0..TRIALS {
        board.late_us = 0;
        let heard = board.listen(LISTEN_US, |_samples| None);
        rates = rates.or_else(|_before| rate(board, &heard, period_us));
        in_order = in_order.or_else(|_before| numbers(&heard));
        apart = apart.or_else(|_before| times(&heard, period_us));
        if rates.is_ok() && in_order.is_ok() && apart.is_ok() {
            break;
        }
    }
    let late_us = board.late_us;
    let (clock, drift) = drift(board);
    let fresh = (0..TRIALS).fold(untried(), |fresh, _| {
        fresh.or_else(|_before| ages(&board.listen(LISTEN_US / 2, |_samples| None), &clock))
    });
    let judged = |item, seen| ConformanceItem::judged(item, seen, late_us);
    vec![
        judged(ITEMS[0], rates),
        judged(ITEMS[1], in_order),
        judged(ITEMS[2], apart),
        ConformanceItem::new("its clock is at most 3 % too fast or slow", drift),
        judged(ITEMS[3], fresh),
    ]
}

const fn untried() -> Result<String, String> {
    Err(String::new())
}

fn rate(board: &TestedBoard<'_>, heard: &[TimedSamples], period_us: u16) -> Result<String, String> {
    if 0 < board.unreadable {
        let (n, n_keys) = (board.unreadable, board.layout.n_keys);
        return Err(format!("{n} frames of samples are none of {n_keys} keys in position24"));
    }
    let expected = LISTEN_US as f64 / f64::from(period_us);
    let came = heard.len() as f64;
    let seen = format!("{came} of {expected:.0} came in {} ms", LISTEN_US / 1_000);
    // A clock with an error of 3 %, and a machine that was busy.
    let is_right = (0.9 * expected..1.08 * expected).contains(&came);
    if is_right { Ok(seen) } else { Err(seen) }
}

fn numbers(heard: &[TimedSamples]) -> Result<String, String> {
    let (mut missing, mut wrong) = (0_u32, 0_u32);
    for pair in heard.windows(2) {
        let [one, next] = [pair[0], pair[1]].map(|it| it.samples.header.sequence);
        match next.after(one) {
            FrameOrder::Newer { missing: n } => missing += u32::from(n),
            FrameOrder::Repeated | FrameOrder::Older => wrong += 1,
        }
    }
    let n = heard.len();
    let seen = format!("of {n} frames {missing} are missing, {wrong} came again or were overtaken");
    let few = FEW * n as f64;
    if 1 < n && f64::from(missing) <= few && wrong == 0 { Ok(seen) } else { Err(seen) }
}

fn times(heard: &[TimedSamples], period_us: u16) -> Result<String, String> {
    let (mut n, mut good) = (0_u32, 0_u32);
    for pair in heard.windows(2) {
        let [one, next] = [pair[0], pair[1]].map(|it| it.samples.header);
        let FrameOrder::Newer { missing: 0 } = next.sequence.after(one.sequence) else { continue };
        n += 1;
        let apart = f64::from(next.stamp_us.wrapping_sub(one.stamp_us));
        good += u32::from((apart - f64::from(period_us)).abs() <= 0.5 * f64::from(period_us));
    }
    let seen = format!("{good} of {n} steps are {period_us} us, more or less half of it");
    // Boards on busy simulators leave frames out.
    let is_right = 0 < n && 0.8 * f64::from(n) <= f64::from(good);
    if is_right { Ok(seen) } else { Err(seen) }
}

fn drift(board: &mut TestedBoard<'_>) -> (ClockModel, Result<String, String>) {
    let mut clock = ClockModel::default();
    for _ in 0..PINGS {
        let reply = board.ask_raw(Operation::Ping as u8, &[]);
        let pong = reply.as_ref().and_then(|it| {
            firmware_protocol::Record::take(&it.record).map(|Pong { board_us }| (it, board_us))
        });
        let Some((reply, board_us)) = pong else {
            return (clock, Err("Ping was not answered with a time".into()));
        };
        // A clock that jumps is learned again, and unknown in the end.
        let _jumped = clock.learn(reply.sent_us, board_us, reply.heard_us);
        board.listen(PING_US, |_samples| None);
    }
    let percent = clock.drift_ppm() * 1e-4;
    let seen = format!("{percent:+.2} % by {PINGS} pings");
    let most = MOST_DRIFT * 1e2 + 0.3;
    let outcome = if !clock.is_known() {
        Err("its rate cannot be read from its answers".into())
    } else if percent.abs() <= most {
        Ok(seen)
    } else {
        Err(seen)
    };
    (clock, outcome)
}

fn ages(heard: &[TimedSamples], clock: &ClockModel) -> Result<String, String> {
    let age = |it: &TimedSamples| clock.age_us(it.heard_us, it.samples.header.stamp_us);
    let mut ages: Vec<_> = heard.iter().filter_map(age).collect();
    ages.sort_unstable();
    let Some(median) = ages.get(ages.len() / 2) else {
        return Err("no sample came whose time is known".into());
    };
    let seen = format!("they are {:.1} ms old, half of them", f64::from(*median) * 1e-3);
    let most = i32::from(VALID_MS) * 1_000;
    if (-2_000..=most).contains(median) { Ok(seen) } else { Err(seen) }
}

pub(super) fn ends(board: &mut TestedBoard<'_>) -> ConformanceItem {
    const ITEM: &str = "Stream with 0 ends the samples";
    let none = Stream { period_us: 0, packing: SamplePacking::Position24 as u8, phase_us: 0 };
    let ended = board.get_with::<_, Nothing>(Operation::Stream, &none).and_then(|_done| {
        board.listen(50_000, |_samples| None);
        match board.listen(150_000, |_samples| None).len() {
            0 => Ok("none came".to_owned()),
            n => Err(format!("{n} came")),
        }
    });
    ConformanceItem::new(ITEM, ended)
}
