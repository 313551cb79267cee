//! Processors on which threads run: affinity, and processors that the kernel keeps free.

use std::fs;

use rustix::thread::{CpuSet, sched_getaffinity, sched_setaffinity};

/// Keeps the calling thread to processor `cpu`; an error states the remedy.
pub(crate) fn keep_to(cpu: usize) -> Result<(), String> {
    let mut set = CpuSet::new();
    if cpu < CpuSet::MAX_CPU {
        set.set(cpu);
    }
    sched_setaffinity(None, &set).map_err(|error| {
        format!(
            "The tick could not be kept to processor {cpu} ({error}), so it runs on any; give \
             others in `[realtime] cpus` (`lscpu --extended` lists them), or allow this one \
             (`taskset`, or `AllowedCPUs=` of a service)."
        )
    })
}

pub fn allowed() -> Vec<usize> {
    let set = sched_getaffinity(None).unwrap_or_else(|_| CpuSet::new());
    (0..CpuSet::MAX_CPU).filter(|cpu| set.is_set(*cpu)).collect()
}

/// Returns the processors kept free by the kernel (`isolcpus=`). Not for the tick: reads a file.
pub fn isolated() -> Vec<usize> {
    let list = fs::read_to_string("/sys/devices/system/cpu/isolated").unwrap_or_default();
    listed(&list)
}

#[cfg(test)]
pub(crate) fn online() -> Vec<usize> {
    listed(&fs::read_to_string("/sys/devices/system/cpu/online").unwrap_or_default())
}

/// Returns the numbers of a list in the kernel's format, `1,4-6`.
fn listed(list: &str) -> Vec<usize> {
    let ends = |part: &str| {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        Some(first.parse::<usize>().ok()?..=last.parse::<usize>().ok()?.min(CpuSet::MAX_CPU))
    };
    list.trim().split(',').filter_map(ends).flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_the_kernel_are_read() {
        assert_eq!(listed("1,4-6,9\n"), [1, 4, 5, 6, 9]);
        assert_eq!(listed("3"), [3]);
        for nothing in ["", "\n", "x", "5-4", "-"] {
            assert_eq!(listed(nothing), [0; 0], "{nothing:?}");
        }
    }
}
