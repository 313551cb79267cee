//! `letoff lab piano`: the figures of an instrument's action, beside three measured grands.

mod sheet;

pub use sheet::write_sheet;
