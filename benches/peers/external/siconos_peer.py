"""Siconos, made for nonsmooth mechanics, on the cradle.

"event-driven" (LsodarOSI) stops at impacts; the knob is the distance of its own time events.
"Moreau–Jean" (theta 0.5, which keeps the energy of a swing) steps over impacts, with Newton's
law in the step, and has no events: states alone are judged. Both as in Siconos' examples
BouncingBallED and BouncingBallTS. Timed is the loop over steps, in Python as in its examples.

Not the block: event-driven it has no friction, and a relation that is written in Python ends
in a segmentation fault (MoreauJeanOSI::computeFreeOutput, Debian's 4.4.0).
"""

import subprocess
import sys

import numpy as np
import siconos.kernel as sk

from case import Case, problem
from rows import process_time, row

# Its own __version__ is 0 in Debian's package.
VERSION = subprocess.check_output(
    ["dpkg-query", "--show", "--showformat", "${source:Upstream-Version}", "python3-siconos"],
    text=True)


class Stepped:
    """The cradle under Moreau's time stepping."""

    def __init__(self, it, case, step):
        self.body = sk.LagrangianLinearTIDS(np.array(it.start()[1][:5]), np.zeros(5), np.eye(5))
        model = sk.NonSmoothDynamicalSystem(0.0, case.t_end)
        model.insertDynamicalSystem(self.body)
        # Siconos keeps pointers to all of these.
        self.kept = [model, stiffness := np.eye(5) * it.square]
        self.body.setKPtr(stiffness)
        for i, gap in enumerate(it.gaps):
            difference, offset = np.zeros((1, 5)), np.array([gap])
            difference[0, i:i + 2] = -1, 1
            relation = sk.LagrangianLinearTIR(difference, offset)
            model.link(sk.Interaction(sk.NewtonImpactNSL(it.e), relation), self.body)
            self.kept += [difference, offset, relation]
        self.simulation = self.simulator(model, sk.TimeDiscretisation(0.0, step))

    def simulator(self, model, times):
        return sk.TimeStepping(model, times, sk.MoreauJeanOSI(0.5), sk.LCP())

    def step(self):
        self.simulation.computeOneStep()
        self.simulation.nextStep()

    def run(self):
        while self.simulation.hasNextEvent():
            self.step()

    def follow(self):
        """The same with time and state after each step."""
        while self.simulation.hasNextEvent():
            self.step()
            yield self.simulation.startingTime(), [*self.body.q(), *self.body.velocity()]


class EventDriven(Stepped):
    """The cradle under a simulation that stops at impacts."""

    def simulator(self, model, times):
        simulation = sk.EventDriven(model, times)
        simulation.insertIntegrator(sk.LsodarOSI())
        simulation.insertNonSmoothProblem(sk.LCP(), sk.SICONOS_OSNSP_ED_IMPACT)
        simulation.insertNonSmoothProblem(sk.LCP(), sk.SICONOS_OSNSP_ED_SMOOTH_ACC)
        simulation.initialize()
        return simulation

    def step(self):
        self.simulation.advanceToEvent()
        self.simulation.processEvents()


def states(samples, followed):
    """The states at the steps that end at samples."""
    found, wanted = [], list(samples)
    for t, state in followed:
        if wanted and abs(t - wanted[0]) < 1e-9:
            wanted.pop(0)
            found += map(float, state)
    return found


def impacts(it, followed, step):
    """Times at which it stopped between its own time events, and the pair that is closed."""
    for t, state in followed:
        if abs(t / step - round(t / step)) > 1e-9:
            gaps = [gap + state[i + 1] - state[i] for i, gap in enumerate(it.gaps)]
            yield [t, f"pair{gaps.index(min(gaps))}"]


def main():
    case = Case(sys.argv[1])
    it = problem(case)
    timed = lambda kind, step: lambda: process_time(kind(it, case, step).run)
    step = 1e-2
    followed = list(EventDriven(it, case, step).follow())
    row(case, (VERSION, "event-driven", "sweep", "Lsodar and LCP, stops at impacts"), step,
        list(impacts(it, followed, step)), states(case.samples, followed),
        timed(EventDriven, step))
    for step in (1e-3, 1e-4, 1e-5):
        found = states(case.samples, Stepped(it, case, step).follow())
        row(case, (VERSION, "Moreau–Jean", "sweep", "time stepping, no events"), step, None,
            found, timed(Stepped, step))


main()
