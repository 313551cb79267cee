//! `letoff devices --boards --set number=3`: settings that a board keeps.

use boards::keybed::{FoundBoard, Identified, Keybed};
use boards::refusal::Refusal;
use firmware_protocol::acyclic::Operation;
use firmware_protocol::acyclic::config::{Config, WriteConfig, setting};
use firmware_protocol::key::{BoardId, KeyIndex};

/// A setting of a board, and its new value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoardSetting {
    name: String,
    number: u8,
    value: i32,
}

impl BoardSetting {
    /// Parses `number=3`, `first_key=C4` or `max_force_mn=12000`; the error is a sentence.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        const HELP: &str = "write number=0 to 14, first_key=A0 to C8, or max_force_mn=1 to 32767";
        let wrong = || format!("`{text}` is no setting of a board: {HELP}");
        let (name, value) = text.split_once('=').ok_or_else(wrong)?;
        let whole = || value.parse::<u16>().ok();
        let (number, value) = match name {
            "number" => {
                (setting::BOARD, whole().filter(|it| *it <= u16::from(BoardId::MAX.number())))
            }
            "first_key" => {
                let key = value.parse::<KeyIndex>().ok();
                (setting::FIRST_KEY, key.map(|key| u16::from(key.number())))
            }
            "max_force_mn" => {
                (setting::MAX_FORCE_MN, whole().filter(|it| (1..=32_767).contains(it)))
            }
            _ => return Err(wrong()),
        };
        let value = value.ok_or_else(wrong)?.into();
        Ok(Self { name: name.to_owned(), number, value })
    }
}

/// Writes `settings` to the board; returns a sentence on each present value.
pub(super) fn write(
    settings: &[BoardSetting],
    found: &FoundBoard,
    keybed: &mut Keybed<Identified>,
) -> Result<Vec<String>, Refusal> {
    let mut asker = keybed.asker(found.line, found.board);
    let mut written = Vec::new();
    for BoardSetting { name, number, value } in settings {
        let wanted = WriteConfig { setting: *number, value: *value };
        let Config { value, config_crc } =
            keybed.ask(&mut asker, Operation::WriteConfig, &wanted)?;
        let when = if *number == setting::MAX_FORCE_MN { "" } else { " from its next start on" };
        written.push(format!("{name} = {value}{when}; configuration {config_crc:08x}"));
    }
    Ok(written)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_has_a_name_and_a_possible_value() {
        let numbers = |text| BoardSetting::parse(text).map(|it| (it.number, it.value));
        assert_eq!(numbers("number=3"), Ok((0, 3)));
        assert_eq!(numbers("first_key=C4"), Ok((1, 39)));
        assert_eq!(numbers("max_force_mn=12000"), Ok((2, 12_000)));
        for text in
            ["", "number", "number=15", "number=-1", "first_key=C9", "max_force_mn=0", "x=1"]
        {
            assert!(numbers(text).unwrap_err().contains("write number=0 to 14"), "{text}");
        }
    }
}
