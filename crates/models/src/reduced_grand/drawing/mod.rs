//! What the reduced grand looks like: a grand's action, from the key's front to the string.
//!
//! The model has two coordinates; levers of a real key's size turn with them. What the
//! parameters fix is exact where it is felt: the blow, the string, the head on the jack at
//! rest, the button at yb, the bed at ybed, the check at zc. Between, arcs and their chords
//! differ by some tenths of a millimetre.

mod frame;
mod jack;
mod lever;
mod parts;
mod places;

use super::{Mode, ReducedGrand};
use crate::draw::Sketch;
use crate::shapes::Pen;
use places::Places;

/// The jack under the knuckle, as one with the whippen.
const UNDER: &[u8] = &[Mode::Acc as u8, Mode::Fla as u8];
/// The jack's tender on the button.
const ON_BUTTON: &[u8] = &[Mode::Lo as u8, Mode::Fll as u8, Mode::Stu as u8];
/// The jack beside the knuckle.
const TRIPPED: &[u8] = &[
    Mode::Flt as u8,
    Mode::Stt as u8,
    Mode::RepH as u8,
    Mode::RepL as u8,
    Mode::Rep0 as u8,
    Mode::Chk as u8,
];
/// The lever pressed down as far as the jack lets the knuckle.
const LEVER_PRESSED: &[u8] = &[Mode::Acc as u8, Mode::Lo as u8];
/// The lever on its spring, going with the whippen.
const LEVER_FREE: &[u8] = &[Mode::Fla as u8, Mode::Stu as u8];
/// The lever under the drop screw.
const LEVER_DROPPED: &[u8] = &[Mode::Fll as u8, Mode::Flt as u8, Mode::Stt as u8];
/// The lever with the knuckle on it.
const LEVER_LOADED: &[u8] =
    &[Mode::RepH as u8, Mode::RepL as u8, Mode::Rep0 as u8, Mode::Chk as u8];

impl ReducedGrand {
    /// From what stands still to what is in front.
    pub(super) fn sketch(&self, sketch: &mut dyn Sketch) {
        let places = Places::new(self);
        let mut pen = Pen::new(sketch, places.view());
        places.draw_frame(&mut pen, self);
        let key = places.draw_key(&mut pen, self);
        let whippen = places.draw_whippen(&mut pen);
        places.draw_jack(&mut pen, self);
        places.draw_lever(&mut pen, self, whippen);
        places.draw_hammer(&mut pen);
        places.draw_finger(&mut pen, key);
    }
}
