//! Intervals of acyclic frames, for the host and for plans of buses.

/// Time between two frames of bus time, where forces are for all boards (us).
pub(crate) const SYNC_US: u64 = 20_000;
/// Time between two round trips to a board whose clock is known (us).
pub(crate) const PING_US: u64 = 50_000;
/// Time between two requests for a board's counts (us).
pub(crate) const COUNTERS_US: u64 = 1_000_000;
/// Time between two requests for the health of a board, and of one of its keys by turns (us).
pub(crate) const HEALTH_US: u64 = 1_000_000;
