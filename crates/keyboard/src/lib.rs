//! The 88 keys of a full compass: index, note name, range, and differences key by key.
//!
//! A key has one number, its [`KeyIndex`], 0 (A0) to 87 (C8); names and MIDI numbers map to it.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(test)]
extern crate std;

mod difference;
mod index;
mod name;
mod range;

pub use difference::Difference;
pub use index::{KEYS, KeyIndex};
pub use name::NoteError;
pub use range::{KeyRange, RangeError};
