//! The derivation and what it gives, against hand-written models and closed forms.

mod assembled;
mod beside_hand_written;
mod bounds;
mod by_hand;
mod touching;
