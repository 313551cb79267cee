//! Processors that do not fall so deeply asleep between ticks that waking takes long.

use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::Path;

/// Where the kernel is told how long waking may take, for as long as the file is open.
const PLACE: &str = "/dev/cpu_dma_latency";

/// Waking is kept short while this lives, if it was asked for.
#[derive(Debug, Default)]
pub struct HeldLatency {
    file: Option<File>,
    /// What to do if it is not.
    pub advice: Option<String>,
}

impl HeldLatency {
    /// Asks that waking take no time, if the kernel can be asked.
    ///
    /// Not for the tick: opens a file.
    pub fn hold() -> Self {
        Self::hold_at(Path::new(PLACE))
    }

    /// Returns whether the kernel was told.
    pub const fn is_held(&self) -> bool {
        self.file.is_some()
    }

    fn hold_at(place: &Path) -> Self {
        let told = OpenOptions::new().write(true).open(place).and_then(|mut file| {
            file.write_all(&0_i32.to_ne_bytes())?;
            Ok(file)
        });
        match told {
            Ok(file) => Self { file: Some(file), advice: None },
            // A kernel without this has no such states, or no way to avoid them.
            Err(error) if error.kind() == ErrorKind::NotFound => Self { file: None, advice: None },
            Err(error) => {
                let advice = format!(
                    "Processors may fall asleep between ticks, since {PLACE} cannot be written \
                     ({error}); let the group write it: `KERNEL==\"cpu_dma_latency\", \
                     GROUP=\"realtime\", MODE=\"0660\"` in /etc/udev/rules.d, then \
                     `sudo udevadm trigger /dev/cpu_dma_latency`."
                );
                Self { file: None, advice: Some(advice) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_be_written_is_told_zero_and_held() {
        let place = std::env::temp_dir().join(format!("letoff-latency-{}", std::process::id()));
        std::fs::write(&place, [7; 4]).unwrap();
        let held = HeldLatency::hold_at(&place);
        assert!(held.is_held() && held.advice.is_none());
        assert_eq!(std::fs::read(&place).unwrap(), [0; 4]);
        std::fs::remove_file(place).unwrap();
    }

    #[test]
    fn what_is_not_there_is_not_missed_and_what_is_refused_comes_with_advice() {
        let missing = HeldLatency::hold_at(Path::new("/no/such/place"));
        assert!(!missing.is_held() && missing.advice.is_none());
        let refused = HeldLatency::hold_at(Path::new("/"));
        assert!(!refused.is_held() && refused.advice.unwrap().contains("udev"));
    }
}
