"""A client of the Foxglove WebSocket protocol that shares no code with ours.

Usage: client.py ws://127.0.0.1:8765

It prints what it found, one line each, and ends with "ok".
"""

import base64
import json
import struct
import sys

from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from websockets.sync.client import connect

PATIENCE = 120  # seconds, a last resort


class Client:
    def __init__(self, socket):
        self.socket = socket

    def say(self, **message):
        self.socket.send(json.dumps(message))

    def hear(self):
        """The next message: of JSON an object, of bytes the bytes."""
        message = self.socket.recv(timeout=PATIENCE)
        return json.loads(message) if isinstance(message, str) else message

    def text(self, op, **fields):
        """The next text with this op and these fields."""
        while True:
            message = self.hear()
            if isinstance(message, bytes) or message["op"] != op:
                continue
            if all(message.get(name) == value for name, value in fields.items()):
                return message

    def data(self, subscription):
        """The next message of a subscription: when it was made, and its bytes."""
        while True:
            message = self.hear()
            if isinstance(message, bytes) and message[0] == 1:
                of, at = struct.unpack_from("<IQ", message, 1)
                if of == subscription:
                    return at, message[13:]

    def call(self, service, call, request):
        """The answer of a service: an object, or why there is none."""
        payload = json.dumps(request).encode()
        head = struct.pack("<BIII", 2, service["id"], call, 4)
        self.socket.send(head + b"json" + payload)
        while True:
            message = self.hear()
            if isinstance(message, bytes) and message[0] == 3:
                of, length = struct.unpack_from("<II", message, 5)
                assert of == call and message[13 : 13 + length] == b"json", message
                return json.loads(message[13 + length :])
            if not isinstance(message, bytes) and message["op"] == "serviceCallFailure":
                assert message["callId"] == call, message
                return message["message"]


def message_class(channel):
    """The channel's messages, by the schema that it advertises and by nothing else."""
    assert channel["encoding"] == channel["schemaEncoding"] == "protobuf", channel
    files = descriptor_pb2.FileDescriptorSet.FromString(base64.b64decode(channel["schema"]))
    pool = descriptor_pool.DescriptorPool()
    for file in files.file:
        pool.Add(file)
    return message_factory.GetMessageClass(pool.FindMessageTypeByName(channel["schemaName"]))


def check_channels(client):
    channels = {it["topic"]: it for it in client.text("advertise")["channels"]}
    for channel in channels.values():
        message_class(channel)
    print(f"channels: {len(channels)}")
    return channels


def check_messages(client, channels):
    catalogue, block = channels["/catalogue"], channels["/key/39/block"]
    wanted = [{"id": 7, "channelId": catalogue["id"]}, {"id": 8, "channelId": block["id"]}]
    client.say(op="subscribe", subscriptions=wanted)
    _, payload = client.data(7)
    model = message_class(catalogue).FromString(payload).models[0]
    limits = [(it.name, it.min, it.max, it.unit) for it in model.parameters]
    assert limits == [("k2", 0.0, 1e5, "N/m"), ("m", 0.01, 1.0, "kg")], limits
    at, payload = client.data(8)
    rows = message_class(block).FromString(payload)
    assert at > 0 and rows.key == 39 and len(rows.position) == len(rows.after) == 33, rows
    assert all(0.0 <= it <= 0.0100001 for it in rows.position), rows.position
    client.say(op="unsubscribe", subscriptionIds=[7, 8])
    print("messages: decoded by their own schema")


def values(client, request):
    found = client.text("parameterValues", id=request)["parameters"]
    return {it["name"]: it["value"] for it in found}


def refusal(client, request, raw):
    """Why a set of key 39's m to `raw` is refused; nothing changes by it."""
    text = '{"op":"setParameters","id":"%s","parameters":[{"name":"/key/39/k2","value":1},%s]}'
    client.socket.send(text % (request, raw))
    message = client.text("status", level=2)["message"]
    client.say(op="getParameters", parameterNames=["/key/39/k2"], id=f"{request} after")
    assert values(client, f"{request} after") == {"/key/39/k2": 1234.5}, raw
    return message


def check_parameters(client, other):
    other.say(op="subscribeParameterUpdates", parameterNames=["/key/39/k2"])
    other.say(op="getParameters", parameterNames=[], id="before")
    assert values(other, "before") == {"/key/39/k2": 500.0, "/key/39/m": 0.1}
    wanted = [{"name": "/key/39/k2", "value": 1234.5}]
    client.say(op="setParameters", parameters=wanted, id="set")
    assert values(client, "set") == {"/key/39/k2": 1234.5}
    told = other.text("parameterValues")["parameters"]
    assert told == [{"name": "/key/39/k2", "value": 1234.5, "type": "float64"}], told
    print("parameters: set, and seen by another client")
    for request, raw in [
        ("string", '{"name":"/key/39/m","value":"heavy"}'),
        ("limit", '{"name":"/key/39/m","value":2}'),
        ("name", '{"name":"/key/39/mass","value":0.5}'),
        ("path", '{"name":"mass","value":0.5}'),
        ("null", '{"name":"/key/39/m","value":null}'),
        ("nan", '{"name":"/key/39/m","value":NaN}'),
        ("none", '{"name":"/key/39/m"}'),
    ]:
        print(f"refused {request}: {refusal(client, request, raw)}")


def check_services(client, services):
    press = services["/letoff/press"]
    assert json.loads(press["request"]["schema"])["required"] == ["key", "newtons"], press
    assert client.call(press, 1, {"key": 39, "newtons": 2.5})["reply"] == "done"
    assert client.call(services["/letoff/scene"], 2, {})["toml"] == "tick_hz = 1000\n"
    print(f"refused call: {client.call(press, 3, {'key': 39, 'newtons': 'much'})}")
    print(f"services: {len(services)}")


def check(client, other):
    information = client.text("serverInfo")
    assert {"parameters", "parametersSubscribe", "services"} <= set(information["capabilities"])
    channels = check_channels(client)
    services = {it["name"]: it for it in client.text("advertiseServices")["services"]}
    check_messages(client, channels)
    check_parameters(client, other)
    check_services(client, services)


def main():
    how = {"subprotocols": ["foxglove.sdk.v1"], "open_timeout": PATIENCE}
    with connect(sys.argv[1], **how) as one, connect(sys.argv[1], **how) as two:
        check(Client(one), Client(two))
    print("ok")


main()
