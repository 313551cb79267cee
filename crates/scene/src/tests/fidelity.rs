use super::super::embedded::INSTRUMENTS;
use super::*;
use mechanism::Library;

fn with(line: &str) -> String {
    format!("[[keys]]\nrange = \"A0..C8\"\n{line}")
}

#[track_caller]
fn check_refused(lines: &str, expected: &str) {
    let said = Scene::check(&Library::default(), &source(&with(lines)), &[]).map(drop);
    let said = said.expect_err("something is wrong").to_string();
    assert!(said.contains(expected), "said:\n{said}");
}

#[test]
fn an_instrument_without_levels_is_itself_and_auto_has_nothing_to_choose() {
    for (fidelity, autos) in [("full", 0), ("auto", 1)] {
        let lines = format!("instrument = \"spring-wall\"\nfidelity = \"{fidelity}\"\n");
        let scene = load(&with(&lines), &[]);
        assert_eq!(scene.fidelity.ranges.len(), autos);
        let levels = scene.fidelity.ranges.iter().flat_map(|range| &range.levels);
        assert!(levels.clone().all(|level| level.instrument == "spring-wall"));
        assert_eq!(levels.count(), autos);
        assert_eq!(scene.keys.iter().flatten().count(), 88);
    }
}

#[test]
fn a_key_without_a_voice_gets_none_by_a_fidelity() {
    let mut scene = load(&with("instrument = \"spring-wall\"\nfidelity = \"auto\"\n"), &[]);
    scene.keys[3] = None;
    let auto = scene.fidelity.ranges.remove(0);
    scene.set_fidelity(auto.keys, &auto.levels[0]);
    assert_eq!(scene.keys.iter().position(Option::is_none), Some(3));
    assert_eq!(scene.keys.iter().flatten().count(), 87);
}

#[test]
fn a_fidelity_that_is_not_there_is_answered_with_those_that_are() {
    let wall = "instrument = \"spring-wall\"\n";
    check_refused(&format!("{wall}fidelity = \"reduced\"\n"), "spring-wall has no fidelity");
    check_refused(&format!("{wall}fidelity = \"ful\"\n"), "full");
    let parameters = format!("{wall}fidelity = \"auto\"\n[keys.parameters]\nk = 1\n");
    check_refused(&parameters, "parameters stand beside fidelity \"auto\"");
    let model = "model = \"key-hammer-springs\"\nfidelity = \"map\"\n";
    check_refused(model, "\"fidelity\" stands beside a model");
    check_refused(&format!("{wall}[midi]\nprograms = [\"spring-wal\"]\n"), "spring-wall");
    let scene =
        Scene::check(&Library::default(), &source(&format!("budget = 2\n{}", with(wall))), &[]);
    assert!(scene.expect_err("more than a lane").to_string().contains("budget"));
}

#[test]
fn programs_are_those_of_general_midi_and_no_number_is_given_twice() {
    assert_eq!(Instrument::of_program(1), Some("grand"));
    assert_eq!(Instrument::of_program(7), Some("harpsichord"));
    assert_eq!(Instrument::of_program(128), None);
    let heads = instruments();
    let text = |name: &str| INSTRUMENTS.find(name).unwrap_or_default();
    let numbers = heads.iter().filter_map(|it| {
        text(&it.name).lines().find_map(|line| line.strip_prefix("program = ")).map(str::to_owned)
    });
    let mut numbers: Vec<_> = numbers.collect();
    let count = numbers.len();
    numbers.sort();
    numbers.dedup();
    assert_eq!((count, numbers.len()), (9, 9));
    assert!(heads.iter().all(|it| !it.doc.is_empty() && !it.model.is_empty()));
}
