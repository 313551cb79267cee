//! Limits of this user's processes, from `/proc/self`.

use std::path::Path;

use super::files::text;

/// Bit of `CapEff` for locking any amount of memory.
const CAP_IPC_LOCK: u32 = 14;
/// Bit of `CapEff` for any priority.
const CAP_SYS_NICE: u32 = 23;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ResourceLimit {
    None,
    Of(u64),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct ProcessLimits {
    pub(super) priority: ResourceLimit,
    /// Memory that is never paged out (bytes).
    pub(super) locked: ResourceLimit,
}

impl ProcessLimits {
    pub(super) fn read(root: &Path) -> Option<Self> {
        let process = root.join("proc/self");
        let limits = text(&process.join("limits"))?;
        let status = text(&process.join("status")).unwrap_or_default();
        Self::parse(&limits, &status)
    }

    fn parse(limits: &str, status: &str) -> Option<Self> {
        let capabilities = capabilities(status);
        let limit = |name, capability: u32| {
            let may = capabilities >> capability & 1 == 1;
            if may { Some(ResourceLimit::None) } else { soft(limits, name) }
        };
        Some(Self {
            priority: limit("Max realtime priority", CAP_SYS_NICE)?,
            locked: limit("Max locked memory", CAP_IPC_LOCK)?,
        })
    }
}

fn soft(limits: &str, name: &str) -> Option<ResourceLimit> {
    let line = limits.lines().find_map(|line| line.strip_prefix(name))?;
    let value = line.split_whitespace().next()?;
    if value == "unlimited" {
        Some(ResourceLimit::None)
    } else {
        value.parse().ok().map(ResourceLimit::Of)
    }
}

/// Returns the effective capabilities; none if unknown.
fn capabilities(status: &str) -> u64 {
    let line = status.lines().find_map(|line| line.strip_prefix("CapEff:"));
    line.and_then(|set| u64::from_str_radix(set.trim(), 16).ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: &str = "\
Limit                     Soft Limit           Hard Limit           Units
Max cpu time              unlimited            unlimited            seconds
Max locked memory         8388608              8388608              bytes
Max nice priority         0                    0
Max realtime priority     0                    95
Max realtime timeout      unlimited            unlimited            us";

    #[test]
    fn capabilities_lift_their_limits() {
        let nice = ProcessLimits::parse(LIMITS, "Name:\tx\nCapEff:\t0000000000800000\n").unwrap();
        assert_eq!(
            nice,
            ProcessLimits { priority: ResourceLimit::None, locked: ResourceLimit::Of(8_388_608) }
        );
        let root = ProcessLimits::parse(LIMITS, "CapEff:\t000001ffffffffff\n").unwrap();
        assert_eq!(
            root,
            ProcessLimits { priority: ResourceLimit::None, locked: ResourceLimit::None }
        );
    }
}
