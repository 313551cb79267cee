//! A board's settings, by number.
//!
//! Settings survive a restart; the hello contains their CRC-32, so a host writes only changes.

record! {
    /// Asks for the value of a setting.
    ReadConfig {
        /// Number of the setting.
        setting: u8,
    }
}

record! {
    /// A setting and its value.
    WriteConfig {
        /// Number of the setting.
        setting: u8,
        /// Its new value.
        value: i32,
    }
}

record! {
    /// A setting with its current value.
    Config {
        /// The value as it is now.
        value: i32,
        /// CRC-32 of all settings as they are now.
        config_crc: u32,
    }
}

/// The settings that every board has.
pub mod setting {
    /// The board's number on its link, `0 ..= 14`; holds from the next start.
    pub const BOARD: u8 = 0;
    /// First key of the board, `0 ..= 87`; holds from the next start.
    pub const FIRST_KEY: u8 = 1;
    /// Force limit of all motors (mN).
    pub const MAX_FORCE_MN: u8 = 2;
    /// Number of settings.
    pub const COUNT: u8 = 3;
}

/// Returns the CRC-32 (ISO-HDLC) of all settings, in the order of their numbers, little-endian.
pub fn crc(settings: &[i32]) -> u32 {
    const CRC32: crc::Crc<u32> = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC);
    let mut digest = CRC32.digest();
    for value in settings {
        digest.update(&value.to_le_bytes());
    }
    digest.finalize()
}
