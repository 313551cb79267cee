"""Reads a recording with other people's packages and prints what it finds, for a test to compare.

Needs `mcap` and `mcap-protobuf-support` from PyPI; knows nothing of Letoff but topics' names.
"""

import json
import struct
import sys

from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory


def bits(layout, value):
    """A number's bits, which no printing or reading rounds."""
    return struct.pack(layout, value).hex()


with open(sys.argv[1], "rb") as file:
    reader = make_reader(file, decoder_factories=[DecoderFactory()])
    summary = reader.get_summary()
    found = {
        "profile": reader.get_header().profile,
        "messages": summary.statistics.message_count,
        "chunks": len(summary.chunk_indexes) > 0,
        "schemas": sorted(schema.name for schema in summary.schemas.values()),
        "metadata": [dict(record.metadata) for record in reader.iter_metadata()],
        "positions": [],
        "signals": [],
        "strikes": [],
        "models": [],
        "voices": [],
        "topics": {},
    }
    for _schema, channel, message, decoded in reader.iter_decoded_messages():
        found["topics"][channel.topic] = found["topics"].get(channel.topic, 0) + 1
        if channel.topic == "/key/39/block":
            found["positions"] += [
                [message.log_time, bits(">d", value)] for value in decoded.position
            ]
            found["signals"] += [bits(">f", value) for value in decoded.signals]
        elif channel.topic == "/events" and decoded.kind == decoded.STRIKE:
            theta = bits(">d", decoded.theta)
            found["strikes"].append([decoded.tick, theta, decoded.key, decoded.speed])
        elif channel.topic == "/catalogue":
            found["models"] += [model.name for model in decoded.models]
        elif channel.topic == "/voices":
            found["voices"].append([decoded.key, decoded.instrument])
    # The same through the index only, which finds messages by topic and time.
    later = found["positions"][-1][0] if found["positions"] else 0
    found["last"] = [
        decoded.tick
        for *_others, decoded in reader.iter_decoded_messages(
            topics=["/key/39/block"], start_time=later
        )
    ]
    print(json.dumps(found))
