//! Limit on the sleep states of processors between ticks, so that waking up stays short.

use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::Path;

/// Device that limits the time to wake up, for as long as the file is open.
const PLACE: &str = "/dev/cpu_dma_latency";

/// Keeps the time to wake up short while it lives, if it was requested.
#[derive(Debug, Default)]
pub struct HeldLatency {
    file: Option<File>,
    /// Remedy if the latency is not held.
    pub advice: Option<String>,
}

impl HeldLatency {
    /// Requests a wake-up time of zero, if the kernel supports it. Not for the tick: opens a file.
    pub fn hold() -> Self {
        Self::hold_at(Path::new(PLACE))
    }

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
            // A kernel without this device has no such states, or no way to avoid them.
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
