//! Settings of the kernel that delay a tick.

use std::{collections::BTreeSet, fmt, fs, path::Path};

use super::files::{number, text};

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(in super::super) struct KernelVersion {
    pub(super) major: u32,
    pub(super) minor: u32,
}

impl KernelVersion {
    /// Parses the start of a release, as in `6.1.0-56-amd64`.
    fn of(release: &str) -> Option<Self> {
        let mut numbers = release.split(|c: char| !c.is_ascii_digit()).map(str::parse);
        Some(Self { major: numbers.next()?.ok()?, minor: numbers.next()?.ok()? })
    }

    pub(in super::super) fn read(root: &Path) -> Option<Self> {
        Self::of(&release(root)?)
    }
}

impl fmt::Display for KernelVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.major, self.minor)
    }
}

/// Returns the kernel's release, as `uname -r` prints it.
pub(super) fn release(root: &Path) -> Option<String> {
    text(&root.join("proc/sys/kernel/osrelease"))
}

/// Returns `true` if the kernel was built for real time (`PREEMPT_RT`).
pub(super) fn is_real_time(root: &Path) -> bool {
    text(&root.join("sys/kernel/realtime")).as_deref() == Some("1")
}

/// Returns the limit of real-time threads per period, if any (us), and the period.
pub(super) fn throttling(root: &Path) -> Option<(u32, u32)> {
    let kernel = root.join("proc/sys/kernel");
    let runtime: i64 = number(&kernel.join("sched_rt_runtime_us"))?;
    let period: u32 = number(&kernel.join("sched_rt_period_us")).unwrap_or(1_000_000);
    // -1 means all.
    let runtime = u32::try_from(runtime).ok()?;
    (runtime < period).then_some((runtime, period))
}

/// Returns the governors of the processors' clocks; empty if unknown.
pub(super) fn governors(root: &Path) -> BTreeSet<String> {
    let folders = fs::read_dir(root.join("sys/devices/system/cpu"));
    let folders = folders.into_iter().flatten().flatten();
    folders.filter_map(|cpu| text(&cpu.path().join("cpufreq/scaling_governor"))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::links::discovery::testing::Root;

    #[test]
    fn versions_are_compared_by_number() {
        let of = |release| KernelVersion::of(release).unwrap();
        assert_eq!(of("6.1.0-56-amd64"), KernelVersion { major: 6, minor: 1 });
        assert!(of("6.1.0-56-amd64") < of("6.6.3") && of("6.6-rc1") < of("6.12.0"));
        assert_eq!(KernelVersion::of("unknown"), None);
    }

    #[test]
    fn each_governor_is_named_once() {
        let file = |cpu| format!("sys/devices/system/cpu/cpu{cpu}/cpufreq/scaling_governor");
        let root = Root::new("governors")
            .with(&file(0), "powersave")
            .with(&file(1), "powersave")
            .with(&file(2), "performance")
            .with("sys/devices/system/cpu/online", "0-2");
        let names = governors(root.path());
        assert_eq!(names.into_iter().collect::<Vec<_>>(), ["performance", "powersave"]);
    }
}
