//! Arbitrary bytes as a description that may start from itself: read, or rejected with a mistake.
#![no_main]

use mechanism::kane::description::{Bases, read_bytes, rendered};
use libfuzzer_sys::fuzz_target;

/// Valid description, and the bytes themselves.
struct Shelf<'a>(&'a [u8]);

impl Bases for Shelf<'_> {
    fn load(&self, base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
        match base {
            "good.toml" => {
                let good = include_bytes!("../../../instruments/src/key_hammer_springs/model.toml");
                Ok((base.to_owned(), good.to_vec()))
            }
            "self.toml" => Ok((base.to_owned(), self.0.to_vec())),
            _ => Err("there is no such file".to_owned()),
        }
    }
}

fuzz_target!(|bytes: &[u8]| {
    match read_bytes("fuzzed.toml", bytes, &Shelf(bytes)) {
        Ok(description) => assert!(!description.mechanism.modes.is_empty()),
        Err(mistakes) => {
            assert!(!mistakes.as_slice().is_empty());
            assert!(!rendered(&mistakes, &[]).is_empty());
        }
    }
});
