//! Addresses of links in the syntax of command line and scenes, and the kinds that they name.

use std::fmt;

use super::{BusSide, LINKS, Link};
use crate::links::{Error, HostClock};
use crate::plan::{Medium, NoPlan};

/// A link of any kind.
pub type BoxedLink = Box<dyn Link + Send>;

/// A kind of link. Addresses, scenes, plans and help texts read the list of kinds, [`LINKS`].
#[derive(Clone, Copy, Debug)]
pub struct BoardLinkKind {
    /// Scheme of its addresses: `serial` in `serial:/dev/ttyACM0`.
    pub scheme: &'static str,
    /// Forms of its addresses, for messages: `can:INTERFACE`.
    pub forms: &'static str,
    /// Forms of its addresses, for the help of `--link`.
    pub help: &'static str,
    /// Key of `[[links.bus]]` in a scene. Kinds with the same key differ by their mode.
    pub key: &'static str,
    /// Value of `mode` in a scene that selects this kind; the first kind with a key is its default.
    pub mode: Option<&'static str>,
    /// Further keys of `[[links.bus]]` that this kind accepts.
    pub options: &'static [&'static str],
    /// Noun in "a bus is either ...".
    pub noun: &'static str,
    /// Subject in "... has no \"baud\"".
    pub subject: &'static str,
    /// Default baud rate, if its addresses have one (bit/s).
    pub baud: Option<u32>,
    /// `true` if it leads to a program in lockstep, which lives in virtual time only.
    pub is_in_lockstep: bool,
    pub open: fn(&Address, BusSide, &HostClock) -> Result<BoxedLink, Error>,
    /// Returns the medium at an address, with the bit rates of arbitration and data (bit/s).
    pub medium: fn(&Address, (u32, u32)) -> Result<Medium, NoPlan>,
}

impl PartialEq for BoardLinkKind {
    fn eq(&self, other: &Self) -> bool {
        self.scheme == other.scheme
    }
}

impl Eq for BoardLinkKind {}

impl BoardLinkKind {
    /// Returns the kind of a scene's `key` and `mode`; without a mode the key's first kind.
    pub fn find(key: &str, mode: Option<&str>) -> Option<&'static Self> {
        let mut kinds = LINKS.iter().filter(|it| it.key == key);
        let first = kinds.clone().next();
        kinds.find(|it| mode.is_some() && it.mode == mode).or(first)
    }
}

/// Destination of a link.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Address {
    pub kind: &'static BoardLinkKind,
    /// Port, interface or program with its arguments, as messages name the link.
    pub place: String,
    /// Bits per second, if addresses of this kind have them.
    pub baud: Option<u32>,
}

impl Address {
    /// Parses `serial:/dev/ttyACM0` or another form in [`LINKS`]; the error is a sentence.
    pub fn parse(text: &str) -> Result<Self, String> {
        let unknown = || {
            let forms = listed(LINKS.iter().map(|it| it.forms), " or ");
            format!("\"{text}\" is no link: write {forms}")
        };
        let (scheme, rest) = text.split_once(':').ok_or_else(unknown)?;
        let kind = LINKS.iter().find(|it| it.scheme == scheme).ok_or_else(unknown)?;
        let (place, baud) = match rest.rsplit_once('@') {
            Some((place, baud)) if kind.baud.is_some() => {
                let number = baud.parse().ok().filter(|baud| *baud != 0);
                let wrong = || format!("\"{baud}\" is no baud rate: write 2000000");
                (place, Some(number.ok_or_else(wrong)?))
            }
            Some(_) | None => (rest, kind.baud),
        };
        if rest.trim().is_empty() { Err(unknown()) } else { Ok(Self::new(kind, place, baud)) }
    }

    /// Returns the address of the trimmed `place`; ignores a `baud` that this kind does not have.
    pub fn new(kind: &'static BoardLinkKind, place: &str, baud: Option<u32>) -> Self {
        let baud = kind.baud.map(|usual| baud.unwrap_or(usual));
        Self { kind, place: place.trim().to_owned(), baud }
    }

    /// Returns the address as typed in a shell: in quotes if it has several words.
    pub fn typed(&self) -> String {
        let text = self.to_string();
        if text.contains(char::is_whitespace) { format!("'{text}'") } else { text }
    }

    pub fn open(&self, side: BusSide, clock: &HostClock) -> Result<BoxedLink, Error> {
        (self.kind.open)(self, side, clock)
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.kind.scheme, self.place)?;
        self.baud.map_or(Ok(()), |baud| write!(f, "@{baud}"))
    }
}

pub fn listed(words: impl IntoIterator<Item = &'static str>, or: &str) -> String {
    let words: Vec<_> = words.into_iter().collect();
    match words.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, others)) => [&others.join(", "), or, last].concat(),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_reads_as_it_is_written() {
        let rig = "rig:./rig --fault half";
        for text in ["serial:/dev/ttyUSB0@1000000", "can:can0", "classic-can:vcan1", rig] {
            assert_eq!(Address::parse(text).unwrap().to_string(), text);
        }
        let usual = Address::parse("serial:/dev/ttyACM0").unwrap();
        assert_eq!((&*usual.place, usual.baud), ("/dev/ttyACM0", Some(2_000_000)));
    }

    #[test]
    fn what_is_no_address_says_what_to_write() {
        for text in ["", "can", "can:", "usb:1", "serial:/dev/x@fast", "serial:/dev/x@0", "rig: "] {
            assert!(Address::parse(text).unwrap_err().contains("write"), "{text}");
        }
    }
}
