//! Trials of the hello, of the time of answers, and of requests that must be refused.

use firmware_protocol::acyclic::config::{self, Config, ReadConfig, setting};
use firmware_protocol::acyclic::{ANSWER_MS, Operation, Status, arm::Disarmed, ping::Pong};
use firmware_protocol::frame::hello::{Hello, Introduction};
use firmware_protocol::{Nothing, Record as _, schema};

use super::{ConformanceItem, TestedBoard};
use crate::{hello_values::impossible_values, identity::ClaimedKeys};

const PINGS: usize = 50;
/// An operation of no version.
const NO_OPERATION: u8 = 200;

pub(super) fn items(
    board: &mut TestedBoard<'_>,
    introduction: &Introduction,
) -> Vec<ConformanceItem> {
    vec![
        ConformanceItem::new("the values of its hello are possible", hello(introduction)),
        ConformanceItem::new("Hello is answered as the hello frame is", asked(board, introduction)),
        ConformanceItem::new("a request is answered within 20 ms", times(board)),
        ConformanceItem::new("a request with the same id is answered alike", repeated(board)),
        ConformanceItem::new("an unknown operation is answered with Unknown", unknown(board)),
        ConformanceItem::new("a short record is answered with BadValue", short(board)),
        damaged(board),
        settings(board, &introduction.hello),
    ]
}

fn hello(introduction: &Introduction) -> Result<String, String> {
    let hello = &introduction.hello;
    let mut wrong: Vec<_> = impossible_values(hello).iter().map(ToString::to_string).collect();
    let keys = ClaimedKeys { first: hello.first_key, n: hello.n_keys };
    if keys.range().is_none() || 12 < hello.n_keys {
        wrong.push(keys.to_string());
    }
    if hello.schema != schema::HASH {
        wrong.push(format!("schema {:016x}, this host has {:016x}", hello.schema, schema::HASH));
    }
    if introduction.safe != (hello.safe_reason != 0) {
        wrong.push(format!(
            "flag {} and safe_reason {}",
            u8::from(introduction.safe),
            hello.safe_reason
        ));
    }
    let is = format!("protocol {}.{}, {keys}", hello.major, hello.minor);
    if wrong.is_empty() { Ok(is) } else { Err(wrong.join("; ")) }
}

fn asked(board: &mut TestedBoard<'_>, introduction: &Introduction) -> Result<String, String> {
    let asked: Hello = board.get(Operation::Hello)?;
    let board_us = introduction.hello.board_us;
    if (Hello { board_us, ..asked }) == introduction.hello {
        Ok("all fields are the same".into())
    } else {
        Err("its fields differ".into())
    }
}

fn times(board: &mut TestedBoard<'_>) -> Result<String, String> {
    let mut ms = Vec::new();
    for _ in 0..PINGS {
        let reply = board.ask_raw(Operation::Ping as u8, &[]);
        let reply = reply.ok_or("Ping was not answered")?;
        if reply.status != Status::Done || Pong::take(&reply.record).is_none() {
            return Err(format!("Ping was answered with {:?}", reply.status));
        }
        ms.push(reply.heard_us.saturating_sub(reply.sent_us) as f64 * 1e-3);
    }
    ms.sort_by(f64::total_cmp);
    // This machine may have delayed some.
    let most = ms[PINGS * 8 / 10];
    let seen = format!("median {:.1} ms, 80 % within {most:.1} ms", ms[PINGS / 2]);
    if most <= f64::from(ANSWER_MS) { Ok(seen) } else { Err(seen) }
}

fn repeated(board: &mut TestedBoard<'_>) -> Result<String, String> {
    let request = board.request(Operation::Disarm as u8, &[]);
    let mut nonce = |request: &[u8]| {
        let reply = board.exchange(request).ok_or("Disarm was not answered")?;
        match Disarmed::take(&reply.record) {
            Some(Disarmed { nonce }) if reply.status == Status::Done => Ok(nonce),
            _ => Err(format!("Disarm was answered with {:?}", reply.status)),
        }
    };
    let (first, again) = (nonce(&request)?, nonce(&request)?);
    let other = board.get::<Disarmed>(Operation::Disarm)?.nonce;
    match (first == again, first == other) {
        (true, false) => Ok("the same nonce, and another one for another id".into()),
        (false, _) => Err("the same request was done twice: it gave two nonces".into()),
        (true, true) => Err("two disarmings gave the same nonce".into()),
    }
}

fn unknown(board: &mut TestedBoard<'_>) -> Result<String, String> {
    match board.ask_raw(NO_OPERATION, &[]).map(|it| it.status) {
        Some(Status::Unknown) => Ok(format!("operation {NO_OPERATION} is unknown")),
        Some(other) => Err(format!("operation {NO_OPERATION} was answered with {other:?}")),
        None => Err(format!("operation {NO_OPERATION} was not answered")),
    }
}

fn short(board: &mut TestedBoard<'_>) -> Result<String, String> {
    // On CAN FD a frame of five bytes stays one of five bytes.
    match board.ask_raw(Operation::Stream as u8, &[0, 0]).map(|it| it.status) {
        Some(Status::BadValue) => Ok("Stream with two bytes is refused".into()),
        Some(other) => Err(format!("Stream with two bytes was answered with {other:?}")),
        None => Err("Stream with two bytes was not answered".into()),
    }
}

fn damaged(board: &mut TestedBoard<'_>) -> ConformanceItem {
    const ITEM: &str = "a frame with a wrong checksum is dropped";
    match board.answers_damaged() {
        None => ConformanceItem::not_tried(ITEM, "checksums of CAN are the controller's"),
        Some(true) => {
            ConformanceItem::new(ITEM, Err("a request with an inverted bit was answered".into()))
        }
        Some(false) => {
            let next = board.status(Operation::Ping, &Nothing);
            let next = next.map(|_status| "dropped, and the next frame is read".to_owned());
            ConformanceItem::new(ITEM, next)
        }
    }
}

fn settings(board: &mut TestedBoard<'_>, hello: &Hello) -> ConformanceItem {
    const ITEM: &str = "its settings have the CRC of its hello";
    let mut values = Vec::new();
    for setting in 0..setting::COUNT {
        match board.get_with::<_, Config>(Operation::ReadConfig, &ReadConfig { setting }) {
            Ok(Config { value, .. }) => values.push(value),
            Err(why) => return ConformanceItem::not_tried(ITEM, &why),
        }
    }
    let (crc, says) = (config::crc(&values), hello.config_crc);
    let seen = format!("settings {values:?} have {crc:08x}, its hello {says:08x}");
    ConformanceItem::new(ITEM, if crc == says { Ok(seen) } else { Err(seen) })
}
