"""Rows of the results, one line of JSON each, and the timing of runs."""

import json
import time


def process_time(run):
    """CPU time of `run` [ns]."""
    before = time.process_time_ns()
    run()
    return time.process_time_ns() - before


def row(case, code, knobs, events, states, run, error=None):
    """Prints a row. `code` is (version, method, setting, note), `knobs` its tolerance or step.

    `events` is None for a code that reports none; `run` makes one run and says how long it
    took [ns], and is repeated until the budget is spent.
    """
    version, method, setting, note = code
    times, begin = [], time.process_time()
    while error is None and (not times or time.process_time() - begin < case.budget):
        times.append(run())
    print(json.dumps({
        "version": version, "method": method, "setting": setting, "knob": knobs, "note": note,
        "events": events, "states": states, "rhs": None, "ns": times, "error": error,
    }), flush=True)
