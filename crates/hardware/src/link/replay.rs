//! A link that plays a recording back: the same boards, saying the same at the same time.
//!
//! What was received then comes again when its time has come. What is sent is compared with
//! what was sent then, and the first difference is kept.

use std::fmt;

use firmware_protocol::MAX_FRAME;

use super::faulty::Direction;
use super::{Link, Parcel, RecvError, SendError};

/// A recording that is played back.
#[derive(Debug)]
pub struct Replay {
    received: Track,
    sent: Track,
    time_us: u64,
    lost: u64,
    difference: Option<Difference>,
}

/// The frames of one direction, and which one is next.
#[derive(Debug)]
struct Track {
    frames: Box<[Recorded]>,
    next: usize,
}

/// A frame that was recorded.
#[derive(Clone, Copy, Debug)]
struct Recorded {
    line: usize,
    time_us: u64,
    parcel: Parcel,
}

impl Replay {
    /// Reads a recording that [`super::recorder`] wrote.
    ///
    /// # Errors
    /// Says all that is wrong with it, each with its line.
    pub fn parse(text: &str) -> Result<Self, Mistakes> {
        let mut reader = Reader::default();
        for (line, text) in (1..).zip(text.lines()) {
            if let Err(what) = reader.take(line, text) {
                reader.mistakes.push(Mistake { line, what });
            }
        }
        if !reader.mistakes.is_empty() {
            return Err(Mistakes(reader.mistakes));
        }
        let track = |frames: Vec<_>| Track { frames: frames.into(), next: 0 };
        let (received, sent) = (track(reader.received), track(reader.sent));
        Ok(Self { received, sent, time_us: 0, lost: reader.lost, difference: None })
    }

    /// What time it is [us]: what was received up to then has come.
    pub const fn set_time(&mut self, time_us: u64) {
        self.time_us = time_us;
    }

    /// The first frame that was sent otherwise than it was recorded.
    pub const fn difference(&self) -> Option<&Difference> {
        self.difference.as_ref()
    }

    /// Recorded frames that have not been received yet.
    pub const fn to_receive(&self) -> usize {
        self.received.left()
    }

    /// Recorded frames that have not been sent yet, if there was no difference.
    pub const fn to_send(&self) -> usize {
        self.sent.left()
    }

    /// Frames that the recording says it has lost; a difference may come from there.
    pub const fn lost(&self) -> u64 {
        self.lost
    }
}

impl Track {
    fn peek(&self) -> Option<Recorded> {
        self.frames.get(self.next).copied()
    }

    const fn left(&self) -> usize {
        self.frames.len() - self.next
    }
}

/// # Real-time
/// A copy or a comparison of one frame; no heap.
impl Link for Replay {
    fn try_send(&mut self, frame: &[u8]) -> Result<(), SendError> {
        if MAX_FRAME < frame.len() {
            return Err(SendError::TooLong { len: frame.len() });
        }
        let got = Parcel::new(frame)?;
        if self.difference.is_some() {
            return Ok(());
        }
        let expected = self.sent.peek();
        if expected.is_some_and(|recorded| recorded.parcel.as_slice() == frame) {
            self.sent.next += 1;
        } else {
            self.difference = Some(Difference { time_us: self.time_us, got, expected });
        }
        Ok(())
    }

    fn try_recv(&mut self, buffer: &mut [u8]) -> Result<Option<usize>, RecvError> {
        let now = self.time_us;
        let due = self.received.peek().filter(|recorded| recorded.time_us <= now);
        let Some(Recorded { parcel, .. }) = due else { return Ok(None) };
        self.received.next += 1;
        parcel.unpack(buffer).map(Some)
    }
}

/// Where what is sent leaves the recording; a sentence when displayed.
#[derive(Clone, Copy, Debug)]
pub struct Difference {
    time_us: u64,
    got: Parcel,
    expected: Option<Recorded>,
}

impl Difference {
    /// The line of the recording that was not sent; none if the recording has no more.
    pub fn line(&self) -> Option<usize> {
        self.expected.map(|recorded| recorded.line)
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let got = self.got.as_slice();
        write!(f, "at {} s this run sent {}", Seconds(self.time_us), Hex(got))?;
        let Some(Recorded { line, time_us, parcel }) = &self.expected else {
            return write!(f, ", where the recording sends nothing more");
        };
        let expected = parcel.as_slice();
        let same = got.iter().zip(expected).take_while(|(one, other)| one == other).count();
        write!(
            f,
            ", and the recording {} in line {line} at {} s: they differ from byte {same} on",
            Hex(expected),
            Seconds(*time_us)
        )
    }
}

/// Microseconds, written as seconds.
struct Seconds(u64);

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{:06}", self.0 / 1_000_000, self.0 % 1_000_000)
    }
}

/// Bytes, written as two digits each.
struct Hex<'a>(&'a [u8]);

impl fmt::Display for Hex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02X}"))
    }
}

/// All that is wrong with a recording.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mistakes(Vec<Mistake>);

/// What is wrong with a line.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Mistake {
    /// Its number, from 1.
    pub line: usize,
    pub what: String,
}

impl Mistakes {
    /// Each of them, in the order of lines.
    pub fn as_slice(&self) -> &[Mistake] {
        &self.0
    }
}

impl fmt::Display for Mistakes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, Mistake { line, what }) in self.0.iter().enumerate() {
            let separator = if i == 0 { "" } else { "\n" };
            write!(f, "{separator}line {line}: {what}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Mistakes {}

/// What was read of a recording so far.
#[derive(Default)]
struct Reader {
    received: Vec<Recorded>,
    sent: Vec<Recorded>,
    time_us: u64,
    lost: u64,
    mistakes: Vec<Mistake>,
}

impl Reader {
    /// Takes a line, or says what is wrong with it.
    fn take(&mut self, line: usize, text: &str) -> Result<(), String> {
        let text = text.trim();
        if text.is_empty() || text.starts_with('#') {
            return Ok(());
        }
        if let Some(number) = text.strip_prefix('!') {
            let refused = |_| format!("`{}` is no number of lost frames", number.trim());
            self.lost += number.trim().parse::<u64>().map_err(refused)?;
            return Ok(());
        }
        let (direction, recorded) = parse_frame(line, text)?;
        if recorded.time_us < self.time_us {
            return Err(format!(
                "{} s is before the frame above, at {} s",
                Seconds(recorded.time_us),
                Seconds(self.time_us)
            ));
        }
        self.time_us = recorded.time_us;
        match direction {
            Direction::Send => self.sent.push(recorded),
            Direction::Receive => self.received.push(recorded),
        }
        Ok(())
    }
}

/// Reads `(12.003000) < 6300`.
fn parse_frame(line: usize, text: &str) -> Result<(Direction, Recorded), String> {
    let mut words = text.split_whitespace();
    let shape = || format!("`{text}` is not as `(12.003000) < 6300FF`");
    let (Some(time), Some(sign), frame, None) =
        (words.next(), words.next(), words.next(), words.next())
    else {
        return Err(shape());
    };
    let direction = match sign {
        ">" => Direction::Send,
        "<" => Direction::Receive,
        _ => return Err(format!("`{sign}` is neither `<`, received, nor `>`, sent")),
    };
    let time = time.strip_prefix('(').and_then(|time| time.strip_suffix(')')).ok_or_else(shape)?;
    let time_us = parse_time(time).ok_or_else(|| format!("`{time}` is no time in seconds"))?;
    let parcel = parse_parcel(frame.unwrap_or_default())?;
    Ok((direction, Recorded { line, time_us, parcel }))
}

/// Reads seconds with six places as microseconds.
fn parse_time(text: &str) -> Option<u64> {
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let (seconds, micros) = text.split_once('.')?;
    if micros.len() != 6 || !digits(seconds) || !digits(micros) {
        return None;
    }
    let seconds = seconds.parse::<u64>().ok()?.checked_mul(1_000_000)?;
    seconds.checked_add(micros.parse().ok()?)
}

/// Reads bytes of two digits each.
fn parse_parcel(text: &str) -> Result<Parcel, String> {
    let (pairs, rest) = text.as_bytes().as_chunks::<2>();
    let byte = |pair: &[u8; 2]| {
        let digits = std::str::from_utf8(pair).ok().filter(|pair| !pair.starts_with('+'))?;
        u8::from_str_radix(digits, 16).ok()
    };
    let bytes: Option<Vec<u8>> = pairs.iter().map(byte).collect();
    let bytes = bytes.filter(|_| rest.is_empty());
    let bytes = bytes.ok_or_else(|| format!("`{text}` is not bytes of two hexadecimal digits"))?;
    let len = bytes.len();
    let too_long = || format!("{len} bytes are more than the {MAX_FRAME} of any frame");
    if MAX_FRAME < len {
        Err(too_long())
    } else {
        Parcel::new(&bytes).map_err(|_refused| too_long())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# letoff\n(0.001000) < 6300\n(0.001000) > 2300\n\n! 2\n\
                        (0.002000) < 6301\n(0.002000) > 230155\n";

    #[test]
    fn what_was_received_comes_when_its_time_has_come() {
        let mut replay = Replay::parse(TEXT).unwrap();
        let mut recv = |time_us| {
            replay.set_time(time_us);
            let mut buffer = [0; 2];
            replay.try_recv(&mut buffer).unwrap().map(|_| buffer[1])
        };
        let got = [0, 1_000, 1_000, 2_500, 9_000].map(&mut recv);
        assert_eq!(got, [None, Some(0), None, Some(1), None]);
        assert_eq!((replay.to_receive(), replay.lost()), (0, 2));
    }

    #[test]
    fn the_first_difference_is_kept_and_told() {
        let mut replay = Replay::parse(TEXT).unwrap();
        for frame in [&[0x23, 0][..], &[0x23, 1, 0x54], &[0x23, 1, 0x55]] {
            assert_eq!(replay.try_send(frame), Ok(()));
            replay.set_time(2_000);
        }
        let difference = replay.difference().unwrap();
        assert_eq!(difference.line(), Some(7));
        assert_eq!(
            difference.to_string(),
            "at 0.002000 s this run sent 230154, and the recording 230155 in line 7 at 0.002000 s: \
             they differ from byte 2 on"
        );
        assert_eq!(replay.to_send(), 1);
    }

    #[test]
    fn a_frame_too_many_is_a_difference() {
        let mut replay = Replay::parse("").unwrap();
        replay.try_send(&[1]).unwrap();
        let sentence = replay.difference().unwrap().to_string();
        assert_eq!(
            sentence,
            "at 0.000000 s this run sent 01, where the recording sends nothing more"
        );
    }

    #[test]
    fn all_that_is_wrong_is_said_with_its_line() {
        let long = format!("(0.000000) > {}", "00".repeat(MAX_FRAME + 1));
        let text = [
            "hello",
            "(1.5) > 00",
            "(2.000000) ? 00",
            "(2.000000) > 0",
            "(2.000000) > +1",
            "(2.000000) > 00",
            "(1.999999) < 00",
            "! many",
            "(99999999999999999999.000000) > 00",
            &long,
        ];
        let mistakes = Replay::parse(&text.join("\n")).unwrap_err();
        assert_eq!(
            mistakes.to_string(),
            "line 1: `hello` is not as `(12.003000) < 6300FF`\n\
             line 2: `1.5` is no time in seconds\n\
             line 3: `?` is neither `<`, received, nor `>`, sent\n\
             line 4: `0` is not bytes of two hexadecimal digits\n\
             line 5: `+1` is not bytes of two hexadecimal digits\n\
             line 7: 1.999999 s is before the frame above, at 2.000000 s\n\
             line 8: `many` is no number of lost frames\n\
             line 9: `99999999999999999999.000000` is no time in seconds\n\
             line 10: 65 bytes are more than the 64 of any frame"
        );
        let lines: Vec<_> = mistakes.as_slice().iter().map(|mistake| mistake.line).collect();
        assert_eq!(lines, [1, 2, 3, 4, 5, 7, 8, 9, 10]);
    }
}
