//! Descriptions edited while the host plays them: `letoff run --watch`, and its recording replayed
//! without the files.

use std::fs;
use std::io::{BufRead as _, BufReader, Write as _};
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::process::Child;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use crate::letoff::{Said, end, folder, run, start};

/// Longest wait for any line of the host, also beside builds.
const PATIENCE: Duration = Duration::from_secs(90);

const REST: Duration = Duration::from_millis(1500);

/// Ticks after which a key has settled that moved while ticks were skipped, and one more.
const SETTLED: usize = 12;

/// C4 and C♯4, as keys are numbered.
const KEYS: [u8; 2] = [39, 40];

/// Stiffness of the base, and of the spring between key and mass before and after the edit (N/m).
const BASE: f64 = 1200.0;
const SPRINGS: [f64; 2] = [400.0, 800.0];

const OTHER_BASE: f64 = 2400.0;

/// Returns a mass between two springs, one to the key (`k`) and one to the ground (`base`).
fn base() -> String {
    format!(
        r#"name = "feel"
summary = "a mass between two springs"
requires = ["base > 100 N/m"]

[input]
name = "s"
unit = "m"
per_metre = "1"

[parameters]
k = {{ value = "{} N/m", range = ["1 N/m", "100 kN/m"], doc = "key to mass" }}
base = {{ value = "{BASE} N/m", range = ["1 N/m", "100 kN/m"], doc = "mass to ground" }}
m = {{ value = "20 g", range = ["1 g", "1 kg"], doc = "mass" }}

[coordinates]
y = {{ unit = "m", range = ["-50 mm", "50 mm"], speed_range = ["-5 m/s", "5 m/s"] }}

[frames]
body = {{ in = "ground", origin = ["0 m", "y"] }}

[bodies]
body = {{ frame = "body", mass = "m" }}

[springs]
key = {{ stretch = "s - y", stiffness = "k", damping = "1 N*s/m" }}
ground = {{ stretch = "y", stiffness = "base", damping = "5 N*s/m" }}

[modes.playing]
doc = "both springs act"

[outputs]
F = {{ unit = "N", value = "force(key)" }}

[rest]
mode = "playing"
y = "s*k/(k + base)"
"#,
        SPRINGS[0]
    )
}

fn stiffer() -> String {
    format!("base = \"base.toml\"\n[parameters]\nk = {{ value = \"{} N/m\" }}\n", SPRINGS[1])
}

fn felt(spring: f64, base: f64) -> f64 {
    spring * base / (spring + base)
}

struct Running<'a> {
    child: Child,
    said: Receiver<String>,
    folder: &'a Path,
    heard: String,
}

impl<'a> Running<'a> {
    fn start(folder: &'a Path, arguments: &[&str]) -> Self {
        let mut child = start(folder, arguments);
        let (tell, said) = channel();
        let lines = BufReader::new(child.stderr.take().expect("its stderr")).lines();
        std::thread::spawn(move || {
            lines.map_while(Result::ok).try_for_each(|line| tell.send(line))
        });
        Self { child, said, folder, heard: String::new() }
    }

    #[track_caller]
    fn wait_for(&mut self, text: &str) {
        let until = Instant::now() + PATIENCE;
        loop {
            let left = until.saturating_duration_since(Instant::now());
            let line = self.said.recv_timeout(left);
            let line = line.unwrap_or_else(|_| panic!("nobody said {text:?}:\n{}", self.heard));
            self.heard += &line;
            self.heard += "\n";
            if line.contains(text) {
                return;
            }
        }
    }

    fn ask(&self, request: &str) -> String {
        self.ask_and_stay(request).0
    }

    fn ask_and_stay(&self, request: &str) -> (String, UnixStream) {
        let stream = UnixStream::connect(self.folder.join("socket")).expect("the host listens");
        (&stream).write_all(format!("{request}\n").as_bytes()).expect("it hears");
        let mut answer = String::new();
        BufReader::new(&stream).read_line(&mut answer).expect("it answers");
        (answer, stream)
    }

    fn press(&self, key: u8) -> UnixStream {
        let press = format!(r#"{{"service":"press","key":{key},"newtons":2.0}}"#);
        let (said, stream) = self.ask_and_stay(&press);
        assert!(said.contains("pressed"), "{said}");
        stream
    }

    fn stop(mut self) -> (Said, String) {
        self.ask(r#"{"service":"stop"}"#);
        let rest = self.said.iter().collect::<Vec<_>>().join("\n");
        self.heard += &rest;
        (end(self.child), self.heard)
    }
}

/// Returns the largest change of the sent force from one tick to the next (N).
///
/// A busy machine may skip ticks, while the key moves under a constant force; the force then settles for some ticks.
fn largest_change(rows: &[[f64; 4]]) -> f64 {
    let settled = |rows: &&[[f64; 4]]| rows.windows(2).all(|pair| pair[1][0] - pair[0][0] < 1.5);
    let in_turn = rows.windows(SETTLED).filter(settled).filter_map(|rows| rows.last_chunk::<2>());
    in_turn.map(|[one, next]| (next[3] - one[3]).abs()).fold(0.0, f64::max)
}

/// Rows of a key: tick, position (m), the voice's force and the force sent (N).
fn rows(folder: &Path, key: u8) -> Vec<[f64; 4]> {
    let text = fs::read_to_string(folder.join(format!("export/key-{key}.csv"))).expect("its rows");
    let mut lines = text.lines();
    let names: Vec<_> = lines.next().expect("a header").split(',').collect();
    let column = |name: &str| {
        let found = names.iter().position(|it| it.starts_with(name));
        found.unwrap_or_else(|| panic!("no {name} in {names:?}"))
    };
    let columns = ["tick", "position", "force", "sent"].map(column);
    let number = |text: &str| text.parse().expect("a number");
    lines
        .map(|line| {
            let fields: Vec<_> = line.split(',').collect();
            columns.map(|column| number(fields[column]))
        })
        .collect()
}

/// Returns the stiffnesses (N/m) at which a pressed key rested, in the order of time: unchanged
/// rows are not recorded. A key that creeps by a step of its encoder is still at rest.
fn rests(rows: &[[f64; 4]]) -> Vec<f64> {
    let next = rows.iter().skip(1).map(|row| row[0]).chain([f64::INFINITY]);
    let rests = rows.iter().zip(next).filter(|(row, next)| 200.0 < next - row[0] && 1e-3 < row[1]);
    let mut found: Vec<_> = rests.map(|([_, position, force, _], _)| force / position).collect();
    found.dedup_by(|next, before| is_near(*next, *before));
    found
}

fn is_near(found: f64, wanted: f64) -> bool {
    (found / wanted - 1.0).abs() < 0.01
}

#[track_caller]
fn check_near(found: &[f64], wanted: &[f64]) {
    let near = |(found, wanted): (&f64, &f64)| is_near(*found, *wanted);
    assert!(
        found.len() == wanted.len() && found.iter().zip(wanted).all(near),
        "{found:?}, {wanted:?}"
    );
}

fn save(file: &Path, text: &str) {
    let beside = file.with_extension("new");
    fs::write(&beside, text).expect("a file");
    fs::rename(beside, file).expect("its place");
}

fn scene(folder: &Path) {
    let scene = "tick_hz = 1000\nlanes = 1\n[[keys]]\nrange = \"C4..E4\"\nmodel = \"feel.toml\"\n";
    fs::write(folder.join("scene.toml"), scene).expect("a scene");
}

#[test]
fn a_description_that_is_saved_plays_on_with_its_new_forces_and_a_wrong_one_changes_nothing() {
    let folder = folder("watched");
    let _of_an_earlier_run = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let (file, soft) = (folder.join("feel.toml"), base());
    scene(&folder);
    fs::write(folder.join("base.toml"), &soft).expect("a file");
    fs::write(&file, &soft).expect("a file");
    let arguments =
        ["run", "scene.toml", "--watch", "--record", "a.mcap", "--listen", "none", "--json"];
    let mut host = Running::start(&folder, &arguments);
    host.wait_for("plays");
    let set = format!(
        r#"{{"service":"set","changes":[{{"key":40,"parameter":"base","value":{OTHER_BASE}}}]}}"#
    );
    assert!(host.ask(&set).contains("1 values on 1 keys"));
    let unmet = host.ask(&set.replace("2400", "50"));
    assert!(unmet.contains("feel needs base > 100 N/m, which does not hold on"), "{unmet}");
    let _held = KEYS.map(|key| host.press(key));
    std::thread::sleep(REST);
    save(&file, &stiffer());
    host.wait_for("5 keys play version 2 of feel");
    std::thread::sleep(REST);
    // A file that is missing for a short time is neither an error nor a version.
    fs::remove_file(&file).expect("the file");
    std::thread::sleep(Duration::from_millis(500));
    save(&file, &format!("{}\n[springs]\nkey = {{ stiffness = \"kk\" }}\n", stiffer()));
    host.wait_for("is wrong, and the version before it plays on");
    host.wait_for("feel.toml:6:");
    host.wait_for("^");
    let still = host.ask(r#"{"service":"scene"}"#);
    assert!(still.contains("feel.toml"), "{still}");
    std::thread::sleep(REST);
    save(&file, &soft);
    // The earlier content is the same version again.
    host.wait_for("5 keys play version 1 of feel");
    std::thread::sleep(REST);
    let (said, heard) = host.stop();
    assert_eq!(said.code, Some(0), "{said:?}\n{heard}");
    assert_eq!(said.report()["faults"], 0, "{}", said.out);
    assert!(!heard.contains("such file"), "{heard}");

    assert_eq!(run(&folder, &["replay", "a.mcap", "--export", "export"]).code, Some(0));
    let all = KEYS.map(|key| rows(&folder, key));
    let wanted = |base| [SPRINGS[0], SPRINGS[1], SPRINGS[0]].map(|spring| felt(spring, base));
    check_near(&rests(&all[0]), &wanted(BASE));
    check_near(&rests(&all[1]), &wanted(OTHER_BASE));
    let largest = largest_change(&all[0]);
    let blended = all[0].iter().filter(|[.., force, sent]| 0.05 < (sent - force).abs()).count();
    assert!(5 < blended, "{blended} ticks in which the force is on its way to the new one");
    let travel = 2.0 / felt(SPRINGS[0], BASE);
    let jump = travel * (felt(SPRINGS[1], BASE) - felt(SPRINGS[0], BASE));
    // The forces differ by more than 1 N at the key's position; in a tick the sent force changes by
    // a twentieth of that, and by the key's motion.
    assert!(jump > 1.0 && largest < 0.2 * jump, "{largest} N in a tick, {jump} N between both");

    for file in ["feel.toml", "base.toml", "scene.toml"] {
        fs::remove_file(folder.join(file)).expect("a file");
    }
    let replayed = run(&folder, &["replay", "a.mcap"]);
    assert_eq!(replayed.code, Some(0), "{replayed:?}");
    assert!(replayed.out.contains("are the same to the last bit"), "{replayed:?}");
    assert!(!replayed.out.contains("could be compared"), "{replayed:?}");
}

#[test]
fn values_that_a_model_does_not_allow_are_refused_wherever_they_are_given() {
    let folder = folder("watched-unmet");
    fs::write(folder.join("feel.toml"), base()).expect("a file");
    let scene = "[[keys]]\nrange = \"C4..E4\"\nmodel = \"feel.toml\"\nparameters = { base = 50 }\n";
    fs::write(folder.join("scene.toml"), scene).expect("a scene");
    let said = run(&folder, &["check", "scene.toml"]);
    let why = "feel needs base > 100 N/m, which does not hold on C4";
    assert!(said.code == Some(2) && said.err.contains(why), "{said:?}");
    let arguments =
        ["simulate", "feel.toml", "--set", "base=50", "--until", "0.1", "--step", "1e-3"];
    let said = run(&folder, &arguments);
    let why = "feel needs base > 100 N/m, which does not hold";
    assert!(said.code == Some(2) && said.err.contains(why), "{said:?}");
}
