//! The derivation and what it gives, against hand-written models and closed forms.

mod assembled;
mod by_hand;
