//! The motor and its amplifier: a held command becomes a delayed, smoothed force.

/// Longest delay of a command, in substeps: 8 ms at 50 µs, two ticks at 250 Hz.
pub const MAX_DELAY_STEPS: usize = 160;

/// Distance to the command (N) at which the lag ends: far below the resolution of any drive.
const SETTLED: f64 = 1e-9;

/// Constants of a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorParameters {
    /// Largest force in either direction (N).
    pub limit: f64,
    /// Bandwidth of the current loop (rad/s); infinite for none.
    pub bandwidth: f64,
    /// Delay from command to effect, in substeps, `0 ..= MAX_DELAY_STEPS`.
    pub delay_steps: usize,
}

/// A motor: delay, saturation and a first-order lag, in this order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motor {
    parameters: MotorParameters,
    command: f64,
    line: DelayLine,
    lag: Lag,
    force: f64,
}

impl Motor {
    /// Creates a motor at zero force. A delay above [`MAX_DELAY_STEPS`] is cut to it.
    pub fn new(parameters: MotorParameters) -> Self {
        let line = DelayLine::new(parameters.delay_steps.min(MAX_DELAY_STEPS));
        let lag = Lag { bandwidth: parameters.bandwidth, h: 0.0, share: 0.0 };
        Self { parameters, command: 0.0, line, lag, force: 0.0 }
    }

    /// Sets the force to hold from now on (N), up positive; saturates, and treats NaN as zero.
    pub fn command(&mut self, newtons: f64) {
        let finite = if newtons.is_nan() { 0.0 } else { newtons };
        let command = finite.clamp(-self.parameters.limit, self.parameters.limit);
        if command - self.command != 0.0 {
            self.command = command;
            self.line.disturb();
        }
    }

    /// Advances by `dt` (s) and returns the force on the key at its end (N), up positive. The lag
    /// is solved exactly, so the step response does not depend on `dt`.
    ///
    /// # Real-time
    /// No loop; one exponential when `dt` differs from the last one.
    pub fn step(&mut self, dt: f64) -> f64 {
        let target = self.line.pass(self.command);
        let gap = target - self.force;
        let rest = gap.abs() < SETTLED;
        self.force = if rest { target } else { self.force + self.lag.share(dt) * gap };
        self.force
    }

    /// Returns the force on the key (N), up positive.
    pub const fn force(&self) -> f64 {
        self.force
    }

    /// Returns `true` if steps change nothing until the next command.
    pub fn is_settled(&self) -> bool {
        self.line.pending == 0 && self.command - self.force == 0.0
    }
}

/// A first-order lag that remembers its last exponential.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Lag {
    bandwidth: f64,
    /// Step of `share` (s).
    h: f64,
    /// Fraction of the gap that is closed within `h`.
    share: f64,
}

impl Lag {
    fn share(&mut self, h: f64) -> f64 {
        if h - self.h != 0.0 {
            self.h = h;
            self.share = -(-self.bandwidth * h).exp_m1();
        }
        self.share
    }
}

/// Delayed commands, one entry for each substep of delay.
#[derive(Clone, Copy, Debug, PartialEq)]
struct DelayLine {
    places: [f64; MAX_DELAY_STEPS],
    length: usize,
    next: usize,
    /// Steps until all entries hold the present command.
    pending: usize,
}

impl DelayLine {
    const fn new(length: usize) -> Self {
        Self { places: [0.0; MAX_DELAY_STEPS], length, next: 0, pending: 0 }
    }

    const fn disturb(&mut self) {
        self.pending = self.length;
    }

    /// Inserts `command` and returns the one of `length` steps ago.
    fn pass(&mut self, command: f64) -> f64 {
        if self.pending == 0 {
            return command;
        }
        self.pending -= 1;
        let oldest = core::mem::replace(&mut self.places[self.next], command);
        self.next = if self.next + 1 < self.length { self.next + 1 } else { 0 };
        oldest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const H: f64 = 5e-5;
    const BANDWIDTH: f64 = 6283.0;

    fn motor(delay_steps: usize) -> Motor {
        Motor::new(MotorParameters { limit: 30.0, bandwidth: BANDWIDTH, delay_steps })
    }

    fn run(motor: &mut Motor, steps: u32) {
        for _ in 0..steps {
            motor.step(H);
        }
    }

    #[track_caller]
    fn check_step_response(delay: u32) {
        let mut motor = motor(delay as usize);
        motor.command(10.0);
        for step in 1..=100_u32 {
            let since = f64::from(step.saturating_sub(delay)) * H;
            let expected = 10.0 * (1.0 - (-BANDWIDTH * since).exp());
            let force = motor.step(H);
            // A hundred roundings of 10 N, and the nanonewton at which the lag ends.
            assert!((force - expected).abs() < 1e-12 + SETTLED, "step {step}: {force}");
        }
    }

    #[test]
    fn the_step_response_is_the_closed_form_after_the_delay() {
        [0, 1, 7, 60].into_iter().for_each(check_step_response);
    }

    #[test]
    fn a_command_that_changes_each_tick_arrives_in_order() {
        let delay = 33;
        let (mut late, mut prompt) = (motor(delay), motor(0));
        let command = |step: usize| f64::from(u32::try_from(step / 20 % 7).unwrap());
        for step in 0..1000 {
            if step % 20 == 0 {
                late.command(command(step));
            }
            if step >= delay && (step - delay) % 20 == 0 {
                prompt.command(command(step - delay));
            }
            assert_eq!(late.step(H).to_bits(), prompt.step(H).to_bits(), "step {step}");
        }
    }

    #[test]
    fn a_command_saturates_and_what_is_not_a_number_is_zero() {
        for (command, force) in [(1e9, 30.0), (f64::NEG_INFINITY, -30.0), (f64::NAN, 0.0)] {
            let mut motor = motor(3);
            motor.command(command);
            run(&mut motor, 1000);
            assert!(motor.is_settled());
            assert_eq!(motor.force().to_bits(), f64::to_bits(force));
        }
    }
}
