"""Finds every note of a MIDI file in the WAV file of the same run: its first frame and its pitch.

Needs mido and numpy from PyPI; knows nothing of Letoff. The font is a cosine that begins at its
maximum (crates/midi/tests/font/cosine.py): the second difference of the sound is large in the first
frame of a note, and in no other.

    heard.py FILE.mid FILE.wav
"""

import sys
import wave

import mido
import numpy as np

WINDOW = 2400  # frames in which a pitch is measured; it is not of a note that is over before
CENTS = -5.1  # of the font, by its period of 184 frames


def notes(path):
    """Onset and end (s) of each note, and its number."""
    now, sounding, found = 0.0, {}, []
    for message in mido.MidiFile(path):
        now += message.time
        if message.type == "note_on" and message.velocity > 0:
            sounding[message.note] = now
        elif message.type in ("note_on", "note_off"):
            found.append((sounding.pop(message.note), now, message.note))
    assert not sounding, sounding
    return sorted(found)


def sound(path):
    with wave.open(path) as file:
        assert (file.getnchannels(), file.getsampwidth()) == (2, 2)
        frames = np.frombuffer(file.readframes(file.getnframes()), dtype="<i2")
        return file.getframerate(), frames[::2] / 32768.0


def level(window, hertz, rate):
    turns = np.exp(-2j * np.pi * hertz / rate * np.arange(len(window)))
    return abs(np.mean(window * np.hanning(len(window)) * turns))


def main(midi, wav):
    rate, left = sound(wav)
    bend = np.abs(np.diff(left, n=2, prepend=[0.0, 0.0]))
    played = [[round(at * rate), round(end * rate), note] for at, end, note in notes(midi)]
    edges = np.flatnonzero(bend > 0.004)
    first = set(edges[np.diff(edges, prepend=-99) > 8])
    for frame, end, note in played:
        near = [it for it in first if abs(it - frame) <= 3]
        assert near, f"no note {note} at frame {frame}"
        if end - frame < WINDOW:
            continue
        hertz = 440.0 * 2 ** ((note - 69 + CENTS / 100) / 12)
        after = left[frame + 4 : frame + 4 + WINDOW]
        levels = [level(after, hertz * 2 ** (cents / 1200), rate) for cents in (-100, 0, 100)]
        assert max(levels) == levels[1] > 1e-3, f"note {note} at frame {frame}: {levels}"
    frames = {frame for frame, *_ in played}
    extra = [it for it in first if not any(abs(it - frame) <= 3 for frame in frames)]
    assert not extra, f"sounds that were not struck at frames {extra}"
    print(f"{len(played)} notes are heard")


main(*sys.argv[1:])
