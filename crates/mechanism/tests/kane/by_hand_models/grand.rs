//! Model C: a grand's key and hammer with let-off, check and repetition.
//!
//! State y (m) key front, down; z (m) hammer head, up; u = y', w = z'. s is the finger's position.

use std::f64::consts::LN_2;

use instruments::equations::functions::{logistic, softplus, softplus_area, softplus_square_area};
use pode::{EnergyBalance, GuardValue, Motion};

use super::{After, ByHand, NamedGuard, Values, turned};

pub(crate) struct Grand(Values);

/// Head on the key: z = ζ(y).
struct Head {
    height: f64,
    ratio: f64,
    /// Second derivative ζ'' (1/m).
    bend: f64,
    /// Force on the key over force on the head: ζ' and the part of friction.
    transmission: f64,
}

impl Head {
    const fn straight(height: f64, ratio: f64) -> Self {
        Self { height, ratio, bend: 0.0, transmission: ratio }
    }
}

/// Felt with a soft onset: F = k w² sp(x/w)² max(1 + a x', 0), with x the depth in it.
struct Felt {
    k: f64,
    w: f64,
    a: f64,
    depth: f64,
    rate: f64,
}

impl Felt {
    fn spring(&self) -> f64 {
        self.k * self.w.powi(2) * softplus(self.depth / self.w).powi(2)
    }

    fn factor(&self) -> f64 {
        (1.0 + self.a * self.rate).max(0.0)
    }

    fn force(&self) -> f64 {
        self.spring() * self.factor()
    }

    fn energy(&self) -> f64 {
        self.k * self.w.powi(3) * softplus_square_area(self.depth / self.w)
    }

    fn lost(&self) -> f64 {
        self.spring() * (self.factor() - 1.0) * self.rate
    }

    /// Returns ∂F/∂x and ∂F/∂x'.
    fn slopes(&self) -> [f64; 2] {
        let x = self.depth / self.w;
        let per_rate = if self.factor() > 0.0 { self.spring() * self.a } else { 0.0 };
        [2.0 * self.k * self.w * softplus(x) * logistic(x) * self.factor(), per_rate]
    }
}

impl Grand {
    fn felts(&self, y: f64, u: f64) -> [Felt; 2] {
        let [bed, w] = self.0.of(["ybed", "wf"]);
        let [kb, ab, kr, ar] = self.0.of(["Kb", "ab", "Kr", "ar"]);
        let bed = Felt { k: kb, w, a: ab, depth: y - bed, rate: u };
        [bed, Felt { k: kr, w, a: ar, depth: -y, rate: -u }]
    }

    /// Returns F_KU = k1 (s − y) + b1 (s' − u) (N).
    fn finger(&self, y: f64, u: f64, s: &Motion) -> f64 {
        let [k1, b1] = self.0.of(["k1", "b1"]);
        k1 * (s.position - y) + b1 * (s.rate - u)
    }

    /// Returns S, the resistance of the key's own parts to going down (N).
    fn load(&self, y: f64, u: f64) -> f64 {
        let [weight, dry, slow, viscous] = self.0.of(["Wk", "Fc", "vc", "ck"]);
        let [kj, wj, yb] = self.0.of(["kj", "wj", "yb"]);
        let [bed, rail] = self.felts(y, u);
        let rubbing = dry * (u / slow).tanh() + viscous * u;
        let jack = kj * wj * softplus((y - yb) / wj);
        weight + rubbing + jack + bed.force() - rail.force()
    }

    /// Returns the rate of F_KU − S while the key accelerates at `a` (N/s).
    fn push_rate(&self, y: f64, u: f64, a: f64, s: &Motion) -> f64 {
        let [k1, b1, dry, slow, viscous] = self.0.of(["k1", "b1", "Fc", "vc", "ck"]);
        let [kj, wj, yb] = self.0.of(["kj", "wj", "yb"]);
        let [bed, rail] = self.felts(y, u).map(|felt| felt.slopes());
        let stiffness = kj * logistic((y - yb) / wj) + bed[0] + rail[0];
        let rubbing = dry / slow * (1.0 - (u / slow).tanh().powi(2)) + viscous;
        let damping = rubbing + bed[1] + rail[1];
        k1 * (s.rate - u) + b1 * (s.acceleration - a) - stiffness * u - damping * a
    }

    /// Returns ξ and D of the let-off from the button at yb to the trip at yt = yb + D.
    fn let_off(&self, y: f64) -> [f64; 2] {
        let [ratio, yb, zt, rho] = self.0.of(["R", "yb", "zt", "rho"]);
        let travel = (2.0 * (zt - ratio * yb) / (ratio * (1.0 + rho))).max(1e-6);
        [(y - yb) / travel, travel]
    }

    /// Returns the head on the tripping jack: Z = zb + R D (ξ − ξ² (1 − ρ)/2).
    fn at_button(&self, y: f64, u: f64) -> Head {
        let [ratio, yb, rho, nu, slow] = self.0.of(["R", "yb", "rho", "nu", "vc"]);
        let [xi, travel] = self.let_off(y);
        let slope = ratio * (1.0 - xi * (1.0 - rho));
        let rubbing = 16.0 * nu * (xi * (1.0 - xi)).powi(2) * (u / slow).tanh();
        Head {
            height: ratio * yb + ratio * travel * (xi - 0.5 * xi * xi * (1.0 - rho)),
            ratio: slope,
            bend: -ratio * (1.0 - rho) / travel,
            transmission: slope + rubbing,
        }
    }

    /// Returns the head in check: Zc = zc + Rc (y − ybed).
    fn in_check(&self, y: f64) -> Head {
        let [zc, rc, bed] = self.0.of(["zc", "Rc", "ybed"]);
        Head::straight(zc + rc * (y - bed), rc)
    }

    /// Returns the head on the key, if the key carries it in `mode`.
    fn carried(&self, mode: &str, y: f64, u: f64) -> Option<Head> {
        let [ratio] = self.0.of(["R"]);
        match mode {
            "ACC" => Some(Head::straight(ratio * y, ratio)),
            "LO" => Some(self.at_button(y, u)),
            "CHK" => Some(self.in_check(y)),
            _ => None,
        }
    }

    /// Returns the end of the repetition lever, Zr = o_r + R (y − wd sp(a)), a = (y − yd)/wd, and
    /// Zr'.
    fn lever(&self, y: f64) -> [f64; 2] {
        let [ratio, offset, yd, wd] = self.0.of(["R", "o_r", "yd", "wd"]);
        let a = (y - yd) / wd;
        [offset + ratio * (y - wd * softplus(a)), ratio * (1.0 - logistic(a))]
    }

    /// Returns the repetition spring on the head, kr d sp(cr d')/ln 2 with d = Zr − z, kr d, and
    /// d'.
    fn lever_force(&self, [y, z, u, w]: [f64; 4]) -> [f64; 3] {
        let [kr, cr] = self.0.of(["kr", "cr"]);
        let [height, ratio] = self.lever(y);
        let (spring, rate) = (kr * (height - z), ratio * u - w);
        [spring * softplus(cr * rate) / LN_2, spring, rate]
    }

    fn string_force(&self, z: f64, w: f64) -> [f64; 2] {
        let [zs, ks, ps, mus] = self.0.of(["zs", "Ks", "ps", "mus"]);
        let spring = ks * (z - zs).max(0.0).powf(ps);
        [spring * (1.0 + mus * w).max(0.0), spring]
    }

    /// Returns the force on a carried head without ζ' y'': mh (ζ'' u² + g) + ch ζ' u (N).
    fn burden(&self, head: &Head, u: f64) -> f64 {
        let [mh, g, ch] = self.0.of(["mh", "g", "ch"]);
        mh * (head.bend * u * u + g) + ch * head.ratio * u
    }

    fn with_head(&self, mode: &str, head: &Head, x: &[f64; 4], s: &Motion) -> f64 {
        let [mk, mh, kr] = self.0.of(["mk", "mh", "kr"]);
        let [y, _, u, _] = *x;
        let [height, ratio] = self.lever(y);
        // The repetition spring stays under a head in check.
        let spring = if mode == "CHK" { kr * (height - head.height) } else { 0.0 };
        let push = self.finger(y, u, s) - self.load(y, u) + spring * (head.ratio - ratio);
        (push - head.transmission * self.burden(head, u))
            / (mk + mh * head.transmission * head.ratio)
    }

    /// Returns λ, the jack's force on the head in ACC and LO (N).
    fn jack_force(&self, mode: &str, x: &[f64; 4], s: &Motion) -> Option<f64> {
        let [mh] = self.0.of(["mh"]);
        let head = self.carried(mode, x[0], x[2]).filter(|_| mode != "CHK")?;
        Some(mh * head.ratio * self.with_head(mode, &head, x, s) + self.burden(&head, x[2]))
    }

    /// Returns λ (mk + mh t ζ')/mk and its rate, which vanish with λ and contain no friction of the
    /// let-off: mh ζ' (Fu − S)/mk + mh (ζ'' u² + g) + ch ζ' u.
    fn lift_off(&self, mode: &str, head: &Head, x: &[f64; 4], s: &Motion) -> GuardValue {
        let [mk, mh, ch] = self.0.of(["mk", "mh", "ch"]);
        let ([y, _, u, _], &Head { ratio, bend, .. }) = (*x, head);
        let push = self.finger(y, u, s) - self.load(y, u);
        let a = self.with_head(mode, head, x, s);
        let rate = mh / mk * (bend * u * push + ratio * self.push_rate(y, u, a, s))
            + 2.0 * mh * bend * u * a
            + ch * (bend * u * u + ratio * a);
        GuardValue::new(mh / mk * ratio * push + self.burden(head, u), rate)
    }

    /// Lands a head on a part that moves at `ratio`: u⁺ = (mk u + mh r w)/(mk + r² mh), w⁺ = r u⁺.
    fn caught(&self, ratio: f64, [y, z, u, w]: [f64; 4]) -> [f64; 4] {
        let [mk, mh] = self.0.of(["mk", "mh"]);
        let speed = (mk * u + mh * ratio * w) / (mk + mh * ratio * ratio);
        [y, z, speed, ratio * speed]
    }
}

impl ByHand<4> for Grand {
    fn new(values: Values) -> Self {
        Self(values)
    }

    fn constrain(&self, mode: &str, x: &[f64; 4], _s: &Motion) -> [f64; 4] {
        let [y, _, u, _] = *x;
        self.carried(mode, y, u).map_or(*x, |head| [y, head.height, u, head.ratio * u])
    }

    fn derivative(&self, mode: &str, x: &[f64; 4], s: &Motion) -> [f64; 4] {
        let [mk, mh, g, ch] = self.0.of(["mk", "mh", "g", "ch"]);
        let [y, z, u, w] = *x;
        if let Some(head) = self.carried(mode, y, u) {
            let a = self.with_head(mode, &head, x, s);
            return [u, head.ratio * u, a, head.ratio * a + head.bend * u * u];
        }
        let (on_key, on_head) = match mode {
            "STU" | "STT" => (0.0, -self.string_force(z, w)[0]),
            "REPH" | "REPL" | "REP0" => {
                let [force, ..] = self.lever_force(*x);
                (-self.lever(y)[1] * force, force)
            }
            _ => (0.0, 0.0),
        };
        let key = (self.finger(y, u, s) - self.load(y, u) + on_key) / mk;
        [u, w, key, -g + (on_head - ch * w) / mh]
    }

    fn readout(&self, _mode: &str, x: &[f64; 4], s: &Motion) -> f64 {
        self.finger(x[0], x[2], s)
    }

    fn guards(&self, mode: &str, x: &[f64; 4], s: &Motion) -> Vec<NamedGuard> {
        let [ratio, yb, zs, yck, yco, yrs] = self.0.of(["R", "yb", "zs", "yck", "yco", "yrs"]);
        let [y, z, u, w] = *x;
        let (above, beyond) = (
            |place: f64| GuardValue::new(place - y, -u),
            |place: f64| GuardValue::new(y - place, u),
        );
        let over = |height: f64, slope: f64| GuardValue::new(z - height, w - slope * u);
        let [lever, slope] = self.lever(y);
        let lift_off = || {
            let head = self.carried(mode, y, u).expect("a head on the jack");
            ("lift-off", self.lift_off(mode, &head, x, s))
        };
        let (button, button_off) = (("button", above(yb)), ("button-off", beyond(yb)));
        let trip = ("trip", above(yb + self.let_off(y)[1]));
        let string_on = ("string-on", GuardValue::new(zs - z, -w));
        let string_off = ("string-off", GuardValue::new(z - zs, w));
        let (rep_on, reset) = (("rep-on", over(lever, slope)), ("reset", beyond(yrs)));
        let rep_off = ("rep-off", turned(over(lever, slope)));
        match mode {
            "ACC" => vec![lift_off(), button],
            "LO" => vec![lift_off(), button_off, trip],
            "FLA" => vec![button, ("land", over(ratio * y, ratio)), string_on],
            "FLL" => {
                let head = self.at_button(y, u);
                vec![button_off, trip, ("land", over(head.height, head.ratio)), string_on]
            }
            "FLT" => vec![string_on, rep_on, reset],
            "STU" => vec![trip, string_off],
            "STT" => vec![string_off, reset],
            "REPH" => {
                let head = self.in_check(y);
                vec![rep_off, ("check", over(head.height, head.ratio)), ("check-far", beyond(yck))]
            }
            "REPL" => vec![rep_off, ("check-near", above(yck)), reset],
            "REP0" => {
                let jack_in = turned(over(ratio * y, ratio));
                vec![rep_off, ("jack-in", jack_in), ("jack-out", above(yrs))]
            }
            _ => vec![("check-off", beyond(yco))],
        }
    }

    /// Landing and check are plastic, the string is met exactly; other events keep the state.
    fn reset(&self, mode: &str, guard: &str, x: &[f64; 4], _s: &Motion) -> After<4> {
        let [ratio, rc, yb, zs, yck] = self.0.of(["R", "Rc", "yb", "zs", "yck"]);
        let [y, z, u, w] = *x;
        let has_room = z > ratio * y;
        let (to, state) = match (mode, guard) {
            ("FLA", "land") => ("ACC", self.caught(ratio, *x)),
            ("FLL", "land") => ("LO", self.caught(self.at_button(y, u).ratio, *x)),
            (_, "check") => ("CHK", self.caught(rc, *x)),
            (_, "string-on") => {
                let to = if mode == "FLT" { "STT" } else { "STU" };
                return After { sounds: Some(w.abs()), ..After::to(to, [y, zs, u, w]) };
            }
            ("STT", "string-off") | ("LO" | "FLL", "trip") | ("REPH" | "REPL", "rep-off") => {
                ("FLT", *x)
            }
            (_, "string-off") if y >= yb => ("FLL", *x),
            ("LO", "lift-off") | ("FLA", "button") => ("FLL", *x),
            (_, "button") => ("LO", *x),
            ("LO", "button-off") => ("ACC", *x),
            ("STU", "trip") => ("STT", *x),
            ("STT", "reset") => ("STU", *x),
            (_, "reset") if !has_room => ("REP0", *x),
            (_, "rep-on") if y > yck => ("REPH", *x),
            (_, "check-near") => ("REPH", *x),
            (_, "rep-on" | "check-far" | "check-off" | "jack-out") => ("REPL", *x),
            _ => ("FLA", *x),
        };
        After::to(to, state)
    }

    fn balance(&self, mode: &str, x: &[f64; 4], s: &Motion) -> EnergyBalance {
        let [mk, mh, g, weight, k1, b1] = self.0.of(["mk", "mh", "g", "Wk", "k1", "b1"]);
        let [kj, wj, yb, zs, ps, kr] = self.0.of(["kj", "wj", "yb", "zs", "ps", "kr"]);
        let [dry, slow, viscous, ch] = self.0.of(["Fc", "vc", "ck", "ch"]);
        let [y, z, u, w] = *x;
        let (bent, slip) = (s.position - y, s.rate - u);
        let felts = self.felts(y, u);
        let mut energy = 0.5 * (mk * u * u + mh * w * w + k1 * bent * bent)
            + weight * y
            + mh * g * z
            + kj * wj * wj * softplus_area((y - yb) / wj)
            + felts.iter().map(Felt::energy).sum::<f64>();
        let rubbing = dry * (u / slow).tanh() + viscous * u;
        let felt: f64 = felts.iter().map(Felt::lost).sum();
        let mut dissipated = b1 * slip * slip + ch * w * w + rubbing * u + felt;
        match mode {
            "LO" => {
                let head = self.at_button(y, u);
                let force = self.jack_force(mode, x, s).expect("a head on the jack");
                dissipated += (head.transmission - head.ratio) * u * force;
            }
            "STU" | "STT" => {
                let [force, spring] = self.string_force(z, w);
                energy += spring * (z - zs) / (ps + 1.0);
                dissipated += (force - spring) * w;
            }
            "REPH" | "REPL" | "REP0" => {
                let [force, spring, rate] = self.lever_force(*x);
                energy += 0.5 * spring * spring / kr;
                dissipated += (force - spring) * rate;
            }
            "CHK" => energy += 0.5 * kr * (self.lever(y)[0] - z).powi(2),
            _ => {}
        }
        let supplied = self.finger(y, u, s) * s.rate;
        EnergyBalance { energy, supplied, dissipated }
    }

    fn outputs(&self, mode: &str, x: &[f64; 4], s: &Motion) -> Vec<(&'static str, f64)> {
        let [kr] = self.0.of(["kr"]);
        let [y, z, u, w] = *x;
        let lever = match mode {
            "REPH" | "REPL" | "REP0" => self.lever_force(*x)[0],
            "CHK" => kr * (self.lever(y)[0] - self.in_check(y).height),
            _ => 0.0,
        };
        let string = if mode.starts_with("ST") { self.string_force(z, w)[0] } else { 0.0 };
        let jack = self.jack_force(mode, x, s).unwrap_or(0.0);
        let finger = self.finger(y, u, s);
        vec![("F_KU", finger), ("F_jack", jack), ("F_lever", lever), ("F_string", string)]
    }
}
