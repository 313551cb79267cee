//! A golden vector as text, read without a heap.

use core::str::FromStr;

use firmware_protocol::MAX_FRAME;

/// A vector with its text.
pub struct Vector<'a> {
    text: &'a str,
    frame: [u8; MAX_FRAME],
    len: usize,
}

impl<'a> Vector<'a> {
    pub fn read(text: &'a str) -> Option<Self> {
        let mut vector = Self { text, frame: [0; MAX_FRAME], len: 0 };
        for digits in vector.line("frame")?.as_bytes().chunks(2) {
            *vector.frame.get_mut(vector.len)? = byte(digits)?;
            vector.len += 1;
        }
        Some(vector)
    }

    pub fn frame(&self) -> &[u8] {
        &self.frame[..self.len]
    }

    pub fn line(&self, name: &str) -> Option<&'a str> {
        let value = |line: &'a str| line.strip_prefix(name)?.strip_prefix(" =");
        Some(self.text.lines().find_map(value)?.trim())
    }

    pub fn number<T: FromStr>(&self, name: &str) -> Option<T> {
        self.line(name)?.parse().ok()
    }

    pub fn count(&self, name: &str) -> Option<usize> {
        Some(self.line(name)?.split_whitespace().count())
    }
}

pub fn byte(digits: &[u8]) -> Option<u8> {
    u8::from_str_radix(core::str::from_utf8(digits).ok()?, 16).ok()
}
