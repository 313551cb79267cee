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

/// Without any if another test has loaded the model.
#[test]
fn the_default_scene_compiles_the_functions_of_its_model_only() {
    let model = mechanism::derive("grand").expect("a model");
    let before = mechanism::native::compiled_functions();
    let scene = Scene::load(&Library::default(), "default", &[]).expect("a scene");
    assert!(scene.voicings.iter().flatten().all(|it| it.model.name == "grand"));
    let compiled = mechanism::native::compiled_functions() - before;
    assert!([0, model.program.tapes().len()].contains(&compiled), "{compiled}");
}
