//! Set-up and condition of a CAN controller, from `ip`: the kernel has no files for them.

use std::{collections::BTreeMap, process::Command};

use serde_json::Value;

/// One of the two rates of a controller.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BitTiming {
    pub bitrate: u32,
    /// Sample point (thousandths of the bit).
    pub sample_point: u32,
}

/// Output of `ip` about a CAN interface.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct CanLink {
    /// Rate of classic frames, and of head and tail of CAN FD frames.
    pub nominal: Option<BitTiming>,
    /// Rate of the rest of CAN FD frames.
    pub data: Option<BitTiming>,
    /// Time after which a controller that left the bus restarts; 0 for never (ms).
    pub restart_ms: Option<u32>,
    /// `ERROR-ACTIVE` when all is well.
    pub state: Option<String>,
    pub tx_errors: Option<u32>,
    pub rx_errors: Option<u32>,
    /// Active control modes, such as `FD` or `LISTEN-ONLY`.
    pub modes: Vec<String>,
}

/// Returns the output of `ip` about every CAN interface, by name; empty without `ip`.
pub(in super::super) fn ask_ip() -> BTreeMap<String, CanLink> {
    let arguments = ["-details", "-json", "-statistics", "link", "show"];
    let answer = Command::new("ip").args(arguments).output().ok();
    let answer = answer.filter(|answer| answer.status.success());
    answer.map(|it| parse(&String::from_utf8_lossy(&it.stdout))).unwrap_or_default()
}

/// Parses the output of `ip -details -json link show`; unknown parts are left out.
pub(in super::super) fn parse(json: &str) -> BTreeMap<String, CanLink> {
    let links: Vec<Value> = serde_json::from_str(json).unwrap_or_default();
    let is_can = |link: &&Value| link["link_type"] == "can";
    let named = |link: &Value| Some((link["ifname"].as_str()?.to_owned(), can_link(link)));
    links.iter().filter(is_can).filter_map(named).collect()
}

fn can_link(link: &Value) -> CanLink {
    let info = &link["linkinfo"]["info_data"];
    let modes = info["ctrlmode"].as_array().map(Vec::as_slice).unwrap_or_default();
    CanLink {
        nominal: timing(&info["bittiming"]),
        data: timing(&info["data_bittiming"]),
        restart_ms: number(&info["restart_ms"]),
        state: info["state"].as_str().map(str::to_owned),
        tx_errors: number(&info["berr_counter"]["tx"]),
        rx_errors: number(&info["berr_counter"]["rx"]),
        modes: modes.iter().filter_map(Value::as_str).map(str::to_owned).collect(),
    }
}

fn number(value: &Value) -> Option<u32> {
    value.as_u64()?.try_into().ok()
}

/// Returns a rate, unless the controller has none yet.
fn timing(value: &Value) -> Option<BitTiming> {
    let bitrate = number(&value["bitrate"]).filter(|rate| 0 < *rate)?;
    // Older versions of ip print a number, newer ones a text.
    let point = &value["sample_point"];
    let point = point.as_f64().or_else(|| point.as_str()?.parse().ok())?;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it saturates")]
    let sample_point = (point * 1e3).round() as u32;
    Some(BitTiming { bitrate, sample_point })
}

#[cfg(test)]
mod tests {
    use super::*;

    const IP: &str = r#"[
        {"ifindex":1,"ifname":"lo","flags":["LOOPBACK","UP","LOWER_UP"],"mtu":65536,
         "qdisc":"noqueue","operstate":"UNKNOWN","link_type":"loopback","txqlen":1000},
        {"ifindex":3,"ifname":"can0","flags":["NOARP","UP","LOWER_UP","ECHO"],"mtu":72,
         "qdisc":"pfifo_fast","operstate":"UP","linkmode":"DEFAULT","group":"default",
         "txqlen":10,"link_type":"can","promiscuity":0,"allmulti":0,"min_mtu":0,"max_mtu":0,
         "linkinfo":{"info_kind":"can","info_data":{
            "ctrlmode":["FD","TDC_AUTO"],"state":"ERROR-PASSIVE",
            "berr_counter":{"tx":136,"rx":2},"restart_ms":0,
            "bittiming":{"bitrate":1000000,"sample_point":"0.750","tq":25,"prop_seg":14,
                "phase_seg1":15,"phase_seg2":10,"sjw":1,"brp":1},
            "bittiming_const":{"name":"mcp251xfd","tseg1":{"min":2,"max":256},
                "tseg2":{"min":1,"max":128},"sjw":{"min":1,"max":128},
                "brp":{"min":1,"max":256},"brp_inc":1},
            "data_bittiming":{"bitrate":5000000,"sample_point":"0.625","tq":25,"prop_seg":2,
                "phase_seg1":2,"phase_seg2":3,"sjw":1,"brp":1},
            "data_bittiming_const":{"name":"mcp251xfd","tseg1":{"min":1,"max":32},
                "tseg2":{"min":1,"max":16},"sjw":{"min":1,"max":16},
                "brp":{"min":1,"max":256},"brp_inc":1},
            "tdc":{"tdco":5,"tdcf":0},"clock":40000000},
          "info_xstats":{"restarts":0,"bus_error":0,"arbitration_lost":0,"error_warning":1,
            "error_passive":1,"bus_off":0}},
         "num_tx_queues":1,"num_rx_queues":1,"gso_max_size":65536,"gso_max_segs":65535,
         "parentbus":"spi","parentdev":"spi0.0",
         "stats64":{"rx":{"bytes":16,"packets":2,"errors":2,"dropped":0,"over_errors":0,
            "multicast":0},"tx":{"bytes":0,"packets":0,"errors":0,"dropped":0,
            "carrier_errors":0,"collisions":0}}},
        {"ifindex":4,"ifname":"can1","flags":["NOARP","ECHO"],"mtu":16,"operstate":"DOWN",
         "txqlen":10,"link_type":"can","linkinfo":{"info_kind":"can","info_data":{
            "state":"STOPPED","restart_ms":100,
            "bittiming":{"bitrate":250000,"sample_point":0.875,"tq":250}}}},
        {"ifindex":5,"ifname":"vcan0","flags":["NOARP","UP","LOWER_UP"],"mtu":72,
         "txqlen":1000,"link_type":"can","linkinfo":{"info_kind":"vcan"}}]"#;

    #[test]
    fn a_controller_s_rates_state_and_counters_are_read_and_a_virtual_interface_has_none() {
        let links = parse(IP);
        assert_eq!(links.keys().collect::<Vec<_>>(), ["can0", "can1", "vcan0"]);
        let expected = CanLink {
            nominal: Some(BitTiming { bitrate: 1_000_000, sample_point: 750 }),
            data: Some(BitTiming { bitrate: 5_000_000, sample_point: 625 }),
            restart_ms: Some(0),
            state: Some("ERROR-PASSIVE".to_owned()),
            tx_errors: Some(136),
            rx_errors: Some(2),
            modes: vec!["FD".to_owned(), "TDC_AUTO".to_owned()],
        };
        assert_eq!(links["can0"], expected);
        let nominal = links["can1"].nominal;
        assert_eq!(nominal, Some(BitTiming { bitrate: 250_000, sample_point: 875 }));
        assert_eq!(links["vcan0"], CanLink::default());
    }

    #[test]
    fn what_is_no_list_of_links_tells_nothing() {
        for text in ["", "[]", "{}", "[1, null]", "[{\"link_type\":\"can\"}]", "Object \"x\""] {
            assert_eq!(parse(text), BTreeMap::new(), "{text}");
        }
    }
}
