"""A program in lockstep that sends back what it is sent, and may break the exchange."""

import struct
import sys

how, report = sys.argv[1:]
now, exchanges, everything = 0, 0, b""
while head := sys.stdin.buffer.read(10):
    now, length = struct.unpack("<QH", head)
    taken = sys.stdin.buffer.read(length)
    exchanges += 1
    everything += taken
    if how == "exits" and exchanges == 2:
        sys.exit(3)
    if how == "silent":
        continue
    rest = b"hello" if how == "chatty" else b""
    sys.stdout.buffer.write(struct.pack("<H", length) + taken + rest)
    sys.stdout.buffer.flush()
with open(report, "w", encoding="ascii") as file:
    file.write(f"{now} us, {len(everything)} bytes")
