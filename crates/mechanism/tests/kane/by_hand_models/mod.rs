//! The paper's models A and B, and model C, by hand: independent equations for their descriptions.
//!
//! No line of `kane` is used here, and nothing is stated that the equations do not need. Modes,
//! guards, parameters and outputs have the names of the descriptions, with READMEs in
//! `crates/instruments/src` that define coordinates and symbols.

mod grand;
mod key_hammer;

use std::collections::BTreeMap;

use pode::{EnergyBalance, GuardValue, Motion};

pub(crate) use grand::Grand;
pub(crate) use key_hammer::{Rigid, Springs};

#[derive(Debug)]
pub(crate) struct Values(pub(crate) BTreeMap<&'static str, f64>);

impl Values {
    pub(crate) fn of<const K: usize>(&self, names: [&str; K]) -> [f64; K] {
        names.map(|name| *self.0.get(name).unwrap_or_else(|| panic!("no parameter {name}")))
    }
}

#[derive(Debug)]
pub(crate) struct After<const N: usize> {
    pub(crate) mode: &'static str,
    pub(crate) state: [f64; N],
    /// Impulse on the input, in its unit of force times seconds.
    pub(crate) impulse: f64,
    /// Speed at which the string sounds (m/s), if it does.
    pub(crate) sounds: Option<f64>,
}

impl<const N: usize> After<N> {
    const fn to(mode: &'static str, state: [f64; N]) -> Self {
        Self { mode, state, impulse: 0.0, sounds: None }
    }
}

pub(crate) type NamedGuard = (&'static str, GuardValue);

pub(crate) trait ByHand<const N: usize> {
    fn new(values: Values) -> Self;

    /// Sets entries that follow from the others, or from the input.
    fn constrain(&self, mode: &str, x: &[f64; N], s: &Motion) -> [f64; N];

    fn derivative(&self, mode: &str, x: &[f64; N], s: &Motion) -> [f64; N];

    fn readout(&self, mode: &str, x: &[f64; N], s: &Motion) -> f64;

    /// Returns the guards in the order in which simultaneous ones are handled.
    fn guards(&self, mode: &str, x: &[f64; N], s: &Motion) -> Vec<NamedGuard>;

    fn reset(&self, mode: &str, guard: &str, x: &[f64; N], s: &Motion) -> After<N>;

    fn balance(&self, mode: &str, x: &[f64; N], s: &Motion) -> EnergyBalance;

    fn outputs(&self, mode: &str, x: &[f64; N], s: &Motion) -> Vec<(&'static str, f64)>;
}

const fn turned(guard: GuardValue) -> GuardValue {
    GuardValue::new(-guard.value, -guard.rate)
}
