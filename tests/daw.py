"""Compares a MIDI file that Letoff played with the file that Letoff wrote.

Needs mido, pretty_midi and music21 from PyPI; knows nothing of Letoff.

    daw.py make FILE.mid          writes a piece with bars, tempi, names and a marker
    daw.py compare SOURCE WRITTEN asserts the same notes, tempo, bars and names
"""

import sys

import mido
import music21
import pretty_midi

# Keys, beats from the start, lengths (beats) and velocities of the piece, with no key twice within
# a second. Bars of 3/4 to beat 12, of 4/4 from there on.
NOTES = [
    (60 + 5 * (i % 6), 0.5 * i, 0.4 + 0.1 * (i % 3), 45 + 3 * (i % 9)) for i in range(40)
]


def make(path):
    """A format 1 file: a conductor, and two tracks whose delta times are at 96 a quarter."""
    file = mido.MidiFile(type=1, ticks_per_beat=96)
    conductor = mido.MidiTrack()
    conductor.append(mido.MetaMessage("track_name", name="A piece for tests"))
    conductor.append(mido.MetaMessage("time_signature", numerator=3, denominator=4))
    conductor.append(mido.MetaMessage("key_signature", key="Eb"))
    conductor.append(mido.MetaMessage("set_tempo", tempo=mido.bpm2tempo(100)))
    conductor.append(mido.MetaMessage("set_tempo", tempo=mido.bpm2tempo(73), time=96 * 6))
    conductor.append(mido.MetaMessage("marker", text="second part", time=96 * 6))
    conductor.append(mido.MetaMessage("time_signature", numerator=4, denominator=4))
    conductor.append(mido.MetaMessage("set_tempo", tempo=mido.bpm2tempo(131)))
    file.tracks.append(conductor)
    for channel, name in enumerate(["right hand", "left hand"]):
        events = []
        for key, beat, length, velocity in NOTES[channel::2]:
            on, off = round(96 * beat), round(96 * (beat + length))
            events.append((on, mido.Message("note_on", note=key, velocity=velocity)))
            events.append((off, mido.Message("note_off", note=key)))
        track, now = mido.MidiTrack(), 0
        track.append(mido.MetaMessage("track_name", name=name))
        for tick, message in sorted(events, key=lambda it: it[0]):
            track.append(message.copy(time=tick - now, channel=channel))
            now = tick
        file.tracks.append(track)
    file.save(path)


def near(found, expected, tolerance, what):
    assert abs(found - expected) <= tolerance, f"{what}: {found}, expected {expected}"


def metas(path, kind):
    """Meta events of a kind, each with its time in quarter notes and in seconds."""
    file = mido.MidiFile(path)
    tick, seconds, tempo, found = 0, 0.0, 500_000, []
    for message in mido.merge_tracks(file.tracks):
        tick += message.time
        seconds += mido.tick2second(message.time, file.ticks_per_beat, tempo)
        if message.type == "set_tempo":
            tempo = message.tempo
        if message.type == kind:
            found.append((tick / file.ticks_per_beat, seconds, message))
    return found


def with_mido(source, written, lead_in):
    """The tempo map, the signatures and the marker are the source's, later by the lead-in."""
    for kind, value in [
        ("set_tempo", lambda it: it.tempo),
        ("time_signature", lambda it: (it.numerator, it.denominator)),
        ("key_signature", lambda it: it.key),
        ("marker", lambda it: it.text),
    ]:
        expected, found = metas(source, kind), metas(written, kind)
        assert len(found) == len(expected) > 0, (kind, found)
        for (beat, _, wanted), (played, _, message) in zip(expected, found):
            later = lead_in if 0 < beat or kind == "marker" else 0
            assert (played, value(message)) == (beat + later, value(wanted)), (kind, played, beat)
    assert [it[2].name for it in metas(written, "track_name")] == ["A piece for tests"]
    texts = [it[2].text for it in metas(written, "text")]
    assert texts[0].startswith("Played by Letoff "), texts
    assert texts[1:] == ["track 2: right hand", "track 3: left hand"], texts
    division = mido.MidiFile(written).ticks_per_beat
    assert division % 96 == 0 and division < 32_768, division
    slowest = max(it[2].tempo for it in metas(written, "set_tempo"))
    assert slowest / division <= 50, "a tick takes more than 50 us"


def with_pretty_midi(source, written, later):
    """The notes are the source's, later by `later` (s)."""
    notes = {}
    for path in (source, written):
        midi = pretty_midi.PrettyMIDI(path)
        found = [note for instrument in midi.instruments for note in instrument.notes]
        notes[path] = sorted(found, key=lambda note: (note.pitch, note.start))
    assert len(notes[written]) == len(notes[source]) == len(NOTES)
    for asked, played in zip(notes[source], notes[written]):
        assert played.pitch == asked.pitch
        near(played.start, asked.start + later, 1.5e-3, f"onset of {asked}")
        near(played.end, asked.end + later, 30e-3, f"end of {asked}")
        near(played.velocity, asked.velocity, 2, f"velocity of {asked}")
    return notes[source]


def with_music21(source, written, bars):
    """The measures are the source's after those of the lead-in, and every note is on its beat."""
    measures, notes = [], []
    for path in (source, written):
        score = music21.converter.parse(path, quantizePost=False)
        begins, found = set(), []
        for part in score.parts:
            begins.update(it.offset for it in part.getElementsByClass(music21.stream.Measure))
            for element in part.recurse().notes:
                if element.tie is None or element.tie.type == "start":
                    at = float(element.getOffsetInHierarchy(part))
                    found += [(pitch.midi, at) for pitch in element.pitches]
        measures.append(sorted(begins))
        notes.append(sorted(found))
    of_source, of_written = measures
    lead_in = of_written[bars]
    later = [it + lead_in for it in of_source]
    n = min(len(later), len(of_written) - bars)
    # The last release may be just before or after a bar line.
    assert abs(len(of_written) - bars - len(of_source)) <= 1 < n, measures
    assert of_written[bars:][:n] == later[:n], (measures, lead_in)
    assert [len(it) for it in notes] == [len(NOTES), len(NOTES)]
    for (key, at), (played_key, played) in zip(*notes):
        assert key == played_key
        near(played, at + float(lead_in), 0.01, f"beat of {key}")


def compare(source, written):
    # A bar of 3/4 at 100 a minute takes 1.8 s, and a second of silence comes first.
    bars, beats = 1, 3
    with_mido(source, written, beats)
    with_pretty_midi(source, written, 1.8 * bars)
    with_music21(source, written, bars)
    print(f"{len(NOTES)} notes, {bars} bar before")


{"make": make, "compare": compare}[sys.argv[1]](*sys.argv[2:])
