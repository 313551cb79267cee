//! Names in LaTeX: `theta_k'` is a dotted θ with the index k.

const GREEK: [&str; 36] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi", "psi",
    "omega", "Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi",
    "Omega", "varphi", "vartheta",
];

pub(super) fn latex(name: &str) -> String {
    if let Some((function, rest)) = name.split_once('(') {
        let of = rest.trim_end_matches(')');
        return format!("\\operatorname{{{}}}_{{{}}}", escaped(function), upright(of));
    }
    let stem = name.trim_end_matches('\'');
    let primes = name.len() - stem.len();
    let (first, rest) = stem.split_once('_').unwrap_or((stem, ""));
    // `k1` has the index 1.
    let letters = first.trim_end_matches(|it: char| it.is_ascii_digit());
    let (letters, digits) =
        if letters.is_empty() { (first, "") } else { first.split_at(letters.len()) };
    let base = match primes {
        0 => base(letters),
        1 => format!("\\dot{{{}}}", base(letters)),
        2 => format!("\\ddot{{{}}}", base(letters)),
        _ => format!("\\dddot{{{}}}", base(letters)),
    };
    let indices: Vec<String> =
        [digits, rest].iter().filter(|it| !it.is_empty()).map(|it| upright(it)).collect();
    if indices.is_empty() { base } else { format!("{base}_{{{}}}", indices.join(",")) }
}

fn base(letters: &str) -> String {
    if GREEK.contains(&letters) {
        format!("\\{letters}")
    } else if letters.chars().count() == 1 {
        letters.to_owned()
    } else {
        format!("\\mathrm{{{}}}", escaped(letters))
    }
}

/// Returns an index: letters and digits unchanged, words upright.
fn upright(name: &str) -> String {
    if GREEK.contains(&name) {
        return format!("\\{name}");
    }
    if name.chars().count() <= 1 || name.chars().all(|it| it.is_ascii_digit()) {
        return escaped(name);
    }
    format!("\\mathrm{{{}}}", escaped(name))
}

pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '_' | '&' | '%' | '$' | '#' | '{' | '}' => {
                escaped.push('\\');
                escaped.push(character);
            }
            '\\' | '~' | '^' => escaped.push(' '),
            _ => escaped.push(character),
        }
    }
    escaped
}
