use mechanism::Library;

use super::super::*;

#[test]
fn the_paper_s_scene_writes_out_the_defaults() {
    let paper = Scene::load(&Library::default(), "paper", &[]).unwrap();
    let default = Render::default();
    assert_eq!(Render { event_tolerance: default.event_tolerance, ..paper.render }, default);
    // The file rounds 2⁻⁴⁰ to two digits.
    assert!((paper.render.event_tolerance / default.event_tolerance - 1.0).abs() < 0.005);
}
