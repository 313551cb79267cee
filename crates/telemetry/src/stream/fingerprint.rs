//! The fingerprint of a certificate.

use std::{fmt, str::FromStr};

use data_encoding::HEXUPPER;

/// SHA-256 of a certificate; written as 32 pairs of hexadecimal digits, with colons between.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Fingerprint(pub [u8; 32]);

impl Fingerprint {
    pub fn of(der: &[u8]) -> Self {
        let digest = ring::digest::digest(&ring::digest::SHA256, der);
        let mut bytes = [0; 32];
        for (to, from) in bytes.iter_mut().zip(digest.as_ref()) {
            *to = *from;
        }
        Self(bytes)
    }
}

impl fmt::Display for Fingerprint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, byte) in self.0.iter().enumerate() {
            let colon = if place == 0 { "" } else { ":" };
            write!(f, "{colon}{byte:02X}")?;
        }
        Ok(())
    }
}

/// Reason why a text is no fingerprint.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("{0:?} is no fingerprint: it has 32 pairs of hexadecimal digits, as the host printed it")]
pub struct NoFingerprint(String);

impl FromStr for Fingerprint {
    type Err = NoFingerprint;

    /// Colons, spaces and the case of letters do not matter.
    fn from_str(text: &str) -> Result<Self, NoFingerprint> {
        let digits: String = text
            .chars()
            .filter(|letter| *letter != ':' && !letter.is_whitespace())
            .map(|letter| letter.to_ascii_uppercase())
            .collect();
        let bytes = HEXUPPER.decode(digits.as_bytes()).ok();
        bytes
            .and_then(|bytes| bytes.try_into().ok())
            .map(Self)
            .ok_or_else(|| NoFingerprint(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fingerprint_is_a_sha_256_and_comes_back_from_its_text() {
        // FIPS 180-2, example B.1.
        let print = Fingerprint::of(b"abc");
        let text = print.to_string();
        assert!(text.starts_with("BA:78:16:BF:8F:01:CF:EA:"), "{text}");
        assert_eq!(text.parse(), Ok(print));
        assert_eq!(text.replace(':', " ").to_lowercase().parse(), Ok(print));
    }

    #[test]
    fn other_texts_are_refused() {
        let long = "00:".repeat(33);
        for foreign in ["", "BA:78", "wrong", long.as_str()] {
            assert!(foreign.parse::<Fingerprint>().is_err(), "{foreign}");
        }
    }
}
