//! Power series of tapes, against closed forms, exact derivatives, and each other.

mod functions;
mod straight;
