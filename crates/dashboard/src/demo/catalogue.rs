//! What the demonstration has to show: two models, three instruments, a drawing.

use telemetry::{
    Body, Catalogue, Coil, Drawing, Follower, Instrument, KEYS, Model, Outline, Parameter, Signal,
    Voice, outline, signal,
};

use super::action::{self, DemoValues, HAMMER, STRING};

pub(super) const TICK_HZ: u32 = 1000;
pub(super) const MODEL: &str = "key-hammer-springs";
/// The scene's limit of force (N).
pub(super) const LIMIT: f64 = 20.0;
const WALL: &str = "spring-wall";

fn signal(name: &str, unit: &str, kind: signal::Kind, modes: &[u32]) -> Signal {
    Signal { name: name.into(), unit: unit.into(), kind: kind.into(), modes: modes.to_vec() }
}

/// Returns the catalogue of a run that began at `began` (ns since 1970).
pub(super) fn catalogue(began: u64) -> Catalogue {
    use signal::Kind::{Guard, Output, State};
    let signals = vec![
        signal("theta_h", "rad", State, &[]),
        signal("theta_k", "rad", State, &[]),
        signal("theta_h_dot", "rad/s", State, &[]),
        signal("theta_k_dot", "rad/s", State, &[]),
        signal("lift", "N", Guard, &[0]),
        signal("land", "m", Guard, &[1]),
        signal("string", "m", Guard, &[]),
        signal("F_KH", "N", Output, &[]),
    ];
    let springs = Model {
        name: MODEL.into(),
        summary: "key and hammer with springs in the contacts".into(),
        modes: vec!["B1 on the key".into(), "B2 in flight".into()],
        signals: signals.clone(),
        parameters: action::parameters(),
        version: 0,
    };
    let wall = Model {
        name: WALL.into(),
        summary: "a wall with a spring and a damper".into(),
        modes: vec!["free".into(), "in the wall".into()],
        signals,
        parameters: action::parameters(),
        version: 0,
    };
    Catalogue {
        run: "2026-11-22 09:00:00".into(),
        version: "0.1.0".into(),
        began,
        scene: "Demonstration".into(),
        tick_hz: TICK_HZ,
        force_limit: LIMIT,
        slew_limit: 4000.0,
        models: vec![springs, wall],
        instruments: instruments(),
        fingers: true,
        scene_text: scene_text(),
        descriptions: Vec::new(),
    }
}

pub(super) fn scene_text() -> String {
    "title = \"Demonstration\"\ntick_hz = 1000\n\n[render]\nestimator = \"kalman\"\ncoupling_stiffness = 0.0\ncoupling_damping = 0.0\nforce_gain = 1.0\nlead = 0.0\npassivity = \"observe\"\nenergy_tank = 0.001\n\n[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n".into()
}

fn instruments() -> Vec<Instrument> {
    let instrument = |name: &str, model: &str, doc: &str| Instrument {
        name: name.into(),
        model: model.into(),
        doc: doc.into(),
        values: (0..=crate::names::LAST).flat_map(|key| values(name, key)).collect(),
    };
    vec![
        instrument("grand-springs", MODEL, "Hammer mass graded over the compass."),
        instrument("upright-light", MODEL, "A lighter hammer on a softer knuckle."),
        instrument("spring-wall", WALL, "The feel against which boards are calibrated."),
    ]
}

/// Returns the values of an instrument on a key.
pub(super) fn values(instrument: &str, key: u8) -> DemoValues {
    let along = f64::from(key) / 87.0;
    match instrument {
        "upright-light" => [3000.0, 2.0, 0.007 - 0.002 * along, 0.06, 0.2, 0.3],
        "spring-wall" => [9000.0, 8.0, 0.005, 0.05, 0.3, 0.0],
        _ => [6000.0, 3.0, 0.011 - 0.004 * along, 0.09 - 0.02 * along, 0.25, 0.4],
    }
}

/// Returns the voice of a key.
pub(super) fn voice(key: u8, revision: u32, instrument: &str, values: &DemoValues) -> Voice {
    let model = if instrument == "spring-wall" { WALL } else { MODEL };
    Voice {
        key: key.into(),
        revision,
        model: model.into(),
        instrument: instrument.into(),
        values: values.to_vec(),
        writer: "scene".into(),
        drawing: Some(drawing()),
        kept: true,
        version: 0,
    }
}

fn fixed(offset: f64) -> Follower {
    Follower { offset, ..Follower::default() }
}

fn follower(scale: f64, signal: &str) -> Follower {
    Follower { offset: 0.0, scale, signal: signal.into() }
}

fn outline(kind: outline::Kind, points: &[[f64; 2]]) -> Outline {
    Outline {
        kind: kind.into(),
        x: points.iter().map(|point| point[0]).collect(),
        y: points.iter().map(|point| point[1]).collect(),
        closed: true,
    }
}

fn bar(kind: outline::Kind, [x0, y0, x1, y1]: [f64; 4]) -> Outline {
    outline(kind, &[[x0, y0], [x1, y0], [x1, y1], [x0, y1]])
}

fn body(name: &str, place: [f64; 2], angle: Option<Follower>, outlines: Vec<Outline>) -> Body {
    Body {
        name: name.into(),
        x: Some(fixed(place[0])),
        y: Some(fixed(place[1])),
        angle,
        outlines,
        modes: Vec::new(),
    }
}

/// Returns a clamp, open to the right, that holds the string's end at `place`.
fn agraffe([x, y]: [f64; 2]) -> Outline {
    const CLAMP: [[f64; 2]; 8] = [
        [-0.018, -0.014],
        [0.012, -0.014],
        [0.012, -0.005],
        [-0.006, -0.005],
        [-0.006, 0.005],
        [0.012, 0.005],
        [0.012, 0.014],
        [-0.018, 0.014],
    ];
    outline(outline::Kind::Metal, &CLAMP.map(|[across, up]| [x + across, y + up]))
}

/// Returns the mechanism seen from the side: the key's front is at the left.
fn drawing() -> Drawing {
    use outline::Kind::{Felt, Finger, Ground, String, Wood};
    let axis = [0.115 + HAMMER, 0.055];
    let key =
        vec![bar(Wood, [-0.22, -0.012, 0.16, 0.010]), bar(Felt, [0.095, 0.010, 0.115, 0.020])];
    let hammer = vec![
        bar(Wood, [-HAMMER, -0.004, 0.0, 0.004]),
        outline(
            Felt,
            &[[-0.14, 0.0], [-0.12, 0.0], [-0.123, 0.03], [-0.13, 0.038], [-0.137, 0.03]],
        ),
    ];
    let string_y = axis[1] + 0.038 + STRING;
    let still = |name: &str, outlines| body(name, [0.0, 0.0], None, outlines);
    let finger = Body {
        name: "finger".into(),
        x: Some(fixed(-0.2)),
        y: Some(Follower { offset: 0.011, scale: -1.0, signal: "position".into() }),
        angle: None,
        outlines: vec![outline(
            Finger,
            &[[-0.006, 0.03], [-0.007, 0.006], [0.0, 0.0], [0.007, 0.006], [0.006, 0.03]],
        )],
        modes: Vec::new(),
    };
    Drawing {
        left: -0.24,
        bottom: -0.06,
        right: 0.28,
        top: string_y + 0.02,
        bodies: vec![
            still(
                "frame",
                vec![
                    outline(Ground, &[[-0.008, -0.05], [0.008, -0.05], [0.0, -0.012]]),
                    bar(Felt, [-0.215, -0.030, -0.19, -0.0225]),
                    bar(Ground, [-0.22, -0.05, -0.185, -0.030]),
                    bar(Ground, [axis[0] - 0.01, axis[1] - 0.01, axis[0] + 0.02, axis[1] + 0.01]),
                ],
            ),
            body("key", [0.0, 0.0], Some(follower(1.0, "theta_k")), key),
            body("hammer", axis, Some(follower(-1.0, "theta_h")), hammer),
            still("string", vec![bar(String, [-0.05, string_y, 0.28, string_y + 0.002])]),
            still("agraffe", vec![agraffe([-0.05, string_y + 0.001])]),
            finger,
        ],
        coils: vec![Coil {
            name: "knuckle".into(),
            from: 1,
            from_x: 0.105,
            from_y: 0.020,
            to: 2,
            to_x: 0.105 - axis[0],
            to_y: -0.004,
            modes: vec![0],
        }],
    }
}

/// Returns the parameter `name` and its place among the values.
pub(super) fn parameter(name: &str) -> Option<(usize, Parameter)> {
    action::parameters().into_iter().enumerate().find(|(_, parameter)| parameter.name == name)
}

const _: () = assert!(KEYS == 88, "drawn for a full compass");
