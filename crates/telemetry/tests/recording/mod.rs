//! Recordings return their messages, whatever happened to the file.

mod bad_input;
mod black_box;
mod csv;
mod declared;
mod killed;
mod playback;
mod rotation;
mod round_trip;
mod tears;
