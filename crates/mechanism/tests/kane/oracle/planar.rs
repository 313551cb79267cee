use mechanism::kane::graph::Place;
use serde_json::{Value, json};

use crate::kane::builder::MechanismBuilder;
use crate::kane::evaluation::{Derived, Numbers, close, imbalance};

const STATES: usize = 5;

/// Mechanism that is built here and in the text for the other program.
struct Planar {
    numbers: Numbers,
    m: MechanismBuilder,
    /// Origin and angle of every frame on the ground's axes, as text.
    places: Vec<[String; 3]>,
    frames: Vec<Value>,
    bodies: Vec<Value>,
    springs: Vec<Value>,
    torsion: Vec<Value>,
    constraints: Vec<Value>,
    tied: Vec<usize>,
    /// Coordinates of the pose in which the constraints are met.
    start: Vec<f64>,
}

struct FramePoint {
    frame: usize,
    at: [f64; 2],
    place: [String; 2],
}

pub(super) fn random(seed: u64) -> Value {
    let mut numbers = Numbers::new(100 + seed);
    for _ in 0..10 {
        numbers.next();
    }
    let count = (2..).zip(0..=seed % 4).last().map_or(2, |(count, _)| count);
    let names: Vec<String> = (0..count).map(|i| format!("q{i}")).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut m = MechanismBuilder::new(&[], &names);
    m.gravity(&["0", "-9.81"]);
    let zero = || "0".to_owned();
    let mut planar = Planar {
        numbers,
        m,
        places: vec![[zero(), zero(), zero()]],
        frames: Vec::new(),
        bodies: Vec::new(),
        springs: Vec::new(),
        torsion: Vec::new(),
        constraints: Vec::new(),
        tied: Vec::new(),
        start: Vec::new(),
    };
    for i in 0..count {
        // Only chains have closed loops; trees are free.
        let parent = if seed.is_multiple_of(5) { planar.numbers.below(i + 1) } else { i };
        planar.link(i, parent);
    }
    for _ in 0..=seed % 3 {
        planar.spring();
    }
    match seed % 5 {
        1 | 3 if count > 2 => planar.tie(&["x", "y"]),
        2 => planar.tie(&["y"]),
        4 => planar.edge(),
        _ => {}
    }
    planar.finish(seed, &names)
}

impl Planar {
    /// Returns a number with few digits, so that its text is exact.
    fn number(&mut self, low: f64, high: f64) -> f64 {
        let middle = 0.5 * (low + high) + 0.5 * (high - low) * self.numbers.next();
        (middle * 1e4).round() / 1e4
    }

    /// Adds a body on a frame that rotates or slides on an earlier one.
    fn link(&mut self, i: usize, parent: usize) {
        let [x, y] = [self.number(0.1, 0.6), self.number(-0.3, 0.3)];
        let turns = i == 0 || self.numbers.next() > -0.4;
        let angle = self.number(-1.5, 1.5);
        let q = format!("q{i}");
        let (origin, turn) = if turns {
            ([x.to_string(), y.to_string()], q.clone())
        } else {
            ([format!("{x} + {q}"), y.to_string()], angle.to_string())
        };
        let frame = self.m.frame(parent, &[&origin[0], &origin[1]], &turn);
        let [px, py, pa] = self.places[parent].clone();
        self.places.push([
            format!("{px} + ({})*cos({pa}) - ({})*sin({pa})", origin[0], origin[1]),
            format!("{py} + ({})*sin({pa}) + ({})*cos({pa})", origin[0], origin[1]),
            format!("({pa}) + {turn}"),
        ]);
        self.frames.push(json!({ "parent": parent, "origin": origin, "turn": turn }));
        let at = [self.number(0.05, 0.4), self.number(-0.2, 0.2)];
        let [mass, inertia] = [self.number(0.2, 2.0), self.number(0.001, 0.1)];
        let text = at.map(|it| it.to_string());
        self.m.body(frame, &mass.to_string(), &[&text[0], &text[1]], &inertia.to_string());
        self.bodies.push(json!({ "frame": frame, "at": at, "mass": mass, "inertia": inertia }));
        if turns {
            self.torsion_spring(i, frame, parent);
        }
        let start = self.number(-1.0, 1.0);
        self.start.push(if turns { start } else { 0.3 * start });
        self.m.rest(i, &self.start[i].to_string());
    }

    fn torsion_spring(&mut self, i: usize, frame: usize, parent: usize) {
        if self.numbers.next() < 0.0 {
            return;
        }
        let [stiffness, damping] = [self.number(1.0, 20.0), self.number(0.0, 0.5)];
        self.m.force(
            &format!("torsion{i}"),
            &format!("s - q{i}"),
            &format!("{stiffness}*stretch + {damping}*(0 - q{i}')"),
            &format!("{stiffness}*stretch^2/2"),
        );
        self.torsion.push(json!({
            "frame": frame, "parent": parent, "coordinate": format!("q{i}"),
            "stiffness": stiffness, "damping": damping,
        }));
    }

    fn point(&mut self, frame: usize) -> FramePoint {
        let at = [self.number(-0.4, 0.6), self.number(-0.3, 0.3)];
        let [x, y, angle] = &self.places[frame];
        let [a, b] = at;
        let place = [
            format!("{x} + {a}*cos({angle}) - ({b})*sin({angle})"),
            format!("{y} + {a}*sin({angle}) + ({b})*cos({angle})"),
        ];
        FramePoint { frame, at, place }
    }

    fn spring(&mut self) {
        let first = self.numbers.below(self.places.len());
        let second = (first + 1 + self.numbers.below(self.places.len() - 1)) % self.places.len();
        let (from, to) = (self.point(first), self.point(second));
        let [stiffness, length, damping] =
            [self.number(5.0, 80.0), self.number(0.05, 0.4), self.number(0.0, 1.0)];
        let [dx, dy] = [0, 1].map(|k| format!("({}) - ({})", to.place[k], from.place[k]));
        let stretch = format!("sqrt(({dx})^2 + ({dy})^2) - {length}");
        let tension = format!("{stiffness}*stretch + {damping}*rate");
        self.m.force("spring", &stretch, &tension, &format!("{stiffness}*stretch^2/2"));
        let [from, to] = [from, to].map(|it| json!({ "frame": it.frame, "at": it.at }));
        self.springs.push(json!({
            "from": from, "to": to,
            "stiffness": stiffness, "length": length, "damping": damping,
        }));
    }

    /// Holds a point of the last frame at its start, or moves it with the input.
    fn tie(&mut self, axes: &[&str]) {
        let point = self.point(self.places.len() - 1);
        for (k, axis) in ["x", "y"].iter().enumerate().filter(|(_, it)| axes.contains(it)) {
            let place = format!("{:.17} + 0.1*s", self.value(&point.place[k]));
            let name = format!("tie_{axis}");
            self.tied.push(self.m.constraint(&name, &format!("{} - ({place})", point.place[k])));
            self.constraints.push(json!({
                "kind": axis, "place": place,
                "point": { "frame": point.frame, "at": point.at },
            }));
        }
    }

    fn value(&mut self, text: &str) -> f64 {
        let mut probe = MechanismBuilder::new(&[], &[]);
        for (i, value) in self.start.iter().enumerate() {
            probe.define(&format!("q{i}"), &format!("0 + ({value})"));
        }
        let node = probe.e(text);
        probe.graph().number(node).expect("a number")
    }

    /// Lets a point of the last frame move along the frame only, like a skate.
    fn edge(&mut self) {
        let point = self.point(self.places.len() - 1);
        let angle = self.places[point.frame][2].clone();
        let rates = [0, 1].map(|k| {
            let node = self.m.e(&point.place[k]);
            self.m.rate(node)
        });
        self.m.names.insert("vx".into(), rates[0]);
        self.m.names.insert("vy".into(), rates[1]);
        let zero = format!("vy*cos({angle}) - vx*sin({angle})");
        self.tied.push(self.m.nonholonomic("edge", &zero));
        let point = json!({ "frame": point.frame, "at": point.at });
        self.constraints.push(json!({ "kind": "edge", "place": "0", "point": point }));
    }

    fn guess(&mut self, derived: &Derived) -> Vec<f64> {
        let state = derived.system.state.iter();
        let values = state.map(|place| {
            let Place::Coordinate(i) = place else { return self.numbers.next() };
            self.start[usize::from(*i)] + 0.03 * self.numbers.next()
        });
        values.collect()
    }

    fn finish(mut self, seed: u64, names: &[&str]) -> Value {
        self.m.mode("moves", &self.tied.clone());
        for suffix in ["", "'", "''"] {
            for name in names {
                let text = format!("{name}{suffix}");
                self.m.output(&text, &text);
            }
        }
        let mut derived = Derived::from(std::mem::take(&mut self.m));
        let n = names.len();
        let mut states = Vec::new();
        while states.len() < STATES {
            let input = self.numbers.list::<4>().map(|it| 0.1 * it);
            let guess = self.guess(&derived);
            let state = derived.near(0, &guess, input);
            // Close to a dead point the independent coordinates may be out of reach.
            let Some(state) = state.filter(|it| it.iter().all(|x| x.abs() < 10.0)) else {
                continue;
            };
            close(imbalance(&mut derived, 0, &state, input), 0.0, 1e-10, "energy");
            let all = derived.all(&derived.system.modes[0].outputs, &state, input);
            states.push(json!({
                "coordinates": all[..n], "speeds": all[n..2 * n], "accelerations": all[2 * n..],
                "input": input,
            }));
        }
        let coordinates: Vec<_> = names.iter().map(|name| json!({ "name": name })).collect();
        json!({
            "name": format!("planar {seed}"), "coordinates": coordinates, "frames": self.frames,
            "bodies": self.bodies, "springs": self.springs, "torsion": self.torsion,
            "constraints": self.constraints, "states": states,
        })
    }
}
