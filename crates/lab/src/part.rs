//! A share of a study, for several machines or processes.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

/// One of `of` shares of a study's runs, written `3/16`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct StudyPart {
    /// Number of the share, 1 ..= `of`.
    pub index: usize,
    pub of: usize,
}

impl StudyPart {
    pub const WHOLE: Self = Self { index: 1, of: 1 };
    pub const NONE: Self = Self { index: 0, of: 1 };

    /// Returns `true` if the share has the run `number` of its scenario, from 0.
    ///
    /// Numbers are mixed, so that costly runs, which recur with a period, are in different shares.
    pub const fn takes(self, number: usize) -> bool {
        let mixed = (number as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 32;
        mixed % self.of as u64 + 1 == self.index as u64
    }
}

impl FromStr for StudyPart {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let part = || {
            let (index, of) = text.split_once('/')?;
            let (index, of) = (index.parse().ok()?, of.parse().ok()?);
            (1..=of).contains(&index).then_some(Self { index, of })
        };
        part().ok_or_else(|| "expected a share such as 3/16, from 1/16 to 16/16".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_run_is_in_one_share() {
        for of in [1, 3, 16] {
            let parts: Vec<StudyPart> = (1..=of).map(|index| StudyPart { index, of }).collect();
            for number in 0..100 {
                assert_eq!(parts.iter().filter(|it| it.takes(number)).count(), 1, "{number}/{of}");
            }
        }
    }

    #[test]
    fn a_share_is_read_from_its_text_and_others_are_rejected() {
        assert_eq!("3/16".parse(), Ok(StudyPart { index: 3, of: 16 }));
        for wrong in ["", "3", "0/4", "5/4", "1/0", "-1/2", "a/b", "1/2/3"] {
            assert!(wrong.parse::<StudyPart>().is_err(), "{wrong}");
        }
    }
}
