//! Where the pivots are, and how far the levers turn.

use pode::math::sqrt;

use super::super::{ReducedGrand, ReducedGrandValues};
use crate::draw::Follow;
use crate::shapes::{Point, difference, raised, sum, through, turned};

/// Balance pin to key front (m) (S).
pub(super) const FRONT: f64 = 0.2595;
/// Balance pin to capstan (m) (S).
pub(super) const CAPSTAN: f64 = 0.1385;
/// Hammer pin to head (m) (S).
pub(super) const HEAD: f64 = 0.13;
/// Whippen pin to its heel and to the jack's pin (m) (E).
const HEEL_ARM: f64 = 0.055;
const JACK_ARM: f64 = 0.072;
/// Half the thickness of the key (m) (E).
pub(super) const HALF_KEY: f64 = 0.012;
/// Top of the capstan over the key's axis (m) (E).
pub(super) const CAPSTAN_TOP: f64 = 0.030;
/// From the whippen's axis down to its heel (m) (E).
pub(super) const HEEL: f64 = 0.012;
/// From the jack's pin up to its top, and the radius of the top's edge (m) (E).
pub(super) const JACK: f64 = 0.050;
pub(super) const EDGE: f64 = 0.002;
/// From the jack's pin to the end of its tender (m) (E): with it the head leaves the line
/// z = R y much as Z(y) does.
pub(super) const TENDER: f64 = 0.016;
/// From the jack's pin up to where the tender meets the button (m) (E).
pub(super) const TENDER_TOP: f64 = 0.006;
/// Radius of the knuckle, and its middle below the shank's axis (m) (E).
pub(super) const KNUCKLE: f64 = 0.0045;
pub(super) const KNUCKLE_DROP: f64 = 0.010;
/// From the shank's axis up to the point of the head that strikes (m) (S).
pub(super) const BORE: f64 = 0.050;

/// The places of one key's parts, from the balance pin, and their turns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Places {
    /// The key's angle over y.
    pub(super) key: Follow,
    pub(super) whippen_pin: Point,
    /// Its angle over y.
    pub(super) whippen: Follow,
    pub(super) hammer_pin: Point,
    /// Its angle over z.
    pub(super) hammer: Follow,
    /// The shank's angle at the string (rad); at rest it is as much below the level.
    pub(super) strike: f64,
    /// Hammer pin to knuckle, along the shank (m).
    pub(super) knuckle: f64,
    /// Where the head meets the string.
    pub(super) string: Point,
}

/// A follower's value where its signal is `signal`.
pub(super) fn at(follow: &Follow, signal: f64) -> f64 {
    follow.offset + follow.scale * signal
}

impl Places {
    pub(super) fn new(model: &ReducedGrand) -> Self {
        let p = model.values();
        let strike = raised([HEAD, 0.0], 0.5 * p.string).max(0.0);
        let per_height = if p.string == 0.0 { 1.0 / HEAD } else { 2.0 * strike / p.string };
        let level = 0.5 * p.string / p.ratio;
        let key = Follow::of(-level / FRONT, 1.0 / FRONT, "y");
        let whippen_pin = [CAPSTAN + HEEL_ARM, CAPSTAN_TOP + HEEL];
        let whippen = whippen(p, &key, whippen_pin);
        // The three levers give R: what is left for the hammer fixes its knuckle.
        let knuckle = (CAPSTAN / FRONT * JACK_ARM / HEEL_ARM * HEAD / p.ratio).clamp(0.008, 0.05);
        let mut places = Self {
            key,
            whippen_pin,
            whippen,
            hammer_pin: [whippen_pin[0] - JACK_ARM - knuckle, 0.0],
            hammer: Follow::of(-strike, per_height, "z"),
            strike,
            knuckle,
            string: [0.0; 2],
        };
        places.hammer_pin[1] = places.pin_height();
        places.string = sum(places.on_hammer(p.string, [HEAD, 0.0]), [0.0, BORE]);
        places
    }

    /// So high that the knuckle lies on the jack at rest (m).
    fn pin_height(&self) -> f64 {
        let jack = self.on_whippen(0.0, sum(Self::JACK_PIN, [0.0, JACK - EDGE]));
        let knuckle = self.on_hammer(0.0, [self.knuckle, -KNUCKLE_DROP]);
        let aside = jack[0] - knuckle[0];
        let apart = KNUCKLE + EDGE;
        jack[1] + sqrt((apart * apart - aside * aside).max(0.0)) - knuckle[1]
    }

    /// The jack's pin in the whippen's axes.
    pub(super) const JACK_PIN: Point = [-JACK_ARM, 0.0];

    /// The middle of the heel in the whippen's axes.
    pub(super) const HEEL: Point = [-HEEL_ARM, -HEEL];

    /// Where a point of the key is.
    pub(super) fn on_key(&self, y: f64, point: Point) -> Point {
        turned(at(&self.key, y), point)
    }

    /// Where a point of the whippen is.
    pub(super) fn on_whippen(&self, y: f64, point: Point) -> Point {
        sum(self.whippen_pin, turned(at(&self.whippen, y), point))
    }

    /// Where a point of the hammer is.
    pub(super) fn on_hammer(&self, z: f64, point: Point) -> Point {
        sum(self.hammer_pin, turned(at(&self.hammer, z), point))
    }

    /// A point that stands in the head's axes, upright at the string, in the hammer's.
    pub(super) fn in_head(&self, point: Point) -> Point {
        sum([HEAD, 0.0], turned(-self.strike, point))
    }

    /// The lowest point of the knuckle.
    pub(super) fn under_knuckle(&self, z: f64) -> Point {
        sum(self.on_hammer(z, [self.knuckle, -KNUCKLE_DROP]), [0.0, -KNUCKLE])
    }

    /// Left, bottom, right, top (m).
    pub(super) fn view(&self) -> [f64; 4] {
        let down = at(&self.key, 0.0).abs().max(at(&self.key, 0.012).abs()) * FRONT;
        [-FRONT - 0.025, -HALF_KEY - down - 0.016, 0.275, self.string[1] + 0.016]
    }
}

/// The whippen's angle: its heel on the capstan with the key up, and at the bed.
fn whippen(p: &ReducedGrandValues, key: &Follow, pin: Point) -> Follow {
    let angle = |y: f64| {
        let capstan = turned(at(key, y), [CAPSTAN, CAPSTAN_TOP]);
        (y, raised(Places::HEEL, difference(capstan, pin)[1]))
    };
    through("y", angle(0.0), angle(p.bed))
}
