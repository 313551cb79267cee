//! Dense random music: every key about once a second, soft and loud, long and short.

use boards::links::random::Random;
use haptics::{Gesture, Touch};

/// Longest time that a key is held (s).
pub(crate) const LONGEST: f64 = 0.6;

pub(crate) fn strokes(random: &mut Random, end: f64) -> Vec<Gesture> {
    let mut strokes = Vec::new();
    let mut start = 0.1 + random.unit();
    loop {
        let release = start + 0.05 + (LONGEST - 0.05) * random.unit();
        let lift = Gesture::LIFT;
        if end < release + lift {
            return strokes;
        }
        let (touch, speed) = if random.happens(0.7) {
            (Touch::Pressed, 0.08 + 0.5 * random.unit())
        } else {
            (Touch::Struck, 0.3 + 2.0 * random.unit())
        };
        strokes.push(Gesture { start, release, touch, speed, lift, ..Gesture::USUAL });
        start = release + lift + 0.03 + random.unit();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_let_go_before_it_is_played_again_and_before_the_end() {
        let strokes = strokes(&mut Random(7), 60.0);
        assert!((40..80).contains(&strokes.len()), "{} strokes", strokes.len());
        for pair in strokes.windows(2) {
            assert!(pair[0].release + pair[0].lift < pair[1].start);
        }
        assert!(strokes.iter().all(|it| it.release + it.lift <= 60.0));
    }
}
