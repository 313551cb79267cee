//! Condition of a CAN controller, from its reports.
//!
//! Classes and bytes as in Linux' `linux/can/error.h`: byte 1 is the state, 6 and 7 are counters.

use super::bus::ControllerReport;
use crate::links::{Health, WireState};

/// Class: the controller's state.
const CONTROLLER: u32 = 0x004;
/// Class: it has left the bus.
const BUS_OFF: u32 = 0x040;
/// Class: it was restarted.
const RESTARTED: u32 = 0x100;
/// Class: the counters are filled in.
const COUNTERS: u32 = 0x200;

/// Byte 1: warning level of reception or transmission.
const WARNING: u8 = 0x04 | 0x08;
/// Byte 1: error passive in reception or transmission.
const PASSIVE: u8 = 0x10 | 0x20;
/// Byte 1: error active again.
const ACTIVE: u8 = 0x40;

impl Health {
    pub(super) fn note(&mut self, report: ControllerReport) {
        let ControllerReport { class, data: [_, state, .., transmit, receive] } = report;
        let state = if class & CONTROLLER == 0 { None } else { controller_state(state) };
        self.reports += 1;
        if class & RESTARTED != 0 {
            self.restarts += 1;
            self.state = WireState::Active;
        }
        if let Some(state) = state {
            self.state = state;
        }
        if class & BUS_OFF != 0 {
            self.state = WireState::Off;
        }
        // Kernels before 6.0 fill the counters in when the state changes, without this class.
        if class & COUNTERS != 0 || state.is_some() {
            (self.transmit_errors, self.receive_errors) = (transmit, receive);
        }
    }
}

/// Returns the worst state in byte 1; `None` if it contains other reports.
const fn controller_state(byte: u8) -> Option<WireState> {
    if byte & PASSIVE != 0 {
        Some(WireState::Passive)
    } else if byte & WARNING != 0 {
        Some(WireState::Warning)
    } else if byte & ACTIVE != 0 {
        Some(WireState::Active)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A report in the notation of `cansend`, after the error flag.
    fn report(class: u32, data: u64) -> ControllerReport {
        ControllerReport { class, data: data.to_be_bytes() }
    }

    #[test]
    fn a_controller_that_leaves_the_bus_is_off_until_it_is_started_again() {
        let mut health = Health::default();
        health.note(report(0x040, 0));
        assert_eq!(health, Health { state: WireState::Off, reports: 1, ..Health::default() });
        health.note(report(0x101, 0));
        let again = Health { reports: 2, restarts: 1, ..Health::default() };
        assert_eq!(health, again);
    }

    #[test]
    fn an_error_passive_controller_tells_its_counters() {
        let mut health = Health::default();
        health.note(report(0x004, 0x0010_0000_0000_8800));
        let passive = Health {
            state: WireState::Passive,
            transmit_errors: 136,
            reports: 1,
            ..Health::default()
        };
        assert_eq!(health, passive);
    }

    #[test]
    fn an_overflow_leaves_state_and_counters_as_they_were() {
        let mut health = Health::default();
        health.note(report(0x204, 0x0008_0000_0000_6061));
        health.note(report(0x004, 0x0001_0000_0000_0000));
        let warned = Health {
            state: WireState::Warning,
            transmit_errors: 0x60,
            receive_errors: 0x61,
            reports: 2,
            restarts: 0,
            dropped: 0,
        };
        assert_eq!(health, warned);
        health.note(report(0x204, 0x0040_0000_0000_0100));
        assert_eq!((health.state, health.transmit_errors), (WireState::Active, 1));
    }
}
