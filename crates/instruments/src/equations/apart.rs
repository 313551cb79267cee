//! A struck contact, followed in small parts of a step while all else is stepped once.

use pode::math;

/// Longest part of a step (s), and largest angle of the contact's rate in one (rad).
const PART: f64 = 6.25e-5;
const RADIANS: f64 = 0.2;

const MOST_PARTS: f64 = 128.0;

/// Time (s) by which a step may end behind the opening of the contact.
const MARGIN: f64 = 1e-6;

/// A contact at the start of a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct StruckContact {
    /// Depth (m) and its rate (m/s).
    pub(crate) depth: f64,
    pub(crate) rate: f64,
    /// Acceleration of the depth by all other forces (m/s²).
    pub(crate) acceleration: f64,
    /// Inverse of the mass that the contact moves (1/kg).
    pub(crate) mobility: f64,
}

/// Effect of a contact over a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Pulse {
    /// Changes of the depth (m) and of its rate (m/s).
    pub(crate) depth: f64,
    pub(crate) rate: f64,
    /// Energy (J) lost, beyond what the powers at the ends show.
    pub(crate) absorbed: f64,
}

struct PulseEnd {
    depth: f64,
    rate: f64,
    lost: f64,
    /// Largest square of the rate (rad²/s²).
    fastest: f64,
    /// Time of the opening (s).
    opens: Option<f64>,
}

impl StruckContact {
    /// Returns the pulse over `h` (s), or the length of a step that ends where the contact opens.
    ///
    /// `law` gives the force (N) and its slopes by depth and rate. Leapfrog steps, implicit in the
    /// loss: the speed of the exit errs by a thousandth at most, as their energy is known to the
    /// square of the angle, and the parts of the next step are others.
    pub(crate) fn pulse(
        &self,
        h: f64,
        law: impl Fn(f64, f64) -> [f64; 3] + Copy,
    ) -> Result<Pulse, f64> {
        // The rate to come: of the depth in the middle of the step.
        let [_, stiffness, _] = law((self.depth + 0.5 * h * self.rate).max(0.0), self.rate);
        let radians = h * math::sqrt(self.mobility * stiffness.max(0.0));
        let mut parts = math::ceil((h / PART).max(radians / RADIANS)).min(MOST_PARTS);
        let mut end = self.follow(h / parts, h, law);
        while math::sqrt(end.fastest) * h > RADIANS * parts && parts < MOST_PARTS {
            parts = (2.0 * parts).min(MOST_PARTS);
            end = self.follow(h / parts, h, law);
        }
        if let Some(after) = end.opens.filter(|after| *after < h - MARGIN) {
            return Err(after + 0.5 * MARGIN);
        }
        let at_ends = power(law, self.depth, self.rate) + power(law, end.depth, end.rate);
        Ok(Pulse {
            depth: end.depth - (self.depth + h * (self.rate + 0.5 * h * self.acceleration)),
            rate: end.rate - (self.rate + h * self.acceleration),
            absorbed: end.lost - 0.5 * h * at_ends,
        })
    }

    fn follow(&self, part: f64, h: f64, law: impl Fn(f64, f64) -> [f64; 3] + Copy) -> PulseEnd {
        let mut it =
            PulseEnd { depth: self.depth, rate: self.rate, lost: 0.0, fastest: 0.0, opens: None };
        let mut passed = 0.0;
        while passed < h - 0.5 * part {
            let middle = (it.depth + 0.5 * part * it.rate).max(0.0);
            let [force, stiffness, loss] = law(middle, it.rate);
            let push = part * (self.acceleration - self.mobility * force);
            let change = push / (1.0 + 0.5 * part * self.mobility * loss);
            let mean = it.rate + 0.5 * change;
            // Laws are linear in the rate, down to a force of 0.
            let elastic = if force > 0.0 { force - loss * it.rate } else { law(middle, 0.0)[0] };
            it.lost += part * (force + 0.5 * loss * change - elastic) * mean;
            it.fastest = it.fastest.max(self.mobility * stiffness);
            let depth = it.depth + part * mean;
            if depth < 0.0 && it.opens.is_none() {
                it.opens = Some(passed + part * it.depth.max(0.0) / (it.depth.max(0.0) - depth));
            }
            (it.depth, it.rate) = (depth, it.rate + change);
            passed += part;
        }
        it
    }
}

/// Returns the power that the law absorbs (W).
fn power(law: impl Fn(f64, f64) -> [f64; 3] + Copy, depth: f64, rate: f64) -> f64 {
    (force(law, depth, rate) - force(law, depth, 0.0)) * rate
}

fn force(law: impl Fn(f64, f64) -> [f64; 3], depth: f64, rate: f64) -> f64 {
    let [force, ..] = law(depth.max(0.0), rate);
    force
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOBILITY: f64 = 100.0;
    const STIFFNESS: f64 = 1e6;

    fn spring(depth: f64, _rate: f64) -> [f64; 3] {
        [STIFFNESS * depth, STIFFNESS, 0.0]
    }

    /// Follows a strike until the contact opens; returns the time, the speed and the energy lost.
    fn strike(law: impl Fn(f64, f64) -> [f64; 3] + Copy, h: f64) -> (f64, f64, f64) {
        let mut contact =
            StruckContact { depth: 0.0, rate: 3.0, acceleration: 0.0, mobility: MOBILITY };
        let (mut passed, mut lost, mut next) = (0.0, 0.0, h);
        for _ in 0..1000 {
            match contact.pulse(next, law) {
                Err(shorter) => next = shorter,
                Ok(pulse) => {
                    let start = power(law, contact.depth, contact.rate);
                    contact.depth += next * contact.rate + pulse.depth;
                    contact.rate += pulse.rate;
                    lost += pulse.absorbed
                        + 0.5 * next * (start + power(law, contact.depth, contact.rate));
                    passed += next;
                    next = h;
                }
            }
            if contact.depth < 0.0 {
                return (passed, contact.rate, lost);
            }
        }
        panic!("it stays closed: {contact:?}");
    }

    #[test]
    fn a_mass_leaves_a_spring_after_half_a_period_with_its_speed() {
        let half = core::f64::consts::PI / (STIFFNESS * MOBILITY).sqrt();
        for h in [1e-3, 5e-4, 2.5e-4, 6.25e-5] {
            let (after, rate, lost) = strike(spring, h);
            assert!((after - half).abs() < 0.01 * half, "steps of {h} s: {after} s of {half} s");
            assert!((rate + 3.0).abs() < 3e-3, "steps of {h} s: {rate} m/s");
            assert!(lost.abs() < 1e-12, "{lost} J");
        }
    }

    #[test]
    fn what_a_damped_spring_absorbs_is_what_the_mass_loses() {
        let law = |depth: f64, rate: f64| {
            let elastic = 1e10 * depth.powf(2.5);
            [elastic * (1.0 + 0.1 * rate), 2.5e10 * depth.powf(1.5), 0.1 * elastic]
        };
        for h in [5e-4, 2.5e-4] {
            let (_, rate, lost) = strike(law, h);
            let before = 0.5 * 9.0 / MOBILITY;
            let left = before - 0.5 * rate * rate / MOBILITY;
            assert!((lost - left).abs() < 5e-3 * before, "steps of {h} s: {lost} J for {left} J");
            assert!(left > 0.1 * before);
        }
    }
}
