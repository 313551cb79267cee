//! Simulated boards and their keybed, on links in memory through the same bus as real boards.

pub mod board;
mod force_interlock;
mod force_law;
pub mod key;
pub mod keybed;
#[cfg(test)]
mod tests;
