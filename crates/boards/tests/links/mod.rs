//! Links: the checklist, faults, and real drivers.

mod can;
mod conformance;
mod faulty;
mod serial_pty;
