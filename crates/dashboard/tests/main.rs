//! The window, as a user sees and clicks it.

mod common;
mod foreign;
mod panels;
mod scopes;
mod snapshots;
