//! Names in messages: quoted, and the nearest that would have been right.

/// Longest piece of somebody's text that is repeated in a message (characters).
const LONGEST: usize = 60;

/// `text` in quotes, on one line, shortened if it is very long.
pub(crate) fn quoted(text: &str) -> String {
    if text.chars().nth(LONGEST).is_none() {
        return format!("{text:?}");
    }
    let short: String = text.chars().take(LONGEST).chain(['…']).collect();
    format!("{short:?}")
}

/// What to do about `wrong`, where one of `known` is right.
pub(crate) fn choice(wrong: &str, known: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    let known: Vec<_> = known.into_iter().collect();
    let known: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    match (nearest(wrong, &known), known.as_slice()) {
        (_, []) => "remove it".to_owned(),
        (_, [only]) => format!("use {only:?}"),
        (None, _) => format!("use one of {}", known.join(", ")),
        (Some(near), _) => format!("use {near:?}, the nearest of {}", known.join(", ")),
    }
}

/// The one of `known` that was probably meant.
pub(crate) fn nearest<'a>(wrong: &str, known: &[&'a str]) -> Option<&'a str> {
    let wrong: Vec<char> = wrong.chars().take(LONGEST + 1).flat_map(char::to_lowercase).collect();
    if LONGEST < wrong.len() {
        return None;
    }
    if let Some(name) = only_beginning_with(&wrong, known) {
        return Some(name);
    }
    let ranked = known.iter().map(|name| {
        let right: Vec<char> = name.chars().flat_map(char::to_lowercase).collect();
        (distance(&wrong, &right), right.len(), *name)
    });
    let (edits, len, name) = ranked.min_by_key(|(edits, ..)| *edits)?;
    // A third of the name may be wrong: "steper", "kalmann", but not "k1" for "cK".
    (edits <= len.min(wrong.len()).div_ceil(3).min(3) && edits < len.min(wrong.len()))
        .then_some(name)
}

/// The only one of `known` that begins with `start`, if that is three characters or more.
fn only_beginning_with<'a>(start: &[char], known: &[&'a str]) -> Option<&'a str> {
    let start: String = start.iter().collect();
    let mut found = known.iter().filter(|name| name.to_lowercase().starts_with(&start));
    match (found.next(), found.next()) {
        (Some(name), None) if 3 <= start.len() => Some(name),
        _ => None,
    }
}

/// Least number of insertions, deletions, replacements and swaps of neighbours.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut older: Vec<usize> = Vec::new();
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, y) in b.iter().enumerate() {
            let replaced = above[j] + usize::from(x != y);
            let mut best = replaced.min(above[j + 1] + 1).min(row[j] + 1);
            if 0 < i && 0 < j && *x == b[j - 1] && a[i - 1] == *y {
                best = best.min(older[j - 1] + 1);
            }
            row.push(best);
        }
        older = std::mem::replace(&mut above, row);
    }
    above[b.len()]
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
