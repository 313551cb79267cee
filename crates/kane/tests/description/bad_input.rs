//! Whatever is given, mistakes come back: soon, and without a panic or a stack overflow.

use std::fmt::Write as _;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use kane::derive_model;
use kane::description::{Bases, read_bytes};

use super::WEIGHT;

/// Far more than any of these takes, and less than a hang.
const PATIENCE: Duration = Duration::from_secs(30);

/// Bodies of a chain that is derived.
const CHAIN: usize = 8;

/// A thread's stack where nothing else is said.
const STACK: usize = 2 << 20;

/// A shelf on which `loop.toml` starts from the description that asks for it.
struct Circle;

impl Bases for Circle {
    fn load(&self, base: &str, _from: &str) -> Result<(String, Vec<u8>), String> {
        Ok((base.to_owned(), b"base = \"loop.toml\"".to_vec()))
    }
}

/// The line of the description for one of many things.
type Entry = fn(usize) -> String;

/// What is said of some bytes, on a small stack.
#[track_caller]
fn said_of(bytes: Vec<u8>) -> String {
    let (sender, receiver) = mpsc::channel();
    let work = move || {
        let mut mistakes = read_bytes("bad.toml", &bytes, &Circle).err();
        if mistakes.is_none() {
            let text = String::from_utf8_lossy(&bytes);
            mistakes = derive_model("bad.toml", &text, &Circle).err();
        }
        let said = mistakes.map(|it| it.to_string()).unwrap_or_default();
        // Nobody listens any more if it took too long.
        let _late = sender.send(said);
    };
    thread::Builder::new().stack_size(STACK).spawn(work).expect("a thread");
    receiver.recv_timeout(PATIENCE).expect("an answer, without a panic")
}

#[track_caller]
fn refused(bytes: impl Into<Vec<u8>>, part: &str) {
    let said = said_of(bytes.into());
    assert!(said.contains(part), "{part:?} is not in {said:?}");
}

#[test]
fn what_is_no_text_or_no_toml() {
    refused(vec![0xff, 0xfe, 0x00], "UTF-8");
    refused("= = =", "this is not TOML");
    refused(vec![b'#'; 100 << 20], "bytes long");
    refused(vec![b'['; 1 << 20], "bad.toml");
}

#[test]
fn circles_of_bases_and_of_names() {
    refused("base = \"loop.toml\"", "loop.toml");
    let circle = WEIGHT.replacen("\"y - s\"", "\"fall * 1 s\"", 1);
    refused(circle, "made of each other");
}

#[test]
fn too_many_and_too_deep() {
    let mut many = "name = \"many\"\n[coordinates]\n".to_owned();
    for index in 0..10_000 {
        writeln!(many, "q{index} = {{ unit = \"m\", range = [0, 1], speed_range = [0, 1] }}")
            .expect("text grows");
    }
    refused(many, "10000 entries");
    let deep = format!("\"{}y{}\"", "(".repeat(10_000), ")".repeat(10_000));
    refused(WEIGHT.replacen("\"y - s\"", &deep, 1), "200 deep");
}

#[test]
fn units_names_and_numbers() {
    refused(WEIGHT.replacen("\"y - s\"", "\"y - m\"", 1), "kg");
    refused(WEIGHT.replacen("m0 = {", "m = {", 1), "second time");
    refused(WEIGHT.replacen("\"1 m - y\"", "\"1 m - y/0\"", 1), "division by zero");
}

/// A sum of more terms than the graph keeps apart, the first of them negative.
#[test]
fn the_sine_of_a_long_sum() {
    let terms = (1..80).map(|it| format!("cos({it}*y/(1 m))")).collect::<Vec<_>>();
    let sine = format!("\"y - s + 1 m*sin(-{})\"", terms.join(" - "));
    assert_eq!(said_of(WEIGHT.replacen("\"y - s\"", &sine, 1).into_bytes()), "");
}

/// Rods that hang on one another.
fn chain(count: usize) -> String {
    let mut text = "name = \"chain\"\ngravity = [\"0\", \"-9.81 m/s^2\"]\n".to_owned();
    let sections: [(&str, Entry); 3] = [
        ("coordinates", |i| {
            format!("q{i} = {{ unit = \"rad\", range = [-3, 3], speed_range = [-9, 9] }}")
        }),
        ("frames", |i| match i {
            0 => "f0 = { turn = \"q0\" }".to_owned(),
            i => format!("f{i} = {{ in = \"f{}\", origin = [\"0.1 m\"], turn = \"q{i}\" }}", i - 1),
        }),
        ("bodies", |i| {
            format!("b{i} = {{ frame = \"f{i}\", mass = \"1 kg\", centre = [\"0.1 m\"] }}")
        }),
    ];
    for (section, entry) in sections {
        writeln!(text, "[{section}]").expect("text grows");
        for index in 0..count {
            writeln!(text, "{}", entry(index)).expect("text grows");
        }
    }
    text
}

/// What a description may have but a model cannot is refused before it is derived.
#[test]
fn a_chain_of_two_hundred_bodies() {
    refused(chain(200), "\"coordinates\" has 200 entries; there are 64 at most");
    assert_eq!(said_of(chain(CHAIN).into_bytes()), "");
}
