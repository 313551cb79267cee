#!/usr/bin/env python3
"""Makes the golden vectors beside it: every frame of the protocol as bytes.

Written from the documentation alone, with nothing of the Rust or the C in it: where the three
agree, the documentation says what they do. Needs Python 3 and its standard library.

    python3 make.py            writes *.hex
    python3 make.py --check    says which are not current, and fails if any is
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent

# The layouts of the cyclic frames, as every board says them in its hello.
CYCLIC = """\
header: kind:3 flag:1 board:4 | sequence:u8 | stamp_us:u16
key_samples kind 3: position16:i16 | position24:i24 | position16:i16 velocity:i16 | position24:i24 velocity:i16
key_forces kind 1: force:i16 | force:i16 stiffness:slope8 damping:slope8
multicast_forces kind 2: group:4 sequence:u8 stamp_us:u16 | 30 x force:i16
units: position 1 count, velocity 0.2 mm/s, force 1 mN, stiffness 0.25 N/m, damping 0.001 N s/m
slope8: sign:1 exponent:4 mantissa:3
"""

KINDS = ["broadcast", "key_forces", "multicast_forces", "key_samples", "request", "reply", "hello"]
# The class of each kind on CAN; a broadcast that stops is of class 0.
CLASSES = {
    "broadcast": 1,
    "multicast_forces": 2,
    "key_forces": 3,
    "key_samples": 4,
    "request": 8,
    "reply": 9,
    "hello": 10,
}
ALL_BOARDS = 15
LENGTHS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64]


# Framing and CAN.


def crc16(data):
    """CRC-16 with 0x1021 from 0xFFFF, bit by bit."""
    crc = 0xFFFF
    for byte in data:
        for bit in range(7, -1, -1):
            top = crc >> 15 ^ byte >> bit & 1
            crc = crc << 1 & 0xFFFF
            if top:
                crc ^= 0x1021
    return crc


def cobs(data):
    """Stuffing of at most 254 bytes: each run up to a zero, with its length before it."""
    return b"".join(bytes([len(run) + 1]) + run for run in data.split(b"\0"))


def wire(frame):
    return cobs(frame + crc16(frame).to_bytes(2, "little")) + b"\0"


def can_id(kind, frame):
    stops = kind == "broadcast" and frame[1] == 1
    number = 0 if stops else CLASSES[kind]
    node = ALL_BOARDS if kind == "multicast_forces" else frame[0] % 16
    return number * 128 + node


def pieces(frame, roll):
    parts = [frame[i : i + 7] for i in range(0, len(frame), 7)]
    heads = [roll * 32 + (16 if i + 1 == len(parts) else 0) + i for i in range(len(parts))]
    return [bytes([head]) + part for head, part in zip(heads, parts)]


def padded(length):
    return next(allowed for allowed in LENGTHS if length <= allowed)


# Values.


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value


def little(value, size):
    return (value % 256**size).to_bytes(size, "little")


def first(kind, flag, board):
    return bytes([KINDS.index(kind) * 32 + flag * 16 + board])


def header(kind, flag, board, sequence, stamp_us):
    return first(kind, flag, board) + little(sequence, 1) + little(stamp_us, 2)


# Frames. Each is (name, comment, fields, bytes).


def samples(name, comment, packing, head, positions, velocities=()):
    board, sequence, stamp_us, flag = head
    size = [2, 3, 2, 3][packing]
    frame = header("key_samples", flag, board, sequence, stamp_us)
    for slot, position in enumerate(positions):
        frame += little(position, size)
        if packing >= 2:
            frame += little(velocities[slot], 2)
    fields = {
        "kind": "key_samples",
        "board": board,
        "sequence": sequence,
        "stamp_us": stamp_us,
        "flag": flag,
        "packing": packing,
        "positions": positions,
        "velocities": list(velocities),
    }
    return name, comment, fields, frame


def slope(code):
    """What a byte of slope8 means."""
    exponent, mantissa = code >> 3 & 15, code & 7
    magnitude = mantissa if exponent == 0 else (8 + mantissa) * 2 ** (exponent - 1)
    return -magnitude if code & 128 else magnitude


def nearest_slope(units):
    """The byte whose slope is next to `units` on the side of zero, by trying all of them."""
    sign = 128 if units < 0 else 0
    best = max((c for c in range(128) if slope(c) <= abs(units)), key=slope)
    return best | sign if best else 0


def forces(name, comment, head, millinewtons, stiffness=(), damping=()):
    board, sequence, stamp_us, flag = head
    frame = header("key_forces", flag, board, sequence, stamp_us)
    for slot, force in enumerate(millinewtons):
        frame += little(force, 2)
        if stiffness:
            frame += bytes([nearest_slope(stiffness[slot]), nearest_slope(damping[slot])])
    fields = {
        "kind": "key_forces",
        "board": board,
        "sequence": sequence,
        "stamp_us": stamp_us,
        "flag": flag,
        "packing": 1 if stiffness else 0,
        "forces": millinewtons,
        "stiffness": [slope(nearest_slope(units)) for units in stiffness],
        "damping": [slope(nearest_slope(units)) for units in damping],
    }
    return name, comment, fields, frame


def multicast(name, comment, group, sequence, stamp_us, flag, millinewtons):
    frame = header("multicast_forces", flag, group, sequence, stamp_us)
    frame += b"".join(little(force, 2) for force in millinewtons)
    fields = {
        "kind": "multicast_forces",
        "group": group,
        "sequence": sequence,
        "stamp_us": stamp_us,
        "flag": flag,
        "forces": millinewtons,
    }
    return name, comment, fields, frame


def broadcast(name, comment, what, fields, rest):
    frame = first("broadcast", 0, ALL_BOARDS) + bytes([what]) + rest
    return name, comment, {"kind": "broadcast", "what": what, **fields}, frame


# Records: their fields in the order of the wire, with the size of each; a list is bytes.

HELLO = [
    ("magic", [4]), ("major", 1), ("minor", 1), ("schema", 8), ("uid", [6]), ("first_key", 1),
    ("n_keys", 1), ("features", 2), ("max_sample_hz", 2), ("max_force_hz", 2), ("law_hz", 2),
    ("quantum_nm", 4), ("max_force_mn", 2), ("config_crc", 4), ("board_us", 4),
    ("firmware_major", 1), ("firmware_minor", 1), ("reset_reason", 1), ("safe_reason", 1),
]
CALIBRATION = [("slot", 1), ("rest", 4), ("bottom", 4), ("gain_permille", 2)]
COUNTERS = [
    ("samples", 4), ("forces", 4), ("corrupt", 4), ("refused", 4), ("stale", 4),
    ("unanswered", 4), ("trips", 2), ("armings", 2), ("oldest_us", 4), ("unsent", 4),
]
FINGER = [
    ("slot", 1), ("touch", 1), ("start_us", 4), ("release_us", 4), ("speed", 4), ("hold", 4),
    ("from", 4), ("lift", 4),
]


def record(layout, values):
    """The bytes of a record, and its fields by name."""
    assert len(layout) == len(values)
    data = b""
    for (_, size), value in zip(layout, values):
        if isinstance(size, list):
            assert len(value) == size[0]
            data += bytes(value)
        else:
            data += little(value, size)
    return data, {name: value for (name, _), value in zip(layout, values)}


def request(name, comment, board, ident, operation, layout=(), values=()):
    data, named = record(list(layout), list(values))
    frame = first("request", 0, board) + bytes([ident, operation]) + data
    fields = {"kind": "request", "board": board, "id": ident, "operation": operation, **named}
    return name, comment, fields, frame


def reply(name, comment, board, ident, operation, layout=(), values=(), status=0):
    data, named = record(list(layout), list(values))
    frame = first("reply", 0, board) + bytes([ident, operation, status]) + data
    fields = {
        "kind": "reply",
        "board": board,
        "id": ident,
        "operation": operation,
        "status": status,
        **named,
    }
    return name, comment, fields, frame


def hello_values(minor=0):
    return [
        list(b"LTOF"), 2, minor, fnv1a(CYCLIC.encode()), [1, 2, 3, 250, 251, 252], 33, 11, 0x1F,
        2000, 2000, 10000, 1000, 30000, 0xDEADBEEF, 4123456789, 1, 4, 1, 2,
    ]


def hello(name, comment, board, safe):
    data, named = record(HELLO, hello_values())
    fields = {"kind": "hello", "board": board, "flag": safe, **named}
    return name, comment, fields, first("hello", safe, board) + data


EDGES = [0, 1, -1, 2500, -2500, 8388607, -8388608, 256, 65536, -65536, 12345, -2]
SHORT = [0, 1, -1, 2500, -2500, 32767, -32768, 256, -256, 10160, 12345, -2]
SPEEDS = [0, -1, 1, 500, -500, -32768, 32767, -256, 256, 2500, 4321, -3]
FORCES = [0, 1, -1, 500, -500, 32767, -32768, 256, -256, 1234, -4321, 30000]
STIFFNESS = [0, 1, -1, 15, -15, 16, 17, 245760, -245760, 9999999, 4000, -16001]
DAMPING = [-7, 8, 0, 2000, -2000, 1, 31, -33, 245760, 5, 240, 3]


def all_samples():
    names = ["position16", "position24", "position16_velocity", "position24_velocity"]
    for packing, named in enumerate(names):
        for keys in (1, 11, 12):
            positions = (SHORT if packing in (0, 2) else EDGES)[-keys:]
            velocities = SPEEDS[-keys:] if packing >= 2 else []
            head = (packing + keys - 1, 254 + packing & 255, 0x1234 * keys, keys % 2)
            comment = f"{keys} keys, {named.replace('_', ' and ')}"
            yield samples(f"key_samples_{named}_{keys}", comment, packing, head, positions, velocities)


def all_forces():
    for keys in (1, 11, 12):
        head = (keys, 41 + keys, 65536 - keys, int(keys == 1))
        yield forces(f"key_forces_force16_{keys}", f"forces of {keys} keys", head, FORCES[-keys:])
        yield forces(
            f"key_forces_force16_slope_{keys}",
            f"forces and slopes of {keys} keys",
            head,
            FORCES[-keys:],
            STIFFNESS[-keys:],
            DAMPING[-keys:],
        )
    ramp = [1000 * key - 15000 for key in range(30)]
    yield multicast("multicast_forces_0", "forces of the keys 0 to 29", 0, 255, 65535, 0, ramp)
    yield multicast("multicast_forces_2", "no force on the keys 60 to 87", 2, 9, 12345, 1, ramp[::-1])


def all_broadcasts():
    reason = {"reason": 9}
    yield broadcast("broadcast_stop", "emergency stop", 1, reason, bytes([0xDE, 0xAD, 9]))
    time = {"host_us": 0xFEDCBA98}
    yield broadcast("broadcast_time", "bus time", 2, time, little(0xFEDCBA98, 4))
    version = {"major": 2, "minor": 1}
    yield broadcast("broadcast_who", "who is there?", 3, version, bytes([2, 1]))


def all_requests():
    yield request("request_hello", "who are you?", 0, 0, 1)
    stream = [("period_us", 2), ("packing", 1), ("phase_us", 2)]
    yield request("request_stream", "500 samples a second", 1, 1, 2, stream, [2000, 3, 250])
    yield request("request_disarm", "render no force", 2, 2, 3)
    arm = [("nonce", 4), ("packing", 1), ("valid_ms", 1)]
    yield request("request_arm", "render forces", 3, 3, 4, arm, [0xCAFEF00D, 1, 20])
    yield request("request_ping", "what time is it?", 4, 4, 5)
    setting = [("setting", 1)]
    yield request("request_read_config", "read a setting", 5, 5, 6, setting, [2])
    write = [("setting", 1), ("value", 4)]
    yield request("request_write_config", "write a setting", 6, 6, 7, write, [2, -12000])
    slot = [("slot", 1)]
    yield request("request_read_calibration", "read a calibration", 7, 7, 8, slot, [10])
    values = [10, -15, 10161, 985]
    yield request("request_write_calibration", "write it", 8, 8, 9, CALIBRATION, values)
    yield request("request_read_log", "read the log", 9, 9, 10, [("line", 2)], [513])
    yield request("request_light", "show yourself", 10, 10, 11, [("seconds", 1)], [5])
    yield request("request_counters", "what was counted?", 11, 254, 12)
    values = [3, 1, 4000000000, 4000123456, 1500000, 15160, 4321, 123456]
    yield request("request_finger", "a gesture", 14, 255, 13, FINGER, values)


def all_requests_of_2_2():
    yield request("request_board_health", "how are you?", 1, 20, 14)
    yield request("request_key_health", "how is a key?", 2, 21, 15, [("slot", 1)], [11])
    mute = [("slot", 1), ("muted", 1)]
    yield request("request_mute_key", "a motor off", 3, 22, 16, mute, [7, 1])
    magic = [("magic", [4])]
    yield request("request_bootloader", "the way out", 4, 23, 17, magic, [list(b"BOOT")])


def all_replies_of_2_2():
    health = [("boots", 4), ("homed", 2), ("faults", 2), ("muted", 2)]
    values = [4000000001, 0x0FFF, 1, 0x0880]
    yield reply("reply_board_health", "how it is", 1, 20, 14, health, values)
    key = [("fault", 1), ("temperature", 2), ("current", 2)]
    yield reply("reply_key_health", "too hot", 2, 21, 15, key, [3, 853, -1500])
    yield reply("reply_mute_key", "done", 3, 22, 16)
    yield reply("reply_bootloader", "it is armed", 4, 23, 17, status=3)


def all_replies():
    yield reply("reply_hello", "who it is", 0, 0, 1, HELLO, hello_values(minor=7))
    yield reply("reply_stream", "done", 1, 1, 2)
    yield reply("reply_disarm", "the nonce", 2, 2, 3, [("nonce", 4)], [0xCAFEF00D])
    yield reply("reply_arm", "the nonce was another one", 3, 3, 4, status=4)
    yield reply("reply_ping", "the time", 4, 4, 5, [("board_us", 4)], [0x80000001])
    config = [("value", 4), ("config_crc", 4)]
    yield reply("reply_read_config", "a setting", 5, 5, 6, config, [-2147483648, 0xDEADBEEF])
    yield reply("reply_write_config", "a setting as it is now", 6, 6, 7, config, [12000, 1])
    values = [10, -15, 10161, 985]
    yield reply("reply_read_calibration", "a calibration", 7, 7, 8, CALIBRATION, values)
    yield reply("reply_write_calibration", "it is out of range", 8, 8, 9, status=2)
    line = [("lines", 2), ("board_us", 4), ("text", [48])]
    text = list("armed, 20 ms µN".encode().ljust(48, b"\0"))
    yield reply("reply_read_log", "a line", 9, 9, 10, line, [514, 99, text])
    yield reply("reply_light", "done", 10, 10, 11)
    counts = [2**32 - 1, 4, 3, 2, 1, 0, 65535, 256, 19999, 7]
    yield reply("reply_counters", "what was counted", 11, 254, 12, COUNTERS, counts)
    yield reply("reply_finger", "a real board has no finger", 14, 255, 13, status=5)
    yield reply("reply_unknown", "an operation of a newer version", 14, 17, 99, status=1)


def vectors():
    yield hello("hello", "a board that fell safe", 3, 1)
    yield from all_samples()
    yield from all_forces()
    yield from all_broadcasts()
    yield from all_requests()
    yield from all_replies()
    yield from all_requests_of_2_2()
    yield from all_replies_of_2_2()


def shown(value):
    if isinstance(value, list):
        return " ".join(str(item) for item in value)
    return str(value)


def text(number, comment, fields, frame):
    roll = number % 8
    lines = [f"# {comment}", *(f"{k} = {shown(v)}".rstrip() for k, v in fields.items())]
    lines += [
        f"frame = {frame.hex()}",
        f"padded = {padded(len(frame))}",
        f"wire = {wire(frame).hex()}",
        f"can_id = {can_id(fields['kind'], frame)}",
        f"roll = {roll}",
        "pieces = " + " ".join(piece.hex() for piece in pieces(frame, roll)),
    ]
    return "\n".join(lines) + "\n"


def main():
    made = {
        f"{name}.hex": text(number, *rest) for number, (name, *rest) in enumerate(vectors())
    }
    if sys.argv[1:] == ["--check"]:
        there = {path.name: path.read_text() for path in HERE.glob("*.hex")}
        stale = sorted(n for n in made.keys() | there.keys() if made.get(n) != there.get(n))
        print("\n".join(stale) if stale else f"{len(made)} vectors are current")
        return 1 if stale else 0
    for path in HERE.glob("*.hex"):
        path.unlink()
    for name, content in made.items():
        (HERE / name).write_text(content)
    print(f"{len(made)} vectors")
    return 0


sys.exit(main())
