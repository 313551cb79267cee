//! A state that is exactly on the threshold falls through it.

use super::Probe;
use crate::log::Log;
use crate::peers;
use crate::problem::Problem;
use crate::problems::Ball;

/// The ball exactly on the floor after an impact: without the nudge of diffsol's book.
#[derive(Clone, Copy)]
struct OnTheFloor(Ball);

impl Problem<2, 1> for OnTheFloor {
    type Mode = ();

    fn names((): ()) -> [&'static str; 1] {
        Ball::names(())
    }

    fn start(&self) -> ((), [f64; 2]) {
        self.0.start()
    }

    fn derivative(&self, (): (), t: f64, x: &[f64; 2]) -> [f64; 2] {
        self.0.derivative((), t, x)
    }

    fn guards(&self, (): (), x: &[f64; 2]) -> [f64; 1] {
        self.0.guards((), x)
    }

    fn guard_rates(&self, (): (), x: &[f64; 2]) -> [f64; 1] {
        self.0.guard_rates((), x)
    }

    fn fire(&self, (): (), guard: usize, x: &[f64; 2]) -> ((), [f64; 2]) {
        self.0.fire((), guard, x)
    }

    fn longest_step(&self) -> f64 {
        f64::INFINITY
    }
}

/// Returns the number of impacts until 3.6 s, and the height at 3.6 s (m).
fn fall() -> (usize, f64) {
    const T_END: f64 = 3.6;
    let ball = OnTheFloor(Ball { g: 9.81, e: 0.8, height: 1.0 });
    let mut log = Log::new(&[T_END]);
    if let Some(entry) = peers::diffsol(ball, T_END).first() {
        let _ = (entry.run)(&mut log);
    }
    (log.events.len(), log.states.first().copied().unwrap_or(f64::NAN))
}

pub(super) fn probes() -> Vec<Probe> {
    let (impacts, height) = fall();
    let seen = format!(
        "ball, restitution 0.8, put exactly on the floor after an impact, tsit45 as it comes: 10 \
         impacts until 3.6 s are right, it sees {impacts} and ends at a height of {height:.1} m \
         (a root is a product g0·g1 < 0, so a step that starts on zero has none). With \
         `y.max(f64::EPSILON)`, as in its book, it sees all ten."
    );
    vec![Probe::new("diffsol", seen)]
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_ball_falls_through_the_floor() {
        let (impacts, height) = super::fall();
        assert!(impacts < 10 && height < -1.0, "{impacts} impacts, {height} m");
    }
}
