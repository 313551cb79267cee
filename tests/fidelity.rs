//! Fidelities: the part of an action that a budget permits.

use host::session::choose_fidelity;
use scene::Scene;

use crate::stage::scene;

fn octave(budget: &str) -> Scene {
    let changes = [
        ("keys.0.instrument", "grand"),
        ("keys.0.range", "C4..B4"),
        ("keys.0.fidelity", "auto"),
        ("budget", budget),
        ("lanes", "1"),
    ];
    scene("springs", &changes)
}

#[test]
fn a_budget_for_all_leaves_the_highest_and_none_the_lowest() {
    for (budget, fidelity, model, refused) in
        [("1", "full", "grand", 0), ("0.001", "map", "grand-map", 3)]
    {
        let mut scene = octave(budget);
        let chosen = choose_fidelity(&mut scene).expect("voices");
        assert_eq!((chosen[0].fidelity, chosen[0].refused.len()), (fidelity, refused));
        let played = scene.keys.iter().flatten().map(|voice| voice.model.name);
        assert!(played.clone().all(|name| name == model) && played.count() == 12);
        let said = chosen[0].to_string();
        assert!(said.starts_with("C4 to B4 play grand"), "{said}");
    }
}

#[test]
fn before_it_is_chosen_nothing_is_left_out() {
    let scene = octave("0.001");
    assert!(scene.keys.iter().flatten().all(|voice| voice.model.name == "grand"));
}
