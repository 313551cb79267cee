//! Arbitrary text is read or rejected.

use mechanism::kane::description::{read, read_bytes};
use proptest::prelude::*;

use super::WEIGHT;

const SPRINGS: &str = include_str!("../../../../instruments/src/key_hammer_springs/model.toml");

/// Fragments, between `~`, that people and other programs write in the wrong place.
const PIECES: &str = "\"~'~''~'''~(~)~[~]~{~}~=~,~\n~^~*~/~-~0~1e308~y~theta_k'~force(k2)~\
                      reaction(wall)~ m~²~key~x(P)~if(y > s, 1, 2)";

fn piece(at: usize) -> &'static str {
    let count = PIECES.split('~').count();
    PIECES.split('~').nth(at % count).unwrap()
}

fn spoiled(text: &str, at: &[(usize, usize, usize)]) -> String {
    let mut text = text.to_owned();
    for (start, len, piece) in at {
        let start = text.floor_char_boundary(start % (text.len() + 1));
        let end = text.floor_char_boundary((start + len).min(text.len())).max(start);
        text.replace_range(start..end, self::piece(*piece));
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_spoiled_description_is_read_or_refused(
        at in prop::collection::vec((any::<usize>(), 0usize..12, any::<usize>()), 1..6),
        is_large in any::<bool>(),
    ) {
        let text = spoiled(if is_large { SPRINGS } else { WEIGHT }, &at);
        match read("spoiled.toml", &text, &()) {
            Ok(description) => prop_assert!(!description.mechanism.modes.is_empty()),
            Err(mistakes) => prop_assert!(!mistakes.as_slice().is_empty()),
        }
    }

    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        if let Err(mistakes) = read_bytes("bytes", &bytes, &()) {
            prop_assert!(!mistakes.as_slice().is_empty());
        }
    }

    #[test]
    fn any_expression_is_read_or_refused(
        pieces in prop::collection::vec(any::<usize>(), 0..30),
    ) {
        let text: String = pieces.iter().map(|it| piece(*it)).collect();
        for form in [mechanism::kane::text::Form::Value, mechanism::kane::text::Form::Condition] {
            if let Err(error) = mechanism::kane::text::parse(&text, form) {
                prop_assert!(error.span.start <= text.len());
            }
        }
    }
}
