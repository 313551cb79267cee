//! Advice on a serial port before forces use it.

use std::path::Path;

use super::files::number;
use super::usb::{UsbPlace, UsbSpeed};

/// Largest delay of bytes by an FTDI adapter (ms).
const MOST_LATENCY: u32 = 1;

/// Returns the delay of bytes by the adapter of the terminal `tty`, if it has a timer (ms).
pub(in super::super) fn latency_timer(sys: &Path, tty: &str) -> Option<u32> {
    number(&sys.join("bus/usb-serial/devices").join(tty).join("latency_timer"))
}

pub(in super::super) fn advice(
    tty: &str,
    latency: Option<u32>,
    place: Option<&UsbPlace>,
    places: &[UsbPlace],
) -> Vec<String> {
    let findings = [
        latency.and_then(|latency| held_back(tty, latency)),
        place.and_then(|place| sleep(tty, place)),
        place.and_then(|place| slow(tty, place)),
        place.and_then(|place| sharing(tty, place, places)),
    ];
    findings.into_iter().flatten().collect()
}

fn held_back(tty: &str, latency: u32) -> Option<String> {
    (MOST_LATENCY < latency).then(|| {
        format!(
            "the adapter of {tty} holds bytes back for {latency} ms; until it is unplugged: \
             echo {MOST_LATENCY} | sudo tee /sys/bus/usb-serial/devices/{tty}/latency_timer"
        )
    })
}

fn sleep(tty: &str, place: &UsbPlace) -> Option<String> {
    let after = f64::from(place.sleeps_after?) / 1e3;
    Some(format!(
        "the USB device of {tty} is put to sleep after {after} s without traffic; until it is \
         unplugged: echo on | sudo tee {}/power/control",
        place.folder.display()
    ))
}

fn slow(tty: &str, place: &UsbPlace) -> Option<String> {
    (place.speed == UsbSpeed::Low).then(|| {
        format!("the USB device of {tty} is a low-speed one, too slow for keys; use another")
    })
}

fn sharing(tty: &str, place: &UsbPlace, places: &[UsbPlace]) -> Option<String> {
    let shared = place.shared.as_ref()?;
    let mut others: Vec<_> = places
        .iter()
        .filter(|it| it.shared.as_ref() == Some(shared) && it.folder != place.folder)
        .map(|it| &it.folder)
        .collect();
    // A device may have several ports.
    others.sort();
    others.dedup();
    let hub = shared.file_name()?.to_string_lossy();
    (!others.is_empty()).then(|| {
        format!(
            "{tty} shares 12 Mbit/s with {} more of these ports' devices behind the hub {hub}; \
             above 1 kHz put them on ports of the machine, or on a hub with a transaction \
             translator for each port (multi-TT; lsusb -t shows the tree)",
            others.len()
        )
    })
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use crate::links::discovery::diagnosis::usb::{place, tests::tree};
    use crate::links::discovery::testing::Root;

    #[test]
    fn an_adapter_that_holds_bytes_back_is_told_not_to() {
        let root = Root::new("ftdi").with("bus/usb-serial/devices/ttyUSB0/latency_timer", "16");
        let latency = latency_timer(root.path(), "ttyUSB0");
        let [sentence] = <[String; 1]>::try_from(advice("ttyUSB0", latency, None, &[])).unwrap();
        assert_eq!(
            sentence,
            "the adapter of ttyUSB0 holds bytes back for 16 ms; until it is unplugged: \
             echo 1 | sudo tee /sys/bus/usb-serial/devices/ttyUSB0/latency_timer"
        );
        assert_eq!(advice("ttyUSB0", Some(1), None, &[]), [""; 0]);
        assert_eq!(latency_timer(root.path(), "ttyACM0"), None);
    }

    #[test]
    fn a_port_that_shares_its_translator_says_with_how_many() {
        let root = tree("advice-tt", "01");
        let places: Vec<_> = ["ttyACM0", "ttyACM1", "ttyACM2"]
            .iter()
            .map(|tty| place(root.path(), tty).unwrap())
            .collect();
        let advice = |at: usize| advice("port", None, places.get(at), &places);
        let [sentence] = <[String; 1]>::try_from(advice(0)).unwrap();
        assert!(sentence.contains("with 1 more") && sentence.contains("hub 1-1"), "{sentence}");
        assert_eq!(advice(2), [""; 0]);
    }

    #[test]
    fn a_device_that_may_sleep_is_told_to_stay_awake() {
        let awake = UsbPlace {
            folder: "/sys/devices/usb1/1-2".into(),
            speed: UsbSpeed::High,
            shared: None,
            sleeps_after: Some(2_000),
        };
        let [sentence] =
            <[String; 1]>::try_from(advice("ttyACM0", None, Some(&awake), &[])).unwrap();
        assert!(sentence.contains("after 2 s"), "{sentence}");
        assert!(sentence.ends_with("echo on | sudo tee /sys/devices/usb1/1-2/power/control"));
    }
}
