"""Writes cosine.sf2: one looped cosine that begins at its maximum, and an envelope that decays.

Without a resampling of its own at middle C, the first frame of a note is the loudest of its sound,
so that a test sees where it begins. Decay: 40 dB a second, since rustysynth takes the time of a decay
for 80 dB; release: at once.
"""

import math
import struct
from pathlib import Path

RATE = 48_000
PERIOD = 184  # frames: 260.87 Hz, middle C within 4 cent
ROOT = 60
PERIODS = 8


def chunk(kind: bytes, body: bytes) -> bytes:
    return kind + struct.pack("<I", len(body)) + body + b"\0" * (len(body) % 2)


def listed(kind: bytes, *chunks: bytes) -> bytes:
    return chunk(b"LIST", kind + b"".join(chunks))


def name(text: str) -> bytes:
    return text.encode().ljust(20, b"\0")


def timecents(seconds: float) -> int:
    return round(1200 * math.log2(seconds))


def generators(*pairs: tuple[int, int]) -> bytes:
    return b"".join(struct.pack("<Hh", kind, value) for kind, value in pairs)


frames = PERIOD * PERIODS
wave = [round(32_000 * math.cos(2 * math.pi * n / PERIOD)) for n in range(frames)]
samples = struct.pack(f"<{frames + 46}h", *wave, *([0] * 46))
info = listed(
    b"INFO",
    chunk(b"ifil", struct.pack("<HH", 2, 1)),
    chunk(b"isng", b"EMU8000\0"),
    chunk(b"INAM", b"one cosine\0\0"),
)
in_instrument = generators(
    (36, timecents(2.0)),  # decay of the volume
    (37, 1000),  # sustain: 100 dB below the peak
    (38, -12_000),  # release: at once
    (54, 1),  # looped
    (53, 0),  # the sample, last
)
preset = struct.pack("<HHHIII", 0, 0, 0, 0, 0, 0)
pdta = listed(
    b"pdta",
    chunk(b"phdr", name("cosine") + preset + name("EOP") + struct.pack("<HHHIII", 0, 0, 1, 0, 0, 0)),
    chunk(b"pbag", struct.pack("<HHHH", 0, 0, 1, 0)),
    chunk(b"pmod", bytes(10)),
    chunk(b"pgen", generators((41, 0)) + bytes(4)),
    chunk(b"inst", name("cosine") + struct.pack("<H", 0) + name("EOI") + struct.pack("<H", 1)),
    chunk(b"ibag", struct.pack("<HHHH", 0, 0, 5, 0)),
    chunk(b"imod", bytes(10)),
    chunk(b"igen", in_instrument + bytes(4)),
    chunk(
        b"shdr",
        name("cosine")
        + struct.pack("<IIIIIBbHH", 0, frames, PERIOD, frames - PERIOD, RATE, ROOT, 0, 0, 1)
        + name("EOS")
        + bytes(26),
    ),
)
sdta = listed(b"sdta", chunk(b"smpl", samples))
font = chunk(b"RIFF", b"sfbk" + info + sdta + pdta)
Path(__file__).with_suffix(".sf2").write_bytes(font)
