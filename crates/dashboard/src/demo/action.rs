//! A key and a hammer on springs, well enough to look at: not one of the host's models.

use telemetry::Parameter;

/// Steps of each tick.
const STEPS: u32 = 20;
/// Hammer travel for each metre of the key's front.
const RATIO: f64 = 5.0;
/// Where the key's front meets the felt (m).
pub(super) const BOTTOM: f64 = 9.5e-3;
/// Where the hammer meets the string (m).
pub(super) const STRING: f64 = 0.0515;
/// From the hammer's axis to its head (m).
pub(super) const HAMMER: f64 = 0.13;
/// From the key's axis to its front (m).
pub(super) const FRONT: f64 = 0.22;
/// How far the hammer could fall below the key at rest (m).
const REST: f64 = 2e-3;
const GRAVITY: f64 = 9.81;
const FELT: f64 = 3.0e4;

/// Values of the parameters, in the order of [`parameters`].
pub(super) type DemoValues = [f64; 6];

/// Returns the parameters of the demonstration.
pub(super) fn parameters() -> Vec<Parameter> {
    let list = [
        ("k2", "N/m", 500.0, 20_000.0, "stiffness of the knuckle between key and hammer"),
        ("r2", "N s/m", 0.0, 20.0, "damping of the knuckle"),
        ("m_h", "kg", 0.002, 0.03, "mass of the hammer at its head"),
        ("m_k", "kg", 0.02, 0.4, "mass of the key at its front"),
        ("balance", "N", 0.0, 2.0, "weight with which the key comes back"),
        ("restitution", "", 0.0, 0.95, "speed that the string leaves the hammer"),
    ];
    let parameter = |(name, unit, min, max, doc): (&str, &str, f64, f64, &str)| Parameter {
        name: name.into(),
        unit: unit.into(),
        min,
        max,
        doc: doc.into(),
        ..Parameter::default()
    };
    list.into_iter().map(parameter).collect()
}

/// An event in a tick.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum DemoEvent {
    /// The hammer left the key, or came back.
    Switch { from: u8, to: u8, theta: f64 },
    /// The hammer met the string.
    Strike { speed: f64, theta: f64 },
}

/// The state of a key and its hammer.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct DemoAction {
    /// The key's front, down positive (m), and its speed.
    pub(super) key: [f64; 2],
    /// The hammer's head, up positive (m), and its speed.
    pub(super) hammer: [f64; 2],
    /// 0 on the key, 1 in flight.
    pub(super) mode: u8,
    /// What the finger feels (N).
    pub(super) force: f64,
}

impl DemoAction {
    /// Advances by a tick of `period` (s) under a finger's `push` (N).
    pub(super) fn advance(
        &mut self,
        values: &DemoValues,
        push: f64,
        period: f64,
    ) -> Vec<DemoEvent> {
        let h = period / f64::from(STEPS);
        let mut events = Vec::new();
        for i in 0..STEPS {
            let theta = f64::from(i + 1) / f64::from(STEPS);
            self.step(values, push, h);
            let mode = u8::from(self.squeeze() <= 0.0);
            if mode != self.mode {
                events.push(DemoEvent::Switch { from: self.mode, to: mode, theta });
                self.mode = mode;
            }
            if STRING <= self.hammer[0] && 0.0 < self.hammer[1] {
                events.push(DemoEvent::Strike { speed: self.hammer[1], theta });
                self.hammer = [STRING, -values[5] * self.hammer[1]];
            }
        }
        events
    }

    fn step(&mut self, values: &DemoValues, push: f64, h: f64) {
        let [_, _, m_h, m_k, balance, _] = *values;
        let contact = self.contact(values);
        let over = (self.key[0] - BOTTOM).max(0.0) + self.key[0].min(0.0);
        let felt = if over.abs() < 1e-12 { 0.0 } else { FELT * over + 60.0 * self.key[1] };
        let key = (push - balance - RATIO * contact - felt) / m_k - 1.5 * self.key[1];
        let rest = (-8e3 * (self.hammer[0] + REST)).max(0.0);
        let hammer = (contact + rest) / m_h - GRAVITY - 0.5 * self.hammer[1];
        self.key[1] += h * key;
        self.key[0] += h * self.key[1];
        self.hammer[1] += h * hammer;
        self.hammer[0] += h * self.hammer[1];
        self.force = balance + RATIO * contact;
    }

    /// Returns the compression of the knuckle (m).
    fn squeeze(&self) -> f64 {
        RATIO * self.key[0] - self.hammer[0]
    }

    /// Returns the force in the knuckle (N).
    fn contact(&self, values: &DemoValues) -> f64 {
        let squeeze = self.squeeze();
        if squeeze <= 0.0 {
            return 0.0;
        }
        (values[0] * squeeze + values[1] * (RATIO * self.key[1] - self.hammer[1])).max(0.0)
    }

    /// Returns whether nothing moves that could be seen.
    pub(super) fn is_still(&self) -> bool {
        self.key[0] < 2e-4
            && self.hammer[0] < 1e-3
            && self.key[1].abs() < 1e-4
            && self.hammer[1].abs() < 1e-3
    }

    /// Returns the signals, in the order of the catalogue.
    pub(super) fn signals(&self, values: &DemoValues) -> [f64; 8] {
        let contact = self.contact(values);
        [
            self.hammer[0] / HAMMER,
            self.key[0] / FRONT,
            self.hammer[1] / HAMMER,
            self.key[1] / FRONT,
            contact,
            -self.squeeze(),
            STRING - self.hammer[0],
            RATIO * contact,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stroke_throws_the_hammer_which_strikes_and_is_caught() {
        let values = [6000.0, 3.0, 0.0095, 0.08, 0.25, 0.4];
        let mut action = DemoAction::default();
        let mut events = Vec::new();
        for tick in 0..1500 {
            let push = if (200..500).contains(&tick) { 6.0 } else { 0.0 };
            events.extend(action.advance(&values, push, 1e-3));
        }
        let strikes = events.iter().filter(|it| matches!(it, DemoEvent::Strike { .. })).count();
        let switches = events.iter().filter(|it| matches!(it, DemoEvent::Switch { .. })).count();
        assert!(1 <= strikes, "{events:?}");
        assert!(2 <= switches, "{events:?}");
        assert!(action.key[0].abs() < 1e-3, "{action:?}");
    }
}
