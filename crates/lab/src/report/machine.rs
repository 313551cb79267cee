use std::fs;

use serde::{Deserialize, Serialize};

/// The machine and the program of a measurement.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Machine {
    pub processor: String,
    pub processors: usize,
    pub system: String,
    pub program: String,
}

impl Machine {
    pub fn this() -> Self {
        let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let build = if cfg!(debug_assertions) { "not optimised for release" } else { "release" };
        Self {
            processor: processor().unwrap_or_else(|| "a processor without a name".to_owned()),
            processors: cores,
            system: format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH),
            program: format!("letoff {}, {build}", env!("CARGO_PKG_VERSION")),
        }
    }
}

fn processor() -> Option<String> {
    let info = fs::read_to_string("/proc/cpuinfo").ok()?;
    let named = |key: &str| {
        let line = info.lines().find(|line| line.starts_with(key))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    named("model name").or_else(|| named("Model"))
}
