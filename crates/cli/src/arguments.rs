//! Arguments of several commands.

use boards::links::LINKS;
use boards::links::address::listed;
use firmware_protocol::key::KeyIndex;

/// Returns the help of `--link`.
pub fn link_help() -> String {
    let forms = listed(LINKS.iter().map(|it| it.help), ", or ");
    format!("A link to boards, whatever the scene says: {forms}; once for each")
}

/// Parses a duration (s), above 0.
pub fn seconds(text: &str) -> Result<f64, String> {
    match number(text)? {
        seconds if seconds > 0.0 => Ok(seconds),
        _ => Err(format!("`{text}` s is no length: give a number above 0")),
    }
}

/// Parses a ratio above 0.
pub fn ratio(text: &str) -> Result<f64, String> {
    match number(text)? {
        ratio if ratio > 0.0 => Ok(ratio),
        _ => Err(format!("`{text}` is no ratio: give a number above 0, as 0.5")),
    }
}

/// Parses a share, 0 to 1.
pub fn share(text: &str) -> Result<f64, String> {
    match number(text)? {
        share if (0.0..=1.0).contains(&share) => Ok(share),
        _ => Err(format!("`{text}` is no share: give a number from 0 to 1")),
    }
}

/// Parses a size (B), as `500MB` or `1.5GiB`.
pub fn bytes(text: &str) -> Result<u64, String> {
    const UNITS: [(&str, u64); 7] = [
        ("KiB", 1 << 10),
        ("MiB", 1 << 20),
        ("GiB", 1 << 30),
        ("kB", 1_000),
        ("MB", 1_000_000),
        ("GB", 1_000_000_000),
        ("B", 1),
    ];
    let wrong =
        || format!("`{text}` is no size: write a number and B, kB, MB, GB, KiB, MiB or GiB");
    let of = |(unit, size): (&str, u64)| Some((text.strip_suffix(unit)?.trim_end(), size));
    let (digits, unit) = UNITS.into_iter().find_map(of).ok_or_else(wrong)?;
    let number = number(digits).map_err(|_no_number| wrong())?;
    let bytes = number * unit as f64;
    if !(0.0..=1e18).contains(&bytes) {
        return Err(wrong());
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "within 0 and 1e18"
    )]
    Ok(bytes as u64)
}

pub fn number(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("`{text}` is not a number: write digits, as 1.5"))
}

pub fn assignment(text: &str) -> Result<(String, String), String> {
    let (name, value) =
        text.split_once('=').ok_or_else(|| format!("`{text}` has no `=`: write name=value"))?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

/// Parses a key, as C4 or as its MIDI number.
pub fn note(text: &str) -> Result<KeyIndex, String> {
    text.parse().map_err(|_error| {
        format!("`{text}` is no key: give a note from A0 to C8, or a MIDI number from 21 to 108")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_has_a_unit() {
        for (text, size) in
            [("500MB", 500_000_000), ("1.5 GiB", 3 << 29), ("0B", 0), ("2KiB", 2048)]
        {
            assert_eq!(bytes(text), Ok(size), "{text}");
        }
        for text in ["", "5", "GB", "-1GB", "1TB", "nanGB", "1e30GB"] {
            assert!(bytes(text).unwrap_err().contains("is no size"), "{text}");
        }
    }
}
