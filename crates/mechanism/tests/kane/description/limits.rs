//! Too long, too many or too deep descriptions are rejected, without a stack overflow.

use std::fmt::Write as _;

use mechanism::kane::derive_model;
use mechanism::kane::description::{LONGEST, MOST_EXPRESSIONS, read_bytes};

use super::{WEIGHT, mistake, mistakes_of};

#[track_caller]
fn refuses(text: &str, part: &str) {
    let mistakes = mistakes_of(text, &());
    assert!(mistakes.iter().any(|it| it.contains(part)), "{part:?} is not in {mistakes:?}");
}

#[test]
fn a_hundred_megabytes_are_refused_unread() {
    let bytes = vec![b'#'; 100 << 20];
    let mistakes = read_bytes("large.toml", &bytes, &()).expect_err("too long");
    assert!(mistakes.to_string().contains("104857600 bytes long"), "{mistakes}");
}

#[test]
fn ten_thousand_coordinates_are_refused() {
    let mut text = "name = \"many\"\n[coordinates]\n".to_owned();
    for index in 0..10_000 {
        writeln!(text, "q{index} = {{ unit = \"m\", range = [0, 1], speed_range = [0, 1] }}")
            .expect("text grows");
    }
    assert!(text.len() < LONGEST);
    refuses(&text, "\"coordinates\" has 10000 entries");
}

#[test]
fn an_expression_of_ten_thousand_levels_is_refused() {
    for (open, close) in [("(", ")"), ("-", ""), ("sin(", ")"), ("2^", "")] {
        let deep = format!("{}y{}", open.repeat(10_000), close.repeat(10_000));
        let said = mistake("\"y - s\"", &format!("\"{deep}\""));
        assert!(said.contains("nests more than 200 deep"), "{said}");
    }
}

#[test]
fn a_long_expression_is_refused() {
    let long = vec!["y"; 10_000].join(" + ");
    let said = mistake("\"y - s\"", &format!("\"{long}\""));
    assert!(said.contains("the expression is too long"), "{said}");
}

#[test]
fn values_that_nest_are_refused_without_a_stack_overflow() {
    for deep in [
        format!("a = {}{}", "[".repeat(10_000), "]".repeat(10_000)),
        format!("a = {}{}", "{a=".repeat(10_000), "}".repeat(10_000)),
        format!("{}a = 1", "a.".repeat(100_000)),
        format!("[{}a]", "a.".repeat(100_000)),
        format!("{}a = 1", "a . ".repeat(1_900)),
        format!("[[{}a]]", "a.".repeat(1_900)),
    ] {
        assert!(!mistakes_of(&deep, &()).is_empty());
    }
}

#[test]
fn too_many_expressions_are_refused() {
    let mut text = WEIGHT.to_owned();
    for guard in 0..100 {
        write!(text, "\n[[drawing.outlines]]\nname = \"o{guard}\"\npoints = [")
            .expect("text grows");
        text.push_str(&"[\"0 m\", \"0 m\"], ".repeat(25));
        text.push_str("]\n");
    }
    refuses(&text, &format!("more than {MOST_EXPRESSIONS} expressions"));
}

/// Each is the product of all earlier ones: 2²⁰⁰ factors if they were multiplied out.
#[test]
fn expressions_that_grow_are_refused() {
    let mut definitions = "[definitions]\na0 = \"1 + sin(y/(1 m))\"\n".to_owned();
    for index in 1..200 {
        let sum = (0..index).map(|it| format!("a{it}*sin({index} + a{it})")).collect::<Vec<_>>();
        writeln!(definitions, "a{index} = \"{}\"", sum.join(" + ")).expect("text grows");
    }
    refuses(&WEIGHT.replacen("[definitions]\n", &definitions, 1), "too large together");
}

#[track_caller]
fn derived(text: &str) {
    if let Err(mistakes) = derive_model("it.toml", text, &()) {
        panic!("{mistakes}");
    }
}

#[test]
fn the_sine_of_a_long_sum() {
    let terms = (1..80).map(|it| format!("cos({it}*y/(1 m))")).collect::<Vec<_>>();
    let sine = format!("\"y - s + 1 m*sin(-{})\"", terms.join(" - "));
    derived(&WEIGHT.replacen("\"y - s\"", &sine, 1));
}

type Entry = fn(usize) -> String;

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

#[test]
fn a_chain_of_two_hundred_bodies() {
    let said = derive_model("it.toml", &chain(200), &()).unwrap_err().to_string();
    assert!(said.contains("\"coordinates\" has 200 entries; there are 64 at most"), "{said}");
    derived(&chain(8));
}
