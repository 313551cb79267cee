//! Processor time that a hypervisor took from this machine, as the kernel counts it.

use std::fs;

use rustix::param::clock_ticks_per_second;

/// Returns the processors' lost time since boot (s), if counted. Not for the tick: reads a file.
pub fn stolen() -> Option<f64> {
    stolen_ticks(&fs::read_to_string("/proc/stat").ok()?)
        .map(|ticks| ticks as f64 / clock_ticks_per_second() as f64)
}

/// Returns the eighth number of the first line, which adds up all processors.
fn stolen_ticks(stat: &str) -> Option<u64> {
    let all = stat.lines().next()?.strip_prefix("cpu ")?;
    all.split_whitespace().nth(7)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steal_is_the_eighth_number_of_the_line_of_all_processors() {
        let stat =
            "cpu  57777 0 6732 30687 706 0 50 55 0 0\ncpu0 28442 0 2962 16508 70 0 4 26 0 0\n";
        assert_eq!(stolen_ticks(stat), Some(55));
        for foreign in ["", "cpu0 1 2 3 4 5 6 7 8", "cpu 1 2 3", "cpu 1 2 3 4 5 6 7 x"] {
            assert_eq!(stolen_ticks(foreign), None, "{foreign}");
        }
    }
}
