//! Odd files are played like other players do, or refused with track and byte.

use pianist::{ChosenParts, Score, read_parts};

#[test]
fn odd_files_are_played_as_everywhere_or_refused() {
    let rows = include_str!("odd_files.txt").lines().filter(|row| !row.starts_with('#'));
    let mut wrong = Vec::new();
    for row in rows {
        let fields: Vec<_> = row.split('|').map(str::trim).collect();
        let [name, format, parts, cut, chunks, expected] = fields[..] else { panic!("{row}") };
        let bytes = file(format, chunks);
        let bytes = &bytes[..bytes.len() - cut.parse::<usize>().expect("a number")];
        match (read_parts(bytes, &chosen(parts)), expected.strip_prefix("! ")) {
            (Ok(score), None) if described(&score) == expected => {}
            (Err(error), Some(sentence)) if error.to_string().contains(sentence) => {}
            (Ok(score), _) => wrong.push(format!("{name}: {}", described(&score))),
            (Err(error), _) => wrong.push(format!("{name}: {error}")),
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn chosen(parts: &str) -> ChosenParts {
    let number = |kind| parts.strip_prefix(kind).map(|it: &str| it.parse().expect("a number"));
    let tracks = number('t').into_iter().collect();
    ChosenParts {
        tracks,
        channels: number('c').into_iter().filter_map(|it| it.try_into().ok()).collect(),
    }
}

/// Returns a file of 50 ticks a quarter note, with `chunks` of hexadecimal bytes.
fn file(format: &str, chunks: &str) -> Vec<u8> {
    let mut body = Vec::new();
    let mut tracks = 0;
    for chunk in chunks.split('/') {
        let (kind, digits) = chunk.trim().split_once(':').unwrap_or(("MTrk", chunk));
        let digits: Vec<u8> = digits.bytes().filter(|it| !it.is_ascii_whitespace()).collect();
        let byte = |pair: &[u8]| u8::from_str_radix(str::from_utf8(pair).expect("text"), 16);
        let bytes: Vec<u8> = digits.chunks(2).map(|pair| byte(pair).expect("digits")).collect();
        tracks += u8::from(kind == "MTrk");
        let length = u32::try_from(bytes.len()).expect("short").to_be_bytes();
        body.extend([kind.as_bytes(), &length, &bytes].concat());
    }
    let format = format.parse().expect("a number");
    [b"MThd\0\0\0\x06\0", &[format, 0, tracks, 0, 50][..], &body].concat()
}

fn described(score: &Score) -> String {
    let hundredths = |value: f64| (value * 100.0).round() / 100.0;
    let notes = score
        .notes
        .iter()
        .map(|it| format!("{}:{}-{}", it.key + 21, hundredths(it.onset), hundredths(it.end)));
    let pedals = score
        .pedals
        .iter()
        .map(|it| format!("{:?}@{}={}", it.pedal, hundredths(it.at), hundredths(it.depth)));
    let counts = score.passed_over.named().filter(|(_, n)| 0 < *n);
    let counts = counts.map(|(name, n)| format!("{name}={n}"));
    notes.chain(pedals).chain(counts).collect::<Vec<_>>().join(" ")
}
