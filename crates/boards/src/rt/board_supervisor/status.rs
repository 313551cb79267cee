//! What is known of a board, for monitors and reports.

use firmware_protocol::acyclic::counters::Counters;

use super::arm_state::ArmState;

/// How a board is, cheap enough for a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct BoardStatus {
    pub state: ArmState,
    /// Times that it was armed.
    pub armings: u64,
    /// Median of the latest round trips (us), if there were any.
    pub round_trip_us: Option<u32>,
    /// How often it has restarted of late, and why the last time (as in its hello).
    pub restarts: u8,
    pub reset_reason: u8,
    /// Time between bursts of samples (us), if they come in bursts.
    pub burst_us: Option<u64>,
    /// By how many periods samples are later than when it was armed, if that is too much.
    pub late: Option<f64>,
}

/// What a board is like, for reports.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Condition {
    pub state: ArmState,
    /// Times that it was armed.
    pub armings: u64,
    /// Times that its clock jumped.
    pub jumps: u64,
    /// Drift of its clock (1e-6).
    pub drift_ppm: f64,
    /// Median, 99th hundredth and longest of the last round trips (us).
    pub round_trips_us: Option<[u32; 3]>,
    /// What it has counted itself, a second ago at most.
    pub counters: Option<Counters>,
    /// Requests that it declined while it was armed.
    pub declined: u64,
    /// Times that it has restarted since it was armed first, and why the last time (as in its
    /// hello).
    pub restarts: u64,
    pub reset_reason: u8,
    /// Time between bursts of samples (us), if they come in bursts.
    pub burst_us: Option<u64>,
    /// By how many periods samples are later than when it was armed, if that is too much.
    pub late: Option<f64>,
    /// The hottest motor that it has reported (0.1 °C).
    pub hottest: Option<i16>,
}
