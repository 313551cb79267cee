//! Advice on a CAN interface before forces use it.

use std::ops::RangeInclusive;

use super::kernel::KernelVersion;
use crate::links::discovery::can_interface::CanInterface;
use crate::links::discovery::can_link::{BitTiming, CanLink};

/// Force frames of a cycle for eight boards, twice: the last cycle may still wait.
const LEAST_QUEUE_FD: u32 = 2 * 8;
/// Like [`LEAST_QUEUE_FD`] over classic CAN, where a frame of 26 bytes needs four pieces.
const LEAST_QUEUE_CLASSIC: u32 = 2 * 8 * 4;
/// Longest useful queue: frames that wait longer are stale.
const MOST_QUEUE: u32 = 128;
const GOOD_QUEUE: u32 = LEAST_QUEUE_CLASSIC;
/// Range of good sample points (thousandths of the bit).
const SAMPLE_POINTS: RangeInclusive<u32> = 750..=875;
const GOOD_SAMPLE_POINT: u32 = 800;
/// The first kernel whose driver keeps the frames of a USB adapter in order.
const ORDERED_GS_USB: KernelVersion = KernelVersion { major: 6, minor: 6 };

/// Returns all advice on `can` for a kernel of this version, most urgent first.
pub(in super::super) fn advice(can: &CanInterface, kernel: Option<KernelVersion>) -> Vec<String> {
    if can.is_virtual {
        return virtual_mtu(can).into_iter().collect();
    }
    let link = can.link.clone().unwrap_or_default();
    let findings = [
        state(can, &link),
        modes(can, &link),
        fd(can, &link),
        sample_point(can, &link, link.nominal),
        sample_point(can, &link, link.data),
        restart(can, &link),
        queue(can),
        order(can, kernel),
    ];
    findings.into_iter().flatten().collect()
}

/// Returns the commands that set the controller of `name`, which must be down for that.
fn set(name: &str, what: &str) -> String {
    format!("sudo ip link set {name} down && sudo ip link set {name} up type can {what}")
}

/// Returns the rates in the syntax of `ip`: the present ones, or defaults.
fn rates(link: &CanLink) -> String {
    let rate = |timing: Option<BitTiming>, other| timing.map_or(other, |timing| timing.bitrate);
    let (nominal, data) = (rate(link.nominal, 1_000_000), rate(link.data, 5_000_000));
    format!("bitrate {nominal} dbitrate {data} fd on")
}

fn state(can: &CanInterface, link: &CanLink) -> Option<String> {
    let name = &can.name;
    let check = "check the wires, 120 ohm at both ends, and that all boards have the same rates";
    match link.state.as_deref()? {
        "BUS-OFF" => Some(format!(
            "{name} went off the bus after too many errors and carries nothing: {check}, then: \
             sudo ip link set {name} down && sudo ip link set {name} up"
        )),
        state @ ("ERROR-PASSIVE" | "ERROR-WARNING") => Some(format!(
            "{name} is {state} with {} transmit and {} receive errors, on its way off the bus: \
             {check}, and that a board is there to acknowledge; see the counters: \
             ip -details -statistics link show {name}",
            link.tx_errors.unwrap_or(0),
            link.rx_errors.unwrap_or(0)
        )),
        _ => None,
    }
}

fn modes(can: &CanInterface, link: &CanLink) -> Option<String> {
    let (mode, harm) = [
        ("LISTEN-ONLY", "sends nothing, not even forces"),
        ("LOOPBACK", "hears itself instead of the boards"),
    ]
    .into_iter()
    .find(|(mode, _)| link.modes.iter().any(|it| it == mode))?;
    let command = set(&can.name, &format!("{} off", mode.to_lowercase()));
    Some(format!("{} is in mode {mode} and {harm}: {command}", can.name))
}

fn fd(can: &CanInterface, link: &CanLink) -> Option<String> {
    (!can.carries_fd).then(|| {
        format!(
            "{} carries classic frames only (its MTU is not 72), with which 88 keys reach a \
             fifth of the rate; if the adapter can do CAN FD: {}",
            can.name,
            set(&can.name, &rates(link))
        )
    })
}

fn virtual_mtu(can: &CanInterface) -> Option<String> {
    let name = &can.name;
    (!can.carries_fd).then(|| {
        format!(
            "{name} carries classic frames only (its MTU is not 72): sudo ip link set {name} \
             down && sudo ip link set {name} mtu 72 && sudo ip link set {name} up"
        )
    })
}

fn sample_point(can: &CanInterface, link: &CanLink, of: Option<BitTiming>) -> Option<String> {
    let BitTiming { bitrate, sample_point } = of?;
    (!SAMPLE_POINTS.contains(&sample_point)).then(|| {
        format!(
            "{} reads its bits of {} Mbit/s at {} % of their length, outside 75 to 87.5 %, so \
             boards on a long cable are misread: {}",
            can.name,
            f64::from(bitrate) / 1e6,
            f64::from(sample_point) / 10.0,
            set(&can.name, &moved(link))
        )
    })
}

/// Returns the rates of `link` with good sample points; a controller is given all at once.
fn moved(link: &CanLink) -> String {
    let timing = |prefix: &str, it: BitTiming| {
        let good = SAMPLE_POINTS.contains(&it.sample_point);
        let point = if good { it.sample_point } else { GOOD_SAMPLE_POINT };
        format!("{prefix}bitrate {} {prefix}sample-point 0.{point}", it.bitrate)
    };
    let nominal = link.nominal.map(|it| timing("", it));
    let data = link.data.map(|it| timing("d", it) + " fd on");
    nominal.into_iter().chain(data).collect::<Vec<_>>().join(" ")
}

fn restart(can: &CanInterface, link: &CanLink) -> Option<String> {
    (link.restart_ms == Some(0)).then(|| {
        format!(
            "{} never comes back once errors took it off the bus (restart-ms is 0): {}",
            can.name,
            set(&can.name, "restart-ms 100")
        )
    })
}

fn queue(can: &CanInterface) -> Option<String> {
    let (name, length) = (&can.name, can.queue_length?);
    let command = format!("sudo ip link set {name} txqueuelen {GOOD_QUEUE}");
    let least = if can.carries_fd { LEAST_QUEUE_FD } else { LEAST_QUEUE_CLASSIC };
    if length < least {
        Some(format!(
            "{name} queues {length} frames, less than the {least} of two cycles, so forces are \
             dropped in a burst: {command}"
        ))
    } else if MOST_QUEUE < length {
        Some(format!(
            "{name} queues {length} frames, so forces wait until they are stale: {command}"
        ))
    } else {
        None
    }
}

fn order(can: &CanInterface, kernel: Option<KernelVersion>) -> Option<String> {
    let kernel = kernel.filter(|kernel| *kernel < ORDERED_GS_USB)?;
    (can.driver.as_deref() == Some("gs_usb")).then(|| {
        format!(
            "{}'s driver gs_usb swaps frames on kernels before {ORDERED_GS_USB}, and this is \
             {kernel}: install a newer one, on Debian from the backports: sudo apt install -t \
             $(lsb_release -cs)-backports linux-image-$(dpkg --print-architecture)",
            can.name
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn good() -> CanInterface {
        CanInterface {
            name: "can0".to_owned(),
            is_virtual: false,
            carries_fd: true,
            is_up: true,
            state: "up".to_owned(),
            mtu: Some(72),
            queue_length: Some(GOOD_QUEUE),
            driver: Some("mcp251xfd".to_owned()),
            link: Some(CanLink {
                nominal: Some(BitTiming { bitrate: 1_000_000, sample_point: 800 }),
                data: Some(BitTiming { bitrate: 5_000_000, sample_point: 750 }),
                restart_ms: Some(100),
                state: Some("ERROR-ACTIVE".to_owned()),
                tx_errors: Some(0),
                rx_errors: Some(0),
                modes: vec!["FD".to_owned()],
            }),
            obstacle: None,
            advice: Vec::new(),
        }
    }

    const NEW: Option<KernelVersion> = Some(KernelVersion { major: 6, minor: 12 });

    #[track_caller]
    fn check(can: &CanInterface, kernel: Option<KernelVersion>, words: &[&str]) {
        let [sentence] = <[String; 1]>::try_from(advice(can, kernel)).unwrap();
        for part in words {
            assert!(sentence.contains(part), "{sentence}");
        }
    }

    fn with(change: impl FnOnce(&mut CanLink)) -> CanInterface {
        let mut can = good();
        can.link.as_mut().map(change).unwrap();
        can
    }

    #[test]
    fn a_controller_that_is_set_up_well_needs_nothing() {
        assert_eq!(advice(&good(), NEW), [""; 0]);
        assert_eq!(advice(&CanInterface { link: None, ..good() }, None), [""; 0]);
    }

    #[test]
    fn a_queue_holds_two_cycles_but_no_stale_forces() {
        let with = |n| CanInterface { queue_length: Some(n), ..good() };
        check(&with(10), NEW, &["queues 10 frames", "sudo ip link set can0 txqueuelen 64"]);
        check(&with(1_000), NEW, &["stale", "txqueuelen 64"]);
        assert_eq!(advice(&with(16), NEW), [""; 0]);
    }

    #[test]
    fn a_virtual_interface_may_queue_what_it_likes() {
        let virtual_ =
            CanInterface { is_virtual: true, queue_length: Some(1_000), link: None, ..good() };
        assert_eq!(advice(&virtual_, NEW), [""; 0]);
        let classic = CanInterface { carries_fd: false, ..virtual_ };
        check(&classic, NEW, &["mtu 72"]);
    }

    #[test]
    fn a_sample_point_is_moved_without_forgetting_the_other_rate() {
        let at =
            |it: Option<BitTiming>, sample_point| it.map(|it| BitTiming { sample_point, ..it });
        let early = with(|link| link.nominal = at(link.nominal, 500));
        let command = "type can bitrate 1000000 sample-point 0.800 \
                       dbitrate 5000000 dsample-point 0.750 fd on";
        check(&early, NEW, &["1 Mbit/s at 50 %", command]);
        let late = with(|link| link.data = at(link.data, 900));
        let command = "type can bitrate 1000000 sample-point 0.800 \
                       dbitrate 5000000 dsample-point 0.800 fd on";
        check(&late, NEW, &["5 Mbit/s at 90 %", command]);
    }

    #[test]
    fn what_a_controller_says_of_itself_is_answered_with_what_to_do() {
        let state = |state: &str| with(|link| link.state = Some(state.to_owned()));
        check(&state("BUS-OFF"), NEW, &["went off the bus", "120 ohm", "sudo ip link set can0 up"]);
        check(&state("ERROR-PASSIVE"), NEW, &["ERROR-PASSIVE", "0 transmit and 0 receive errors"]);
        check(&with(|link| link.restart_ms = Some(0)), NEW, &["up type can restart-ms 100"]);
        let listening = with(|link| link.modes.push("LISTEN-ONLY".to_owned()));
        check(&listening, NEW, &["sends nothing", "listen-only off"]);
    }

    #[test]
    fn classic_can_is_asked_for_fd_and_a_longer_queue() {
        let classic = CanInterface { carries_fd: false, queue_length: Some(32), ..good() };
        let [fd, queue] = <[String; 2]>::try_from(advice(&classic, NEW)).unwrap();
        assert!(fd.contains("bitrate 1000000 dbitrate 5000000 fd on"), "{fd}");
        assert!(queue.contains("the 64 of two cycles"), "{queue}");
    }

    #[test]
    fn an_old_kernel_swaps_the_frames_of_gs_usb() {
        let gs_usb = CanInterface { driver: Some("gs_usb".to_owned()), ..good() };
        check(&gs_usb, Some(KernelVersion { major: 6, minor: 1 }), &["gs_usb", "this is 6.1"]);
        assert_eq!(advice(&gs_usb, NEW), [""; 0]);
    }
}
