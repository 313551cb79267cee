//! How often boards are told and asked what is not cyclic: as the host does it, and as plans of
//! buses count it.

/// Time between two frames of bus time, where forces are for all boards (us).
pub(crate) const SYNC_US: u64 = 20_000;
/// Time between two round trips to a board whose clock is known (us).
pub(crate) const PING_US: u64 = 50_000;
/// Time between two requests for what a board has counted (us).
pub(crate) const COUNTERS_US: u64 = 1_000_000;
/// Time between two requests for how a board is, and how one of its keys is by turns (us).
pub(crate) const HEALTH_US: u64 = 1_000_000;
