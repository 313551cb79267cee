/// Returns a decimal number without trailing zeros.
pub fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

pub fn rounded(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    let digits = match size {
        1e-3..0.01 => 6,
        0.01..0.1 => 5,
        0.1..1.0 => 4,
        1.0..10.0 => 3,
        10.0..100.0 => 2,
        100.0..1000.0 => 1,
        1000.0..1e5 => 0,
        _ => {
            let text = format!("{value:.3e}");
            let (number, power) = text.split_once('e').unwrap_or((&text, "0"));
            return format!("{}e{power}", trimmed(number));
        }
    };
    trimmed(&format!("{value:.digits$}")).to_owned()
}
