"""The problems, as in src/problems: equations, guards, reset maps; and the parameter file."""

import math


class Case:
    """The parameter file: `name value` lines."""

    def __init__(self, path):
        self.values, self.tolerances, self.samples = {}, [], []
        for line in open(path, encoding="utf-8"):
            name, value = line.split()
            if name == "problem":
                self.problem = value
            elif name == "tolerance":
                self.tolerances.append(float(value))
            elif name == "sample":
                self.samples.append(float(value))
            else:
                self.values[name] = float(value)
        self.t_end, self.budget = self.values["t_end"], 1e-3 * self.values["budget_ms"]


class Ball:
    """State: height and speed."""

    longest_step = float("inf")

    def __init__(self, case):
        self.g, self.e, self.height = (case.values[name] for name in ("g", "e", "height"))

    def start(self):
        return None, [self.height, 0.0]

    def modes(self):
        """By mode: right-hand side, guards (positive while valid), their names."""
        g = self.g
        fall = lambda t, x: [x[1], -g]
        floor = lambda t, x: x[0]
        return {None: (fall, [floor], ["floor"])}

    def fire(self, mode, guard, x):
        return mode, [0.0, -self.e * x[1]]


class ModelB:
    """State: angles of hammer and key, and their rates."""

    def __init__(self, case, functions):
        v = case.values
        self.functions = functions
        self.v = v
        self.rest = [v[f"rest{i}"] for i in range(4)]
        self.bells = [tuple(v[f"bell{3 * i + j}"] for j in range(3)) for i in range(3)]
        self.longest_step = 1 / max(bell[2] for bell in self.bells)

    def start(self):
        return "coupled", list(self.rest)

    def modes(self):
        """By mode: right-hand side, guards (positive while valid), their names."""
        names = "L1 L3 L4 k1 k2 JK JH weight_key weight_hammer string".split()
        l1, l3, l4, k1, k2, jk, jh, key_weight, hammer_weight, string = (self.v[n] for n in names)
        (a1, t1, w1), (a2, t2, w2), (a3, t3, w3) = self.bells
        sin, cos, exp = self.functions.sin, self.functions.cos, self.functions.exp

        def drive(t, key):
            z1, z2, z3 = (t - t1) * w1, (t - t2) * w2, (t - t3) * w3
            return k1 * (a1 * exp(-z1 * z1) + a2 * exp(-z2 * z2) + a3 * exp(-z3 * z3) - key)

        def coupled(t, x):
            h, k, hammer_rate, key_rate = x.tolist()
            sin_h, cos_h, sin_k, cos_k = sin(h), cos(h), sin(k), cos(k)
            sin_d = sin_k * cos_h - cos_k * sin_h
            secant = 1 / (cos_k * cos_h + sin_k * sin_h)
            q4 = (l1 * sin_d - l4 * cos_h + l3 * sin_h) * secant
            q3 = (l1 - l3 * cos_k - l4 * sin_k) * secant
            force = k2 * q4
            hammer = (force * q3 * secant - hammer_weight * cos_h) / jh
            key = (drive(t, k) - force * (l1 + q4 * sin_d * secant) - key_weight * cos_k) / jk
            return [hammer_rate, key_rate, hammer, key]

        def apart(t, x):
            h, k, hammer_rate, key_rate = x.tolist()
            key = (drive(t, k) - key_weight * cos(k)) / jk
            return [hammer_rate, key_rate, -hammer_weight * cos(h) / jh, key]

        def gap(t, x):
            h, k = x[:2].tolist()
            return l4 * cos(h) - l3 * sin(h) - l1 * sin(k - h)

        below = lambda t, x: string - x[0]
        return {
            "coupled": (coupled, [lambda t, x: -gap(t, x), below], ["release", "string"]),
            "apart": (apart, [gap, below], ["land", "string"]),
        }

    def fire(self, mode, guard, x):
        if guard == 0:
            return ("apart" if mode == "coupled" else "coupled"), list(x)
        return mode, [self.v["string"], x[1], -self.v["restitution"] * x[2], x[3]]


class Cradle:
    """State: five balls' positions from where each hangs at rest, then their speeds."""

    longest_step = float("inf")

    def __init__(self, case):
        v = case.values
        self.square, self.e, self.pulled = v["w"] ** 2, v["e"], v["pulled"]
        self.gaps = [v[f"gap{i}"] for i in range(4)]

    def start(self):
        return None, [-self.pulled] + 9 * [0.0]

    def modes(self):
        """By mode: right-hand side, guards (positive while valid), their names."""
        swing = lambda t, x: [*x[5:], *(-self.square * x[:5])]
        between = lambda i: lambda t, x: self.gaps[i] + x[i + 1] - x[i]
        return {None: (swing, [between(i) for i in range(4)], [f"pair{i}" for i in range(4)])}

    def fire(self, mode, pair, x):
        x, left, right = list(x), pair + 5, pair + 6
        x[pair] = x[pair + 1] + self.gaps[pair]
        mean, half = 0.5 * (x[left] + x[right]), 0.5 * (x[right] - x[left])
        x[left], x[right] = mean + self.e * half, mean - self.e * half
        return mode, x


class Block:
    """State: the centre's place, the block's angle, and their rates.

    A mode is the corner that touches (1 right, -1 left) and how it slides (1, -1, 0 not).
    """

    longest_step = float("inf")

    def __init__(self, case, functions):
        v = case.values
        self.a, self.b, self.g, self.mu = (v[name] for name in ("a", "b", "g", "mu"))
        self.first = (int(v["corner"]), int(v["slides"]))
        self.begin = [v[f"start{i}"] for i in range(4)]
        self.functions = functions
        self.turn = (self.a**2 + self.b**2) / 3
        self.about_corner = 4 * self.turn

    def start(self):
        return self.first, list(self.begin)

    def arm(self, corner, angle):
        """From the centre to the corner."""
        s, c, along = self.functions.sin(angle), self.functions.cos(angle), corner * self.a
        return along * c + self.b * s, along * s - self.b * c

    def forces(self, mode, x):
        """Angular acceleration, friction and normal force over the mass, and the arm."""
        corner, slides = mode
        angle, rate = x[1], x[3]
        px, py = self.arm(corner, angle)
        if slides:
            lever = px + self.mu * slides * py
            turn = (self.g + rate * rate * py) * lever / (self.turn + px * lever)
            normal = self.g - turn * px + rate * rate * py
            return turn, -self.mu * slides * normal, normal, px, py
        turn = self.g * px / self.about_corner
        normal = self.g - turn * px + rate * rate * py
        return turn, turn * py + rate * rate * px, normal, px, py

    def modes(self):
        """By mode: right-hand side, guards (positive while valid), their names."""
        return {(corner, slides): self.mode(corner, slides)
                for corner in (1, -1) for slides in (0, 1, -1)}

    def mode(self, corner, slides):
        mode = (corner, slides)

        def right(t, x):
            turn, along, *_ = self.forces(mode, x.tolist())
            return [x[2], x[3], along, turn]

        def cone(side):
            def margin(t, x):
                _, along, normal, *_ = self.forces(mode, x.tolist())
                return self.mu * normal - side * along
            return margin

        tilt = lambda t, x: -corner * x[1]
        slip = lambda t, x: slides * (x[2] - x[3] * self.arm(corner, x[1])[1])
        if slides:
            return right, [tilt, slip], ["impact", "stick"]
        return right, [tilt, cone(1), cone(-1)], ["impact", "slip", "slip"]

    def settled(self, corner, x):
        """The mode at no sliding speed: stuck if the cone holds the force, else on or back."""
        _, along, normal, *_ = self.forces((corner, 0), x)
        if abs(along) <= self.mu * normal:
            return (corner, 0)
        return (corner, -1 if along > 0 else 1)

    def fire(self, mode, guard, x):
        corner, slides = mode
        x = [float(value) for value in x]
        if guard == 0:
            return self.impact(-corner, x)
        # The corner does not move now, without the drift of the steps before.
        x[2] = x[3] * self.arm(corner, x[1])[1]
        if slides == 0:
            return (corner, -1 if guard == 1 else 1), x
        return self.settled(corner, x), x

    def impact(self, corner, x):
        """The other corner comes down, and rebounds from nothing, by Coulomb's law."""
        a, b, mu, turn = corner * self.a, self.b, self.mu, self.turn
        place, _, speed, rate = x
        along, down = speed + rate * b, 2 * rate * a
        tt, nn, tn = 1 + b * b / turn, 1 + a * a / turn, a * b / turn
        over = tt * nn - tn * tn
        pt, pn = (tn * down - nn * along) / over, (tn * along - tt * down) / over
        slides = 0
        if abs(pt) > mu * pn:
            slides = -1 if pt > 0 else 1
            pn = -down / (nn - mu * slides * tn)
            pt = -mu * slides * pn
        x = [place, 0.0, speed + pt, rate + (a * pn + b * pt) / turn]
        return self.settled(corner, x) if slides == 0 else (corner, slides), x


def problem(case, functions=math):
    """The problem that the case asks for, with the sine and its like from `functions`."""
    if case.problem == "ball":
        return Ball(case)
    if case.problem == "cradle":
        return Cradle(case)
    return (ModelB if case.problem == "model-b" else Block)(case, functions)
