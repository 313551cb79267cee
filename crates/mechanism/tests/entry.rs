use std::path::Path;

use mechanism::Library;

#[test]
fn an_entry_is_made_of_the_description() {
    let model = Library::default().find("bouncing-ball", Path::new("")).unwrap();
    assert_eq!((model.name, model.file(), model.version()), ("bouncing-ball", None, 0));
    assert_eq!((model.input, model.input_unit), ("s", "m"));
    assert_eq!((&*model.states, &*model.state_units), (&["y", "v"][..], &["m", "m/s"][..]));
    let titles: Vec<_> = model.parameters.iter().map(|it| &*it.title).collect();
    assert_eq!(titles, ["gravity", "restitution", "mass", "drop", "scale"]);
    let values = |preset: usize| model.presets[preset].values(40);
    assert_eq!(values(0), [9.81, 0.8, 1.0, 1.0, 1.0]);
    assert_eq!(values(1), [9.81, 0.7, 0.01, 0.0, 5.0]);
    assert!(model.presets[0].value(5, 40).is_nan(), "no such parameter");
    let modes: Vec<_> = model.modes.iter().map(|it| (it.name, it.n, it.m, it.p)).collect();
    assert_eq!(modes, [("flight", 1, 0, 1), ("rest", 1, 1, 0)]);
    let leads = |mode: usize| (model.modes[mode].guards[0].name, &*model.modes[mode].guards[0].to);
    assert_eq!(leads(0), ("floor", &["flight", "rest"][..]));
    assert_eq!(leads(1), ("lift", &["flight"][..]));
}

#[test]
fn presets_are_graded_over_the_compass() {
    let model = Library::default().find("grand", Path::new("")).unwrap();
    let [low, high] = [0, 87].map(|key| model.presets[0].values(key));
    assert_eq!(low.len(), model.parameters.len());
    assert_ne!(low, high);
}
