//! The piece for the guest, as a Standard MIDI File.

/// Ticks per quarter note: at the default 120 quarters a minute, 1 ms each.
const TICKS_PER_QUARTER: u16 = 500;

const CHORD: [u8; 3] = [60, 64, 67];

const REPEATED: u8 = 72;

/// Start of the chord (ms), after time to connect a listener.
const START: u32 = 2_000;

/// End of the piece (ms).
const END: u32 = 20_000;

/// Time between two repetitions, with a note in the first half (ms).
const INTERVAL: u32 = 500;

const NOTE_OFF: u8 = 0x80;
const NOTE_ON: u8 = 0x90;

struct PieceEvent {
    /// Time in the piece (ms).
    at: u32,
    status: u8,
    note: u8,
}

/// Returns a chord held for 18 s, and a note repeated twice a second.
pub(crate) fn file() -> Vec<u8> {
    let mut track = Vec::new();
    let mut now = 0;
    for event in events() {
        variable_length(event.at - now, &mut track);
        track.extend([event.status, event.note, 70]);
        now = event.at;
    }
    track.extend([0, 0xFF, 0x2F, 0]);
    let mut file = b"MThd\0\0\0\x06\0\0\0\x01".to_vec();
    file.extend(TICKS_PER_QUARTER.to_be_bytes());
    file.extend(b"MTrk");
    file.extend(u32::try_from(track.len()).unwrap_or(u32::MAX).to_be_bytes());
    file.extend(track);
    file
}

fn events() -> Vec<PieceEvent> {
    let note = |from, to, note| {
        [
            PieceEvent { at: from, status: NOTE_ON, note },
            PieceEvent { at: to, status: NOTE_OFF, note },
        ]
    };
    let chord = CHORD.into_iter().flat_map(|it| note(START, END, it));
    let starts = (START + INTERVAL..END).step_by(INTERVAL as usize);
    let repeated = starts.flat_map(|at| note(at, at + INTERVAL / 2, REPEATED));
    let mut events: Vec<_> = chord.chain(repeated).collect();
    events.sort_by_key(|event| event.at);
    events
}

/// Appends `value`, below 2^14, in groups of seven bits; all but the last have the highest bit set.
fn variable_length(value: u32, to: &mut Vec<u8>) {
    let [.., low] = (value & 0x7F).to_be_bytes();
    let [.., high] = (value >> 7 | 0x80).to_be_bytes();
    if 0x80 < high {
        to.push(high);
    }
    to.push(low);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chord_is_struck_together_and_ends_last() {
        let events = events();
        let begins: Vec<_> = events[..3].iter().map(|it| (it.at, it.status, it.note)).collect();
        assert_eq!(begins, CHORD.map(|note| (START, NOTE_ON, note)));
        assert!(events[events.len() - 3..].iter().all(|it| it.at == END && it.status == NOTE_OFF));
    }

    #[test]
    fn the_file_begins_as_the_format_asks() {
        let file = file();
        let head = b"MThd\0\0\0\x06\0\0\0\x01\x01\xF4MTrk";
        assert_eq!(&file[..head.len()], head);
        let length = u32::try_from(file.len() - head.len() - 4).unwrap();
        assert_eq!(file[head.len()..head.len() + 4], length.to_be_bytes());
        assert_eq!(file[head.len() + 4..head.len() + 9], [0x8F, 0x50, 0x90, 60, 70]);
    }
}
