#!/usr/bin/env python3
"""Thirteen compliant contacts on one planar rigid body, two of them with dry friction.

    pip install scipy
    python3 thirteen_contacts.py > thirteen_contacts.csv

The body (mass m, moment of inertia J) has the centre (x, y) and the angle phi. Contact c is a
point r of the body before a wall n.p = d: gap g = n.p - d, depth e = -g while it touches,

    N = k e^p (1 + chi e'),   friction along t = (n_y, -n_x) at the slip speed s = t.p'

with |friction| <= mu_s N while s = 0 and -sign(s) mu_k N otherwise. The drive is a force at the
centre and a torque, sines of the time. Two more states sum up the energy: taken by contacts and
friction, and put in by the drive.

DOP853 of SciPy, with short steps and tolerances near rounding; an event is bracketed by samples of the
dense output, and then found by integrating up to it anew, so that no interpolation is left in
it. The whole is done a second time with other steps; how far both agree stands in the file.
"""

import math
import sys

import numpy as np
import scipy
from scipy.integrate import DOP853, solve_ivp

M, J, G = 0.5, 1.2e-3, 9.81
END = 1.2
# name, r_x, r_y, n_x, n_y, d, k, p, chi, mu_s, mu_k
FELT, GUM = (1.2e5, 1.5, 0.8), (2.0e3, 1.0, 0.6)
CONTACTS = [
    ("skid-floor", -0.04, -0.020, 0, 1, 0.0, *GUM, 0.90, 0.70),
    ("skid-wall", 0.10, 0.004, -1, 0, -0.1005, 1.5e3, 1.0, 0.6, 0.80, 0.60),
    ("felt-1", -0.10, -0.018, 0, 1, 0.0, *FELT, 0, 0),
    ("felt-2", -0.05, -0.017, 0, 1, 0.0, *FELT, 0, 0),
    ("felt-3", 0.00, -0.0175, 0, 1, 0.0, *FELT, 0, 0),
    ("felt-4", 0.05, -0.0172, 0, 1, 0.0, *FELT, 0, 0),
    ("felt-5", 0.10, -0.0185, 0, 1, 0.0, *FELT, 0, 0),
    ("bed", 0.02, -0.0165, 0, 1, 0.0, 8.0e6, 2.0, 1.0, 0, 0),
    ("top-left", -0.07, 0.02, 0, -1, -0.0465, *FELT, 0, 0),
    ("top-middle", 0.01, 0.02, 0, -1, -0.0460, *FELT, 0, 0),
    ("top-right", 0.07, 0.02, 0, -1, -0.0470, *FELT, 0, 0),
    ("buffer-left", -0.11, 0.002, 1, 0, -0.1130, 9.0e2, 1.0, 1.5, 0, 0),
    ("buffer-right", 0.11, -0.003, -1, 0, -0.1115, 9.0e2, 1.0, 1.5, 0, 0),
]
# amplitude, rate (rad/s), phase of the force along x, along y, and of the torque
DRIVE = [(4.5, 7.0, 0.4), (5.5, 17.0, -1.2), (0.04, 31.0, 0.7)]
START = [-0.001, 0.0235, 0.02, 0.15, -0.1, 0.3, 0.0, 0.0]


def drive(t):
    return [a * math.sin(w * t + phase) for a, w, phase in DRIVE]


class Kinematics:
    """Of one contact at one state."""

    def __init__(self, contact, x):
        _, rx, ry, self.nx, self.ny, d, self.k, self.p, self.chi, self.mu_s, self.mu_k = contact
        cos, sin = math.cos(x[2]), math.sin(x[2])
        self.ax, self.ay = cos * rx - sin * ry, sin * rx + cos * ry
        vx, vy = x[3] - x[5] * self.ay, x[4] + x[5] * self.ax
        self.tx, self.ty = self.ny, -self.nx
        self.gap = self.nx * (x[0] + self.ax) + self.ny * (x[1] + self.ay) - d
        self.rate = self.nx * vx + self.ny * vy
        self.slip = self.tx * vx + self.ty * vy

    def normal(self):
        depth = -self.gap
        elastic = self.k * math.copysign(abs(depth) ** self.p, depth)
        return elastic, elastic * (1 - self.chi * self.rate)


def unforced(t, x, state):
    """Force, torque and power taken, without friction; the frictional contacts that touch."""
    fx, fy, torque = drive(t)
    put_in = fx * x[3] + fy * x[4] + torque * x[5]
    fy -= M * G
    taken, rubbing = 0.0, []
    for number, contact in enumerate(CONTACTS):
        if state[number] == "open":
            continue
        it = Kinematics(contact, x)
        elastic, normal = it.normal()
        fx, fy = fx + normal * it.nx, fy + normal * it.ny
        torque += normal * (it.ax * it.ny - it.ay * it.nx)
        taken -= (normal - elastic) * it.rate
        if state[number] != "closed":
            rubbing.append((number, it, normal))
    return [fx, fy, torque], taken, put_in, rubbing


def frictions(t, x, state):
    """All that acts, with the friction forces: generalised force, powers, forces by contact."""
    force, taken, put_in, rubbing = unforced(t, x, state)
    inverse = np.array([1 / M, 1 / M, 1 / J])
    rows, known = {}, {}
    for number, it, normal in rubbing:
        rows[number] = np.array([it.tx, it.ty, it.ax * it.ty - it.ay * it.tx])
        if state[number] != "stick":
            known[number] = -math.copysign(it.mu_k * normal, 1 if state[number] == "up" else -1)
    force = np.array(force) + sum(f * rows[n] for n, f in known.items())
    stuck = [(n, it) for n, it, _ in rubbing if state[n] == "stick"]
    if stuck:
        jac = np.array([rows[n] for n, _ in stuck])
        # t.p'' = 0: the rotation of r adds -w^2 (t.a).
        centripetal = np.array([-x[5] ** 2 * (it.tx * it.ax + it.ty * it.ay) for _, it in stuck])
        held = np.linalg.solve(jac * inverse @ jac.T, -(jac @ (inverse * force) + centripetal))
        force = force + jac.T @ held
        known.update({n: f for (n, _), f in zip(stuck, held)})
    taken -= sum(known[n] * it.slip for n, it, _ in rubbing)
    return force, taken, put_in, known


def derivative(t, x, state):
    force, taken, put_in, _ = frictions(t, x, state)
    return [x[3], x[4], x[5], force[0] / M, force[1] / M, force[2] / J, taken, put_in]


def guard(number, kind, t, x, state):
    it = Kinematics(CONTACTS[number], x)
    if kind == "gap":
        return it.gap if state[number] == "open" else -it.gap
    if state[number] == "stick":
        return it.mu_s * it.normal()[1] - abs(frictions(t, x, state)[3][number])
    return it.slip if state[number] == "up" else -it.slip


def watched(state):
    for number, contact in enumerate(CONTACTS):
        yield number, "gap"
        if state[number] in ("stick", "up", "down"):
            yield number, "friction"


def settle(number, t, x, state):
    """What a friction does at slip speed zero, or anywhere just after its contact closed."""
    slip = Kinematics(CONTACTS[number], x).slip
    if abs(slip) > 1e-9:
        return "up" if slip > 0 else "down"
    trial = state[:number] + ["stick"] + state[number + 1 :]
    if guard(number, "friction", t, x, trial) > 0:
        return "stick"
    return "down" if frictions(t, x, trial)[3][number] > 0 else "up"


def change(number, kind, t, x, state):
    after, x = list(state), list(x)
    if kind == "gap" and state[number] != "open":
        after[number] = "open"
    elif kind == "gap":
        after[number] = settle(number, t, x, after) if CONTACTS[number][9] else "closed"
    elif state[number] == "stick":
        after[number] = "down" if frictions(t, x, state)[3][number] > 0 else "up"
    else:
        after[number] = settle(number, t, x, after)
    return after, x


def without_slip(x, state):
    """Puts what sticks to rest along the direction of its own forces."""
    stuck = [Kinematics(c, x) for n, c in enumerate(CONTACTS) if state[n] == "stick"]
    if stuck:
        jac = np.array([[it.tx, it.ty, it.ax * it.ty - it.ay * it.tx] for it in stuck])
        inverse = np.array([1 / M, 1 / M, 1 / J])
        impulse = np.linalg.solve(jac * inverse @ jac.T, [-it.slip for it in stuck])
        x[3:6] = np.array(x[3:6]) + inverse * (jac.T @ impulse)
    return x


def exact(t0, x0, t1, state):
    """The state at t1, by an integration of its own."""
    if t1 == t0:
        return list(x0)
    span = t1 - t0
    done = solve_ivp(derivative, (t0, t1), x0, DOP853, rtol=RTOL, atol=ATOL, args=(state,),
                     first_step=span / 3, max_step=span / 3)
    return list(done.y[:, -1])


RTOL, ATOL, SAMPLES = 3e-14, 1e-17, 6


def run(max_step):
    t, x, state = 0.0, list(START), ["open"] * len(CONTACTS)
    events = []
    while t < END:
        it = DOP853(lambda t, x: derivative(t, x, state), t, x, END, max_step=max_step,
                    first_step=min(1e-6, END - t), rtol=RTOL, atol=ATOL)
        armed, found = {}, None
        while it.status == "running" and found is None:
            t_old, x_old = it.t, list(it.y)
            it.step()
            dense = it.dense_output()
            places = [t_old + (it.t - t_old) * i / SAMPLES for i in range(1, SAMPLES + 1)]
            for low, high in zip([t_old] + places, places):
                hits = []
                for which in watched(state):
                    value = guard(*which, high, dense(high), state)
                    if value > 1e-13:
                        armed[which] = True
                    elif value < 0 and which in armed:
                        hits.append((locate(which, t_old, x_old, low, high, state), which))
                if hits:
                    found = min(hits)
                    break
        if found is None:
            return events, list(it.y)
        t, (number, kind) = found
        x = exact(t_old, x_old, t, state)
        state, x = change(number, kind, t, x, state)
        x = without_slip(x, state)
        events.append((t, CONTACTS[number][0], state[number], list(x)))


def locate(which, t0, x0, low, high, state):
    """The root in low .. high by regula falsi (Illinois), each value by an own integration."""
    def value(t):
        return guard(*which, t, exact(t0, x0, t, state), state)

    a, b, fa, fb = low, high, value(low), value(high)
    if fa <= 0:
        return low
    for _ in range(60):
        c = (a * fb - b * fa) / (fb - fa)
        fc = value(c)
        if fc * fb < 0:
            a, fa = b, fb
        else:
            fa *= 0.5
        b, fb = c, fc
        if abs(b - a) < 1e-16 or abs(fb) < 1e-17:
            break
    return b


def energy(x):
    total = 0.5 * M * (x[3] ** 2 + x[4] ** 2) + 0.5 * J * x[5] ** 2 + M * G * x[1]
    for contact in CONTACTS:
        it = Kinematics(contact, x)
        if it.gap < 0:
            total += it.k * (-it.gap) ** (it.p + 1) / (it.p + 1)
    return total


def main():
    events, end = run(2e-4)
    again, other = run(1.3e-4)
    same = [(e[1], e[2]) for e in events] == [(e[1], e[2]) for e in again]
    apart = max(abs(a[0] - b[0]) for a, b in zip(events, again)) if same else math.nan
    print(f"# by thirteen_contacts.py with SciPy {scipy.__version__}; a second run agrees in the "
          f"sequence: {same}, in times to {apart:.1e} s")
    balance = energy(end) - energy(START) + end[6] - end[7]
    print(f"# stored + taken - put in: {balance:.1e} J of {end[7]:.3g} J put in")
    print(f"body,{M!r},{J!r},{G!r}")
    for line in DRIVE:
        print("drive," + ",".join(repr(float(v)) for v in line))
    for contact in CONTACTS:
        print(f"contact,{contact[0]}," + ",".join(repr(float(v)) for v in contact[1:]))
    print("start," + ",".join(repr(v) for v in START))
    for t, name, state, x in events:
        print(f"event,{float(t)!r},{name},{state}," + ",".join(repr(float(v)) for v in x))
    print(f"end,{END!r}," + ",".join(repr(float(v)) for v in end))


if __name__ == "__main__":
    main()
