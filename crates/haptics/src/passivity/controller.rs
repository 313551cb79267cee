/// Largest acceleration of a key's front (m/s²): that of a hard blow on a key of 50 g.
const ACCELERATION: f64 = 300.0;

/// Maximum delay of a force (ticks).
const MOST_LATE: usize = 8;

/// Fraction of the estimated sampling energy kept per tick. It is low enough that a force-limited
/// loud stroke does not trigger the controller; shaking loops generate energy in every tick.
const KEPT: f64 = 0.75;

/// Audits the energy that a key and its action exchange, and limits forces to it.
///
/// The action absorbs energy by its equations, the motor by a force that is held and late: sampling
/// generates or loses the difference. The *credit* is the energy that the hand may get: its input
/// that was not returned, but no more than the action stores and the tank holds, less the sampling
/// energy of the newest ticks. A force held over a tick gives energy to the hand if the key moves
/// along with it. That motion is bounded by the motion in the previous tick, the largest
/// acceleration, and the key's ends. So the largest force is known that cannot return more than the
/// credit, and a larger one is cut to it. The hand gets no more than its input and the tank if the
/// key keeps within that acceleration and the motor renders each force in time.
///
/// A spring that begins slowly needs the tank: a small one makes its first millimetre soft.
///
/// The controller of `[HR02]` dissipates generated energy; this one prevents it. Tank: `[FSR11]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassivityController {
    /// Energy that may be returned beyond the stored energy (J).
    tank: f64,
    /// Travel of the key from its rest to its bottom (m).
    dip: f64,
    /// Largest difference of a tick's motion from the previous tick's (m).
    reach: f64,
    /// Input of the hand that was not returned, as far as it is stored (J).
    credit: f64,
    /// Energy that sampling generated in the newest ticks (J).
    made: f64,
    /// Energy that the action stores beyond its rest (J).
    stored: f64,
    /// Energy that the action absorbed in the last tick (J).
    taken: f64,
    /// Last tick, and the position at its start (m).
    last: Option<(u64, f64)>,
    /// Forces of the newest ticks (N), the newest first.
    forces: [f64; MOST_LATE + 1],
    /// Delay of a force (ticks).
    late: usize,
    /// Motion in the previous tick (m).
    moved: f64,
}

impl PassivityController {
    /// Creates a controller of ticks of `period` (s) for a key with a travel of `dip` (m), that may
    /// return `tank` (J) more than its action stores.
    pub const fn new(tank: f64, dip: f64, period: f64) -> Self {
        Self {
            tank,
            dip,
            reach: ACCELERATION * period * period,
            credit: tank,
            made: 0.0,
            stored: 0.0,
            taken: 0.0,
            last: None,
            forces: [0.0; MOST_LATE + 1],
            late: 0,
            moved: 0.0,
        }
    }

    /// Sets the delay of forces, in ticks after they were sent; at most eight are counted.
    #[must_use]
    pub fn with_delay(self, late: usize) -> Self {
        Self { late: late.min(MOST_LATE), ..self }
    }

    /// Advances to `tick`, with the key at `position` (m): adds the work of the last force.
    ///
    /// # Real-time
    /// A dozen operations.
    pub fn follow(&mut self, tick: u64, position: f64) {
        self.moved = 0.0;
        if let Some((_, before)) = self.last.filter(|(last, _)| last + 1 == tick) {
            self.moved = position - before;
            let supplied = self.forces[self.late] * self.moved;
            self.made = KEPT * (self.made + self.taken - supplied).max(0.0);
            self.credit = (self.credit + supplied).min(self.tank + self.stored.max(0.0));
        }
    }

    /// Returns the force nearest to `force` (N) that may be held over `tick`, with the key at
    /// `position` (m) at its start, as passed to [`Self::follow`].
    ///
    /// # Real-time
    /// A dozen operations.
    #[must_use]
    pub fn limit(&mut self, tick: u64, position: f64, force: f64) -> f64 {
        // Forces are positive up, positions down: motion along the force has the other sign.
        let (way, end) =
            if 0.0 < force { (-self.moved, position) } else { (self.moved, self.dip - position) };
        let longest = (way + self.reach).clamp(0.0, end.max(0.0));
        let most = self.credit().max(0.0);
        let is_within = force.abs() * longest <= most;
        let limited = if is_within { force } else { (most / longest).copysign(force) };
        self.last = Some((tick, position));
        self.forces[..=self.late].rotate_right(1);
        self.forces[0] = limited;
        limited
    }

    /// Records that the action stored `stored` (J) and dissipated `lost` (J) in this tick.
    pub const fn take(&mut self, stored: f64, lost: f64) {
        // Energy that an action generates is no negative loss.
        self.taken = stored + lost.max(0.0);
        self.stored += stored;
    }

    /// Resets after a change of action or finger, or after a gap.
    pub const fn reset(&mut self) {
        let Self { tank, dip, late, reach, .. } = *self;
        *self = Self { reach, late, ..Self::new(tank, dip, 0.0) };
    }

    /// Returns the energy that the hand may get now (J).
    pub const fn credit(&self) -> f64 {
        self.credit.min(self.tank + self.stored - self.made)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1e-3;
    const DIP: f64 = 10e-3;

    /// Rounding (J) of 3000 sums of up to 0.25 J.
    const ROUNDING: f64 = 1e-13;

    fn controller(tank: f64) -> PassivityController {
        PassivityController::new(tank, DIP, H)
    }

    /// A spring and a damper, with their constants (N/m, N s/m).
    type Action = (f64, f64);

    /// Moves a key down by 8 mm and up again in each of three seconds, on a spring with a damper;
    /// returns the returned energy (J), less the damper's loss, and the largest cut of a force (N).
    fn cycles(controller: &mut PassivityController, (stiffness, damping): Action) -> [f64; 2] {
        let (mut back, mut cut) = (0.0, 0.0_f64);
        let mut last = (0.0, 0.0);
        for tick in 0..=3000_u32 {
            let phase = core::f64::consts::TAU * f64::from(tick) * H;
            let position = 4e-3 * (1.0 - phase.cos());
            let moved = position - last.0;
            back -= last.1 * moved;
            controller.follow(tick.into(), position);
            let wanted = stiffness * position + damping * moved / H;
            let sent = controller.limit(tick.into(), position, wanted);
            let stored = |position: f64| 0.5 * stiffness * position * position;
            controller
                .take(stored(position + moved) - stored(position), damping * moved * moved / H);
            cut = cut.max((wanted - sent).abs());
            last = (position, sent);
        }
        [back, cut]
    }

    #[test]
    fn a_held_spring_gives_back_more_than_it_took_and_not_with_the_controller() {
        // Half a period late: pi K A^2 W h / 2 a cycle, of a sine with amplitude A.
        let made = 3.0 * 0.5 * 800.0 * H * 16e-6 * core::f64::consts::TAU * core::f64::consts::PI;
        let [back, cut] = cycles(&mut controller(10.0), (800.0, 0.0));
        assert!((back / made - 1.0).abs() < 0.02 && cut == 0.0, "{back} J of {made}");
        // K r^2 / 2, with the possible motion r of a key at rest, lets it begin.
        let [back, cut] = cycles(&mut controller(36e-6), (800.0, 0.0));
        assert!(back <= 36e-6 + ROUNDING, "{back} J");
        assert!(cut < 0.7, "a spring of 6.4 N is cut by {cut} N near its end at most");
    }

    #[test]
    fn a_damper_and_a_spring_that_is_damped_enough_are_left_alone() {
        for action in [(0.0, 3.0), (300.0, 0.5)] {
            let [back, cut] = cycles(&mut controller(1e-3), action);
            assert!(back < 0.0 && cut == 0.0, "{back} J, {cut} N");
        }
    }

    #[test]
    fn a_motor_that_pushes_along_with_the_motion_gives_back_its_tank() {
        for tank in [1e-6, 1e-3, 5e-3] {
            let [back, _cut] = cycles(&mut controller(tank), (0.0, -2.0));
            assert!(back <= tank + ROUNDING, "{back} J of {tank}");
        }
    }

    #[test]
    fn at_an_end_a_key_is_held_with_any_force() {
        let mut controller = controller(0.0);
        controller.follow(0, 0.0);
        assert!(controller.limit(0, 0.0, 5.0).to_bits() == 5.0_f64.to_bits());
        controller.follow(1, DIP);
        assert!(controller.limit(1, DIP, -5.0).to_bits() == (-5.0_f64).to_bits());
    }
}
