#!/usr/bin/env python3
"""A board behind a pseudo-terminal, written from firmware-protocol/PROTOCOL.md and nothing else.

It serves as a board shall, or is wrong in one way from a stated time after its first arming on.
On SIGINT it prints what the host did, as JSON. It needs Python 3 and its standard library.
"""

import argparse
import binascii
import json
import math
import os
import random
import select
import signal
import struct
import time
import tty
import zlib

CYCLIC = """\
header: kind:3 flag:1 board:4 | sequence:u8 | stamp_us:u16
key_samples kind 3: position16:i16 | position24:i24 | position16:i16 velocity:i16 | position24:i24 velocity:i16
key_forces kind 1: force:i16 | force:i16 stiffness:slope8 damping:slope8
multicast_forces kind 2: group:4 sequence:u8 stamp_us:u16 | 30 x force:i16
units: position 1 count, velocity 0.2 mm/s, force 1 mN, stiffness 0.25 N/m, damping 0.001 N s/m
slope8: sign:1 exponent:4 mantissa:3
"""
DONE, UNKNOWN, BAD_VALUE, WRONG_STATE, WRONG_NONCE, IMPOSSIBLE = range(6)
NONE, NEVER_ARMED, SILENCE, DISARMED, EMERGENCY_STOP, KEY_FAULT = range(6)
SAFE, OFFERED, ARMED, LATCHED = "safe", "disarmed", "armed", "latched"
TRAVEL_UM = 10_160
FADE_US = 10_000
HISTORY = 64
# Mass [kg], return spring [N], damping [N s/m] and friction [N] of each key.
MASS, RETURN, DAMPING, FRICTION = 0.1, 0.3, 1.0, 0.05
LAW_HZ = 1_000

WAYS = """flag key-less key-fault jump noise wrong-nonce no-ping late-replies late reset
any-nonce no-watchdog no-crc mute-unknown stuck-stamp stuck-sequence twice unlatched
deaf-stop lost-homing""".split()


def crc16(data):
    return binascii.crc_hqx(data, 0xFFFF)


def wire(frame):
    body = frame + struct.pack("<H", crc16(frame))
    return b"".join(bytes([len(run) + 1]) + run for run in body.split(b"\0")) + b"\0"


def unstuffed(data):
    """What was stuffed, or nothing if it was not."""
    out, at = [], 0
    while at < len(data):
        run = data[at + 1 : at + data[at]]
        if len(run) != data[at] - 1:
            return None
        out.append(run)
        at += data[at]
    return b"\0".join(out)


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value


class Key:
    """One key with its motor, and a finger that presses it now and then."""

    def __init__(self, slot):
        self.s, self.v, self.slot, self.force = 0.0, 0.0, slot, 0.0

    def advance(self, t, h, force, finger):
        self.force = force
        push = finger * max(0.0, math.sin(2 * math.pi * t + self.slot)) - RETURN - force
        if abs(self.v) < 1e-4 and abs(push) < FRICTION:
            self.v = 0.0
            return
        push -= math.copysign(FRICTION, self.v if self.v else push) + DAMPING * self.v
        self.v += h * push / MASS
        self.s += h * self.v
        if not 0.0 <= self.s <= TRAVEL_UM * 1e-6:
            self.s, self.v = min(max(self.s, 0.0), TRAVEL_UM * 1e-6), 0.0


class Board:
    def __init__(self, args):
        self.args = args
        self.settings = [args.number, args.first_key, 10_000]
        self.start(1)
        self.first_arming = None
        self.before, self.after = [0] * args.keys, [0] * args.keys
        self.told = {"armings": 0, "arm_requests": 0, "forces": 0, "stops": 0, "resets": 0,
                     "skipped": 0}

    def start(self, reason):
        self.args.number, self.began = self.settings[0], time.monotonic()
        self.state, self.reason, self.reset_reason = SAFE, NEVER_ARMED, reason
        self.keys = [Key(slot) for slot in range(self.args.keys)]
        self.period_us, self.packing, self.next_us = 0, 1, 0
        self.sequence, self.history, self.answered = 0, [], -1
        self.nonce, self.valid_us, self.force_packing = None, 0, 0
        self.expires_us, self.faded_us = None, None
        self.forces, self.muted = [0] * self.args.keys, 0
        self.last, self.counters = None, [0] * 10
        self.buffer, self.queue, self.law_us = b"", [], 0
        self.queue.append((self.us() + 1000 * self.args.number, self.hello))

    def us(self):
        """The board's clock, whole."""
        return int((time.monotonic() - self.began) * (1e6 + self.args.drift))

    def wrong(self, way):
        """Whether it is wrong in this way now."""
        if self.args.wrong != way:
            return False
        if self.args.at == 0:
            return True
        armed = self.first_arming if hasattr(self, "first_arming") else None
        return armed is not None and self.args.at <= time.monotonic() - armed

    # What it says.

    def hello_record(self):
        said = {
            "major": 2, "minor": 2, "schema": fnv1a(CYCLIC.encode()),
            "first_key": self.settings[1], "n_keys": self.args.keys, "features": 4 | 32,
            "max_sample_hz": 500, "max_force_hz": 500, "law_hz": LAW_HZ, "quantum_nm": 1000,
            "max_force_mn": self.settings[2], "reset_reason": self.reset_reason,
            "safe_reason": KEY_FAULT if self.wrong("key-fault") else self.reason,
        }
        said.update(self.args.say)
        crc = zlib.crc32(struct.pack("<3i", *self.settings))
        return struct.pack(
            "<4sBBQ6sBBHHHHIHIIBBBB", b"LTOF", said["major"], said["minor"], said["schema"],
            bytes([0x50, 0x59, 0, 0, 0, self.args.number]), said["first_key"], said["n_keys"],
            said["features"], said["max_sample_hz"], said["max_force_hz"], said["law_hz"],
            said["quantum_nm"], said["max_force_mn"], crc, self.us() % 2**32, 1, 0,
            said["reset_reason"], said["safe_reason"],
        )

    def head(self, kind, flag=False):
        return bytes([kind << 5 | bool(flag) << 4 | self.args.number])

    def hello(self):
        self.send(self.head(6, self.state != ARMED) + self.hello_record())

    def send(self, frame, delay_us=0):
        if delay_us:
            self.queue.append((self.us() + delay_us, lambda: self.send(frame)))
            return
        try:
            os.write(self.fd, wire(frame))
        except BlockingIOError:
            self.counters[9] += 1

    def samples(self, now):
        stamp = 4242 if self.wrong("stuck-stamp") else now % 2**16
        flag = self.state != ARMED or self.wrong("flag")
        frame = self.head(3, flag) + struct.pack("<BH", self.sequence, stamp)
        self.history = self.history[-HISTORY + 1 :] + [(self.sequence, stamp, now)]
        for key in self.keys[int(self.wrong("key-less")) :]:
            counts = round(key.s * 1e6)
            if key.slot == 0 and self.wrong("jump"):
                counts += 30_000
            if key.slot == 0 and self.wrong("noise"):
                counts += random.randint(-1000, 1000)
            velocity = min(max(round(key.v * 5e3), -32768), 32767)
            if self.packing in (0, 2):
                frame += struct.pack("<h", min(max(counts, -32768), 32767))
            else:
                frame += struct.pack("<i", counts)[:3]
            if self.packing in (2, 3):
                frame += struct.pack("<h", velocity)
        self.send(frame, 50_000 if self.wrong("late") else 0)
        if self.wrong("twice"):
            self.send(frame)
        self.counters[0] += 1
        if not self.wrong("stuck-sequence"):
            self.sequence = (self.sequence + 1) % 256

    # What it does.

    def let_go(self, state, reason, now):
        if self.state == ARMED and self.expires_us is not None:
            self.faded_us = min(now, self.expires_us)
        elif self.state == ARMED:
            self.faded_us = None
        self.state, self.reason = state, reason

    def stop(self, reason, now):
        if self.state != LATCHED:
            self.let_go(LATCHED, reason, now)

    def share(self, now):
        if self.state == ARMED:
            if self.expires_us is None:
                return 0.0
            if now <= self.expires_us or self.wrong("no-watchdog"):
                return 1.0
            self.counters[6] += 1
            self.let_go(SAFE, SILENCE, self.expires_us)
        if self.faded_us is None:
            return 0.0
        return max(0.0, 1.0 - (now - self.faded_us) / FADE_US)

    def take_forces(self, frame, now):
        values = frame[4 : 4 + 2 * self.args.keys]
        if len(values) < 2 * self.args.keys or any(frame[4 + 2 * self.args.keys :]):
            self.counters[3] += 1
            return
        sequence, stamp = struct.unpack("<BH", frame[1:4])
        forces = struct.unpack(f"<{self.args.keys}h", values)
        is_wrong = self.args.at and self.first_arming is not None and (
            self.args.at + 1.8 <= time.monotonic() - self.first_arming)
        most = self.after if is_wrong or not self.args.at else self.before
        for slot, force in enumerate(forces):
            most[slot] = max(most[slot], abs(force))
        if self.state != ARMED:
            self.counters[3] += 1
            return
        sent = [it for it in self.history if it[:2] == (sequence, stamp)]
        if not sent or sent[0][2] < self.answered or self.valid_us < now - sent[0][2]:
            self.counters[4] += 1
            return
        self.answered = sent[0][2]
        self.counters[1] += 1
        self.counters[8] = max(self.counters[8], now - self.answered)
        self.told["forces"] += 1
        self.expires_us = max(self.expires_us or 0, self.answered + self.valid_us)
        limit = self.settings[2]
        is_none = frame[0] & 16
        self.forces = [0 if is_none else min(max(f, -limit), limit) for f in forces]

    def broadcast(self, frame, now):
        if frame[1:4] == b"\x01\xde\xad" and not self.wrong("deaf-stop"):
            self.told["stops"] += 1
            self.stop(EMERGENCY_STOP, now)
        elif frame[1:2] == b"\x03":
            self.queue.append((now + 1000 * self.args.number, self.hello))

    def request(self, frame, now):
        if self.last and self.last[0] == frame[1:3]:
            self.reply(self.last[1])
            return
        ident, operation, record = frame[1], frame[2], frame[3:]
        try:
            status, answer = self.serve(operation, record, now)
        except struct.error:
            status, answer = BAD_VALUE, b""
        if status == UNKNOWN and self.wrong("mute-unknown"):
            return
        reply = self.head(5) + bytes([ident, operation, status]) + answer
        self.last = (frame[1:3], reply)
        self.reply(reply)

    def reply(self, frame):
        self.send(frame, 26_000 if self.wrong("late-replies") else 0)

    def serve(self, operation, record, now):
        if operation == 1:
            return DONE, self.hello_record()
        if operation == 2:
            period, packing, phase = struct.unpack_from("<HBH", record)
            if packing > 3 or period % (1_000_000 // LAW_HZ) or 0 < period < 2000:
                return BAD_VALUE, b""
            self.period_us, self.packing, self.next_us = period, packing, now + phase
            return DONE, b""
        if operation == 3:
            if self.state == LATCHED and not self.wrong("unlatched"):
                return WRONG_STATE, b""
            self.let_go(OFFERED, DISARMED, now)
            self.nonce = random.randrange(2**32)
            return DONE, struct.pack("<I", self.nonce)
        if operation == 4:
            return self.arm(*struct.unpack_from("<IBB", record)), b""
        if operation == 5 and not self.wrong("no-ping"):
            return DONE, struct.pack("<I", now % 2**32)
        if operation in (6, 7):
            setting = record[0] if record else 99
            if setting >= len(self.settings):
                return BAD_VALUE, b""
            if operation == 7:
                (value,) = struct.unpack_from("<i", record, 1)
                if not [0, 0, 1][setting] <= value <= [14, 87, 32_767][setting]:
                    return BAD_VALUE, b""
                self.settings[setting] = value
            crc = zlib.crc32(struct.pack("<3i", *self.settings))
            return DONE, struct.pack("<iI", self.settings[setting], crc)
        if operation == 14:
            homed = 0 if self.wrong("lost-homing") else 2**self.args.keys - 1
            return DONE, struct.pack("<I3H", 1 + self.told["resets"], homed, 0, self.muted)
        if operation == 15:
            status = DONE if record and record[0] < self.args.keys else BAD_VALUE
            return status, struct.pack("<B2h", 0, -32768, -32768) if status == DONE else b""
        if operation == 16:
            slot, muted = struct.unpack_from("<2B", record)
            if slot >= self.args.keys or muted > 1:
                return BAD_VALUE, b""
            self.muted = self.muted & ~(1 << slot) | muted << slot
            return DONE, b""
        if operation == 12:
            return DONE, struct.pack("<6I2H2I", *self.counters)
        if operation in (8, 9, 10, 11, 13, 17):
            return IMPOSSIBLE, b""
        return UNKNOWN, b""

    def arm(self, nonce, packing, valid_ms):
        self.told["arm_requests"] += 1
        if self.state != OFFERED:
            return WRONG_STATE
        if self.wrong("wrong-nonce") or nonce != self.nonce and not self.wrong("any-nonce"):
            return WRONG_NONCE
        if packing != 0 or not 5 <= valid_ms <= 100:
            return BAD_VALUE
        self.state, self.reason, self.nonce = ARMED, NONE, None
        self.valid_us, self.expires_us, self.faded_us = 1000 * valid_ms, None, None
        self.forces = [0] * self.args.keys
        self.counters[7] += 1
        self.told["armings"] += 1
        self.first_arming = self.first_arming or time.monotonic()
        return DONE

    # How it lives.

    def take_bytes(self, data, now):
        *whole, self.buffer = (self.buffer + data).split(b"\0")
        for piece in filter(None, whole):
            body = unstuffed(piece) if len(piece) < 68 else None
            is_frame = body is not None and len(body) > 2
            if not is_frame or crc16(body[:-2]) != struct.unpack("<H", body[-2:])[0] and not (
                    self.wrong("no-crc")):
                self.counters[2] += 1
                continue
            frame = body[:-2]
            kind, number = frame[0] >> 5, frame[0] & 15
            if kind == 0 and number == 15:
                self.broadcast(frame, now)
            elif kind == 1 and number == self.args.number:
                self.take_forces(frame, now)
            elif kind == 4 and number == self.args.number and len(frame) > 2:
                self.request(frame, now)
            else:
                self.counters[3] += 1

    def live(self, now):
        h_us = 1_000_000 // LAW_HZ
        self.law_us = max(self.law_us, now - 50 * h_us)
        while self.law_us + h_us <= now:
            self.law_us += h_us
            share = self.share(self.law_us)
            for key, force in zip(self.keys, self.forces):
                force *= share * 1e-3 if not self.muted >> key.slot & 1 else 0.0
                key.advance(self.law_us * 1e-6, h_us * 1e-6, force, self.args.finger)
        for due, say in [it for it in self.queue if it[0] <= now]:
            say()
        self.queue = [it for it in self.queue if it[0] > now]
        if self.period_us and self.next_us <= now:
            self.samples(now)
            late = (now - self.next_us) // self.period_us
            self.told["skipped"] += late
            self.next_us += self.period_us * (late + 1)

    def run(self, fd):
        self.fd = fd
        while True:
            if (self.wrong("reset") or self.wrong("lost-homing")) and not self.told["resets"]:
                self.told["resets"] = 1
                self.start(7)
            select.select([fd], [], [], 0.0007)
            try:
                self.take_bytes(os.read(fd, 4096), self.us())
            except BlockingIOError:
                pass
            self.live(self.us())


def say(text):
    name, value = text.split("=")
    return name, int(value, 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--link", required=True, help="name for its pseudo-terminal")
    parser.add_argument("--number", type=int, default=5)
    parser.add_argument("--first-key", type=int, default=39)
    parser.add_argument("--keys", type=int, default=2)
    parser.add_argument("--finger", type=float, default=0.0, help="force of a finger [N]")
    parser.add_argument("--drift", type=int, default=0, help="clock too fast [1e-6]")
    parser.add_argument("--wrong", choices=WAYS)
    parser.add_argument("--at", type=float, default=0, help="time after the first arming [s]")
    parser.add_argument("--say", type=say, action="append", default=[], metavar="FIELD=VALUE")
    args = parser.parse_args()
    args.say = dict(args.say)
    master, other = os.openpty()
    tty.setraw(other)
    os.set_blocking(master, False)
    board = Board(args)

    def end(_signal, _frame):
        raise SystemExit

    signal.signal(signal.SIGINT, end)
    os.symlink(os.ttyname(other), args.link)
    try:
        board.run(master)
    finally:
        told = {"state": board.state, "reason": board.reason, "counters": board.counters}
        told |= {"before_mn": board.before, "after_mn": board.after, **board.told}
        print(json.dumps(told))


main()
