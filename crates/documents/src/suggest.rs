//! Names in messages: quoted, and the nearest known name.

use std::borrow::Cow;

/// Longest piece of user text that a message repeats (characters).
const LONGEST: usize = 60;

/// Returns `text` in quotes, on one line, shortened if it is very long.
pub fn quoted(text: &str) -> String {
    format!("{:?}", shortened(text))
}

/// Returns `text`, or its first 60 characters and `…`.
pub fn shortened(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(LONGEST) {
        Some((end, _character)) => format!("{}…", &text[..end]).into(),
        None => text.into(),
    }
}

/// Returns the remedy for the unknown name `wrong`: the nearest of `known`, or all of them.
pub fn choice(wrong: &str, known: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    let known: Vec<_> = known.into_iter().collect();
    let known: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    match (nearest(wrong, &known), known.as_slice()) {
        (_, []) => "remove it".to_owned(),
        (_, [only]) => format!("use {only:?}"),
        (None, _) => format!("use one of {}", known.join(", ")),
        (Some(near), _) => format!("use {near:?}, the nearest of {}", known.join(", ")),
    }
}

/// Returns the one of `known` that was probably meant.
pub fn nearest<'a>(wrong: &str, known: &[&'a str]) -> Option<&'a str> {
    if wrong.chars().nth(LONGEST).is_some() {
        return None;
    }
    let wrong = wrong.to_lowercase();
    if let Some(name) = only_beginning_with(&wrong, known) {
        return Some(name);
    }
    let ranked = known.iter().map(|name| {
        let right = name.to_lowercase();
        (strsim::osa_distance(&wrong, &right), right.chars().count(), *name)
    });
    let (edits, len, name) = ranked.min_by_key(|(edits, ..)| *edits)?;
    let written = wrong.chars().count();
    // A third of the name may differ: "steper", "kalmann", but not "k1" for "cK".
    let shorter = len.min(written);
    (edits <= shorter.div_ceil(3).min(3) && edits < shorter).then_some(name)
}

/// Returns the only one of `known` that begins with `start` of three characters or more.
fn only_beginning_with<'a>(start: &str, known: &[&'a str]) -> Option<&'a str> {
    let mut found = known.iter().filter(|name| name.to_lowercase().starts_with(start));
    match (found.next(), found.next()) {
        (Some(name), None) if start.chars().nth(2).is_some() => Some(name),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(wrong: &str, expected: Option<&str>) {
        let known = ["rk4", "heun", "bogacki-shampine", "restitution", "k1", "cK"];
        assert_eq!(nearest(wrong, &known), expected, "{wrong}");
    }

    #[test]
    fn a_slip_of_the_finger_finds_the_name() {
        check("rk5", Some("rk4"));
        check("huen", Some("heun"));
        check("Heun", Some("heun"));
        check("bogacki_shampine", Some("bogacki-shampine"));
        check("restitutoin", Some("restitution"));
        check("bogacki", Some("bogacki-shampine"));
    }

    #[test]
    fn a_stranger_among_a_model_s_names_finds_nothing() {
        let known = ["key-hammer-springs", "key-hammer-rigid", "L1"];
        assert_eq!(nearest("key-hamer-sprigns", &known), Some("key-hammer-springs"));
        assert_eq!(nearest("l1", &known), Some("L1"));
        assert_eq!(nearest("sni", &["cos", "sin", "sinh"]), Some("sin"));
        assert_eq!(nearest("harpsichord", &known), None);
        assert_eq!(nearest("z", &["y", "v"]), None);
        assert_eq!(nearest("x", &[]), None);
    }

    #[test]
    fn something_else_finds_nothing() {
        check("euler", None);
        check("zz", None);
        check("", None);
        check(&"rk4".repeat(10_000), None);
    }

    #[test]
    fn what_is_repeated_stays_on_one_short_line() {
        assert_eq!(quoted("a\nb"), r#""a\nb""#);
        assert_eq!(quoted(&"x".repeat(1000)).chars().count(), LONGEST + 3);
    }
}
