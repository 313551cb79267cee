"""Accelerations of planar mechanisms by sympy.physics.mechanics.KanesMethod.

Reads mechanisms with states, and with the accelerations that were found there, from the file
that is named; prints the largest deviation of each mechanism, and fails above the tolerance.
"""

import json
import sys
import time

import numpy as np
import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia,
)

TOLERANCE = 1e-10
T = dynamicsymbols._t


class Mechanism:
    """Frames, bodies and forces of a description, as SymPy has them."""

    def __init__(self, text):
        self.q = dynamicsymbols([c["name"] for c in text["coordinates"]], real=True)
        self.u = dynamicsymbols(["u_" + c["name"] for c in text["coordinates"]], real=True)
        self.s = dynamicsymbols("s", real=True)
        self.names = {q["name"]: it for q, it in zip(text["coordinates"], self.q)}
        self.names["s"] = self.s
        self.ground = ReferenceFrame("N")
        self.origin = Point("O")
        self.origin.set_vel(self.ground, 0)
        self.rates = dict(zip([q.diff(T) for q in self.q], self.u))
        self.frames = [(self.ground, (sp.S.Zero, sp.S.Zero), sp.S.Zero)]
        for frame in text["frames"]:
            self.frames.append(self.frame(frame))
        self.bodies = [self.body(body) for body in text["bodies"]]
        self.loads = [(it.masscenter, -9.81 * it.mass * self.ground.y) for it in self.bodies]
        for spring in text["springs"]:
            self.spring(spring)
        for spring in text["torsion"]:
            self.torsion(spring)
        self.velocity = []
        for constraint in text["constraints"]:
            self.constraint(constraint)

    def expression(self, text):
        return sp.sympify(str(text), locals=self.names)

    def frame(self, text):
        """A frame, its origin on the ground's axes, and its angle to them."""
        parent = self.frames[text["parent"]]
        angle = parent[2] + self.expression(text["turn"])
        frame = self.ground.orientnew("F%d" % len(self.frames), "Axis", [angle, self.ground.z])
        frame.set_ang_vel(self.ground, angle.diff(T).subs(self.rates) * self.ground.z)
        return frame, self.place(parent, text["origin"]), angle

    def place(self, frame, at):
        """A point that may move along the axes of a frame, on the ground's axes."""
        _, (ox, oy), angle = frame
        x, y = (self.expression(it) for it in at)
        c, s = sp.cos(angle), sp.sin(angle)
        return ox + x * c - y * s, oy + x * s + y * c

    def point(self, frame, at):
        x, y = self.place(frame, at)
        ground = self.ground
        point = self.origin.locatenew("P", x * ground.x + y * ground.y)
        u, v = (it.diff(T).subs(self.rates) for it in (x, y))
        point.set_vel(ground, u * ground.x + v * ground.y)
        return point

    def at(self, text):
        return self.point(self.frames[text["frame"]], text["at"])

    def body(self, text):
        frame = self.frames[text["frame"]][0]
        centre = self.at(text)
        about = (inertia(self.ground, 0, 0, text["inertia"]), centre)
        return RigidBody("B", centre, frame, text["mass"], about)

    def spring(self, text):
        """A spring and a damper along the line between two points."""
        first, second = self.at(text["from"]), self.at(text["to"])
        line = second.pos_from(first)
        length = sp.sqrt(line.dot(self.ground.x) ** 2 + line.dot(self.ground.y) ** 2)
        along = line / length
        rate = (second.vel(self.ground) - first.vel(self.ground)).dot(along)
        tension = text["stiffness"] * (length - text["length"]) + text["damping"] * rate
        self.loads += [(first, tension * along), (second, -tension * along)]

    def torsion(self, text):
        """A spring on a coordinate: a generalised force, by the frame that it turns."""
        frame, parent = (self.frames[text[it]][0] for it in ("frame", "parent"))
        q = self.names[text["coordinate"]]
        u = self.u[self.q.index(q)]
        torque = text["stiffness"] * (self.s - q) - text["damping"] * u
        self.loads += [(frame, torque * self.ground.z), (parent, -torque * self.ground.z)]

    def constraint(self, text):
        point = self.at(text["point"])
        velocity = point.vel(self.ground)
        if text["kind"] == "edge":
            angle = self.frames[text["point"]["frame"]][2]
            across = sp.cos(angle) * self.ground.y - sp.sin(angle) * self.ground.x
            self.velocity.append(velocity.dot(across))
            return
        axis = {"x": self.ground.x, "y": self.ground.y}[text["kind"]]
        place = self.expression(text["place"])
        self.velocity.append(velocity.dot(axis) - place.diff(T))

    def accelerations(self, states):
        """Rates of all speeds at each state: the free system's equations are KanesMethod's, the
        constraints' forces and second derivatives are put beside them in numbers."""
        n = len(self.q)
        kane = KanesMethod(
            self.ground, list(self.q), list(self.u),
            [q.diff(T) - u for q, u in zip(self.q, self.u)],
        )
        kane.kanes_equations(self.bodies, self.loads)
        still = {u.diff(T): 0 for u in self.u}
        rows = sp.Matrix(self.velocity) if self.velocity else sp.zeros(0, 1)
        slopes = rows.jacobian(self.u) if self.velocity else sp.zeros(0, n)
        bend = rows.diff(T).subs(still).subs(self.rates)
        s = [sp.Symbol("s%d" % k) for k in range(4)]
        plain = [(self.s.diff(T, k), s[k]) for k in (3, 2, 1)] + [(self.s, s[0])]
        arguments = list(self.q) + list(self.u) + s
        system = [kane.mass_matrix, kane.forcing, slopes, bend]
        system = [it.subs(self.rates).subs(plain) for it in system]
        evaluate = sp.lambdify(arguments, system, modules="numpy", cse=True)
        found = []
        for state in states:
            values = state["coordinates"] + state["speeds"] + state["input"]
            mass, force, slope, curve = (np.array(it, dtype=float) for it in evaluate(*values))
            m = len(self.velocity)
            slope = slope.reshape(m, n)
            matrix = np.block([[mass, -slope.T], [slope, np.zeros((m, m))]])
            right = np.concatenate([force.ravel(), -curve.ravel()])
            found.append(list(np.linalg.solve(matrix, right)[:n]))
        return found


def main():
    with open(sys.argv[1]) as file:
        mechanisms = json.load(file)
    worst = 0.0
    for text in mechanisms:
        start = time.time()
        found = Mechanism(text).accelerations(text["states"])
        deviation = 0.0
        for state, rates in zip(text["states"], found):
            size = max(1.0, max(map(abs, rates)))
            ours = state["accelerations"]
            deviation = max(deviation, *(abs(a - b) / size for a, b in zip(ours, rates)))
        print("%s: %d bodies, %d constraints, deviation %.1e (%.1f s)" % (
            text["name"], len(text["bodies"]), len(text["constraints"]), deviation,
            time.time() - start), flush=True)
        worst = max(worst, deviation)
    print("%d mechanisms, largest deviation %.1e" % (len(mechanisms), worst))
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
