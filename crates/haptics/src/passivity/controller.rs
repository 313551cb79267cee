//! A limit on forces that keeps a key passive, tick by tick.

/// Largest acceleration of a key's front (m/s²): that of a hard blow on a key of 50 g.
const ACCELERATION: f64 = 300.0;

/// Most ticks by which a force may be late.
const MOST_LATE: usize = 8;

/// What a tick leaves of what sampling made before it: as little as lets a loud stroke, of which the
/// force limit makes energy, go on undisturbed; loops that begin to shake make some in every tick.
const KEPT: f64 = 0.75;

/// Keeps account of the energy that a key and its action exchange, and forces within what it allows.
///
/// An action takes what it stores and loses by its equations; its motor takes from the hand force
/// times way, of a force that is held and late. The difference is made or lost by sampling. The
/// *credit* is what the hand may get: what it gave and did not get back, but no more than the
/// action stores and the tank holds, less what sampling made in the newest ticks. A force that is
/// held over a tick gives energy to the hand if the key moves along with it. How far it can move is
/// bounded: by what it moved in the tick before and the largest acceleration, and by the key's
/// ends. So the largest force is known of which not even the longest way gives back more than there
/// is, and a larger one is cut to it: over any way at all the hand gets no more than the tank
/// beyond what it gave, if the key keeps within that acceleration and the motor renders what it is
/// told in time.
///
/// A spring that begins slowly needs the tank: a small one makes its first millimetre soft.
///
/// # References
///
/// The controller of `[HR02]`, that takes energy out after it was made; here it is not made. The
/// tank is that of `[FSR11]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassivityController {
    /// Energy that may be given back beyond what is stored \[J\].
    tank: f64,
    /// Way of the key from its rest to its bottom \[m\].
    dip: f64,
    /// Way that a tick's motion can differ from that of the tick before \[m\].
    reach: f64,
    /// What the hand gave and did not get back, as far as it is stored \[J\].
    credit: f64,
    /// What sampling made in the newest ticks \[J\].
    made: f64,
    /// What the action stores beyond its rest \[J\].
    stored: f64,
    /// What it took in the last tick \[J\].
    taken: f64,
    /// The last tick, and the position at its start \[m\].
    last: Option<(u64, f64)>,
    /// Forces of the newest ticks \[N\], the newest first.
    forces: [f64; MOST_LATE + 1],
    /// Ticks after which a force acts.
    late: usize,
    /// Way in the tick before \[m\].
    moved: f64,
}

impl PassivityController {
    /// Creates a controller of ticks of `period` \[s\] for a key with a way of `dip` \[m\], that
    /// may give back `tank` \[J\] more than its action stores.
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

    /// Returns the same for forces that act `late` ticks after they were sent; eight at
    /// most are counted.
    #[must_use]
    pub fn with_delay(self, late: usize) -> Self {
        Self { late: late.min(MOST_LATE), ..self }
    }

    /// Goes on to `tick`, when the key is at `position` \[m\]: counts the work of the last force.
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

    /// Returns the force nearest to `force` \[N\] that may be held over `tick`, at whose start the
    /// key is at `position` \[m\], as told to [`Self::follow`].
    ///
    /// # Real-time
    /// A dozen operations.
    #[must_use]
    pub fn limit(&mut self, tick: u64, position: f64, force: f64) -> f64 {
        // Up is positive for forces, down for positions: along with the force is the other way.
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

    /// Notes that the action, in this tick, stores `stored` \[J\] more than before and loses
    /// `lost` \[J\] by its own equations.
    pub const fn take(&mut self, stored: f64, lost: f64) {
        // What an action makes by itself is no loss of less than nothing.
        self.taken = stored + lost.max(0.0);
        self.stored += stored;
    }

    /// Forgets all that was seen: another action, another finger, or a gap.
    pub const fn reset(&mut self) {
        let Self { tank, dip, late, reach, .. } = *self;
        *self = Self { reach, late, ..Self::new(tank, dip, 0.0) };
    }

    /// Returns the energy that the hand may get now \[J\].
    pub const fn credit(&self) -> f64 {
        self.credit.min(self.tank + self.stored - self.made)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 1e-3;
    const DIP: f64 = 10e-3;

    /// Of 3000 sums of up to 0.25 J.
    const ROUNDING: f64 = 1e-13;

    fn controller(tank: f64) -> PassivityController {
        PassivityController::new(tank, DIP, H)
    }

    /// A spring and a damper, with their constants (N/m, N s/m).
    type Action = (f64, f64);

    /// Moves a key down by 8 mm and up again in each of three seconds, on a spring with a damper;
    /// returns the energy that came back in all \[J\], less what the damper took, and the largest
    /// cut of a force \[N\].
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
        // K r^2 / 2, with the way r that a key at rest may go, lets it begin.
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
