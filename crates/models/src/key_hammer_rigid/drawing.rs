//! What model A looks like: a finger on the stick, the hammer on a capstan.

use super::KeyHammerRigid;
use crate::draw::{Follow, Sketch};
use crate::key_hammer::drawing::DrawingDimensions;
use crate::shapes::Pen;

impl KeyHammerRigid {
    /// The key turns with the finger, s = position / r.
    pub(super) fn sketch(&self, sketch: &mut dyn Sketch) {
        let look = DrawingDimensions::rigid(&self.values);
        let mut pen = Pen::new(sketch, look.view());
        look.rails(&mut pen);
        look.key(&mut pen, Follow::of(0.0, 1.0 / self.values.r, "position"));
        look.capstan(&mut pen);
        look.hammer(&mut pen);
        look.string(&mut pen);
        look.finger(&mut pen, -look.depth);
    }
}
