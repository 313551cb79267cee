"""heyoka: Taylor's method, compiled for the equations, with terminal events.

default: the tolerance as it comes, 2.2e-16; the order follows from the tolerance.
best: a sweep over tolerances, without compact_mode, which its documentation keeps for large
systems; `high_accuracy` (compensated sums) at the default tolerance, which its documentation
has for errors near rounding.
Terminal events fall; a reset map is the callback of its event, after which the propagation
goes on; where the mode changes the event stops the propagation, and the integrator of the
other mode takes over. Integrators are built, that is compiled, before the timing starts.

Prints one line of JSON per row.
"""

import sys

import heyoka as hy
import numpy as np

from case import Case, problem
from rows import process_time, row


class Integrators:
    """One integrator for each mode, and the events of the last run."""

    def __init__(self, it, case, **options):
        self.start, self.t_end, self.events = it.start(), case.t_end, []
        modes = problem(case, hy).modes()
        names = hy.make_vars(*(f"x{i}" for i in range(len(self.start[1]))))
        x = np.array(names, dtype=object)
        self.integrators = {}
        for mode, (right, guards, called) in modes.items():
            rhs = [hy.expression(value) if isinstance(value, float) else value
                   for value in right(hy.time, x)]
            falls = hy.event_direction.negative
            terminal = [hy.t_event(guard(hy.time, x), callback=self.callback(it, mode, i, name),
                                   direction=falls)
                        for i, (guard, name) in enumerate(zip(guards, called))]
            self.integrators[mode] = hy.taylor_adaptive(
                list(zip(names, rhs)), list(self.start[1]), t_events=terminal, **options)

    def callback(self, it, mode, guard, name):
        """Writes the event down, applies the reset map, and goes on unless the mode changes."""
        def fired(integrator, _sign):
            self.events.append([integrator.time, name])
            self.mode, integrator.state[:] = it.fire(mode, guard, integrator.state)
            return self.mode == mode
        return fired

    def run(self, is_sampled=False):
        """One run; its parts as continuous outputs, if they are asked for."""
        self.mode, state = self.start
        now, self.events, parts = 0.0, [], []
        while now < self.t_end:
            integrator = self.integrators[self.mode]
            integrator.time = now
            integrator.state[:] = state
            integrator.reset_cooldowns()
            done = integrator.propagate_until(self.t_end, c_output=is_sampled)
            parts.append(done[4])
            now, state = integrator.time, integrator.state
        return parts


def states(parts, samples):
    """The state at each of `samples`."""
    found = []
    for t in samples:
        part = next(part for part in parts if part is not None and t <= part.bounds[1])
        found += part(t).tolist()
    return found


def timed(integrators):
    """CPU time of a run [ns], over as many as make the reading of the clock unimportant."""
    once = process_time(integrators.run)
    runs = 1 + int(100_000 / max(once, 1000))
    return process_time(lambda: [integrators.run() for _ in range(runs)]) / runs


def show(it, case, setting, knob, **options):
    """One row."""
    integrators = Integrators(it, case, **options)
    sampled = states(integrators.run(is_sampled=True), case.samples)
    note = "terminal, falling events; reset maps in their callbacks"
    row(case, (hy.__version__, "Taylor", setting, note), knob, integrators.events, sampled,
        lambda: timed(integrators))


def main():
    case = Case(sys.argv[1])
    it = problem(case)
    epsilon = float(np.finfo(float).eps)
    show(it, case, "default", epsilon)
    show(it, case, "high_accuracy", epsilon, high_accuracy=True)
    for tolerance in case.tolerances:
        show(it, case, "sweep", tolerance, tol=tolerance)


main()
