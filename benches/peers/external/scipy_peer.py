"""SciPy's solve_ivp with terminal, falling events, begun anew at each event.

default: RK45 with rtol 1e-3 and atol 1e-6, as its documentation says.
best: DOP853 (its documentation: "recommended for solving with high precision") and LSODA
("a good universal choice"), with max_step, without which LSODA jumps over the stroke: that is
run as well. Right-hand sides in plain Python on floats, which is faster here than on arrays.
LSODA gives no finer dense output than its own interpolant.

Prints one line of JSON per row.
"""

import json
import sys
import time

import numpy as np
import scipy
from scipy.integrate import solve_ivp

from case import Case, problem

MOST_EVENTS = 100


def run(it, case, method, rtol, atol, max_step, samples):
    """One run; its events, states at `samples`, evaluations, and the error that ended it."""
    mode, x = it.start()
    modes = it.modes()
    for _, guards, _ in modes.values():
        for index, guard in enumerate(guards):
            guard.terminal, guard.direction = True, -1
    t, events, states, evaluations = 0.0, [], [], 0
    while t < case.t_end:
        right, guards, names = modes[mode]
        wanted = [s for s in samples or () if t < s <= case.t_end] or None
        done = solve_ivp(right, (t, case.t_end), np.array(x), method, events=guards, rtol=rtol, atol=atol,
                         max_step=max_step, t_eval=wanted)
        evaluations += done.nfev
        if done.status == -1:
            return events, states, evaluations, done.message
        if wanted and len(done.y):
            states += done.y.T.ravel().tolist()
        if done.status == 0:
            break
        index = next(i for i, found in enumerate(done.t_events) if len(found))
        t = float(done.t_events[index][-1])
        events.append([t, names[index]])
        if len(events) >= MOST_EVENTS:
            return events, states, evaluations, f"stopped after {MOST_EVENTS} events"
        mode, x = it.fire(mode, index, done.y_events[index][-1])
    return events, states, evaluations, None


def row(it, case, method, setting, rtol, atol, max_step, note):
    """Runs one row, times it, and prints it."""
    events, states, _, error = run(it, case, method, rtol, atol, max_step, case.samples)
    times, begin, evaluations = [], time.process_time(), None
    while error is None and (not times or time.process_time() - begin < case.budget):
        before = time.process_time_ns()
        evaluations = run(it, case, method, rtol, atol, max_step, None)[2]
        times.append(time.process_time_ns() - before)
    print(json.dumps({
        "version": scipy.__version__, "method": method, "setting": setting, "knob": rtol,
        "note": note, "events": events, "states": states, "rhs": evaluations, "ns": times,
        "error": error,
    }), flush=True)


def main():
    case = Case(sys.argv[1])
    it = problem(case)
    free = float("inf")
    row(it, case, "RK45", "default", 1e-3, 1e-6, free, "terminal events; absolute tolerance 1e-6")
    for tolerance in case.tolerances:
        both = (tolerance, tolerance)
        note = "terminal, falling events; max_step one width of the narrowest bell"
        row(it, case, "DOP853", "sweep", *both, it.longest_step, note)
        row(it, case, "LSODA", "sweep", *both, it.longest_step, note)
        if it.longest_step < free:
            row(it, case, "LSODA", "no max_step", *both, free, "terminal, falling events")


main()
