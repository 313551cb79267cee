//! The machine's effects on a tick, whatever is plugged in.

use std::path::Path;

use super::kernel;
use super::limits::{ProcessLimits, ResourceLimit};
use crate::links::discovery::Listing;

const WANTED_PRIORITY: u64 = 80;

/// A property of this machine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fact {
    pub name: &'static str,
    pub detail: String,
    pub advice: Option<String>,
}

/// Returns properties of this machine's kernel, and the rights of this user.
pub fn this_machine() -> Listing<Fact> {
    let facts = if cfg!(target_os = "linux") { facts(Path::new("/")) } else { Vec::new() };
    Listing::new(facts, "the kernel tells this on Linux only")
}

fn facts(root: &Path) -> Vec<Fact> {
    let facts = [preemption(root), kernel::throttling(root).map(throttling), governors(root)];
    let limits = ProcessLimits::read(root).map(|it| [priority(it.priority), memory(it.locked)]);
    facts.into_iter().flatten().chain(limits.into_iter().flatten()).collect()
}

fn preemption(root: &Path) -> Option<Fact> {
    let (name, release) = ("kernel", kernel::release(root)?);
    if kernel::is_real_time(root) {
        return Some(Fact { name, detail: format!("{release}, PREEMPT_RT"), advice: None });
    }
    let advice = "drivers can delay a tick by a millisecond and more on a kernel without \
                  PREEMPT_RT; if ticks are late, install one, on Debian: \
                  sudo apt install linux-image-rt-$(dpkg --print-architecture)";
    let detail = format!("{release}, not PREEMPT_RT");
    Some(Fact { name, detail, advice: Some(advice.to_owned()) })
}

fn throttling((runtime, period): (u32, u32)) -> Fact {
    let ms = |micros: u32| f64::from(micros) / 1e3;
    let advice = format!(
        "real-time threads that never sleep are stopped for {} ms in every {} ms; if lanes spin, \
         until the next start: sudo sysctl kernel.sched_rt_runtime_us=-1",
        ms(period - runtime),
        ms(period)
    );
    Fact {
        name: "real-time share",
        detail: format!("{} of {} ms", ms(runtime), ms(period)),
        advice: Some(advice),
    }
}

fn governors(root: &Path) -> Option<Fact> {
    let names = kernel::governors(root);
    let saves = names.contains("powersave");
    let advice = "a processor that saves power wakes up slowly; until the next start: \
                  echo performance | sudo tee \
                  /sys/devices/system/cpu/cpu*/cpufreq/scaling_governor";
    (!names.is_empty()).then(|| Fact {
        name: "processor clock",
        detail: names.into_iter().collect::<Vec<_>>().join(" and "),
        advice: saves.then(|| advice.to_owned()),
    })
}

fn priority(limit: ResourceLimit) -> Fact {
    let (detail, enough) = match limit {
        ResourceLimit::None => ("any".to_owned(), true),
        ResourceLimit::Of(most) => (format!("up to {most}"), WANTED_PRIORITY <= most),
    };
    let advice = format!(
        "the tick asks for real-time priority {WANTED_PRIORITY} and will not get it: \
         echo '@realtime - rtprio 95' | sudo tee /etc/security/limits.d/realtime.conf && \
         sudo groupadd -f realtime && sudo usermod -aG realtime $USER, then log in again"
    );
    Fact { name: "real-time priority", detail, advice: (!enough).then_some(advice) }
}

fn memory(limit: ResourceLimit) -> Fact {
    let (detail, enough) = match limit {
        ResourceLimit::None => ("any amount".to_owned(), true),
        ResourceLimit::Of(most) => (format!("up to {} KiB", most / 1024), false),
    };
    let advice = "memory that is allocated later cannot be locked, so a page fault may delay a \
                  tick: echo '@realtime - memlock unlimited' | sudo tee -a \
                  /etc/security/limits.d/realtime.conf && sudo groupadd -f realtime && \
                  sudo usermod -aG realtime $USER, then log in again"
        .to_owned();
    Fact { name: "locked memory", detail, advice: (!enough).then_some(advice) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::links::discovery::testing::Root;

    const GOVERNOR: &str = "sys/devices/system/cpu/cpu0/cpufreq/scaling_governor";
    fn machine(test: &str, [real_time, throttle, governor, locked, priority]: [&str; 5]) -> Root {
        let limits = format!(
            "Max locked memory  {locked}  unlimited  bytes\nMax realtime priority  {priority}  99"
        );
        Root::new(test)
            .with("proc/sys/kernel/osrelease", "6.12.1-amd64")
            .with("sys/kernel/realtime", real_time)
            .with("proc/sys/kernel/sched_rt_runtime_us", throttle)
            .with("proc/sys/kernel/sched_rt_period_us", "1000000")
            .with(GOVERNOR, governor)
            .with("proc/self/limits", &limits)
    }

    #[test]
    fn a_machine_as_shipped_is_told_five_things() {
        let root = machine("as-shipped", ["0", "950000", "powersave", "8388608", "0"]);
        let facts = facts(root.path());
        let names: Vec<_> = facts.iter().map(|it| it.name).collect();
        let expected =
            ["kernel", "real-time share", "processor clock", "real-time priority", "locked memory"];
        assert_eq!(names, expected);
        assert!(facts.iter().all(|it| it.advice.is_some()), "{facts:?}");
        assert_eq!(facts[0].detail, "6.12.1-amd64, not PREEMPT_RT");
        assert!(facts[1].advice.as_ref().unwrap().contains("50 ms in every 1000 ms"));
        assert_eq!(facts[4].detail, "up to 8192 KiB");
    }

    #[test]
    fn a_machine_that_was_set_up_is_told_nothing() {
        let root = machine("set-up", ["1", "-1", "performance", "unlimited", "95"]);
        let facts = facts(root.path());
        assert_eq!(facts[0].detail, "6.12.1-amd64, PREEMPT_RT");
        assert!(facts.iter().all(|it| it.advice.is_none()), "{facts:?}");
    }

    #[test]
    fn files_that_are_not_there_tell_nothing() {
        assert_eq!(facts(Root::new("no-files").path()), []);
    }
}
