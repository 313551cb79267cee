//! Notes as they are written: `D4`, `F#3+A3/4.`, `r/8`, `E4/4~`.

/// Ticks per quarter note.
pub(super) const QUARTER: u32 = 480;

/// A note, a chord or a rest.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Token {
    /// MIDI numbers; none is a rest.
    pub(super) pitches: Vec<u8>,
    /// Length (ticks).
    pub(super) length: u32,
    /// Whether it is held over into the next of the same pitch.
    pub(super) is_tied: bool,
}

/// Reads a note, a chord or a rest with its length.
pub(super) fn token(text: &str) -> Result<Token, String> {
    let (text, is_tied) = text.strip_suffix('~').map_or((text, false), |text| (text, true));
    let (pitches, length) =
        text.split_once('/').ok_or_else(|| format!("\"{text}\" has no length: write C4/8"))?;
    let pitches = if pitches == "r" {
        Vec::new()
    } else {
        pitches.split('+').map(pitch).collect::<Result<_, _>>()?
    };
    Ok(Token { pitches, length: self::length(length)?, is_tied })
}

/// MIDI number of a pitch such as C4 (60), F#3 or Bb2.
pub(super) fn pitch(text: &str) -> Result<u8, String> {
    let wrong = || format!("\"{text}\" is not a pitch of the keyboard: write C4, F#3 or Bb2");
    let mut letters = text.chars();
    let step = match letters.next().ok_or_else(wrong)? {
        'C' => 0,
        'D' => 2,
        'E' => 4,
        'F' => 5,
        'G' => 7,
        'A' => 9,
        'B' => 11,
        _ => return Err(wrong()),
    };
    let rest = letters.as_str();
    let octave = rest.trim_start_matches(['#', 'b']);
    let sharps = rest.matches('#').count();
    let flats = rest.matches('b').count();
    let octave: usize = octave.parse().map_err(|_not_a_number| wrong())?;
    let number = (12 * (octave + 1) + step + sharps).checked_sub(flats).ok_or_else(wrong)?;
    u8::try_from(number).ok().filter(|number| (21..=108).contains(number)).ok_or_else(wrong)
}

/// Ticks of a length: 1, 2, 4, 8, 16 or 32, and a dot for half as much again.
fn length(text: &str) -> Result<u32, String> {
    let wrong = || format!("\"{text}\" is not a length: write 1, 2, 4, 8, 16 or 32, or 4.");
    let (part, is_dotted) = text.strip_suffix('.').map_or((text, false), |part| (part, true));
    let part: u32 = part.parse().map_err(|_not_a_number| wrong())?;
    if !part.is_power_of_two() || part > 32 {
        return Err(wrong());
    }
    let plain = 4 * QUARTER / part;
    Ok(if is_dotted { plain + plain / 2 } else { plain })
}
