//! What each line of a score does.

use super::curve::Curve;
use super::piece::Piece;
use super::token::{QUARTER, Token, pitch, token};

/// Names of dynamics, with their MIDI velocity.
const DYNAMICS: [(&str, f64); 7] = [
    ("ppp", 30.0),
    ("pp", 36.0),
    ("p", 46.0),
    ("mp", 56.0),
    ("mf", 66.0),
    ("f", 82.0),
    ("ff", 96.0),
];

/// Takes one line into `piece`.
pub(super) fn read(piece: &mut Piece, line: &str) -> Result<(), String> {
    let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    let rest = rest.trim();
    match word {
        "title" => rest.clone_into(&mut piece.title),
        "composer" => rest.clone_into(&mut piece.composer),
        "meter" => return meter(piece, rest),
        "voice" => return voice(piece, rest),
        "tempo" => {
            let (start, bar) = (piece.start(), piece.bar_length());
            return change(&mut piece.tempo, (start, bar), rest, number);
        }
        "dynamic" => {
            let (start, bar) = (piece.start(), piece.bar_length());
            return change(&mut piece.dynamics, (start, bar), rest, dynamic);
        }
        "bar" => return piece.begin_bar(whole(rest)?),
        "pedal" => return pedal(piece, rest),
        "broken" => return broken(piece, rest),
        _ => return notes(piece, word, rest),
    }
    Ok(())
}

fn meter(piece: &mut Piece, rest: &str) -> Result<(), String> {
    let (beats, unit) = rest.split_once('/').ok_or("a meter is written 4/4")?;
    piece.choose_meter(whole(beats)?, whole(unit)?)
}

fn voice(piece: &mut Piece, rest: &str) -> Result<(), String> {
    let (name, louder) = rest.split_once(' ').ok_or("a voice is written: voice NAME LOUDER")?;
    piece.add_voice(name, number(louder)?);
    Ok(())
}

/// `VALUE`, or `VALUE to VALUE over BARS`, from the bar that starts at `start` (ticks).
fn change(
    curve: &mut Curve,
    (start, bar): (u32, u32),
    rest: &str,
    value: fn(&str) -> Result<f64, String>,
) -> Result<(), String> {
    match rest.split_whitespace().collect::<Vec<_>>().as_slice() {
        [only] => curve.step(start, value(only)?),
        [first, "to", last, "over", bars] => {
            curve.ramp(start, whole(bars)? * bar, value(first)?, value(last)?);
        }
        _ => return Err("a change is written VALUE, or VALUE to VALUE over BARS".to_owned()),
    }
    Ok(())
}

fn pedal(piece: &mut Piece, rest: &str) -> Result<(), String> {
    if rest == "off" {
        piece.lift_pedal(0);
        return Ok(());
    }
    for beat in rest.split_whitespace() {
        let at = piece.beat(whole(beat)?)?;
        piece.change_pedal(at);
    }
    Ok(())
}

/// The figure of Bach's first prelude: five pitches, broken as 1 2 3 4 5 3 4 5, twice in a bar.
fn broken(piece: &mut Piece, rest: &str) -> Result<(), String> {
    let pitches = rest.split_whitespace().map(pitch).collect::<Result<Vec<_>, _>>()?;
    let &[bass, tenor, low, middle, high] = pitches.as_slice() else {
        return Err("a broken chord has five pitches".to_owned());
    };
    let sixteenths = |n: u32, pitch: Option<u8>| Token {
        pitches: pitch.into_iter().collect(),
        length: n * QUARTER / 4,
        is_tied: false,
    };
    for _ in 0..2 {
        piece.play_voice(0, &[sixteenths(8, Some(bass))])?;
        piece.play_voice(1, &[sixteenths(1, None), sixteenths(7, Some(tenor))])?;
        piece.play_voice(2, &[sixteenths(2, None)])?;
        let figure = [low, middle, high, low, middle, high];
        piece.play_voice(2, &figure.map(|pitch| sixteenths(1, Some(pitch))))?;
    }
    Ok(())
}

fn notes(piece: &mut Piece, word: &str, rest: &str) -> Result<(), String> {
    let name = word.strip_suffix(':').ok_or_else(|| {
        format!(
            "\"{word}\" is none of title, composer, meter, tempo, dynamic, voice, bar, pedal, \
             broken, nor a voice with a colon"
        )
    })?;
    let tokens = rest.split_whitespace().map(token).collect::<Result<Vec<_>, _>>()?;
    piece.play(name, &tokens)
}

fn dynamic(text: &str) -> Result<f64, String> {
    let named = DYNAMICS.iter().find(|(name, _)| *name == text);
    named.map_or_else(|| number(text), |(_, value)| Ok(*value))
}

fn number(text: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("\"{text}\" is not a number"))
}

fn whole(text: &str) -> Result<u32, String> {
    text.trim().parse().map_err(|_not_a_number| format!("\"{text}\" is not a whole number"))
}
