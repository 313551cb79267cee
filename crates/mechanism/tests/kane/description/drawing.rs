//! Drawings, against positions computed by hand.

use super::meaning::value;
use super::{WEIGHT, good, mistakes_of};
use crate::kane::runnable::{Run, described, model};
use instruments::equations::ModeNumber;
use pode::Motion;

/// Lid that leaves its weight where the weight leans on the wall.
const LID: &str = r#"
[frames.shelf]
origin = ["0 m", "2*m/(1 kg/m)"]

[points.Q]
in = "shelf"
at = ["1 m", "0 m"]

[drawing]
view = ["-1 m", "-1 m", "x(Q)", "y(Q)"]
springs = [{ name = "k", from = "P", to = { frame = "lid", at = ["3 m", "4 m"] } }]

[drawing.frames]
lid = { frame = "W", in = { leaning = "shelf" } }

[drawing.outlines]
wall = [{ material = "ground", rectangle = ["0 m", "1 m", "2 m", "3 m"] }]
W = [{ disc = ["0 m", "0 m", "1 cm"] }]
lid = [{ scale = "2 m", turn = "90 deg", origin = ["x(Q)", "0 m"], points = [[1, 0], [0, 1]] }]
"#;

fn weight_with_lid() -> String {
    format!("{WEIGHT}{LID}")
}

#[test]
fn bodies_are_named_and_stand_on_the_frames_of_their_names() {
    let drawing = good(&weight_with_lid()).mechanism.instrument.drawing;
    let bodies: Vec<_> = drawing.bodies.iter().map(|it| (it.name.as_str(), it.frame)).collect();
    assert_eq!(bodies, [("wall", None), ("W", Some(0)), ("lid", Some(1))]);
    let frames: Vec<_> = drawing.frames.iter().map(|it| it.frames.as_slice()).collect();
    assert_eq!(frames, [[1, 1], [1, 2]], "one for each mode");
    let spring = &drawing.springs[0];
    assert_eq!((spring.from.0, spring.to.0), (1, 2), "by the bodies' numbers");
    assert!(drawing.bodies[0].outlines[0].is_closed, "a rectangle is");
}

#[test]
fn points_are_multiplied_then_turned_then_moved() {
    let mechanism = good(&weight_with_lid()).mechanism;
    let of = |node| value(&mechanism, node, &[0.0; 2], [0.0; 4]);
    let points = |body: usize| -> Vec<[f64; 2]> {
        let points = &mechanism.instrument.drawing.bodies[body].outlines[0].points;
        points.iter().map(|it| it.map(of)).collect()
    };
    assert_eq!(points(0), [[0.0, 1.0], [2.0, 1.0], [2.0, 3.0], [0.0, 3.0]]);
    for (found, expected) in points(2).iter().zip([[1.0, 2.0], [-1.0, 0.0]]) {
        let apart = (found[0] - expected[0]).hypot(found[1] - expected[1]);
        assert!(apart < 1e-15, "{found:?} is not {expected:?}");
    }
    // The shelf's height over the parameters: the light weight has 20 g.
    let view = mechanism.instrument.drawing.view.expect("a view").map(of);
    assert_eq!(view, [-1.0, -1.0, 1.0, 0.04]);
}

#[test]
fn a_drawn_frame_is_another_one_in_some_modes() {
    let it: Run<2> = model(described(&weight_with_lid()), (0, 0));
    let names = it.table().outputs.iter().map(|it| it.name).skip(2);
    assert!(names.eq(["W.x", "W.y", "W.angle", "lid.x", "lid.y", "lid.angle"]));
    for (mode, lid) in [(0, 0.7), (1, 0.04)] {
        let mut found = [0.0; 8];
        it.outputs(ModeNumber(mode), &[0.7, 0.0], &Motion::default(), &mut found);
        assert_eq!(found[6], lid, "in mode {mode}");
    }
}

#[test]
fn a_frame_of_a_mode_is_that_of_its_configurations() {
    let stop = "[contacts.stop]\ngap = \"y + 1 m\"\nrigid = true\n";
    let text = format!("{WEIGHT}{stop}{LID}").replace("leaning = \"shelf\"", "free = \"shelf\"");
    let mechanism = good(&text).mechanism;
    let modes: Vec<_> = mechanism.modes.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(modes, ["free", "leaning", "free+stop"]);
    assert_eq!(mechanism.instrument.drawing.frames[1].frames, [2, 1, 2]);
}

#[test]
fn what_is_wrong_in_a_drawing_is_said() {
    let says = |old: &str, new: &str, part: &str| {
        assert!(LID.contains(old), "{old:?} is not there");
        let mistakes = mistakes_of(&format!("{WEIGHT}{}", LID.replacen(old, new, 1)), &());
        assert!(mistakes.iter().any(|it| it.contains(part)), "{mistakes:?} lacks {part:?}");
    };
    says("lid = { frame = \"W\"", "lid = { frame = \"V\"", "there is no frame \"V\"");
    says("\"shelf\" } }", "\"self\" } }", "there is no frame \"self\"; use \"shelf\"");
    says("leaning = ", "lean = ", "there is no mode \"lean\"; use \"leaning\"");
    says("lid = { frame", "W = { frame", "\"W\" is a frame already");
    says("\"2 m\", \"3 m\"] }]", "\"2 m\"] }]", "the rectangle has not four edges");
    says("[[1, 0], ", "[[1], ", "this is no point");
    says("[[1, 0], ", "[[\"1 m\", 0], ", "\"points\" is in m");
    says("at = [\"3 m\", \"4 m\"]", "", "the place has no \"at\"");
    says("\"x(Q)\", \"y(Q)\"]", "\"x(P)\", \"y(P)\"]", "which cannot stand here");
}
