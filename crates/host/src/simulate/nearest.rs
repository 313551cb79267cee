//! The name that was probably meant.

/// The known name that is nearest, if at most a third of its letters are wrong.
pub(super) fn nearest(name: &str, known: &[&'static str]) -> Option<&'static str> {
    let slips = known.iter().map(|candidate| (slips(name, candidate), *candidate));
    let (slips, near) = slips.min_by_key(|(slips, _)| *slips)?;
    let letters = name.chars().count().max(near.chars().count());
    (3 * slips <= letters).then_some(near)
}

/// Letters to insert, drop, change or swap to make `a` into `b`; case does not count.
fn slips(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|text| text.to_lowercase().chars().collect::<Vec<_>>());
    let mut before = vec![0; b.len() + 1];
    let mut above: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let change = above[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = change.min(above[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && (a[i - 1], a[i - 2]) == (b[j - 2], b[j - 1]) {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        (before, above) = (above, row);
    }
    above[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slip_of_the_finger_is_recognised_and_a_stranger_is_not() {
        let known = ["key-hammer-springs", "key-hammer-rigid", "L1"];
        assert_eq!(nearest("key-hamer-sprigns", &known), Some("key-hammer-springs"));
        assert_eq!(nearest("l1", &known), Some("L1"));
        assert_eq!(nearest("sni", &["cos", "sin", "sinh"]), Some("sin"));
        assert_eq!(nearest("harpsichord", &known), None);
        assert_eq!(nearest("z", &["y", "v"]), None);
        assert_eq!(nearest("x", &[]), None);
    }
}
