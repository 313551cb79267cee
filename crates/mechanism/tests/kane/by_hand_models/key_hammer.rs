//! The paper's models A and B.
//!
//! The key K pivots at P1 = (0, 0), the hammer H at P2 = (L3, L4); the slider pivots on K at the
//! distance L1 from P1 and slides along H. s is the key's angle in A, the manipulandum's in B.

use pode::{EnergyBalance, GuardValue, Motion};

use super::{After, ByHand, NamedGuard, Values, turned};

impl Values {
    /// Returns the gap between slider and hammer, L4 cos θh − L3 sin θh − L1 sin(θk − θh), and its
    /// rate.
    fn gap(&self, (h, wh): (f64, f64), (k, wk): (f64, f64)) -> GuardValue {
        let [l1, l3, l4] = self.of(["L1", "L3", "L4"]);
        let delta = k - h;
        let value = l4 * h.cos() - l3 * h.sin() - l1 * delta.sin();
        let rate = -(l4 * h.sin() + l3 * h.cos()) * wh - l1 * delta.cos() * (wk - wh);
        GuardValue::new(value, rate)
    }

    fn below_string(&self, (h, wh): (f64, f64)) -> GuardValue {
        let [string] = self.of(["string_angle"]);
        GuardValue::new(string - h, -wh)
    }

    /// Returns the moments of level hammer and key about their pivots: M2 g L2 and M1 g cK (N·m).
    fn moments(&self) -> [f64; 2] {
        let [m1, m2, g, l2, ck] = self.of(["M1", "M2", "g", "L2", "cK"]);
        [m2 * g * l2, m1 * g * ck]
    }

    /// Returns the kinetic energy and that of gravity, with heights from P1 (J).
    fn moving(&self, (h, wh): (f64, f64), (k, wk): (f64, f64)) -> f64 {
        let [jh, jk, m2, g, l4] = self.of(["JH", "JK", "M2", "g", "L4"]);
        let [hammer, key] = self.moments();
        0.5 * (jh * wh * wh + jk * wk * wk) + hammer * h.sin() + key * k.sin() + m2 * g * l4
    }

    fn thrown(&self, wh: f64) -> [f64; 2] {
        let [string, restitution] = self.of(["string_angle", "restitution"]);
        [string, -restitution * wh]
    }

    fn head(&self, wh: f64) -> f64 {
        let [l2] = self.of(["L2"]);
        l2 * wh.abs()
    }
}

/// Model A: rigid contact. A1: the hammer on the key; A2: in free flight. State θh, θh'.
pub(crate) struct Rigid(Values);

/// Hammer on a rigid key, as a function of s, s', s'', s'''.
struct Coupled {
    angle: f64,
    rate: f64,
    acceleration: f64,
    jerk: f64,
    /// Distance σ of the slider from P2 (m), and its rate.
    reach: f64,
    reach_rate: f64,
    /// Cosine cos(s − θh).
    cos_delta: f64,
}

impl Rigid {
    /// X = L1 cos s − L3, Y = L1 sin s − L4; θh = atan2(Y, X), σ = hypot(X, Y), δ = s − θh;
    /// σ θh' = L1 cos δ s' and σ' = −L1 sin δ s', and their derivatives.
    fn on_key(&self, s: &Motion) -> Coupled {
        let [l1, l3, l4] = self.0.of(["L1", "L3", "L4"]);
        let (x, y) = (l1 * s.position.cos() - l3, l1 * s.position.sin() - l4);
        let (angle, reach) = (y.atan2(x), x.hypot(y));
        let (sin, cos) = (s.position - angle).sin_cos();
        let (rate, reach_rate) = (l1 * cos * s.rate / reach, -l1 * sin * s.rate);
        let turning = s.rate - rate;
        let driven = l1 * (cos * s.acceleration - sin * turning * s.rate);
        let acceleration = (driven - reach_rate * rate) / reach;
        let reach_acceleration = -l1 * (cos * turning * s.rate + sin * s.acceleration);
        let turning_rate = s.acceleration - acceleration;
        let driven_rate = l1
            * (cos * (s.jerk - turning * turning * s.rate)
                - sin * (2.0 * turning * s.acceleration + turning_rate * s.rate));
        let bent = reach_acceleration * rate + 2.0 * reach_rate * acceleration;
        let jerk = (driven_rate - bent) / reach;
        Coupled { angle, rate, acceleration, jerk, reach, reach_rate, cos_delta: cos }
    }

    /// Returns F_KH = (JH θh'' + M2 g L2 cos θh)/σ and its rate.
    fn contact(&self, hammer: &Coupled) -> GuardValue {
        let [jh] = self.0.of(["JH"]);
        let [weight, _] = self.0.moments();
        let Coupled { angle, rate, reach, .. } = *hammer;
        let force = (jh * hammer.acceleration + weight * angle.cos()) / reach;
        let moment_rate = jh * hammer.jerk - weight * angle.sin() * rate;
        GuardValue::new(force, (moment_rate - force * hammer.reach_rate) / reach)
    }

    fn forces(&self, mode: &str, s: &Motion) -> [f64; 2] {
        let [jk, l1] = self.0.of(["JK", "L1"]);
        let key = jk * s.acceleration + self.0.moments()[1] * s.position.cos();
        let hammer = self.on_key(s);
        let contact = if mode == "A1" { self.contact(&hammer).value } else { 0.0 };
        [contact, key + contact * l1 * hammer.cos_delta]
    }
}

impl ByHand<2> for Rigid {
    fn new(values: Values) -> Self {
        Self(values)
    }

    fn constrain(&self, mode: &str, x: &[f64; 2], s: &Motion) -> [f64; 2] {
        let hammer = self.on_key(s);
        if mode == "A1" { [hammer.angle, hammer.rate] } else { *x }
    }

    fn derivative(&self, mode: &str, x: &[f64; 2], s: &Motion) -> [f64; 2] {
        let [jh] = self.0.of(["JH"]);
        let falling = -self.0.moments()[0] * x[0].cos() / jh;
        [x[1], if mode == "A1" { self.on_key(s).acceleration } else { falling }]
    }

    fn readout(&self, mode: &str, _x: &[f64; 2], s: &Motion) -> f64 {
        self.forces(mode, s)[1]
    }

    fn guards(&self, mode: &str, x: &[f64; 2], s: &Motion) -> Vec<NamedGuard> {
        let hammer = (x[0], x[1]);
        if mode == "A1" {
            return vec![("release", self.contact(&self.on_key(s)))];
        }
        let gap = self.0.gap(hammer, (s.position, s.rate));
        vec![("land", gap), ("string", self.0.below_string(hammer))]
    }

    /// A landing is plastic; its impulse acts on the key.
    fn reset(&self, _mode: &str, guard: &str, x: &[f64; 2], s: &Motion) -> After<2> {
        if guard == "release" {
            return After::to("A2", *x);
        }
        if guard == "string" {
            return After {
                sounds: Some(self.0.head(x[1])),
                ..After::to("A2", self.0.thrown(x[1]))
            };
        }
        let [jh, l1] = self.0.of(["JH", "L1"]);
        let hammer = self.on_key(s);
        let impulse = jh * (hammer.rate - x[1]) / hammer.reach * l1 * hammer.cos_delta;
        After { impulse, ..After::to("A1", [hammer.angle, hammer.rate]) }
    }

    fn balance(&self, mode: &str, x: &[f64; 2], s: &Motion) -> EnergyBalance {
        EnergyBalance {
            energy: self.0.moving((x[0], x[1]), (s.position, s.rate)),
            supplied: self.readout(mode, x, s) * s.rate,
            dissipated: 0.0,
        }
    }

    fn outputs(&self, mode: &str, x: &[f64; 2], s: &Motion) -> Vec<(&'static str, f64)> {
        let [contact, torque] = self.forces(mode, s);
        let gap = self.0.gap((x[0], x[1]), (s.position, s.rate)).value;
        vec![("F_KH", contact), ("T_KU", torque), ("gap", gap)]
    }
}

/// Model B: springs in the contacts. B1: the hammer on the key, through k2; B2: in free flight.
/// State θh, θk, θh', θk'.
pub(crate) struct Springs(Values);

/// Spring k2 and the slider, with δ = θk − θh.
struct Contact {
    /// Compression of k2 (m), (L1 sin δ − L4 cos θh + L3 sin θh)/cos δ, and its rate.
    q4: f64,
    q4_rate: f64,
    /// Position of the slider along H (m), (L1 − L3 cos θk − L4 sin θk)/cos δ.
    q3: f64,
    /// Slopes ∂q4/∂θh = −q3/cos δ and ∂q4/∂θk = L1 + q4 tan δ (m/rad).
    per_angle: [f64; 2],
    /// Stored part of the force, k2 q4 (N).
    spring: f64,
    /// Force F_KH = k2 q4 (1 + c2 q4'); the felt's factor never makes it pull.
    force: f64,
}

impl Springs {
    fn contact(&self, &[h, k, wh, wk]: &[f64; 4]) -> Contact {
        let [l1, l3, l4, k2, c2] = self.0.of(["L1", "L3", "L4", "k2", "c2"]);
        let delta = k - h;
        let q4 = (l1 * delta.sin() - l4 * h.cos() + l3 * h.sin()) / delta.cos();
        let q3 = (l1 - l3 * k.cos() - l4 * k.sin()) / delta.cos();
        let per_angle = [-q3 / delta.cos(), l1 + q4 * delta.tan()];
        let q4_rate = per_angle[0] * wh + per_angle[1] * wk;
        let spring = k2 * q4;
        let force = spring * (1.0 + c2 * q4_rate).max(0.0);
        Contact { q4, q4_rate, q3, per_angle, spring, force }
    }

    /// Returns T_KU = k1 (s − θk) + b1 (s' − θk') (N·m).
    fn coupling(&self, x: &[f64; 4], s: &Motion) -> f64 {
        let [k1, b1] = self.0.of(["k1", "b1"]);
        k1 * (s.position - x[1]) + b1 * (s.rate - x[3])
    }
}

impl ByHand<4> for Springs {
    fn new(values: Values) -> Self {
        Self(values)
    }

    fn constrain(&self, _mode: &str, x: &[f64; 4], _s: &Motion) -> [f64; 4] {
        *x
    }

    fn derivative(&self, mode: &str, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let [jh, jk] = self.0.of(["JH", "JK"]);
        let contact = self.contact(x);
        let [hammer, key] = self.0.moments();
        let force = if mode == "B1" { contact.force } else { 0.0 };
        let [on_hammer, on_key] = contact.per_angle.map(|per| force * per);
        let hammer = (-hammer * x[0].cos() - on_hammer) / jh;
        let key = (self.coupling(x, s) - key * x[1].cos() - on_key) / jk;
        [x[2], x[3], hammer, key]
    }

    fn readout(&self, _mode: &str, x: &[f64; 4], s: &Motion) -> f64 {
        self.coupling(x, s)
    }

    fn guards(&self, mode: &str, x: &[f64; 4], _s: &Motion) -> Vec<NamedGuard> {
        let gap = self.0.gap((x[0], x[2]), (x[1], x[3]));
        let contact = if mode == "B1" { ("release", turned(gap)) } else { ("land", gap) };
        vec![contact, ("string", self.0.below_string((x[0], x[2])))]
    }

    fn reset(&self, mode: &str, guard: &str, x: &[f64; 4], _s: &Motion) -> After<4> {
        match (mode, guard) {
            (_, "release") => After::to("B2", *x),
            (_, "land") => After::to("B1", *x),
            _ => {
                let [angle, rate] = self.0.thrown(x[2]);
                let mode = if mode == "B1" { "B1" } else { "B2" };
                let after = After::to(mode, [angle, x[1], rate, x[3]]);
                After { sounds: Some(self.0.head(x[2])), ..after }
            }
        }
    }

    fn balance(&self, mode: &str, x: &[f64; 4], s: &Motion) -> EnergyBalance {
        let [k1, b1] = self.0.of(["k1", "b1"]);
        let (twist, slip) = (s.position - x[1], s.rate - x[3]);
        let Contact { q4, q4_rate, spring, force, .. } = self.contact(x);
        let (stored, lost) = (0.5 * spring * q4, (force - spring) * q4_rate);
        let closed = if mode == "B1" { 1.0 } else { 0.0 };
        let own = self.0.moving((x[0], x[2]), (x[1], x[3]));
        EnergyBalance {
            energy: own + 0.5 * k1 * twist * twist + closed * stored,
            supplied: self.coupling(x, s) * s.rate,
            dissipated: b1 * slip * slip + closed * lost,
        }
    }

    fn outputs(&self, mode: &str, x: &[f64; 4], s: &Motion) -> Vec<(&'static str, f64)> {
        let gap = self.0.gap((x[0], x[2]), (x[1], x[3])).value;
        let Contact { q4, q3, force, .. } = self.contact(x);
        // Apart, the spring is slack and the slider is not on the hammer.
        let closed = if mode == "B1" { 1.0 } else { 0.0 };
        vec![
            ("F_KH", closed * force),
            ("T_KU", self.coupling(x, s)),
            ("gap", gap),
            ("q4", closed * q4),
            ("q3", closed * q3),
        ]
    }
}
