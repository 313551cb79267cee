"""Encodes written scores as MIDI files: encode_score.py FILE.score [FILE.mid].

The notation is explained in README.md.
Without a second name, the MIDI file stands beside the score.
"""

import bisect
import dataclasses
import math
import pathlib
import re
import struct
import sys

QUARTER = 480  # ticks
PEDAL_PAUSE = QUARTER // 4  # between lifting the pedal and pressing it again (ticks)
DOWNBEAT, MIDDLE, OFFBEAT = 4.0, 2.0, -2.0  # louder than a weak beat, in MIDI units
DYNAMICS = {"ppp": 30.0, "pp": 36.0, "p": 46.0, "mp": 56.0, "mf": 66.0, "f": 82.0, "ff": 96.0}
STEPS = {"C": 0, "D": 2, "E": 4, "F": 5, "G": 7, "A": 9, "B": 11}
STATEMENTS = "title, composer, meter, tempo, dynamic, voice, bar, pedal, broken"


class Mistake(Exception):
    """What is wrong in a line of a score."""


def nearest(value):
    """The nearest whole number to a positive value, halves upwards."""
    return math.floor(value + 0.5)


def whole(text):
    if not re.fullmatch(r"\s*\d+\s*", text):
        raise Mistake(f'"{text}" is not a whole number')
    return int(text)


def number(text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise Mistake(f'"{text}" is not a number')
    return value


def dynamic(text):
    return DYNAMICS[text] if text in DYNAMICS else number(text)


def pitch(text):
    """MIDI number of a pitch such as C4 (60), F#3 or Bb2."""
    parts = re.fullmatch(r"([A-G])([#b]*)(\d+)", text)
    if parts:
        step, accidentals, octave = parts.groups()
        shift = accidentals.count("#") - accidentals.count("b")
        key = 12 * (int(octave) + 1) + STEPS[step] + shift
        if 21 <= key <= 108:
            return key
    raise Mistake(f'"{text}" is not a pitch of the keyboard: write C4, F#3 or Bb2')


def note(text):
    """The pitches, the length (ticks) and the tie of `D4/4`, `F#3+A3/4.`, `r/8` or `E4/4~`."""
    names, slash, length = text.removesuffix("~").partition("/")
    if not slash:
        raise Mistake(f'"{names}" has no length: write C4/8')
    pitches = [] if names == "r" else [pitch(name) for name in names.split("+")]
    part = length.removesuffix(".")
    if part not in ("1", "2", "4", "8", "16", "32"):
        raise Mistake(f'"{length}" is not a length: write 1, 2, 4, 8, 16 or 32, or 4.')
    ticks = 4 * QUARTER // int(part)
    return pitches, ticks + ticks // 2 * (part != length), text.endswith("~")


class Curve:
    """A value that changes over a piece: corners at ticks, straight lines between them."""

    def __init__(self):
        self.corners = []

    def step(self, tick, value):
        if self.corners:
            self.corners.append((tick, self.at(tick)))
        self.corners.append((tick, value))

    def at(self, tick):
        """The value at `tick`; that of the first corner before it, zero if there is none."""
        after = bisect.bisect_right(self.corners, tick, key=lambda corner: corner[0])
        around = self.corners[max(after - 1, 0) : after + 1]
        if not around:
            return 0.0
        if after == 0 or len(around) == 1:
            return around[0][1]
        (start, low), (end, high) = around
        return low + (high - low) * (tick - start) / (end - start)


@dataclasses.dataclass
class Voice:
    louder: float  # than the dynamics, in MIDI units
    tied: list = dataclasses.field(default_factory=list)  # sounds that are held over
    filled: int | None = None  # ticks of this bar; None if it is silent in it


@dataclasses.dataclass
class Sound:
    pitch: int
    start: int
    end: int
    velocity: int


class Piece:
    """A piece as far as it has been read."""

    def __init__(self):
        self.title = self.composer = ""
        self.tempo, self.dynamics = Curve(), Curve()
        self.sounds, self.pedals, self.voices = [], [], {}
        self.beats, self.beat = 0, 0  # in a bar; ticks
        self.bar, self.start = 0, 0  # counted from 1; ticks

    def length(self):
        return self.beats * self.beat

    def end(self):
        return max((sound.end for sound in self.sounds), default=0)

    def read(self, line):
        """Takes one line into the piece."""
        word, *rest = line.split(None, 1)
        rest = rest[0].strip() if rest else ""
        if word in ("title", "composer"):
            setattr(self, word, rest)
        elif word == "meter":
            beats, slash, unit = rest.partition("/")
            if not slash:
                raise Mistake("a meter is written 4/4")
            if whole(beats) == 0 or whole(unit) not in (1, 2, 4, 8, 16):
                raise Mistake(f"{rest} is not a meter")
            self.beats, self.beat = int(beats), 4 * QUARTER // int(unit)
        elif word == "voice":
            name, blank, louder = rest.partition(" ")
            if not blank:
                raise Mistake("a voice is written: voice NAME LOUDER")
            self.voices[name] = Voice(number(louder))
        elif word == "tempo":
            self.change(self.tempo, rest, number)
        elif word == "dynamic":
            self.change(self.dynamics, rest, dynamic)
        elif word == "bar":
            self.begin_bar(whole(rest))
        elif word == "pedal":
            self.pedal(rest)
        elif word == "broken":
            self.broken([pitch(name) for name in rest.split()])
        elif word.endswith(":"):
            name = word[:-1]
            if name not in self.voices:
                raise Mistake(f'no voice is called "{name}"')
            self.play(self.voices[name], [note(text) for text in rest.split()])
        else:
            raise Mistake(f'"{word}" is none of {STATEMENTS}, nor a voice with a colon')

    def change(self, curve, rest, value):
        """`VALUE`, or `VALUE to VALUE over BARS`, from this bar."""
        match rest.split():
            case [only]:
                curve.step(self.start, value(only))
            case [first, "to", last, "over", bars]:
                curve.step(self.start, value(first))
                curve.corners.append((self.start + whole(bars) * self.length(), value(last)))
            case _:
                raise Mistake("a change is written VALUE, or VALUE to VALUE over BARS")

    def begin_bar(self, bar):
        self.finish_bar()
        if self.length() == 0:
            raise Mistake("give the meter before the first bar")
        if bar != self.bar + 1:
            raise Mistake(f"this is bar {self.bar + 1}, not {bar}")
        self.start += self.length() * (self.bar > 0)
        self.bar = bar

    def finish_bar(self):
        """Checks that every voice that plays in this bar fills it."""
        for name, voice in self.voices.items():
            if voice.filled not in (None, self.length()):
                raise Mistake(f"voice {name} does not fill bar {self.bar}")
            if voice.filled is None:
                voice.tied = []
            voice.filled = None

    def pedal(self, rest):
        if rest == "off":
            return self.lift_pedal(self.start)
        for beat in rest.split():
            if not 1 <= whole(beat) <= self.beats:
                raise Mistake(f"a bar has no beat {beat}")
            at = self.start + (int(beat) - 1) * self.beat
            self.lift_pedal(at)
            self.pedals.append((at + PEDAL_PAUSE, True))

    def lift_pedal(self, at):
        if self.pedals and self.pedals[-1][1]:
            self.pedals.append((at, False))

    def broken(self, pitches):
        """The figure of Bach's first prelude, twice in a bar."""
        if len(pitches) != 5:
            raise Mistake("a broken chord has five pitches")
        if len(self.voices) < 3:
            raise Mistake("name three voices before a broken chord")
        sixteenth = QUARTER // 4
        bass, tenor, *upper = [[key] for key in pitches]
        voices = list(self.voices.values())
        for _ in range(2):
            self.play(voices[0], [(bass, 8 * sixteenth, False)])
            self.play(voices[1], [([], sixteenth, False), (tenor, 7 * sixteenth, False)])
            figure = [([], 2 * sixteenth, False)]
            self.play(voices[2], figure + [(key, sixteenth, False) for key in 2 * upper])

    def play(self, voice, notes):
        if self.bar == 0:
            raise Mistake("begin a bar before the notes")
        for pitches, length, is_tied in notes:
            filled = voice.filled or 0
            start, held, sounding = self.start + filled, voice.tied, []
            for key in pitches:
                sound = next((it for it in held if it.pitch == key), None)
                if sound is None:
                    sound = Sound(key, start, start, self.velocity(start, filled, voice.louder))
                    self.sounds.append(sound)
                sound.end = start + length
                sounding.append(sound)
            voice.filled = filled + length
            voice.tied = sounding if is_tied else []

    def velocity(self, at, filled, louder):
        if filled == 0:
            accent = DOWNBEAT
        elif 2 * filled == self.length():
            accent = MIDDLE
        else:
            accent = OFFBEAT if filled % self.beat else 0.0
        return min(max(nearest(self.dynamics.at(at) + louder + accent), 1), 127)

    def events(self):
        """All MIDI events with their ticks; of those of one tick, note-offs before note-ons."""
        last = None
        for tick in range(0, self.end(), QUARTER):
            us = nearest(60e6 / (self.tempo.at(tick) or 120.0))
            if us != last:
                yield tick, b"\xff\x51\x03" + us.to_bytes(3, "big")
            last = us
        for kind, text in ((3, self.title), (1, self.composer)):
            text = text.encode()
            yield 0, bytes([0xFF, kind]) + variable(len(text)) + text
        for sound in self.sounds:
            yield sound.end, bytes([0x80, sound.pitch, 64])
        for at, is_down in self.pedals:
            yield at, bytes([0xB0, 64, 127 * is_down])
        yield self.end(), bytes([0xB0, 64, 0])
        for sound in self.sounds:
            yield sound.start, bytes([0x90, sound.pitch, sound.velocity])


def variable(value):
    """A number of variable length, as MIDI files write it."""
    parts = [value & 0x7F]
    while value := value >> 7:
        parts.append(0x80 | value & 0x7F)
    return bytes(reversed(parts))


def encode(piece):
    """The piece as a Standard MIDI File of format 0."""
    track, now, status = b"", 0, None
    for at, event in sorted(piece.events(), key=lambda timed: timed[0]):
        track += variable(at - now)
        track += event[1:] if event[0] == status else event
        now, status = at, event[0] if event[0] < 0xF0 else None
    track += variable(QUARTER) + b"\xff\x2f\x00"
    header = struct.pack(">4sIHHH", b"MThd", 6, 0, 1, QUARTER)
    return header + struct.pack(">4sI", b"MTrk", len(track)) + track


def read(path):
    piece, at = Piece(), 0
    try:
        for at, line in enumerate(path.read_text().splitlines(), 1):
            line = line.split(" --")[0].strip()
            if line and not line.startswith("--"):
                piece.read(line)
        piece.finish_bar()
    except Mistake as mistake:
        sys.exit(f"{path}:{at}: {mistake}")
    return piece


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: encode_score.py FILE.score [FILE.mid]")
    score = pathlib.Path(sys.argv[1])
    target = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else score.with_suffix(".mid")
    target.write_bytes(encode(read(score)))
