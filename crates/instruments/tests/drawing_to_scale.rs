//! What the models draw is to scale, and in contact where they say so.

use instruments::SmallModel;
use instruments::draw::Material;
use instruments::{Described as _, Playable};

use crate::sketch::play::{Moment, film};
use crate::sketch::{Drawing, Part, Point, distance};
use crate::stroke::{parameter, tuned};

const MODEL_A: &str = "key-hammer-rigid";
const MODEL_B: &str = "key-hammer-springs";
const MODEL_C: &str = "reduced-grand";
const BALL: &str = "bouncing-ball";
const CART: &str = "cart-pendulum";
const WALL: &str = "spring-wall";

#[track_caller]
fn small(name: &str) -> SmallModel {
    crate::every_model::named(name).small().expect("a small model")
}

#[track_caller]
fn grand_mode(name: &str) -> usize {
    let modes = small(MODEL_C).entry().modes.clone();
    modes.iter().position(|it| it.name == name).expect("a mode")
}

#[test]
fn the_stroke_visits_the_modes_of_the_actions() {
    let modes = |film: &[(String, Moment)]| {
        let mut modes: Vec<_> = film.iter().map(|it| it.1.mode).collect();
        modes.sort_unstable();
        modes.dedup();
        modes
    };
    assert_eq!(modes(&film(&tuned(&small(MODEL_A), "playable", 39, &[]))), [0, 1]);
    assert_eq!(modes(&film(&tuned(&small(MODEL_B), "playable", 39, &[]))), [0, 1]);
    let grand = modes(&film(&tuned(&small(MODEL_C), "default", 0, &[])));
    assert!(grand.contains(&grand_mode("CHK")) && grand.len() > 7, "{grand:?}");
}

fn extreme(points: &[Point], sign: f64) -> f64 {
    sign * points.iter().map(|it| sign * it[1]).fold(f64::NEG_INFINITY, f64::max)
}

/// Returns the drawn distance of the head below the string (m).
fn below_string(drawing: &Drawing, moment: &Moment) -> f64 {
    let hammer = drawing.part("hammer", moment);
    let felts = hammer.of(Material::Felt).into_iter();
    let felt: Vec<Point> = felts.flat_map(|it| hammer.placed(moment, it)).collect();
    let string = drawing.part("string", moment).points(moment);
    let over = |point: &Point| string[0][0] < point[0] && point[0] < string[1][0];
    assert!(felt.iter().all(over), "the string is over the head");
    extreme(&string, -1.0) - extreme(&felt, 1.0)
}

#[track_caller]
fn check_string<M: Playable>(model: &M, guard: &str) {
    let drawing = Drawing::of(model);
    let film = film(model);
    let hits: Vec<_> = film.iter().filter(|it| it.0 == guard).collect();
    assert!(!hits.is_empty(), "{}: the stroke meets no string", model.entry().name);
    for (_, moment) in hits {
        let gap = below_string(&drawing, moment);
        assert!(gap.abs() < 1e-6, "{}: {gap} m from the string", model.entry().name);
    }
}

fn hammer_strikes<M: Playable>(model: &M) {
    for key in [0, 39, 87] {
        check_string(&tuned(model, "playable", key, &[]), "string");
    }
}

fn low_string<M: Playable>(model: &M) {
    check_string(&tuned(model, "playable", 39, &[("string_angle", 0.19)]), "string");
}

fn head_strikes<M: Playable>(model: &M) {
    for key in [0, 39, 87] {
        check_string(&tuned(model, "playable", key, &[]), "string-on");
        check_string(&tuned(model, "default", key, &[("zs", 0.047)]), "string-on");
    }
}

#[test]
fn the_head_touches_the_string_where_the_guard_is_zero() {
    hammer_strikes(&small(MODEL_A));
    low_string(&small(MODEL_A));
    hammer_strikes(&small(MODEL_B));
    head_strikes(&small(MODEL_C));
}

fn underside(drawing: &Drawing, moment: &Moment) -> Vec<Point> {
    drawing.part("hammer", moment).placed(moment, 0)
}

fn slider(part: &Part, moment: &Moment) -> Vec<Point> {
    part.placed(moment, part.outlines.len() - 1)
}

#[test]
fn at_rest_the_hammer_of_model_a_lies_on_the_capstan() {
    let known = &small(MODEL_A);
    for name in ["paper", "literal", "playable"] {
        let model = tuned(known, name, 39, &[]);
        let l1 = parameter(known, (name, 39), "L1");
        let drawing = Drawing::of(&model);
        for down in [0.0, 0.003, 0.006, 0.010] {
            let moment = Moment::at_rest(&model, down);
            let slider = slider(drawing.part("key", &moment), &moment);
            let gap = distance(&slider, &underside(&drawing, &moment));
            // A rim of 24 corners is within 0.9 % of its circle; one corner touches at rest.
            let rim = if down > 0.0 { 2e-4 * l1 } else { 0.0 };
            assert!(gap < 1e-4_f64.min(1e-4 * l1) + rim, "{name}: {gap} m at {down} m");
        }
    }
}

#[test]
fn in_flight_the_hammer_of_model_a_is_off_by_the_gap() {
    let known = &small(MODEL_A);
    let model = tuned(known, "playable", 39, &[]);
    let drawing = Drawing::of(&model);
    let film = film(&model);
    let flights = film.iter().filter(|it| it.1.mode == 1 && it.1.signal("gap") > 1e-3);
    let mut seen = 0;
    for (_, moment) in flights {
        let slider = slider(drawing.part("key", moment), moment);
        let drawn = distance(&slider, &underside(&drawing, moment));
        let gap = moment.signal("gap");
        assert!((drawn - gap).abs() < 5e-5, "{drawn} m is drawn for {gap} m");
        seen += 1;
    }
    assert!(seen > 10, "{seen} moments in flight");
}

#[test]
fn at_rest_the_hammer_of_model_b_lies_on_the_slider() {
    let known = &small(MODEL_B);
    for name in ["paper", "literal", "playable"] {
        let model = tuned(known, name, 39, &[]);
        let drawing = Drawing::of(&model);
        for down in [0.0, 0.005, 0.010] {
            let moment = Moment::at_rest(&model, down);
            let slider = slider(drawing.part("slider", &moment), &moment);
            let gap = distance(&slider, &underside(&drawing, &moment));
            let scale = (parameter(known, (name, 39), "L1") / 0.1385).max(1.0);
            assert!(gap < 1e-4 * scale, "{name}: {gap} m at {down} m");
        }
    }
}

#[test]
fn along_a_stroke_the_hammer_of_model_b_is_off_by_the_gap() {
    let known = &small(MODEL_B);
    let model = tuned(known, "playable", 39, &[]);
    let drawing = Drawing::of(&model);
    for (_, moment) in film(&model) {
        let slider = slider(drawing.part("slider", &moment), &moment);
        let drawn = distance(&slider, &underside(&drawing, &moment));
        let gap = moment.signal("gap").max(0.0);
        assert!((drawn - gap).abs() < 1e-4, "{drawn} m is drawn for {gap} m: {moment:?}");
    }
}

#[test]
fn k2_is_as_much_shorter_as_it_is_pressed() {
    let known = &small(MODEL_B);
    let model = tuned(known, "paper", 0, &[]);
    let drawing = Drawing::of(&model);
    let length = |moment: &Moment| {
        let coils = drawing.coils(moment);
        let [a, b] = coils.iter().find(|it| it.0.name == "k2").expect("k2").1;
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let moment = Moment::at_rest(&model, 0.0);
    // The hammer if it touches a slider that k2 does not carry.
    let [l1, l3, l4] = ["L1", "L3", "L4"].map(|name| parameter(known, ("paper", 0), name));
    let (sin, cos) = moment.signal("theta_k").sin_cos();
    let touching = (l1 * sin - l4).atan2(l1 * cos - l3);
    let entries = [("theta_k", moment.signal("theta_k")), ("theta_h", touching)];
    let slack = Moment::posed(&model, 0, 0.0, &entries);
    let pressed = length(&slack) - length(&moment);
    let q4 = moment.signal("q4");
    assert!(q4 > 0.01 && (pressed / q4 - 1.0).abs() < 0.01, "{pressed} m for {q4} m");
}

fn line(drawing: &Drawing, (name, index): (&str, usize), moment: &Moment) -> Vec<Point> {
    drawing.part(name, moment).placed(moment, index)
}

/// Returns their distance (m): the knuckle is the hammer's third line, the jack its own first.
fn knuckle_to_jack(drawing: &Drawing, moment: &Moment) -> f64 {
    distance(&line(drawing, ("hammer", 2), moment), &line(drawing, ("jack", 0), moment))
}

#[test]
fn at_rest_the_grand_s_knuckle_lies_on_the_jack_and_the_whippen_on_the_capstan() {
    let known = &small(MODEL_C);
    for (name, key) in [("default", 0), ("playable", 0), ("playable", 87)] {
        let model = tuned(known, name, key, &[]);
        let drawing = Drawing::of(&model);
        let moment = Moment::at_rest(&model, 0.0);
        let gap = knuckle_to_jack(&drawing, &moment);
        assert!(gap < 1e-4, "{name} {key}: {gap} m between knuckle and jack");
        let capstan = drawing.part("key", &moment);
        let capstan = capstan.of(Material::Metal).into_iter();
        let capstans = capstan.map(|it| line(&drawing, ("key", it), &moment));
        let heel = line(&drawing, ("whippen", 1), &moment);
        let gap = capstans.map(|it| distance(&it, &heel)).fold(f64::INFINITY, f64::min);
        assert!(gap < 1e-4, "{name} {key}: {gap} m between capstan and heel");
    }
}

#[test]
fn the_grand_s_knuckle_stays_on_the_jack_up_to_the_trip() {
    let known = &small(MODEL_C);
    let model = tuned(known, "default", 0, &[]);
    let drawing = Drawing::of(&model);
    let mut worst: f64 = 0.0;
    for down in (0_u8..=86).map(|it| 1e-4 * f64::from(it)) {
        let moment = Moment::at_rest(&model, down);
        let mode = ["ACC", "LO"].map(grand_mode);
        assert!(mode.contains(&moment.mode), "at {down} m");
        worst = worst.max(knuckle_to_jack(&drawing, &moment));
    }
    assert!(worst < 2.5e-4, "up to {worst} m apart");
}

#[test]
fn the_grand_s_tail_is_held_by_the_check() {
    let known = &small(MODEL_C);
    let model = tuned(known, "default", 0, &[]);
    let drawing = Drawing::of(&model);
    let film = film(&model);
    let caught: Vec<_> = film.iter().filter(|it| it.1.mode == grand_mode("CHK")).collect();
    assert!(caught.len() > 100, "{} moments in check", caught.len());
    for (_, moment) in caught {
        let key = drawing.part("key", moment);
        let pads = key.of(Material::Felt);
        let pad = key.placed(moment, *pads.last().expect("a pad"));
        let gap = distance(&pad, &line(&drawing, ("hammer", 3), moment));
        // Exact in the middle of its range; 1.2 mm of key away the check swings 0.5 mm further.
        assert!(gap < 5e-4, "{gap} m between tail and check at {moment:?}");
    }
}

#[test]
fn the_grand_s_tender_meets_the_button_from_there_to_the_trip() {
    let known = &small(MODEL_C);
    let model = tuned(known, "default", 0, &[]);
    let drawing = Drawing::of(&model);
    for y in [0.0082, 0.0085, 0.0088, 0.0091] {
        let moment = Moment::posed(&model, grand_mode("LO"), 0.0, &[("y", y)]);
        let button = drawing.part("let-off button", &moment);
        let felt = button.placed(&moment, *button.of(Material::Felt).last().expect("a felt"));
        let gap = distance(&felt, &line(&drawing, ("jack", 0), &moment));
        assert!(gap < 1e-4, "{gap} m between tender and button at {y} m");
    }
}

fn between(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn origin(drawing: &Drawing, name: &str, moment: &Moment) -> Point {
    drawing.part(name, moment).place(moment, [0.0, 0.0])
}

#[track_caller]
fn near(what: &str, drawn: f64, given: f64) {
    assert!((drawn - given).abs() < 1e-12, "{what}: {drawn} m is drawn for {given} m");
}

fn lengths_of_levers<M: Playable>(known: &M) {
    for name in ["paper", "literal", "playable"] {
        let model = tuned(known, name, 0, &[]);
        let given = |length: &str| parameter(known, (name, 0), length);
        let (drawing, moment) = (Drawing::of(&model), Moment::at_rest(&model, 0.0));
        near("P1", between(origin(&drawing, "key", &moment), [0.0, 0.0]), 0.0);
        near("P2", between(origin(&drawing, "hammer", &moment), ["L3", "L4"].map(given)), 0.0);
        let hammer = drawing.part("hammer", &moment);
        let centre = &hammer.outlines.last().expect("a mass centre").points;
        near("L2", 0.5 * (centre[0][0] + centre[12][0]), given("L2"));
        let rim = &drawing.part("slider", &moment).outlines[0].points;
        near("L1", 0.5 * (rim[0][0] + rim[12][0]), given("L1"));
        let stick = &drawing.part("key", &moment).outlines[0].points;
        near("r", -stick[0][0], given("r"));
    }
}

fn heights_of_head<M: Playable>(known: &M) {
    let model = tuned(known, "default", 0, &[]);
    let drawing = Drawing::of(&model);
    let head = |z: f64| {
        let moment = Moment::posed(&model, grand_mode("FLA"), 0.0, &[("z", z)]);
        below_string(&drawing, &moment)
    };
    near("zs", head(0.045), 0.0);
    // In between the head leans back by up to 7°: its 50 mm are 0.4 mm lower.
    assert!((head(0.03) - 0.015).abs() < 5e-4, "{} m is drawn for 15 mm", head(0.03));
}

#[test]
fn lengths_are_the_parameters() {
    lengths_of_levers(&small(MODEL_B));
    heights_of_head(&small(MODEL_C));
}

#[test]
fn the_grand_s_blow_is_drawn_in_full() {
    let known = &small(MODEL_C);
    // The striking point of the head moves on a circle; the shank's end is what rises.
    let model = tuned(known, "default", 0, &[]);
    let drawing = Drawing::of(&model);
    let moment = Moment::at_rest(&model, 0.0);
    let hammer = drawing.part("hammer", &moment);
    let at = |z: f64| {
        let moment = Moment::posed(&model, grand_mode("FLA"), 0.0, &[("z", z)]);
        hammer.place(&moment, [0.13, 0.0])[1]
    };
    let (low, middle, high) = (at(0.0), at(0.0225), at(0.045));
    assert!((high - low - 0.045).abs() < 1e-12, "{} m for 45 mm", high - low);
    assert!((middle - low - 0.0225).abs() < 1e-12, "{} m for 22.5 mm", middle - low);
}

fn ball_lies<M: Playable>(known: &M) {
    let ball = tuned(known, "key", 0, &[]);
    let drawing = Drawing::of(&ball);
    for down in [0.0, 0.005, 0.01] {
        let moment = Moment::at_rest(&ball, down);
        let lowest = extreme(&drawing.part("ball", &moment).points(&moment), -1.0);
        let floor = extreme(&drawing.part("paddle", &moment).points(&moment), 1.0);
        assert!((lowest - floor).abs() < 1e-12, "{lowest} m on {floor} m");
        assert!((floor - 5.0 * down).abs() < 1e-12, "{floor} m for {down} m");
    }
}

fn cart_is_stopped<M: Playable>(known: &M) {
    let cart = tuned(known, "key", 0, &[]);
    let drawing = Drawing::of(&cart);
    let moment = Moment::at_rest(&cart, 0.01);
    assert_eq!(moment.mode, 2, "at the right wall");
    let wall = line(&drawing, ("walls", 1), &moment);
    let side = line(&drawing, ("cart", 0), &moment);
    assert!(distance(&wall, &side) < 1e-12, "cart and wall");
    let rod = line(&drawing, ("pendulum", 0), &moment);
    assert!((between(rod[0], rod[1]) - 0.1).abs() < 1e-12, "length");
}

#[test]
fn the_ball_lies_on_its_paddle_and_the_cart_at_its_walls() {
    ball_lies(&small(BALL));
    cart_is_stopped(&small(CART));
}

#[test]
fn the_wall_stands_where_it_is_until_the_key_takes_it_along() {
    let known = &small(WALL);
    let model = tuned(known, "default", 0, &[]);
    let drawing = Drawing::of(&model);
    for (down, top) in [(0.0, -0.005), (0.004, -0.005), (0.005, -0.005), (0.008, -0.008)] {
        let moment = Moment::at_rest(&model, down);
        let pad = extreme(&drawing.part("wall", &moment).points(&moment), 1.0);
        assert!((pad - top).abs() < 1e-12, "the pad is at {pad} m with the key at {down} m");
        let key = extreme(&drawing.part("key", &moment).points(&moment), -1.0);
        assert!((key + down).abs() < 1e-12, "the key is at {key} m");
    }
}
