//! Variables of a loop, which can be axes of a map.

use haptics::RigParameters;

/// Longest delay of a force (periods).
pub const LONGEST_DELAY: f64 = 16.0;

/// A quantity of a loop.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LoopQuantity {
    Stiffness,
    Damping,
    Period,
    Delay,
    EncoderStep,
    Friction,
    Mass,
    DeviceDamping,
    Bandwidth,
    JerkDensity,
    Finger,
}

/// Names, units and ranges of a quantity.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct QuantityEntry {
    pub quantity: LoopQuantity,
    pub name: &'static str,
    pub title: &'static str,
    /// SI unit as typed; empty for a name or a ratio.
    pub unit: &'static str,
    /// Unit in pictures, and its number per SI unit.
    pub shown: (&'static str, f64),
    /// Allowed range (SI).
    pub range: (f64, f64),
    /// Default axis (SI).
    pub axis: (f64, f64),
}

use LoopQuantity::{
    Bandwidth, Damping, Delay, DeviceDamping, EncoderStep, Finger, Friction, JerkDensity, Mass,
    Period, Stiffness,
};

/// Every quantity, at the index of its number.
pub const QUANTITIES: [QuantityEntry; 11] = [
    QuantityEntry {
        quantity: Stiffness,
        name: "stiffness",
        title: "stiffness K",
        unit: "N/m",
        shown: ("kN/m", 1e-3),
        range: (0.0, 1e8),
        axis: (100.0, 200e3),
    },
    QuantityEntry {
        quantity: Damping,
        name: "damping",
        title: "damping B",
        unit: "N*s/m",
        shown: ("N·s/m", 1.0),
        range: (-1e3, 1e4),
        axis: (0.05, 200.0),
    },
    QuantityEntry {
        quantity: Period,
        name: "period",
        title: "period of the loop T",
        unit: "s",
        shown: ("ms", 1e3),
        range: (1e-5, 20e-3),
        axis: (0.1e-3, 10e-3),
    },
    QuantityEntry {
        quantity: Delay,
        name: "delay",
        title: "delay of the force",
        unit: "s",
        shown: ("ms", 1e3),
        range: (0.0, LONGEST_DELAY * 20e-3),
        axis: (0.0, 5e-3),
    },
    QuantityEntry {
        quantity: EncoderStep,
        name: "encoder-step",
        title: "step of the encoder",
        unit: "m",
        shown: ("µm", 1e6),
        range: (0.0, 10e-3),
        axis: (0.1e-6, 1e-3),
    },
    QuantityEntry {
        quantity: Friction,
        name: "friction",
        title: "friction of the key",
        unit: "N",
        shown: ("N", 1.0),
        range: (0.0, 10.0),
        axis: (0.0, 0.5),
    },
    QuantityEntry {
        quantity: Mass,
        name: "mass",
        title: "mass of the key",
        unit: "kg",
        shown: ("g", 1e3),
        range: (1e-8, 10.0),
        axis: (5e-3, 0.5),
    },
    QuantityEntry {
        quantity: DeviceDamping,
        name: "device-damping",
        title: "damping of the key b",
        unit: "N*s/m",
        shown: ("N·s/m", 1.0),
        range: (0.0, 100.0),
        axis: (0.1, 10.0),
    },
    QuantityEntry {
        quantity: Bandwidth,
        name: "bandwidth",
        title: "bandwidth of the motor (0 for no lag)",
        unit: "Hz",
        shown: ("Hz", 1.0),
        range: (0.0, 1e6),
        axis: (20.0, 5e3),
    },
    QuantityEntry {
        quantity: JerkDensity,
        name: "jerk-density",
        title: "jerk density of the Kalman filter",
        unit: "m^2/s^5",
        shown: ("m²/s⁵", 1.0),
        range: (1e-3, 1e12),
        axis: (1.0, 1e8),
    },
    QuantityEntry {
        quantity: Finger,
        name: "finger",
        title: "finger on the key",
        unit: "",
        shown: ("", 1.0),
        range: (0.0, 3.0),
        axis: (0.0, 3.0),
    },
];

/// Names of fingers, by their number.
pub const FINGERS: [&str; 4] = ["none", "limp", "ordinary", "stiff"];

/// Smallest step of an encoder (m): a key's travel fits into its counter.
pub(super) const FINEST_STEP: f64 = 1e-9;

impl LoopQuantity {
    pub const fn entry(self) -> &'static QuantityEntry {
        &QUANTITIES[self as usize]
    }

    pub fn named(name: &str) -> Option<Self> {
        QUANTITIES.iter().find(|it| it.name == name).map(|it| it.quantity)
    }
}

/// A value of every quantity (SI).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct LoopValues([f64; QUANTITIES.len()]);

impl LoopValues {
    /// Returns the theory's wall on the key of `rig`: no friction, motor lag, delay or counts.
    pub const fn ideal(rig: &RigParameters, period: f64, jerk_density: f64) -> Self {
        let (mass, damping) = (rig.key.mass, rig.key.damping);
        Self([2e3, 0.0, period, 0.0, 0.0, 0.0, mass, damping, 0.0, jerk_density, 0.0])
    }

    /// Returns the loop of a voice on `rig`, with no finger.
    pub fn of_rig(rig: &RigParameters, period: f64, jerk_density: f64) -> Self {
        let mut values = Self::ideal(rig, period, jerk_density);
        values.set(Stiffness, 0.0);
        values.set(EncoderStep, rig.quantum);
        values.set(Friction, rig.key.coulomb);
        let bandwidth = rig.motor.bandwidth / core::f64::consts::TAU;
        values.set(Bandwidth, if bandwidth.is_finite() { bandwidth } else { 0.0 });
        values
    }

    /// Returns the value of a quantity (SI).
    pub const fn get(&self, quantity: LoopQuantity) -> f64 {
        self.0[quantity as usize]
    }

    /// Sets the value of a quantity (SI).
    pub const fn set(&mut self, quantity: LoopQuantity, value: f64) {
        self.0[quantity as usize] = value;
    }

    /// Describes invalid combinations, in a sentence each.
    pub fn mistakes(&self) -> Vec<String> {
        let mut mistakes = Vec::new();
        for QuantityEntry { quantity, name, unit, range: (low, high), .. } in QUANTITIES {
            let value = self.get(quantity);
            if !(low..=high).contains(&value) {
                mistakes.push(format!("{name} must be from {low} to {high} {unit}, not {value}"));
            }
        }
        let (delay, period) = (self.get(Delay), self.get(Period));
        if mistakes.is_empty() && LONGEST_DELAY * period * (1.0 + 1e-9) < delay {
            mistakes.push(format!(
                "a delay of {delay} s is longer than {LONGEST_DELAY} periods of {period} s, the \
                 longest that is studied; give a shorter delay or a longer period"
            ));
        }
        let step = self.get(EncoderStep);
        if 0.0 < step && step < FINEST_STEP {
            mistakes.push(format!(
                "encoder-step must be 0 for no steps, or at least {FINEST_STEP} m, not {step}"
            ));
        }
        mistakes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_quantity_stands_at_its_number_and_has_an_axis_within_its_range() {
        for (number, entry) in QUANTITIES.iter().enumerate() {
            assert_eq!(entry.quantity as usize, number);
            assert_eq!(LoopQuantity::named(entry.name), Some(entry.quantity));
            let ((low, high), (from, to)) = (entry.range, entry.axis);
            assert!(low <= from && from < to && to <= high, "{}", entry.name);
        }
    }

    #[test]
    fn values_that_cannot_be_are_refused_in_a_sentence_each() {
        let mut values = LoopValues::of_rig(&RigParameters::default(), 1e-3, 1e5);
        assert_eq!(values.mistakes(), [""; 0]);
        values.set(Delay, 16e-3);
        assert_eq!(values.mistakes(), [""; 0]);
        values.set(Delay, 17e-3);
        let wrong = values.mistakes();
        assert!(wrong.len() == 1 && wrong[0].contains("longer than 16 periods"), "{wrong:?}");
        values.set(Period, -1e-3);
        values.set(EncoderStep, 1e-12);
        let wrong = values.mistakes();
        assert!(wrong.len() == 2 && wrong[0].contains("period must be from"), "{wrong:?}");
        values.set(Period, f64::NAN);
        assert_eq!(values.mistakes().len(), 2);
    }
}
