//! Wait of a frame on a bus without preemption where the most urgent goes first.

/// A frame with its minimum interval and its time on the bus (us).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Periodic {
    pub period: f64,
    pub time: f64,
}

/// Larger than any that converges in use; each step lasts for a frame at least.
const MAX_STEPS: u32 = 100_000;

/// Returns the longest time from the request to send a frame to its arrival (us).
///
/// First the frame on the bus ends (`blocking`, the longest there is (us)); then go all of
/// `higher`, as often as they arrive meanwhile; then the frame itself, for `own` (us). `R = B +
/// sum(ceil(R / P) T) + own`, iterated from below. `None` if `higher` leave no room, or for NaN.
pub fn worst_response(blocking: f64, higher: &[Periodic], own: f64) -> Option<f64> {
    let share: f64 = higher.iter().map(|it| it.time / it.period).sum();
    // Also false for NaN.
    let has_room = share < 1.0;
    if !has_room {
        return None;
    }
    let mut response = blocking + own;
    for _ in 0..MAX_STEPS {
        let ahead: f64 = higher.iter().map(|it| (response / it.period).ceil() * it.time).sum();
        let next = blocking + ahead + own;
        if next <= response {
            return Some(response);
        }
        response = next;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn those_that_come_again_while_it_waits_go_first_again() {
        // By hand: 20, then 20 + 10, 20 + 2 * 10, 20 + 2 * 10 stays.
        let higher = [Periodic { period: 25.0, time: 10.0 }];
        assert_eq!(worst_response(10.0, &higher, 10.0), Some(40.0));
    }

    #[test]
    fn a_full_bus_never_answers() {
        let higher =
            [Periodic { period: 100.0, time: 60.0 }, Periodic { period: 50.0, time: 20.0 }];
        assert_eq!(worst_response(1.0, &higher, 1.0), None);
        assert_eq!(worst_response(1.0, &[Periodic { period: 1.0, time: f64::NAN }], 1.0), None);
    }
}
