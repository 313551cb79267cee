use super::*;

#[test]
fn a_case_fails_by_no_method_without_an_explanation() {
    let all = &*HARD_CASES;
    for case in all {
        let is_known = case.source.starts_with("https://")
            || ["closed form", "SciPy"].contains(&case.source.as_str());
        assert!(is_known && !case.symptom.is_empty(), "{} has no source", case.name);
        let is_falling = case.steps.is_sorted_by(|a, b| a > b);
        assert!(case.steps.len() == 4 && is_falling, "{}: four steps that fall", case.name);
    }
    assert!(all.len() >= 55 && all.iter().filter(|it| it.explained.is_some()).count() <= 4);
    let choice = HardChoice::new(&[], &[]).unwrap().quick();
    let rows = measure(&choice, &|| ());
    let runs: usize = rows.iter().map(|it| it.runs.len()).sum();
    assert_eq!(runs, choice.count());
    let failed: Vec<_> = rows.iter().filter(|it| it.is_unexplained()).collect();
    let lines: Vec<_> = failed
        .iter()
        .flat_map(|row| row.failures().into_iter().map(|it| format!("{}: {it:?}", row.case.name)))
        .collect();
    assert!(lines.is_empty(), "{} cases fail:\n{}", failed.len(), lines.join("\n"));
    let needless = rows.iter().filter(|it| it.case.explained.is_some() && it.failures().is_empty());
    assert_eq!(needless.count(), 0, "an explained case is right now");
}

#[test]
fn errors_of_coarse_methods_are_found() {
    let case = ["a pendulum in x and y".to_owned()];
    let choice = HardChoice::new(&case, &["explicit-euler".to_owned()]).unwrap();
    let rows = measure(&choice, &|| ());
    assert!(rows[0].runs.iter().all(|it| HardVerdict::Right < it.verdict), "{rows:?}");
    assert!(rows[0].failures().is_empty(), "it need not be right");
}

#[test]
fn the_committed_picture_shows_every_case_and_method() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/hard/hard.svg");
    let shown = std::fs::read_to_string(path).unwrap();
    for case in HARD_CASES.iter() {
        let mark = if case.explained.is_some() { " ✗" } else { "" };
        let name = case.name.replace('&', "&amp;").replace('<', "&lt;");
        assert!(shown.contains(&format!("\n{name}{mark}\n")), "draw it again: {name}");
        assert!(shown.contains(&format!("\n{}\n", case.topic)), "draw it again: {}", case.topic);
    }
    for name in pode::stepper::Any::NAMES {
        assert!(shown.contains(&format!("\n{name}\n")), "draw it again: {name}");
    }
}
