"""Accelerations and forces of the built-in models by sympy.physics.mechanics.KanesMethod.

Each model is built here as its README draws it: bodies, points and the forces at them, without a
look at its description. What holds by contact is a force that is not known, beside the condition
on the accelerations that determines it; the key of model A has an auxiliary speed, as in the paper.
Reads parameters, states and what was found there from the file that is named; prints the largest
deviation of each mode, and fails above the tolerance.
"""

import json
import sys
from types import SimpleNamespace

import numpy as np
import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod, Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia,
)

TOLERANCE = 1e-10
T = dynamicsymbols._t
N = ReferenceFrame("N")
ORIGIN = Point("O")
ORIGIN.set_vel(N, 0)
S = dynamicsymbols("s")


class Model:
    """Rows that are zero, linear in what is unknown, and the quantities to compare."""

    def __init__(self, q, u, bodies, loads, auxiliary=(), **dependent):
        self.q, self.u = list(q), list(u)
        rates = [a.diff(T) - b for a, b in zip(q + dependent.get("q_dependent", []),
                                               u + dependent.get("u_dependent", []))]
        options = {"u_auxiliary": list(auxiliary), **dependent} if auxiliary else dependent
        kane = KanesMethod(N, self.q, self.u, rates, **options)
        fr, frstar = kane.kanes_equations(bodies, loads)
        self.rows = list(fr + frstar)
        self.q += dependent.get("q_dependent", [])
        self.u += dependent.get("u_dependent", [])
        self.rows += [row.diff(T) for row in dependent.get("velocity_constraints", [])]
        self.kinematics = dict(zip([it.diff(T) for it in self.q], self.u))
        self.unknown = [it.diff(T) for it in self.u]
        self.outputs = {it.name + "'": it.diff(T) for it in self.u}
        # What follows from the other entries of the state, in order.
        self.closing = {}

    def values(self, parameters, states):
        """The quantities at each state."""
        names = list(parameters)
        s = [sp.Symbol("s_%d" % k) for k in range(4)]
        plain = [(S.diff(T, k), s[k]) for k in (3, 2, 1)] + [(S, s[0])]
        unknown = [sp.Symbol("unknown_%d" % k) for k in range(len(self.unknown))]
        hidden = dict(zip(self.unknown, unknown))
        state = [sp.Symbol("x_%d" % k) for k in range(len(self.q + self.u))]
        shown = dict(zip(self.q + self.u, state))

        def explicit(it):
            it = sp.sympify(it).doit().subs(self.kinematics).doit().subs(hidden)
            return it.subs(plain).subs(shown)

        arguments = [sp.Symbol(name) for name in names] + state + s
        rows = sp.Matrix([explicit(row) for row in self.rows])
        matrix = rows.jacobian(unknown)
        right = -rows.subs({it: 0 for it in unknown})
        system = sp.lambdify(arguments, [matrix, right], modules="numpy", cse=True)
        outputs = [explicit(it) for it in self.outputs.values()]
        read = sp.lambdify(arguments + unknown, outputs, modules="numpy", cse=True)
        closing = [(it, sp.lambdify(arguments, explicit(by))) for it, by in self.closing.items()]
        entries = [it.name for it in self.q + self.u]
        for given in states:
            x = [given["state"].get(name, 0.0) for name in entries]
            before = list(parameters.values())
            for it, by in closing:
                x[entries.index(it.name)] = by(*before, *x, *given["input"])
            before += x + given["input"]
            a, b = (np.array(it, dtype=float) for it in system(*before))
            found = np.linalg.solve(a, b.ravel())
            yield dict(zip(self.outputs, read(*before, *found)))


def point(start, name, at, frame, angular):
    """A point of a frame that turns about `start`."""
    it = start.locatenew(name, at)
    it.set_vel(N, start.vel(N) + angular.cross(at))
    return it


def body(name, centre, frame, mass, moment):
    return RigidBody(name, centre, frame, mass, (inertia(frame, 0, 0, moment), centre))


def turned(name, angle, rate):
    frame = N.orientnew(name, "Axis", [angle, N.z])
    frame.set_ang_vel(N, rate * N.z)
    return frame, rate * N.z


def lever_pair(p, key_angle, key_rate, hammer_angle, hammer_rate):
    """Key and hammer on their pivots, with their weights."""
    key, key_turn = turned("K", key_angle, key_rate)
    hammer, hammer_turn = turned("H", hammer_angle, hammer_rate)
    pivot = ORIGIN.locatenew("P", p.L3 * N.x + p.L4 * N.y)
    pivot.set_vel(N, 0)
    key_centre = point(ORIGIN, "KC", p.cK * key.x, key, key_turn)
    hammer_centre = point(pivot, "HC", p.L2 * hammer.x, hammer, hammer_turn)
    bodies = [
        body("key", key_centre, key, p.M1, p.JK - p.M1 * p.cK**2),
        body("hammer", hammer_centre, hammer, p.M2, p.JH - p.M2 * p.L2**2),
    ]
    loads = [(key_centre, -p.M1 * p.g * N.y), (hammer_centre, -p.M2 * p.g * N.y)]
    return SimpleNamespace(key=key, key_turn=key_turn, hammer=hammer, hammer_turn=hammer_turn,
                           pivot=pivot, bodies=bodies, loads=loads)


def key_hammer_rigid(p, mode):
    """Model A: the key is where the manipulandum is, by the torque T; the hammer lies on it by F."""
    angle, = q = [dynamicsymbols("theta_h")]
    rate, auxiliary = dynamicsymbols("theta_h_dot u_a")
    force, torque = sp.symbols("F T")
    it = lever_pair(p, S, S.diff(T) + auxiliary, angle, rate)
    on_key = point(ORIGIN, "A", p.L1 * it.key.x, it.key, it.key_turn)
    reach = on_key.pos_from(it.pivot)
    under = point(it.pivot, "B", reach.dot(it.hammer.x) * it.hammer.x, it.hammer, it.hammer_turn)
    loads = it.loads + [
        (under, force * it.hammer.y), (on_key, -force * it.hammer.y), (it.key, torque * N.z),
    ]
    model = Model(q, [rate], it.bodies, loads, [auxiliary])
    gap = -reach.dot(it.hammer.y)
    still = {auxiliary: 0, auxiliary.diff(T): 0}
    model.rows = [sp.sympify(row).subs(still) for row in model.rows]
    first = gap.diff(T).subs(model.kinematics)
    model.rows.append(first.diff(T) if mode == "A1" else force)
    model.unknown += [force, torque]
    model.outputs |= {"F_KH": force, "T_KU": torque, "readout": torque, "gap": gap}
    return model


def key_hammer_springs(p, mode):
    """Model B: four coordinates, two constraints, the slider's spring k2 across the key."""
    h, k, q3, q4 = dynamicsymbols("theta_h theta_k q3 q4")
    uh, uk, u3, u4 = dynamicsymbols("theta_h_dot theta_k_dot q3_dot q4_dot")
    it = lever_pair(p, k, uk, h, uh)
    below = p.L1 * it.key.x - q4 * it.key.y
    on_key = point(ORIGIN, "A", below, it.key, it.key_turn)
    slider = ORIGIN.locatenew("S", below)
    slider.set_vel(N, on_key.vel(N) - u4 * it.key.y)
    force = p.k2 * q4 * sp.Max(1 + p.c2 * u4, 0) if mode == "B1" else sp.S.Zero
    torque = p.k1 * (S - k) + p.b1 * (S.diff(T) - uk)
    loads = it.loads + [
        (slider, force * it.key.y), (on_key, -force * it.key.y), (it.key, torque * N.z),
    ]
    along = point(it.pivot, "B", q3 * it.hammer.x, it.hammer, it.hammer_turn)
    apart = slider.pos_from(along)
    loop = [apart.dot(axis) for axis in (N.x, N.y)]
    slip = slider.vel(N) - along.vel(N) - u3 * it.hammer.x
    speeds = [slip.dot(axis) for axis in (N.x, N.y)]
    model = Model([h, k], [uh, uk], it.bodies, loads, q_dependent=[q3, q4],
                  u_dependent=[u3, u4], configuration_constraints=loop,
                  velocity_constraints=speeds)
    model.closing = {**sp.solve(loop, [q3, q4]), **sp.solve(speeds, [u3, u4])}
    gap = ORIGIN.locatenew("C", p.L1 * it.key.x).pos_from(it.pivot).dot(-it.hammer.y)
    model.outputs |= {"F_KH": force, "T_KU": torque, "readout": torque, "gap": gap}
    # Without contact the description's slider is nowhere.
    model.outputs |= {"q3": q3, "q4": q4} if mode == "B1" else {"q3": 0, "q4": 0}
    return model


def cart_pendulum(p, mode):
    x, theta = q = list(dynamicsymbols("x theta"))
    v, w = u = list(dynamicsymbols("x_dot theta_dot"))
    wall = sp.Symbol("wall")
    cart = ORIGIN.locatenew("C", x * N.x)
    cart.set_vel(N, v * N.x)
    frame, turn = turned("B", theta, w)
    bob = point(cart, "G", -p.length * frame.y, frame, turn)
    pull = p.k * (S - x) + p.b * (S.diff(T) - v)
    loads = [(cart, (pull + wall) * N.x), (bob, -p.bob_mass * p.g * N.y)]
    bodies = [Particle("cart", cart, p.cart_mass), body("bob", bob, frame, p.bob_mass, p.inertia)]
    model = Model(q, u, bodies, loads)
    model.rows.append(wall if mode == "free" else v.diff(T))
    model.unknown.append(wall)
    model.outputs |= {"F": pull, "readout": pull, "N": -wall if mode == "right" else wall}
    return model


def bouncing_ball(p, mode):
    y, v = dynamicsymbols("y v")
    floor = sp.Symbol("floor")
    ball = ORIGIN.locatenew("B", y * N.y)
    ball.set_vel(N, v * N.y)
    model = Model([y], [v], [Particle("ball", ball, p.mass)], [(ball, (floor - p.mass * p.g) * N.y)])
    model.rows.append(floor if mode == "flight" else v.diff(T) - S.diff(T, 2))
    model.unknown.append(floor)
    model.outputs |= {"F": floor, "readout": floor, "gap": y - S}
    return model


def reduced_grand(p, mode):
    """Model C: key front and hammer head, each on a line of its own; what passes between them is
    an unknown force on the head, and on the key that force times its ratio."""
    y, z = q = list(dynamicsymbols("y z"))
    u, w = speeds = list(dynamicsymbols("u w"))
    passed = sp.Symbol("passed")

    def soft(x):
        return sp.log(1 + sp.exp(x))

    key, head = ORIGIN.locatenew("K", y * N.x), ORIGIN.locatenew("H", z * N.y)
    key.set_vel(N, u * N.x)
    head.set_vel(N, w * N.y)
    finger = p.k1 * (S - y) + p.b1 * (S.diff(T) - u)
    bed = p.Kb * p.wf**2 * soft((y - p.ybed) / p.wf)**2 * sp.Max(1 + p.ab * u, 0)
    rail = p.Kr * p.wf**2 * soft(-y / p.wf)**2 * sp.Max(1 - p.ar * u, 0)
    resists = (p.Wk + p.Fc * sp.tanh(u / p.vc) + p.ck * u
               + p.kj * p.wj * soft((y - p.yb) / p.wj) + bed - rail)
    # Where the head is on what carries it, as a function of the key's travel.
    room = 2 * (p.zt - p.R * p.yb) / (p.R * (1 + p.rho))
    part = (y - p.yb) / room
    button = p.R * p.yb + p.R * room * (part - part**2 * (1 - p.rho) / 2)
    lever_place = p.o_r + p.R * (y - p.wd * soft((y - p.yd) / p.wd))
    lever_ratio = lever_place.diff(y)
    carried = {"ACC": p.R * y, "LO": button, "CHK": p.zc + p.Rc * (y - p.ybed)}.get(mode)
    ratio = carried.diff(y) if carried is not None else 0
    if mode == "LO":
        ratio += 16 * p.nu * (part * (1 - part))**2 * sp.tanh(u / p.vc)
    lever, string = sp.S.Zero, sp.S.Zero
    if mode in ("REPH", "REPL", "REP0"):
        squeezed = lever_ratio * u - w
        lever = p.kr * (lever_place - z) * soft(p.cr * squeezed) / sp.log(2)
    elif mode == "CHK":
        lever = p.kr * (lever_place - z)
    elif mode in ("STU", "STT"):
        string = p.Ks * sp.Max(z - p.zs, 0)**p.ps * sp.Max(1 + p.mus * w, 0)
    on_head = passed + lever - string - p.mh * p.g - p.ch * w
    on_key = finger - resists - lever * lever_ratio - passed * ratio
    bodies = [Particle("key", key, p.mk), Particle("head", head, p.mh)]
    model = Model(q, speeds, bodies, [(key, on_key * N.x), (head, on_head * N.y)])
    if carried is None:
        model.rows.append(passed)
    else:
        model.rows.append((w - carried.diff(T).subs(model.kinematics)).diff(T))
    model.unknown.append(passed)
    jack = passed if mode in ("ACC", "LO") else 0
    model.outputs |= {"F_KU": finger, "readout": finger, "F_jack": jack, "F_lever": lever,
                      "F_string": string}
    return model


MODELS = {
    "key-hammer-rigid": key_hammer_rigid, "key-hammer-springs": key_hammer_springs,
    "cart-pendulum": cart_pendulum, "bouncing-ball": bouncing_ball, "reduced-grand": reduced_grand,
}


def main():
    with open(sys.argv[1]) as file:
        cases = json.load(file)
    worst, compared = 0.0, 0
    for case in cases:
        parameters = case["parameters"]
        symbols = SimpleNamespace(**{name: sp.Symbol(name) for name in parameters})
        model = MODELS[case["model"]](symbols, case["mode"])
        deviation = 0.0
        for given, found in zip(case["states"], model.values(parameters, case["states"])):
            for name, ours in given["found"].items():
                apart = abs(ours - found[name]) / max(1.0, abs(found[name]))
                if not apart <= TOLERANCE:
                    print("%s %s: %s is %r, not %r at %s" % (
                        case["model"], case["mode"], name, ours, float(found[name]), given["state"]))
                deviation = max(deviation, apart if apart == apart else np.inf)
                compared += 1
        print("%s %s: %d states, deviation %.1e" % (
            case["model"], case["mode"], len(case["states"]), deviation), flush=True)
        worst = max(worst, deviation)
    print("%d modes, %d numbers, largest deviation %.1e" % (len(cases), compared, worst))
    return 0 if compared and worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
