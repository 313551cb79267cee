//! State of a board, for monitors and reports.

use firmware_protocol::acyclic::counters::Counters;

use super::arm_state::ArmState;

/// Status of a board, cheap enough for a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardStatus {
    pub state: ArmState,
    pub armings: u64,
    /// Median of the latest round trips (us), if any.
    pub round_trip_us: Option<u32>,
    /// Number of recent restarts, and the last reason (as in its hello).
    pub restarts: u8,
    pub reset_reason: u8,
    /// Interval of bursts of samples (us), if they arrive in bursts.
    pub burst_us: Option<u64>,
    /// Lateness of samples since arming (periods), if it is too large.
    pub late: Option<f64>,
}

/// Condition of a board, for reports.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Condition {
    pub state: ArmState,
    pub armings: u64,
    pub jumps: u64,
    pub drift_ppm: f64,
    /// Median, 99th percentile and longest of the last round trips (us).
    pub round_trips_us: Option<[u32; 3]>,
    /// The board's own counters, at most 1 s old.
    pub counters: Option<Counters>,
    /// Requests that it declined while it was armed.
    pub declined: u64,
    /// Restarts since the first arming, and the last reason (as in its hello).
    pub restarts: u64,
    pub reset_reason: u8,
    pub burst_us: Option<u64>,
    /// Lateness of samples since arming (periods), if it is too large.
    pub late: Option<f64>,
    /// Hottest reported motor (0.1 °C).
    pub hottest: Option<i16>,
}
