//! Content of a calibration file, and its checksum.

use std::fmt::Write as _;

use firmware_protocol::key::PerKey;

use crate::{calibration::KeyCalibration, identity::Uid};

const HEAD: &str = "\
# How the keys of one board read and push, as `letoff calibrate` has measured it.
# Do not edit it: the checksum is that of the values. Calibrate anew instead.
";

const UNITS: &str = "
# rest and bottom [counts], metres_per_count [m], friction [N],
# gain: what must be asked of the motor for a newton [1]
";

/// Calibration of one board's keys, with its origin.
#[derive(Clone, PartialEq, Debug)]
pub struct CalibrationSheet {
    pub uid: Uid,
    /// Time of the measurement, in the caller's words.
    pub made: String,
    /// Person or program that measured it.
    pub by: String,
    /// Keys in the order of slots; `None` for an unknown one.
    pub keys: PerKey<Option<KeyCalibration>>,
}

impl CalibrationSheet {
    pub fn render(&self) -> String {
        let quoted = |text: &str| toml_edit::Value::from(text).to_string();
        let mut text = format!(
            "{HEAD}board = \"{}\"\nmade = {}\nby = {}\nchecksum = \"{:08x}\"\n{UNITS}",
            self.uid,
            quoted(&self.made),
            quoted(&self.by),
            self.checksum()
        );
        for (slot, key) in self.keys.as_slice().iter().enumerate() {
            let Some(key) = key else { continue };
            let KeyCalibration { rest, quantum, gain, bottom, friction } = key;
            let _always = writeln!(
                text,
                "[[key]]\nslot = {slot}\nrest = {}\nbottom = {}\nmetres_per_count = {quantum:?}\n\
                 friction = {friction:?}\ngain = {gain:?}\n",
                rest.get(),
                bottom.get(),
            );
        }
        text
    }

    /// Returns the CRC-32 (ISO-HDLC) of all values in one rendering, whatever the file's spelling.
    pub fn checksum(&self) -> u32 {
        const CRC32: crc::Crc<u32> = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);
        let mut digest = CRC32.digest();
        digest.update(&self.uid.0);
        for text in [&self.made, &self.by] {
            digest.update(&(text.len() as u64).to_le_bytes());
            digest.update(text.as_bytes());
        }
        for key in self.keys.as_slice() {
            let Some(key) = key else {
                digest.update(&[0]);
                continue;
            };
            let KeyCalibration { rest, quantum, gain, bottom, friction } = key;
            digest.update(&rest.get().to_le_bytes());
            digest.update(&bottom.get().to_le_bytes());
            for value in [quantum, friction, gain] {
                digest.update(&value.to_bits().to_le_bytes());
            }
        }
        digest.finalize()
    }
}
