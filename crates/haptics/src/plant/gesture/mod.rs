//! A gesture: the command of a finger's muscle during one stroke, as a function of time.

mod stroke;

pub use stroke::MuscleCommand;

use super::smooth::{quintic, quintic_slope};
use stroke::StrokeProfile;

/// Range of the lifting time of a finger (s).
const LIFTS: (f64, f64) = (10e-3, 1.0);

/// Start of a finger's stroke.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touch {
    Pressed,
    /// The finger meets the key from above at full speed, meant for 0.1 m/s and more. In a slower
    /// stroke the swing after the impact also decides the hammer's speed.
    Struck,
}

/// One stroke of one finger and its release.
///
/// Position and velocity are commands: the finger follows them as its stiffness allows. Both and
/// the acceleration are continuous for any release; until the release a faster gesture is never
/// behind a slower one on its way down.
///
/// Times share the origin of `t`. An unknown `release` is infinite, and may be set later.
///
/// A finger that must soon play its key again is not fully lifted: the next gesture takes over at
/// its start, from the depth to which the key has risen by then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gesture {
    /// Start of the finger's motion (s).
    pub start: f64,
    /// Start of the lift (s); before `start` counts as `start`.
    pub release: f64,
    pub touch: Touch,
    /// Depth of the key at which a pressed finger starts (m), down positive.
    pub from: f64,
    /// Commanded speed on the way down (m/s), meant for `0.02 ..= 3`, and to 8 from a stiffer
    /// finger: see [`FingerParameters::braced`](super::FingerParameters::braced).
    pub speed: f64,
    /// Commanded depth while the key is held (m), down positive; see [`Self::HOLD`].
    pub hold: f64,
    /// Duration of the lift (s), meant for `0.01 ..= 1`.
    pub lift: f64,
}

impl Gesture {
    /// Hold depth for the default key and finger (m): dip and 2 N at 400 N/m.
    pub const HOLD: f64 = Self::hold_of(10.16e-3);

    /// Height above the key after the lift (m) (estimate).
    pub const LIFT_HEIGHT: f64 = 10e-3;

    /// Default duration of the lift (s) (estimate).
    pub const LIFT: f64 = 50e-3;

    /// A press of medium speed at time 0 without release, the template of other gestures.
    pub const USUAL: Self = Self {
        start: 0.0,
        release: f64::INFINITY,
        touch: Touch::Pressed,
        from: 0.0,
        speed: 0.2,
        hold: Self::HOLD,
        lift: Self::LIFT,
    };

    /// Returns the depth of the default finger's hold on a key with a travel of `dip` (m).
    pub const fn hold_of(dip: f64) -> f64 {
        dip + stroke::PUSH
    }

    /// Returns the commanded position at `t` (s), in metres, down positive.
    ///
    /// # Real-time
    /// Some ten divisions; no loop.
    pub fn position(&self, t: f64) -> f64 {
        self.command(t).position
    }

    /// Returns the commanded velocity at `t` (s), the position's derivative (m/s).
    ///
    /// # Real-time
    /// As [`Self::position`].
    pub fn velocity(&self, t: f64) -> f64 {
        self.command(t).velocity
    }

    /// Returns the time (s) at which the unhindered finger passes the key's rest, released or not.
    pub fn arrival(&self) -> f64 {
        self.start + StrokeProfile::of(self).arrival()
    }

    /// Returns the time (s) from the start to `depth` (m), between full speed and hold, unhindered.
    pub fn passes(&self, depth: f64) -> f64 {
        StrokeProfile::of(self).passes(depth)
    }

    /// Returns the end of the finger's presence (s).
    pub fn end(&self) -> f64 {
        self.lift_off() + self.lift_time()
    }

    /// Returns `true` if there is a finger at `t` (s), in `[start, end)`.
    pub fn is_active(&self, t: f64) -> bool {
        self.start <= t && t < self.end()
    }

    const fn lift_off(&self) -> f64 {
        self.release.max(self.start)
    }

    /// Returns the duration of the lift (s), within a finger's range.
    const fn lift_time(&self) -> f64 {
        self.lift.max(LIFTS.0).min(LIFTS.1)
    }

    /// Returns position and velocity at `t` (s): the stroke, blended into the lifted finger.
    pub(super) fn command(&self, t: f64) -> MuscleCommand {
        let down = StrokeProfile::of(self).command(t - self.start);
        let lift_time = self.lift_time();
        let x = (t - self.lift_off()) / lift_time;
        let (lifted, rate) = (quintic(x), quintic_slope(x) / lift_time);
        let way = -Self::LIFT_HEIGHT - down.position;
        MuscleCommand {
            position: down.position + lifted * way,
            velocity: down.velocity * (1.0 - lifted) + rate * way,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn endless(touch: Touch, speed: f64) -> Gesture {
        Gesture { start: 1.0, touch, speed, ..Gesture::USUAL }
    }

    fn speeds() -> impl Iterator<Item = f64> {
        (0..=50).map(|i| 0.02 * 150.0_f64.powf(f64::from(i) / 50.0))
    }

    #[test]
    fn a_finger_that_takes_over_starts_at_its_depth_and_is_at_full_speed_no_deeper() {
        let full = |from| {
            let gesture = Gesture { from, ..endless(Touch::Pressed, 0.5) };
            assert_eq!(gesture.command(1.0), MuscleCommand { position: from, velocity: 0.0 });
            let times = (0..10_000).map(|i| 1.0 + f64::from(i) * 1e-5);
            let at = times.clone().find(|t| gesture.velocity(*t) >= 0.5 * (1.0 - 1e-9));
            gesture.position(at.unwrap())
        };
        let (rest, half) = (full(0.0), full(5e-3));
        // Half of the way to the hold depth, less by the square of the remaining way.
        assert!((rest - 7.58e-3).abs() < 1e-5, "{rest}");
        let part = 1.0 - 5.0 / 10.16;
        assert!((half - (5e-3 + 7.58e-3 * part * part)).abs() < 1e-5, "{half}");
    }

    #[test]
    fn a_slow_lift_takes_the_time_it_is_given() {
        let gesture = Gesture { release: 1.3, lift: 0.2, ..endless(Touch::Pressed, 0.5) };
        assert!((gesture.end() - 1.5).abs() < 1e-15);
        let quick = Gesture { lift: 0.0, ..gesture };
        assert!((quick.end() - 1.31).abs() < 1e-15, "no finger is faster");
        let middle = Gesture { lift: 0.1, ..gesture }.position(1.35);
        assert!((gesture.position(1.4) - middle).abs() < 1e-4, "the same way");
    }

    #[test]
    fn a_struck_finger_arrives_at_its_speed() {
        for speed in speeds() {
            let gesture = endless(Touch::Struck, speed);
            let command = gesture.command(gesture.arrival());
            // Time is rounded at 2 s.
            assert!(command.position.abs() <= 4.0 * speed * f64::EPSILON, "{command:?}");
            assert!((command.velocity - speed).abs() <= f64::EPSILON * speed, "{command:?}");
        }
    }

    #[test]
    fn a_forte_press_leads_to_15_to_20_newtons() {
        for speed in [1.0, 2.0, 3.0] {
            let gesture = endless(Touch::Pressed, speed);
            let depth = (0..2000).map(|i| gesture.position(1.0 + f64::from(i) * 1e-4));
            let newtons = 400.0 * (depth.fold(0.0, f64::max) - 10.16e-3);
            assert!((14.0..20.0).contains(&newtons), "{newtons} N at {speed} m/s");
        }
    }

    #[track_caller]
    fn check_ahead(slow: &Gesture, fast: &Gesture) {
        let commands =
            (1..100_000).map(|i| 1.0 + f64::from(i) * 1e-4).map(|t| (t, fast.command(t)));
        for (t, ahead) in commands.take_while(|(_, command)| 0.0 < command.velocity) {
            // A rounding of the depth.
            assert!(slow.position(t) <= ahead.position + 1e-15, "{slow:?} {fast:?} {t}");
        }
    }

    #[test]
    fn a_faster_finger_is_never_behind_on_its_way_down() {
        for touch in [Touch::Pressed, Touch::Struck] {
            for (slow, fast) in speeds().zip(speeds().skip(1)) {
                check_ahead(&endless(touch, slow), &endless(touch, fast));
            }
        }
    }

    #[test]
    fn after_the_end_the_finger_is_lifted_and_gone() {
        let gesture = Gesture { release: 1.3, ..endless(Touch::Pressed, 0.5) };
        assert!((gesture.end() - 1.35).abs() < 1e-15);
        assert!(!gesture.is_active(0.999) && gesture.is_active(1.0));
        assert!(gesture.is_active(1.349) && !gesture.is_active(gesture.end()));
        let command = gesture.command(gesture.end());
        assert!((command.position + 0.01).abs() < 1e-15 && command.velocity == 0.0);
    }

    fn any_gesture() -> impl Strategy<Value = Gesture> {
        let touch = prop_oneof![Just(Touch::Pressed), Just(Touch::Struck)];
        let slow_to_fast = (-3.9..1.1_f64).prop_map(f64::exp);
        let depths = (0.0..0.007_f64, 0.008..0.03_f64);
        (0.0..10.0_f64, -0.1..1.5_f64, touch, slow_to_fast, depths, 0.05..0.4_f64).prop_map(
            |(start, held, touch, speed, (from, hold), lift)| Gesture {
                start,
                release: start + held,
                touch,
                from,
                speed,
                hold,
                lift,
            },
        )
    }

    proptest! {
        #[test]
        fn the_velocity_is_the_slope_of_a_continuous_position(
            gesture in any_gesture(),
            part in -0.1..1.1_f64,
        ) {
            let t = gesture.start + part * (gesture.end() - gesture.start);
            let step = 1e-6;
            let slope = (gesture.position(t + step) - gesture.position(t - step)) / (2.0 * step);
            // Jerk is below 12 · 3 m/s / (0.26 ms)², of a finger that starts deep: 6e8 m/s³, which
            // bends the slope by 1e-4 m/s; time rounded at 10 s errs by 1e-15 s, times 4 m/s, over
            // the step: 1e-8 m/s.
            let error = (slope - gesture.velocity(t)).abs();
            prop_assert!(error < 1.2e-4, "{error} at {t}");
        }

        #[test]
        fn it_is_smooth_where_its_parts_meet(gesture in any_gesture()) {
            // The fastest change of velocity: 1.5 · 3 m/s in 0.26 ms, and lifting 0.1 m.
            let most = 1.5 * 3.0 / 2.6e-4 + 6.0 * 0.1 / (0.05 * 0.05) + 2.0 * 3.0 * 1.9 / 0.05;
            for i in 0..2000_u32 {
                let t = gesture.start - 1e-3 + f64::from(i) * 1e-3;
                let change = gesture.velocity(t + 1e-6) - gesture.velocity(t);
                prop_assert!(change.abs() < most * 1e-6, "{change} at {t}");
            }
        }
    }
}
