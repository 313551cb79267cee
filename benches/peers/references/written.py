"""Writes a reference as JSON with one event and one row of states on a line."""

import json


def write(path, reference):
    """Writes the dictionary `reference` to `path`."""
    def entry(value):
        if isinstance(value, list):
            return "[\n" + ",\n".join(map(json.dumps, value)) + "\n]"
        return json.dumps(value)

    lines = [f"{json.dumps(name)}: {entry(value)}" for name, value in reference.items()]
    path.write_text("{\n" + ",\n".join(lines) + "\n}\n")
